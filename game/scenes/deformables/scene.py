"""P04: soft bodies whose contacts a hash table finds."""

from __future__ import annotations

from collections.abc import Sequence

from game.lab.studies.deformables import cell_study
from game.physics.deformables.effects import SOFT
from game.scenes.deformables import DEFORMABLES
from game.scenes.deformables.figure import draw_two_passes
from game.scenes.deformables.hand import DeformablesHand
from game.scenes.deformables.level import DEFAULT, HEIGHT, WIDTH, DeformablesContent
from game.scenes.deformables.model import DeformablesModel, exercise
from game.scenes.deformables.parameters import OF_PICTURE, DeformablesParameters
from game.scenes.deformables.readouts import readouts_of
from game.scenes.deformables.view import DeformablesView
from game.stage import Equation, Frame, Hint, Strip, WarmUp
from game.worlds.scene import ModelScene, Told


class Deformables(ModelScene):
    """Many soft bodies of triangles fall on each other, and bend on to themselves. No tree of boxes survives
    that for long, so none is kept: in each step all vertices go into the cells of a grid, and the cells into
    the slots of a hash table. Then each triangle looks through its own cells for vertices that are inside.

    The table is never cleared: what has an old time stamp does not count. Two cells may share a slot, which
    costs tests but no errors. Vertices inside are pushed out by the depth that they agree on with their
    neighbours.

    In the equations: i, j cell and l its size, p_1, p_2 large primes, m slots of the table, β barycentric
    coordinates, x where an edge crosses the rim and n its normal there, d depth of vertex p, r its way out.
    """

    name, task, title = DEFORMABLES.names
    parameters_type = DeformablesParameters
    parameters: DeformablesParameters
    model: DeformablesModel
    effects = SOFT.known
    content_type = DeformablesContent
    told = Told(readouts_of)
    not_of_model = (*OF_PICTURE, "step_length")
    default_content = DEFAULT
    study = cell_study
    figure = staticmethod(draw_two_passes)
    hints = (Hint(("Drag",), "a body"),)
    strips = (
        Strip("Contacts", "", ("contacts", "self-contacts", "edges crossing")),
        Strip("Deepest", "m", ("deepest",)),
    )
    equations = (
        Equation(
            "Slot of a cell",
            r"h = (i p_1 \oplus j p_2) \mod m",
            "Teschner and others 2003",
        ),
        Equation("Inside", r"\beta_1, \beta_2, \beta_3 \ge 0", "edges belong to the triangle"),
        Equation(
            "Depth at the rim",
            r"d = \frac{\sum w (\v{x} - \v{p}) \cdot \v{n}}{\sum w}",
            "w = 1/|x - p|², Heidelberger and others 2004",
        ),
        Equation("Push", r"\Delta \v{p} = \frac{w_p s d}{w_p + \sum \beta_i^2 w_i} \v{r}", "momentum stays"),
    )
    try_this = (
        "Drag a body through the pile, and look at the ways out of the vertices that are inside.",
        "Show the cells and change their size: large ones are full, small ones are many.",
        "Make the table small: chains grow, tests too, but the contacts stay the same.",
        "Switch self-contacts off and fold the worm: it passes through itself.",
    )

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        return (WarmUp("soft bodies", exercise),)

    def make(self, content: DeformablesContent) -> None:
        self.model = DeformablesModel(content, self.parameters, self.active)
        self.hand = DeformablesHand(self.model)
        self.view = DeformablesView(self.model)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return (
            ("disc:vermilion", "vertex in a triangle", ""),
            ("line:amber", "edge that crosses a rim", ""),
            ("disc:text1", "fixed", ""),
        )

    def frame(self) -> Frame:
        middle = self.model.middle
        return Frame(middle - 0.5 * WIDTH - 0.03, -0.26, middle + 0.5 * WIDTH + 0.03, HEIGHT)

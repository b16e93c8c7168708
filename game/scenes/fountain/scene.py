"""A fountain of particles over a stone, by seven methods and three ways to meet the stone."""

from __future__ import annotations

from typing import Any, ClassVar

from game.lab.studies.particles import bounce_study
from game.physics.fields import DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import OBSTACLES
from game.scenes.fountain import C04
from game.scenes.fountain.figure import draw_impact
from game.scenes.fountain.hand import FountainHand
from game.scenes.fountain.level import FountainContent
from game.scenes.fountain.model import FountainModel
from game.scenes.fountain.parameters import FountainParameters
from game.scenes.fountain.readouts import readouts
from game.scenes.fountain.targets import story_names, story_targets
from game.scenes.fountain.view import FountainView
from game.scenes.shared.repeats import Repeat
from game.stage import (
    Equation,
    Hint,
    Pointer,
    SceneAction,
    SetParameter,
    StageEvent,
    Strip,
)
from game.stage.states.state import copy_state
from game.worlds.expectations import draw_captions
from game.worlds.scene import ModelScene, Told

MANY_PLACES = 200_000


class Fountain(ModelScene):
    """Each particle is a point of 1 kg. It leaves the nozzle at its own instant within a step, in a random
    direction inside the spread. It falls, is slowed by the air, and bounces off the stone and the ground by
    Newton's law of impact.

    The dashed curve is exact: no particle of this speed can pass it before it has touched something. A method
    of first order shows spray above it. Without quadratic drag and vortex all particles of one age lie on a
    circle that is known exactly. The error is how far the worst of them is off.

    Handling an impact at the end of a step makes every method one of first order. Interpolating along the
    chord restores the second, and solving for the instant of the impact the full order.

    In the equations: x position, v velocity, a acceleration, h time step, g gravity, k and q linear and
    quadratic drag, w wind, n the normal of what is hit, e restitution; + after and − before an impact.
    """

    name, task, title = C04.names
    effects = GRAVITY | DRAG | WIND | QUADRATIC_DRAG | WHIRL | GROUND | OBSTACLES
    parameters_type = FountainParameters
    parameters: FountainParameters
    model: FountainModel
    content_type = FountainContent
    told = Told(readouts, FountainModel.content_now, story_targets, names=story_names)
    default_content: ClassVar[FountainContent] = FountainContent()
    study = bounce_study
    takes = frozenset(("right",))

    strips = (
        Strip(
            "Energy",
            "J",
            ("potential", "kinetic", "total", "Euler total", "midpoint total"),
            sometimes=("potential", "kinetic", "Euler total", "midpoint total"),
        ),
        Strip(
            "Highest particle",
            "m",
            ("exact", "highest", "Euler highest", "midpoint highest"),
            ("exact",),
            sometimes=("Euler highest", "midpoint highest"),
        ),
        Strip("Error", "m", ("error",)),
    )
    hints = (
        Hint(("Drag",), "move stone, nozzle, rim"),
        Hint(("Shift", "Click"), "new stone"),
        Hint(("Right click",), "remove stone"),
    )
    actions = (
        SceneAction("emit", "emitter on or off", "E"),
        SceneAction("clear", "clear all particles", "C"),
    )
    figure = staticmethod(draw_impact)
    equations = (
        Equation(
            "Motion, with drag and wind",
            r"\v{a} = \v{g} - (k + q\abs{\v{v}-\v{w}})(\v{v}-\v{w})",
            "Newton 1687",
        ),
        Equation(
            "Explicit Euler",
            r"\v{x}_{n+1} = \v{x}_n + h\v{v}_n,  \v{v}_{n+1} = \v{v}_n + h\v{a}(\v{x}_n, \v{v}_n)",
            "Euler 1768",
        ),
        Equation(
            "Midpoint",
            r"\v{v}_{1/2} = \v{v}_n + \frac{1}{2}h\v{a}_n,  \v{x}_{1/2} = \v{x}_n + \frac{1}{2}h\v{v}_n",
            "Runge 1895",
        ),
        Equation("", r"\v{x}_{n+1} = \v{x}_n + h\v{v}_{1/2}"),
        Equation("", r"\v{v}_{n+1} = \v{v}_n + h\v{a}(\v{x}_{1/2}, \v{v}_{1/2})"),
        Equation(
            "Velocity Verlet",
            r"\v{x}_{n+1} = \v{x}_n + h\v{v}_n + \frac{1}{2}h^2\v{a}_n",
            "Swope and others 1982",
        ),
        Equation("", r"\v{v}_{n+1} = \v{v}_n + \frac{1}{2}h(\v{a}_n + \v{a}_{n+1})"),
        Equation("Impact", r"\v{v}^+ = \v{v}^- - (1+e)(\v{v}^- \cdot \v{n})\v{n}", "Newton 1687"),
        Equation("Envelope of all paths", r"y = \frac{v^2}{2g} - \frac{g x^2}{2 v^2}", "Torricelli 1644"),
        Equation(
            "Births", r"t_n = n / \text{rate},  N(T) = \floor{\text{rate} \, T}", "each at its own instant"
        ),
    )
    try_this = (
        "Choose explicit Euler and a long time step: the spray rises above the dashed curve.",
        "Show three methods and take a long time step: where does the total energy of each go?",
        "Set both restitutions to 1 and wait 3 s: the total energy rises to what the nozzle gave.",
        "Switch drag and wind on: the bars show what each costs; the dashed curve is still exact.",
        "Raise the places to 100 000 and the emit rate to 40 000: see what a step costs then.",
    )

    # -- building -----------------------------------------------------------------------------------

    def make(self, content: FountainContent) -> None:
        self.model = FountainModel(content, self.parameters, self.active, self.seed)
        self.hand = FountainHand(self.model)
        self.view = FountainView(self.model)
        self.repeat = Repeat(content.repeat)
        self._beginning = copy_state(self.state()) if content.repeat else None

    def takes_long(self, event: StageEvent | None) -> bool:
        """Very many places, which are all laid out again."""
        return isinstance(event, SetParameter) and event.name == "places" and float(event.value) > MANY_PLACES

    def why_idle(self, name: str) -> str:
        return "Three methods are shown." if name == "method" and self.model.beside else ""

    # -- a step, and what comes in ------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self._beginning is not None and self.repeat.advance(dt):
            self.restore(self._beginning)
            self.model.renew()
            self.previous = None
        self.said.say(self.model.advance(dt, self.hand.stone, self.hand.target))

    def pointer(self, event: Pointer) -> None:
        if event.kind == "down":
            self.repeat.end()
        super().pointer(event)

    def action(self, name: str) -> None:
        if name == "emit":
            self.model.switch_emitters()
        else:
            self.model.clear()

    # -- what there is to see -----------------------------------------------------------------------

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, self.previous, alpha)
        zoom = self.model.content.zoom
        if zoom is not None:
            self.view.draw_inset(canvas, zoom, self.previous, alpha)
        self.draw_expected(canvas)

    def draw_expected(self, canvas: Any) -> None:
        frame = self.frame()
        top = (0.5 * (frame.left + frame.right), frame.top)
        draw_captions(canvas, top, self.captions(), self.repeat.left)

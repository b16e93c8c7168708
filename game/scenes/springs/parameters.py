"""The parameters of the two mass-spring scenes: their solver, their world, their tools, and what is shown."""

from __future__ import annotations

from typing import Any, ClassVar

from game.physics.constraints import (
    AREAS,
    ATTACHMENTS,
    CONTACTS,
    DAMPING,
    LINKS,
    ORDERS,
    SCHEMES,
    SOLVERS,
    TEARING,
)
from game.physics.fields import GRAVITY, GROUND
from game.scenes.springs.hand import TOOLS
from game.stage import Choice, Param, Parameter, Scene, Toggle

CHOSEN_PARAMETERS = ("mass", "fixed", "own_stiffness")  # they say and set what is chosen


class MassSpringParameters(Scene):
    """Base of both scenes: what they let one choose. Each adds how stiff its links are."""

    effects = GRAVITY | GROUND | LINKS | AREAS | ATTACHMENTS | TEARING | DAMPING | CONTACTS

    iterations = Param(
        20, 1, 500, whole=True, log=True, group="Solver",
        help="sweeps over all links in each substep: more makes them stiffer, not the motion more exact",
    )  # fmt: skip
    substeps = Param(
        4, 1, 200, whole=True, log=True, group="Solver",
        help="parts of a step: for equal work they beat iterations by their number",
    )  # fmt: skip
    step_length = Param(1.0 / 60.0, 1.0 / 2000.0, 0.1, unit="s", log=True, group="Solver", label="Time step")
    scheme = Choice(
        "euler", SCHEMES, labels=("Euler", "BDF2"), group="Solver",
        help="first order, loses energy; or second order, loses hardly any",
    )  # fmt: skip
    solver = Choice(
        "gauss-seidel", SOLVERS, labels=("Sweeps", "Direct"), group="Solver",
        help="link by link, or all links of a chain at once",
    )  # fmt: skip
    order = Choice("coloured", ORDERS, group="Solver", rebuild=True, help="in which links are solved")
    relaxation = Param(
        1.0,
        0.1,
        1.95,
        group="Solver",
        help="above 1 each correction goes further than it should; far above, the net shakes itself apart",
    )
    damping = Param(0.4, 0.0, 50.0, unit="N s/m", group="World", help="k_d in the force −k_d v")
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    strength = Param(
        0.8,
        0.01,
        20.0,
        log=True,
        group="World",
        label="Tears at",
        help="stretch over length that tears a link",
    )
    speed_limit = Param(
        60.0, 1.0, 10_000.0, unit="m/s", log=True, group="World",
        help="nobody gets faster, not even by hand; whom it slows down loses momentum",
    )  # fmt: skip
    tool = Choice(
        "hand", TOOLS, labels=("Move", "New particle", "Link two", "Pin", "Cut"), group="Tools",
        help="what the left button does",
    )  # fmt: skip
    mass = Param(
        1.0, 1e-6, 1e6, unit="kg", log=True, group="Tools", help="of the chosen particle, and of new ones"
    )
    fixed = Toggle(False, group="Tools", label="Fixed in space", help="inverse mass 0")
    strains = Toggle(True, group="Shown", label="Stretch", help="links coloured by their stretch")
    points = Toggle(True, group="Shown", label="Particles")

    groups: ClassVar[tuple[str, ...]] = ("Solver", "World", "Tools", "Shown")  # as the panel has them

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, group by group: a subclass's own groups come first."""
        order = {group: i for i, group in enumerate(cls.groups, start=1)}
        return dict(
            sorted(super().declared_parameters().items(), key=lambda item: order.get(item[1].group, 0))
        )

"""The parameters of the two mass-spring scenes: their links, their solver, their world, their tools, and what
is shown."""

from __future__ import annotations

from game.physics.constraints import MODELS, ORDERS, SCHEMES, SOLVERS
from game.stage import Choice, Param, Parameters, Toggle

TOOLS = ("hand", "particle", "link", "pin", "cut")
BUILDING = ("particle", "link", "pin")  # tools with which an empty sheet stands still
OF_CHOSEN = ("mass", "fixed", "own_stiffness")  # they say and set what is chosen
OF_PICTURE = ("strains", "points", "slow_sweep")


class MassSpringParameters(Parameters):
    """What both scenes let one choose. Each adds how stiff its links are."""

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
        1.0, 0.1, 1.95, group="Solver",
        help="above 1 each correction goes further than it should; far above, the net shakes itself apart",
    )  # fmt: skip
    damping = Param(0.4, 0.0, 50.0, unit="N s/m", group="World", help="k_d in the force −k_d v")
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    strength = Param(
        0.8,
        0.01,
        20.0,
        log=True,
        group="World",
        label="Tears at",
        help="stretch over length that tears one",
    )
    speed_limit = Param(
        60.0, 1.0, 10_000.0, unit="m/s", log=True, group="World",
        help="no particle gets faster, not even by hand; whom it slows down loses momentum",
    )  # fmt: skip
    tool = Choice(
        "hand", TOOLS, labels=("Move", "New particle", "Link two", "Pin", "Cut"), group="Tools",
        help="what the left button does",
    )  # fmt: skip
    grip = Param(
        0.0, 0.0, 2.0, unit="m", group="Tools", label="Grip radius",
        help="who is nearer to the particle that is taken is led along, the nearer the more; 0: it alone",
    )  # fmt: skip
    mass = Param(
        1.0, 1e-6, 1e6, unit="kg", log=True, group="Tools", help="of the chosen particle, and of new ones"
    )
    fixed = Toggle(False, group="Tools", label="Fixed in space", help="inverse mass 0")
    slow_sweep = Toggle(
        False, group="Shown", label="Sweep slowed down",
        help="time stands still, and link by link is put right, in the order given",
    )  # fmt: skip
    strains = Toggle(True, group="Shown", label="Stretch", help="links coloured by their stretch")
    points = Toggle(True, group="Shown", label="Particles")


class RigidLinkChoices(Parameters):
    """How stiff the links of C14 are."""

    model = Choice(
        "pbd", ("pbd", "xpbd"), labels=("Position based", "With compliance"), group="Links",
        help="the link's length put right, or a spring of a real stiffness",
    )  # fmt: skip
    compliance = Param(
        1e-6, 1e-9, 1.0, unit="m/N", log=True, group="Links", help="inverse stiffness, with compliance only"
    )


class SoftSpringChoices(Parameters):
    """How stiff the springs of C15 are."""

    model = Choice(
        "pbd", MODELS, labels=("k", "k′", "Compliance"), group="Springs",
        help="k each sweep; k spread over the sweeps; or a real stiffness",
    )  # fmt: skip
    stiffness = Param(
        0.2, 0.0, 1.0, group="Springs", label="Stiffness k_s", help="of all springs without one of their own"
    )
    own_stiffness = Param(
        0.2, 0.0, 1.0, group="Springs", label="Of the chosen", help="springs at the chosen particle"
    )


class RigidLinkParameters(MassSpringParameters, RigidLinkChoices):
    """All of C14: what the last base declares comes first in the panel."""


class SoftSpringParameters(MassSpringParameters, SoftSpringChoices):
    """All of C15."""

"""The parameters of the sphere collisions: impacts, motion, resting contact, world, tools, what is shown."""

from __future__ import annotations

from game.physics.spheres.settings import CORRECTIONS, LAWS, SCHEMES
from game.stage import Choice, Param, Parameters, Toggle

BROAD_PHASES = ("brute-force", "grid", "hierarchical", "sweep-and-prune")
TOOLS = ("push", "sphere", "remove")
# what a change of is nothing to the solver
NOT_SETTINGS = (
    "tool",
    "radius",
    "push_strength",
    "push_time",
    "shown_impulses",
    "shown_bearing",
    "ledger",
    "freeze",
)
TABLE_PARAMETERS = ("restitution", "friction", "wall_restitution", "wall_friction")


class CollisionParameters(Parameters):
    """What of spheres and solver can be chosen."""

    restitution = Param(0.8, 0.0, 1.0, group="Collisions", label="Restitution e", help="between spheres")
    friction = Param(0.2, 0.0, 2.0, group="Collisions", label="Friction μ", help="between spheres")
    wall_restitution = Param(
        1.0,
        0.0,
        1.0,
        group="Collisions",
        label="e at walls",
        help="1 mirrors the velocity",
    )
    wall_friction = Param(0.0, 0.0, 2.0, group="Collisions", label="μ at walls")
    law = Choice(
        "in-turn", LAWS, labels=("Sequential", "Simultaneous"), group="Collisions",
        help="one contact after the other until none approaches, or Newton's law at all of them together",
    )  # fmt: skip
    rest = Param(
        4.0, 0.0, 20.0, group="Collisions", label="Resting speed", unit="g h",
        help="approach over g h / (1 − e²) below which nothing bounces",
    )  # fmt: skip
    step_length = Param(1.0 / 120.0, 1.0 / 2000.0, 0.1, unit="s", log=True, group="Motion", label="Time step")
    substeps = Param(1, 1, 50, whole=True, log=True, group="Motion", help="parts of a step")
    scheme = Choice(
        "explicit-euler", SCHEMES, labels=("Explicit", "Semi-impl.", "Parabola"), group="Motion",
        help="explicit Euler as the course says, semi-implicit, or exact free flight",
    )  # fmt: skip
    correction = Choice(
        "split", CORRECTIONS, labels=("None", "Baumgarte", "Soft", "Split impulses", "Projection"),
        group="Resting contact", help="of penetration; Baumgarte and soft contacts add velocity",
    )  # fmt: skip
    iterations = Param(
        10,
        1,
        200,
        whole=True,
        log=True,
        group="Resting contact",
        help="sweeps of the impulses of resting contacts",
    )
    passes = Param(3, 0, 50, whole=True, group="Resting contact", help="sweeps of position correction")
    slop = Param(
        0.01,
        0.0,
        0.2,
        group="Resting contact",
        label="Slop",
        unit="r",
        help="penetration that is left, over the smallest radius",
    )
    warm = Toggle(
        True, group="Resting contact", label="Warm start", help="begin with the last step's impulses"
    )
    broad_phase = Choice(
        "brute-force", BROAD_PHASES, labels=("Brute force", "Grid", "Hierarchical grid", "Sweep and prune"),
        group="Resting contact", rebuild=True, help="how pairs are found that may be in contact",
    )  # fmt: skip
    gravity = Param(9.81, -20.0, 30.0, unit="m/s²", group="World", help="downwards")
    drag = Param(0.1, 0.0, 20.0, unit="N s/m", group="World", help="of the air, in proportion to velocity")
    real = Toggle(
        False, group="World", label="Real masses", rebuild=True,
        help="mass from density and 2/5 m r²; else mass 1 and inertia 1, as the course has it",
    )  # fmt: skip
    density = Param(
        1.0, 1e-3, 1e5, unit="kg/m³", log=True, group="World", rebuild=True, help="for real masses"
    )
    lifted = Param(
        0, 0, 40, whole=True, group="World", label="Balls lifted", rebuild=True,
        help="of each cradle; 0: as many as the level says",
    )  # fmt: skip
    tool = Choice(
        "push", TOOLS, labels=("Push", "New sphere", "Remove"), group="Tools",
        help="a force from where you press to where you let go; a click makes a sphere, or removes one",
    )  # fmt: skip
    push_strength = Param(
        40.0, 0.1, 1e4, unit="N/m", log=True, group="Tools", help="force over the length drawn"
    )
    push_time = Param(0.1, 0.001, 1.0, unit="s", log=True, group="Tools", help="how long a force acts")
    radius = Param(0.25, 0.01, 5.0, unit="m", log=True, group="Tools", help="of new spheres")
    shown_impulses = Toggle(True, group="Shown", label="Impulses", help="of collisions of the last 0.5 s")
    shown_bearing = Toggle(
        False, group="Shown", label="Contact forces", help="of resting contacts: lines as wide as their force"
    )
    freeze = Toggle(
        False, group="Shown", label="Freeze on impact", help="stand still at each collision, until G goes on"
    )
    ledger = Toggle(True, group="Shown", label="Ledger", help="the last collisions in figures")

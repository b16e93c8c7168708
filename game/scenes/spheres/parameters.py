"""The parameters of the sphere collisions: impacts, motion, bearing, world, tools, and what is shown."""

from __future__ import annotations

from typing import Any, ClassVar

from game.physics.fields import DRAG, GRAVITY
from game.physics.rigid import PUSHES, ROTATION, WINDOW
from game.physics.spheres.effects import COLLISIONS, FRICTION, IMPACT_TIMES, LEDGES, STRINGS
from game.physics.spheres.settings import CORRECTIONS, LAWS, SCHEMES
from game.scenes.spheres.hand import TOOLS
from game.stage import Choice, Param, Parameter, Scene, Toggle

BROAD_PHASES = ("brute-force", "grid", "hierarchical", "sweep-and-prune")
NOT_SETTINGS = ("tool", "radius", "push_strength", "push_time", "shown_impulses", "shown_bearing", "ledger")
TABLE_PARAMETERS = ("restitution", "friction", "wall_restitution", "wall_friction")


class CollisionParameters(Scene):
    """Base of the scene: what of spheres and solver can be chosen."""

    effects = (
        GRAVITY | DRAG | ROTATION | WINDOW | PUSHES | COLLISIONS | FRICTION | IMPACT_TIMES | STRINGS | LEDGES
    )

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
        "in-turn", LAWS, labels=("In turn", "At once"), group="Collisions",
        help="touches one after the other until none approaches, or Newton's law at all together",
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
        group="Bearing", help="how overlap is taken away; Baumgarte and soft contacts add speed",
    )  # fmt: skip
    iterations = Param(
        10, 1, 200, whole=True, log=True, group="Bearing", help="sweeps of the impulses that bear what rests"
    )
    passes = Param(3, 0, 50, whole=True, group="Bearing", help="sweeps of position correction")
    slop = Param(
        0.01, 0.0, 0.2, group="Bearing", label="Overlap left", unit="r", help="of the smallest radius"
    )
    warm = Toggle(True, group="Bearing", label="Warm start", help="begin with the last step's impulses")
    broad_phase = Choice(
        "brute-force", BROAD_PHASES, labels=("Brute force", "Grid", "Hierarchical grid", "Sweep and prune"),
        group="Bearing", rebuild=True, help="how pairs are found that may touch",
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
    tool = Choice(
        "push", TOOLS, labels=("Push", "New sphere", "Take away"), group="Tools",
        help="a force from where you press to where you let go; click a sphere into being, or away",
    )  # fmt: skip
    push_strength = Param(40.0, 0.1, 1e4, unit="N/m", log=True, group="Tools", help="force to drawn length")
    push_time = Param(0.1, 0.001, 1.0, unit="s", log=True, group="Tools", help="how long a force acts")
    radius = Param(0.25, 0.01, 5.0, unit="m", log=True, group="Tools", help="of new spheres")
    shown_impulses = Toggle(True, group="Shown", label="Impulses", help="of collisions of the last 0.5 s")
    shown_bearing = Toggle(False, group="Shown", label="Bearing forces", help="lines as wide as their force")
    ledger = Toggle(True, group="Shown", label="Ledger", help="the last collisions in figures")

    groups: ClassVar[tuple[str, ...]] = ("Collisions", "Motion", "Bearing", "World", "Tools", "Shown")

    @classmethod
    def declared_parameters(cls) -> dict[str, Parameter[Any]]:
        """Parameters by name, group by group."""
        order = {group: i for i, group in enumerate(cls.groups)}
        return dict(
            sorted(super().declared_parameters().items(), key=lambda item: order.get(item[1].group, 99))
        )

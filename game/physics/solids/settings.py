"""What a step of solids does, and the numbers that its kernels read."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.physics.solids.effects import (
    CONTACTS_BIT,
    DRAG_BIT,
    FRICTION_BIT,
    GRAVITY_BIT,
    RESTITUTION_BIT,
    SOLIDS,
    USUAL,
)
from game.physics.solids.solvers.impact_law import IMPACT_LAWS

MOST_TURNS = 10_000
JOINT_SOLVERS = ("direct", "sweeps")
GOVERNED = "soft-step"  # others show how they are, as printed
JOINT_RATE = 0.4  # part of a stiff joint's gap that a substep restores
USUAL_HERTZ = 0.135  # of soft contacts, as part of the substeps a second
ABREAST = frozenset({"soft-step"})  # solvers that take rows in batches
TIERS = {"play": 4, "teach": 12, "film": 24}  # substeps


def tier_of(substeps: float) -> str:
    """What so many substeps are called; empty where they have no name."""
    return next((name.capitalize() for name, count in TIERS.items() if count == substeps), "")


class Numbers(NamedTuple):
    """The numbers of a step, for its kernels."""

    mask: int
    substeps: int
    iterations: int
    dt: float  # s, of the whole step
    h: float  # s, of a substep
    gravity_x: float  # m/s²
    gravity_y: float  # m/s²
    drag: float  # 1/s, of velocity against the air
    spin_drag: float  # 1/s
    near: float  # m: how far apart two may be and yet be prepared as a contact
    recycle: float  # of near: how far two may move against each other before their manifold is found again
    contact_pull: float  # 1/s²: square of the frequency (rad/s) of soft contacts
    contact_rate: float  # 1/s: soft contacts, speed of parting for each metre of overlap
    contact_mass: float  # part of the effective mass that a soft contact uses
    contact_give: float  # part of the impulse that a soft contact gives back
    fixed_rate: float  # the same against what cannot move, which is twice as stiff in frequency
    fixed_mass: float
    fixed_give: float
    direct_joints: bool  # all joints at once, where they have a plan
    joint_rate: float
    joint_mass: float
    joint_give: float
    push: float  # m/s, fastest that overlap drives two apart
    bounce: float  # m/s, slower impacts do not bounce
    impact_law: int  # of `solvers.impact_law`
    slop: float  # m of overlap that is left alone, by solvers that correct it
    friction: float  # 1, or 0 without friction
    passive: bool  # the energy of what has no source is kept from rising
    calm: float  # m/s: slower than that is quiet
    abreast: bool  # the solver takes rows in batches, and copies them where that is needed
    patience: float  # s of quiet before a group falls asleep


def soft(hertz: float, damping: float, h: float) -> tuple[float, float, float]:
    """Rate, mass and give of a damped spring solved implicitly over h (Catto 2011, "Soft constraints").

    hertz 0: no spring at all (rate 0, all of the mass, nothing given back).
    """
    if hertz <= 0.0:
        return 0.0, 1.0, 0.0
    omega = 2.0 * math.pi * hertz
    a1 = 2.0 * damping + h * omega
    a2 = h * omega * a1
    return omega / a1, a2 / (1.0 + a2), 1.0 / (1.0 + a2)


@dataclass(frozen=True, slots=True)
class SolidSettings:
    """What a step does. ValueError, naming the field, for nonsense; change it by `dataclasses.replace`.

    effects: of `SOLIDS`. solver: a name of `SOLVERS`. substeps: parts of a step. iterations: sweeps of a
    substep, by solvers that have them. gravity: (x, y) m/s². drag, spin_drag: 1/s. contact_hertz: of soft
    contacts, at most a quarter of the substeps a second; 0: USUAL_HERTZ of them (a pyramid of 100 rows stands
    at that, not at a quarter); contact_damping: of critical. joint_hertz, joint_damping: of joints without a
    compliance of their own; 0: half as many as substeps a second for sweeps, stiff for the direct solve.
    joint_solver: direct (all joints at once) or sweeps. push: m/s, fastest parting of what overlaps. bounce:
    m/s, slower impacts do not bounce; impact_law: of IMPACT_LAWS. near: m, gap of a contact that is prepared;
    recycle: of it, how far two may move before their manifold is found again, 0 for always. slop: m. calm:
    m/s and patience: s of sleep.
    """

    effects: EffectSet = USUAL
    solver: str = "soft-step"
    substeps: int = 4
    iterations: int = 1
    gravity: tuple[float, float] = (0.0, -9.81)
    drag: float = 0.0
    spin_drag: float = 0.0
    contact_hertz: float = 0.0
    contact_damping: float = 10.0
    joint_hertz: float = 0.0
    joint_damping: float = 2.0
    joint_solver: str = "direct"
    push: float = 3.0
    bounce: float = 1.0
    impact_law: str = "energetic"
    near: float = 0.02
    recycle: float = 0.25
    slop: float = 0.005
    calm: float = 0.01
    patience: float = 0.5

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", SOLIDS.checked(self.effects))
        for name in ("substeps", "iterations"):
            turns = getattr(self, name)
            if isinstance(turns, bool) or not isinstance(turns, int) or not 1 <= turns <= MOST_TURNS:
                raise ValueError(f"{name} = {turns!r}: expected a whole number, 1 to {MOST_TURNS}")
        if self.joint_solver not in JOINT_SOLVERS:
            raise ValueError(
                f"joint_solver = {self.joint_solver!r}: expected one of {', '.join(JOINT_SOLVERS)}"
            )
        if self.impact_law not in IMPACT_LAWS:
            raise ValueError(f"impact_law = {self.impact_law!r}: expected one of {', '.join(IMPACT_LAWS)}")
        limits = {
            "drag": (0.0, 1e6),
            "spin_drag": (0.0, 1e6),
            "contact_hertz": (0.0, 1e6),
            "contact_damping": (0.0, 1e3),
            "joint_hertz": (0.0, 1e6),
            "joint_damping": (0.0, 1e3),
            "push": (0.0, 1e6),
            "bounce": (0.0, 1e6),
            "near": (1e-9, 1e3),
            "recycle": (0.0, 0.5),
            "slop": (0.0, 1e3),
            "calm": (0.0, 1e3),
            "patience": (0.0, 1e6),
        }
        for name, (least, most) in limits.items():
            value = getattr(self, name)
            if not least <= value <= most:
                raise ValueError(f"{name} = {value!r}: expected {least:g} to {most:g}")
        pull = tuple(self.gravity)
        if len(pull) != 2 or not all(abs(part) <= 1e6 for part in pull):
            raise ValueError(f"gravity = {self.gravity!r}: expected two numbers, m/s²")

    def numbers(self, dt: float) -> Numbers:
        """For the kernels of a step of dt (s)."""
        mask = SOLIDS.mask(self.effects)
        h = dt / self.substeps
        hertz = min(self.contact_hertz or USUAL_HERTZ / h, 0.25 / h)
        x, y = (float(part) if mask & GRAVITY_BIT else 0.0 for part in self.gravity)
        dragging = bool(mask & DRAG_BIT)
        return Numbers(
            mask, self.substeps, self.iterations, float(dt), h, x, y,
            float(self.drag) if dragging else 0.0, float(self.spin_drag) if dragging else 0.0,
            float(self.near), float(self.recycle), elementary.square(2.0 * math.pi * hertz),
            *soft(hertz, self.contact_damping, h), *soft(2.0 * hertz, self.contact_damping, h),
            self.joint_solver == "direct", *self._joint_spring(h),
            float(self.push), float(self.bounce) if mask & RESTITUTION_BIT else math.inf,
            IMPACT_LAWS.index(self.impact_law), float(self.slop),
            1.0 if mask & FRICTION_BIT and mask & CONTACTS_BIT else 0.0, self.solver == GOVERNED,
            float(self.calm), self.solver in ABREAST, float(self.patience),
        )  # fmt: skip

    def _joint_spring(self, h: float) -> tuple[float, float, float]:
        """Rate, mass and give of joints without a compliance of their own."""
        if self.joint_hertz == 0.0 and self.joint_solver == "direct":
            return JOINT_RATE / h, 1.0, 0.0
        return soft(self.joint_hertz or 0.125 / h, self.joint_damping, h)

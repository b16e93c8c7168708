"""What a step of colliding spheres does, and the materials that it meets."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.effects import EffectSet
from game.physics.spheres.composition import Composition, whole_numbers
from game.physics.spheres.effects import DRAG_BIT, FRICTION_BIT, GRAVITY_BIT, SPHERES, USUAL

SCHEMES = ("explicit-euler", "semi-implicit", "exact-flight")
LAGS = {"explicit-euler": 0.0, "semi-implicit": 1.0, "exact-flight": 0.5}  # c in x = v t - c g t²
LAWS = ("in-turn", "at-once")
CORRECTIONS = ("none", "baumgarte", "soft", "split", "projection")
PATHS = ("auto", "general", "planar")
BAUMGARTE = 0.2  # part of an overlap that becomes speed in one step
SOFT_HERTZ, SOFT_DAMPING, SOFT_PUSH = 30.0, 10.0, 3.0  # Hz, of critical, m/s: as Box2D 3 has them
WARMEST = 4.0  # most that a long part may make of the impulses of a short one before it
SHARES = {"projection": 0.4, "split": 0.3}  # of an overlap: taken away by a sweep, or by a step
MOST_SHIFT = 0.3  # of the smallest radius: no sweep corrects more
MOST_TURNS = 10_000


class Tables(NamedTuple):
    """Restitution and Coulomb friction (k + 1, k + 1) of each pair of k materials; the last one is walls."""

    restitution: NDArray[np.float64]
    friction: NDArray[np.float64]


class Surroundings(NamedTuple):
    """What nothing moves: window (4,) m as x0 y0 x1 y1, ledges (k, 4) m as x0 y0 x1 y1, and strings.

    hung: (c,) the sphere on each string. strings: (c, 4) m: where it is tied (x, y, z), and its length.
    """

    window: NDArray[np.float64]
    ledges: NDArray[np.float64]
    hung: NDArray[np.int64]
    strings: NDArray[np.float64]


class World(NamedTuple):
    """What a step meets and leaves as it is: what bodies are made of, what surrounds and what pulls them."""

    composition: Composition
    surroundings: Surroundings
    tables: Tables
    pulls: NDArray[np.float64]  # (n, 6) forces N and torques N m


class Numbers(NamedTuple):
    """The numbers of a step, for its kernels."""

    h: float  # s
    nominal: float  # s, length of an undivided substep
    gravity: float  # m/s² downwards
    drag: float  # N s/m
    rest: float  # see impulses.rest_speed; 0 lets everything bounce
    rough: float  # 1, or 0 without friction
    carry: float  # of the last step's impulses, as warm start
    push: float  # 1/s, speed given to each metre of overlap
    push_limit: float  # m/s
    softness: float
    slop: float  # m of overlap that is left alone
    share: float  # of an overlap: see SHARES
    most_shift: float  # m
    rounds: int
    iterations: int
    passes: int
    law: int
    correction: int
    scheme: int
    lag: float  # c in x = v t - c g t², of the scheme
    fast: float  # radii that a sphere moves at least in a step for its impacts to be timed
    mask: int  # bits of its effects


@dataclass(frozen=True, slots=True)
class CollisionSettings:
    """What a step does. ValueError, naming the field, for nonsense; change it by `dataclasses.replace`.

    effects: of `SPHERES`. scheme: of SCHEMES, for the motion. law: of LAWS, for collisions. correction: of
    CORRECTIONS, of overlap. iterations: sweeps of the impulses of resting contacts; passes: of position
    correction; rounds: of collisions, at most. substeps: parts of a step. gravity: m/s². drag: N s/m.
    slop: of the smallest radius. rest: resting speed over g h / (1 - e²). warm: begin with the last impulses.
    path: of PATHS, which kernels. fast: impact times only of what moves more than so many radii in a step.
    """

    effects: EffectSet = USUAL
    scheme: str = "explicit-euler"
    law: str = "in-turn"
    correction: str = "split"
    iterations: int = 10
    passes: int = 3
    rounds: int = 200
    substeps: int = 1
    gravity: float = 9.81
    drag: float = 0.0
    slop: float = 0.01
    rest: float = 4.0
    warm: bool = True
    path: str = "auto"
    fast: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "effects", SPHERES.checked(self.effects))
        options = {"scheme": SCHEMES, "law": LAWS, "correction": CORRECTIONS, "path": PATHS}
        for name, allowed in options.items():
            if getattr(self, name) not in allowed:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected one of {', '.join(allowed)}")
        for name in ("iterations", "passes", "rounds", "substeps"):
            turns, least = getattr(self, name), 0 if name == "passes" else 1
            if isinstance(turns, bool) or not isinstance(turns, int) or not least <= turns <= MOST_TURNS:
                raise ValueError(f"{name} = {turns!r}: expected a whole number, {least} to {MOST_TURNS}")
        limits = {
            "gravity": (-1e4, 1e4),
            "drag": (0.0, 1e9),
            "slop": (0.0, 0.5),
            "rest": (0.0, 1e3),
            "fast": (0.0, 1e3),
        }
        for name, (least_value, most) in limits.items():
            if not least_value <= getattr(self, name) <= most:
                raise ValueError(f"{name} = {getattr(self, name)!r}: expected {least_value:g} to {most:g}")

    def numbers(self, h: float, nominal: float, before: float, radius: float) -> Numbers:
        """For kernels: a part of h (s) of a substep of nominal length, after one of ``before``."""
        push = push_limit = softness = 0.0
        if self.correction == "baumgarte":
            push, push_limit = BAUMGARTE / nominal, 1e9
        elif self.correction == "soft":
            omega = 2.0 * math.pi * min(SOFT_HERTZ, 0.25 / nominal)
            reach = 2.0 * SOFT_DAMPING + nominal * omega
            push, push_limit = omega / reach, SOFT_PUSH
            softness = 1.0 / (1.0 + nominal * omega * reach)
        mask = SPHERES.mask(self.effects)
        return Numbers(
            float(h), float(nominal),
            float(self.gravity) if mask & GRAVITY_BIT else 0.0,
            float(self.drag) if mask & DRAG_BIT else 0.0,
            float(self.rest), 1.0 if mask & FRICTION_BIT else 0.0,
            min(h / before, WARMEST) if self.warm and before > 0.0 else 0.0,
            push, push_limit, softness, self.slop * radius,
            SHARES.get(self.correction, 0.0), MOST_SHIFT * radius, self.rounds, self.iterations,
            self.passes if self.correction in ("split", "projection") else 0,
            LAWS.index(self.law), CORRECTIONS.index(self.correction), SCHEMES.index(self.scheme),
            LAGS[self.scheme], float(self.fast), mask,
        )  # fmt: skip


def material_tables(restitution: ArrayLike, friction: ArrayLike, count: int = 1) -> Tables:
    """Tables for ``count`` materials and walls, from one number or (count + 1, count + 1) each.

    ValueError unless restitution is 0 to 1 and friction 0 or more, both symmetric.
    """
    tables = []
    for name, values, most in (("restitution", restitution, 1.0), ("friction", friction, 100.0)):
        given = np.asarray(values, dtype=np.float64)
        if given.shape not in ((), (count + 1, count + 1)):
            raise ValueError(f"{name}: expected one number, or {count + 1} rows of {count + 1}")
        table = np.array(np.broadcast_to(given, (count + 1, count + 1)))
        if not ((table >= 0.0) & (table <= most)).all():
            raise ValueError(f"{name}: expected 0 to {most:g}")
        if not np.array_equal(table, table.T):
            raise ValueError(f"{name}: a with b must be as b with a")
        tables.append(table)
    return Tables(*tables)


def surroundings_of(
    window: ArrayLike = (-1e6, -1e6, 1e6, 1e6),
    ledges: ArrayLike = (),
    hung: ArrayLike = (),
    strings: ArrayLike = (),
) -> Surroundings:
    """Window, ledges and strings, checked; ValueError, naming what is wrong.

    window (4,): left, bottom, right, top, m; ledges (k, 4): both ends, m; hung (c,): spheres that hang from
    strings (c, 4): x, y, z where they are tied, and length, m.
    """
    box = np.array(window, dtype=np.float64)
    if box.shape != (4,) or not np.isfinite(box).all() or not (box[0] < box[2] and box[1] < box[3]):
        raise ValueError("window: expected left, bottom, right and top, left of right and below top")
    lines = np.array(ledges, dtype=np.float64).reshape(-1, 4)
    if not np.isfinite(lines).all():
        raise ValueError("ledges: expected finite numbers")
    length = np.abs(lines[:, 2:] - lines[:, :2]).max(axis=1, initial=0.0) if len(lines) else np.ones(0)
    if not (length > 1e-9).all():
        raise ValueError("ledges: expected two different ends")
    ties = np.array(strings, dtype=np.float64).reshape(-1, 4)
    spheres = whole_numbers("hung", hung).reshape(-1)
    if len(spheres) != len(ties) or not np.isfinite(ties).all() or not (ties[:, 3] > 0.0).all():
        raise ValueError("strings: expected a place and a length above 0 m for each sphere that hangs")
    return Surroundings(box, lines, spheres, ties)

"""Kinds of stars as a table: how each flies, how long it lives, and what is born of it, when and how.

peony = Kind("star", life_s=2.2, drag_per_m=0.03, burns=0.8)
shell = Kind("shell", life_s=3.0, births=(Birth("death", "star", count=120, speed_m_s=60.0),))
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

WHEN = ("birth", "death", "hit", "trail")
AT_BIRTH, AT_DEATH, AT_HIT, ALONG = range(4)
PATTERNS = ("sphere", "ring", "disc", "cone", "arms", "shape")
SPHERE, RING, DISC, CONE, ARMS, SHAPE = range(6)
MOST_KINDS = 64
MOST_CHILDREN = 4096
MOST_PLACES = 2**21

# columns of a kind's row
WEIGHT, LINEAR, QUADRATIC, EXHAUST, LIFE, LIFE_SPREAD, BURNS, DIES_ON_GROUND, REPORTS = range(9)
KIND_COLUMNS = 9
# columns of a birth's row
PARENT, OCCASION, CHILD, COUNT, RATE, PATTERN, SPEED, SPEED_SPREAD, INHERITED = range(9)
ANGLE, SPREAD, FIRST_POINT, SHAPE_POINTS, SCATTER = range(9, 14)
BIRTH_COLUMNS = 14


@dataclass(frozen=True, slots=True)
class Birth:
    """What is born of a star, and when.

    when: "birth", "death" (of age), "hit" (on the ground) or "trail" (along the way, ``rate_per_s``, the
    first at the parent's own birth). kind: name of what is born. count: how many at once. pattern: of their
    velocities about the parent's: "sphere" and "disc" (seen from the side), "ring" (tilted by ``angle_deg``,
    flattened by ``spread_deg``), "cone" (about ``angle_deg`` from the vertical, to each side by
    ``spread_deg``). "arms" are even, the first at ``angle_deg``. "shape" has ``points``, the longest of unit
    length. speed_m_s: with ``speed_spread`` (share) to each side. inherited: share of the parent's velocity.
    scatter_m_s: a further random velocity. In all patterns but cone, arms and shape stars come in opposite
    pairs, so that a burst keeps the momentum; count must then be even.
    """

    when: str
    kind: str
    count: int = 1
    rate_per_s: float = 0.0
    pattern: str = "sphere"
    speed_m_s: float = 0.0
    speed_spread: float = 0.0
    inherited: float = 1.0
    angle_deg: float = 0.0
    spread_deg: float = 0.0
    scatter_m_s: float = 0.0
    points: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, slots=True)
class Kind:
    """How one kind of star flies and ends.

    life_s: seconds, with ``life_spread`` (share, even chance) to each side. weight: share of gravity it
    feels, negative for what rises. linear_drag_per_s, drag_per_m: k and q of `flight`. burns: share of its
    mass that is gone at the end of its life. exhaust_m_s: speed of the gas a rocket throws out; needs
    ``burns``. grounded: it ends where it meets the ground. reports: its birth, burst or fall are listed for
    others. capacity: places kept for it.
    """

    name: str
    life_s: float = 1.0
    life_spread: float = 0.0
    weight: float = 1.0
    linear_drag_per_s: float = 0.0
    drag_per_m: float = 0.0
    burns: float = 0.0
    exhaust_m_s: float = 0.0
    grounded: bool = True
    reports: bool = False
    capacity: int = 1000
    births: tuple[Birth, ...] = ()


class Table(NamedTuple):
    """All kinds as kernels take them."""

    kinds: NDArray[np.float64]  # (kinds, KIND_COLUMNS)
    births: NDArray[np.float64]  # (births, BIRTH_COLUMNS), ordered by parent
    first: NDArray[np.int64]  # (kinds + 1,) first birth of each kind
    points: NDArray[np.float64]  # (points, 2) of all shapes
    begin: NDArray[np.int64]  # (kinds + 1,) first place of each kind in the pool


def make_table(kinds: Sequence[Kind]) -> Table:
    """The table of some kinds. ValueError names kind, field and reason for what makes no sense."""
    if not 1 <= len(kinds) <= MOST_KINDS:
        raise ValueError(f"kinds: expected 1 to {MOST_KINDS}, got {len(kinds)}")
    numbers = {kind.name: number for number, kind in enumerate(kinds)}
    if len(numbers) < len(kinds):
        raise ValueError("kinds: two have the same name")
    rows = np.zeros((len(kinds), KIND_COLUMNS))
    births: list[tuple[float, ...]] = []
    points: list[tuple[float, float]] = []
    first = [0]
    for number, kind in enumerate(kinds):
        _check_kind(kind)
        rows[number] = (
            kind.weight, kind.linear_drag_per_s, kind.drag_per_m, kind.exhaust_m_s, kind.life_s,
            kind.life_spread, kind.burns, kind.grounded, kind.reports,
        )  # fmt: skip
        for birth in kind.births:
            _check_birth(kind.name, birth, numbers)
            births.append(_birth_row(number, numbers[birth.kind], birth, len(points)))
            points += birth.points
        first.append(len(births))
    _check_cascade(kinds)
    return Table(
        rows,
        np.array(births, dtype=np.float64).reshape(-1, BIRTH_COLUMNS),
        np.array(first),
        np.array(points, dtype=np.float64).reshape(-1, 2),
        np.concatenate([[0], np.cumsum([kind.capacity for kind in kinds])]),
    )


def _birth_row(parent: int, child: int, birth: Birth, first_point: int) -> tuple[float, ...]:
    """One row of the table of births."""
    return (
        parent, WHEN.index(birth.when), child, birth.count, birth.rate_per_s, PATTERNS.index(birth.pattern),
        birth.speed_m_s, birth.speed_spread, birth.inherited, math.radians(birth.angle_deg),
        math.radians(birth.spread_deg), first_point, len(birth.points), birth.scatter_m_s,
    )  # fmt: skip


def _check_kind(kind: Kind) -> None:
    where = f"kind {kind.name!r}"
    _within(where, "life_s", kind.life_s, 1e-6, 1e6)
    _within(where, "life_spread", kind.life_spread, 0.0, 0.99)
    _within(where, "weight", kind.weight, -100.0, 100.0)
    _within(where, "linear_drag_per_s", kind.linear_drag_per_s, 0.0, 1e9)
    _within(where, "drag_per_m", kind.drag_per_m, 0.0, 1e9)
    _within(where, "burns", kind.burns, 0.0, 1.0)
    _within(where, "exhaust_m_s", kind.exhaust_m_s, 0.0, 1e5)
    if (
        isinstance(kind.capacity, bool)
        or not isinstance(kind.capacity, int)
        or not 1 <= kind.capacity <= 2**21
    ):
        raise ValueError(f"{where}: capacity = {kind.capacity!r}: expected 1 to {2**21}")
    if kind.exhaust_m_s > 0.0 and not 0.0 < kind.burns < 1.0:
        raise ValueError(f"{where}: burns = {kind.burns!r}: a rocket burns above 0 and below 1 of its mass")


def _check_birth(parent: str, birth: Birth, numbers: dict[str, int]) -> None:
    where = f"kind {parent!r}, birth of {birth.kind!r}"
    if birth.kind not in numbers:
        raise ValueError(f"{where}: there is no such kind")
    if birth.when not in WHEN:
        raise ValueError(f"{where}: when = {birth.when!r}: expected one of {', '.join(WHEN)}")
    if birth.pattern not in PATTERNS:
        raise ValueError(f"{where}: pattern = {birth.pattern!r}: expected one of {', '.join(PATTERNS)}")
    if (
        isinstance(birth.count, bool)
        or not isinstance(birth.count, int)
        or not 1 <= birth.count <= MOST_CHILDREN
    ):
        raise ValueError(f"{where}: count = {birth.count!r}: expected 1 to {MOST_CHILDREN}")
    paired = birth.when != "trail" and birth.count > 1 and birth.pattern in ("sphere", "ring", "disc")
    if paired and birth.count % 2:
        raise ValueError(f"{where}: count = {birth.count}: opposite pairs need an even number")
    _within(where, "rate_per_s", birth.rate_per_s, 1e-6 if birth.when == "trail" else 0.0, 1e6)
    _within(where, "speed_m_s", birth.speed_m_s, 0.0, 1e5)
    _within(where, "speed_spread", birth.speed_spread, 0.0, 1.0)
    _within(where, "inherited", birth.inherited, -1.0, 1.0)
    _within(where, "angle_deg", birth.angle_deg, -360.0, 360.0)
    _within(where, "spread_deg", birth.spread_deg, 0.0, 180.0)
    _within(where, "scatter_m_s", birth.scatter_m_s, 0.0, 1e5)
    if (birth.pattern == "shape") != bool(birth.points):
        raise ValueError(f"{where}: points: expected for the pattern shape, and only for it")
    if not all(math.isfinite(number) for point in birth.points for number in point):
        raise ValueError(f"{where}: points: expected finite numbers")


def _check_cascade(kinds: Sequence[Kind]) -> None:
    """What is born of itself at once would never end: at birth no kind may lead back to itself."""
    born = {kind.name: {birth.kind for birth in kind.births if birth.when == "birth"} for kind in kinds}
    for name in born:
        seen, todo = set(), [name]
        while todo:
            for child in born[todo.pop()]:
                if child == name:
                    raise ValueError(f"kind {name!r}: is born at its own birth, which has no end")
                if child not in seen:
                    seen.add(child)
                    todo.append(child)


def _within(where: str, field: str, value: float, lowest: float, highest: float) -> None:
    """ValueError unless a number lies between two others."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not lowest <= value <= highest:
        raise ValueError(f"{where}: {field} = {value!r}: expected {lowest:g} to {highest:g}")


def _whole(where: str, field: str, value: int, most: int) -> None:
    """ValueError unless a number is whole and from 1 to another."""
    if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= most:
        raise ValueError(f"{where}: {field} = {value!r}: expected 1 to {most}")

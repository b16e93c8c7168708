"""What a level file of the lecture's table may say, and the balls that it puts on the cloth."""

from __future__ import annotations

from typing import Annotated, Literal, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.lecture.table import LectureTable as Lecture
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS, eight_ball_rack
from game.billiards.table.table import BED_LENGTH, BED_WIDTH, Table
from game.physics.kernels import elementary, linear
from game.scenes.shared.tables.level import BallEntry

Length = Annotated[float, msgspec.Meta(ge=1e-6, le=20.0)]  # m


class StrokeEntry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """A stroke that the level plays by itself."""

    speed: Annotated[float, msgspec.Meta(ge=0.0, le=1e4)]  # m/s
    angle_deg: Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)] = 90.0  # from the x axis, across the table
    after_s: Annotated[float, msgspec.Meta(ge=0.0, le=60.0)] = 1.0


class LectureTableContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a lecture-table level: a rack or single balls, on a pool table or a plain box."""

    table: Literal["pool", "box"] = "pool"
    width: Length = BED_WIDTH  # of a box
    length: Length = BED_LENGTH
    rack: bool = True
    rack_gap: Annotated[float, msgspec.Meta(ge=-0.01, le=0.02)] = 0.0  # m; below 0 the rack is compressed
    balls: Annotated[list[BallEntry], msgspec.Meta(max_length=200)] = []
    stroke: StrokeEntry | None = None
    plays_itself: bool = False  # goes on with strokes of its own until a person takes the cue


class Layout(NamedTuple):
    """Balls as arrays: numbers (n,), positions (n, 2) m, velocities (n, 2) m/s, radii (n,) m, masses (n,)."""

    table: Table
    numbers: NDArray[np.int64]
    positions: Floats
    velocities: Floats
    radii: Floats
    masses: Floats


def layout_of(content: LectureTableContent, radius_spread: float, mass_spread: float, seed: int) -> Layout:
    """The balls of a level; spreads (0 to 0.4) vary numbered balls of a rack about the pool measures.

    Ball 0, the cue ball, is row 0 if there is one. ValueError if a ball is there twice or lies outside.
    """
    table = Table.pool() if content.table == "pool" else Table.bare(content.width, content.length)
    rows = list(content.balls)
    taken = [row.number for row in rows]
    if content.table == "pool" and len(set(taken)) != len(taken):
        double = next(number for number in taken if taken.count(number) > 1)
        raise ValueError(f"balls: number {double} is there twice")
    if content.rack and not rows:
        return _racked(table, content.rack_gap, radius_spread, mass_spread, seed)
    rows.sort(key=lambda row: row.number != 0)
    for row in rows:
        inside = all(
            0.0 <= at <= edge for at, edge in zip(row.position, (table.width, table.length), strict=True)
        )
        if not inside:
            raise ValueError(f"balls: number {row.number} at {row.position} lies outside the bed")
    if not rows:
        raise ValueError("balls: a level without a rack needs at least one ball")
    return Layout(
        table,
        np.array([row.number for row in rows]),
        np.array([row.position for row in rows], dtype=np.float64),
        np.array([row.velocity for row in rows], dtype=np.float64),
        np.array([row.radius for row in rows]),
        np.array([row.mass for row in rows]),
    )


def _racked(table: Table, gap: float, radius_spread: float, mass_spread: float, seed: int) -> Layout:
    """A full rack; with spreads, balls of many sizes in the places of a rack wide enough for the largest."""
    radii = np.full(16, BALL_RADIUS)
    masses = np.full(16, BALL_MASS)
    random = np.random.default_rng(seed)
    radii[1:] *= 1.0 + radius_spread * linear.uniform(random, -1.0, 1.0, 15)
    masses[1:] *= elementary.cube(radii[1:] / BALL_RADIUS) * (
        1.0 + mass_spread * linear.uniform(random, -1.0, 1.0, 15)
    )
    if gap < 0.0:  # a rack pressed together by force: what a resolution pass has to repair
        positions = eight_ball_rack(table)
        apex = positions[1].copy()
        positions[1:] = apex + (positions[1:] - apex) * (1.0 + gap / (2.0 * BALL_RADIUS))
    else:
        positions = eight_ball_rack(table, float(radii.max()), gap)
    return Layout(table, np.arange(16), positions, np.zeros((16, 2)), radii, masses)


def content_of(
    table: Lecture, numbers: NDArray[np.int64], base: LectureTableContent, plays_itself: bool
) -> LectureTableContent:
    """The table as it is now; ``base``: the level that it began with."""
    state = table.state
    rows = [
        BallEntry(
            number=int(numbers[i]),
            position=(float(x), float(y)),
            velocity=(float(state.velocities[i, 0]), float(state.velocities[i, 1])),
            radius=float(state.radii[i]),
            mass=float(table.masses[i]),
        )
        for i, (x, y) in enumerate(table.positions.tolist())
        if state.in_play[i]
    ]
    return LectureTableContent(
        table=base.table,
        width=base.width,
        length=base.length,
        rack=False,
        balls=rows,
        plays_itself=plays_itself,
    )

"""What the lecture's table consists of: effects, and its state as arrays.

Positions are kept as offsets from the middle of the table: there a mirror image only changes signs, so a
rack and its mirror image step alike to the last bit. What the table's own measures lost in rounding is
given back once, by putting them on a grid of a picometre.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.billiards.laws.joint import ContactGraph, JointScratch, joint_scratch
from game.billiards.table.table import Table
from game.physics.effects import Room, declare_effect

WALLS = declare_effect("walls", "Walls", "Balls rebound from cushions and jaws.")
BALL_COLLISIONS = declare_effect("ball-collisions", "Ball collisions", "Balls push one another.")
FRICTION = declare_effect("cloth-friction", "Friction", "Speed shrinks by a factor each frame.")
MINIMUM_SPEED = declare_effect("minimum-speed", "Stopping", "What is slower than a minimum rests.")
POCKETS = declare_effect("pockets", "Pockets", "Cushions open, and the holes take balls.")
ROLLING = declare_effect("rolling", "Rolling", "Numbers and stripes turn with the motion.")
LECTURE_EFFECTS = WALLS | BALL_COLLISIONS | FRICTION | MINIMUM_SPEED | POCKETS | ROLLING
LECTURE = Room("lecture tables", LECTURE_EFFECTS)

MAX_BALLS = 4_096
MAX_COORDINATE = 1e6  # m
GRID = 2.0**-40  # m; jaws, pockets and the ends of cushions are put on multiples of it
EVENT_CAPACITY = 512

# events: columns and kinds
KIND, FIRST, SECOND, TIME, SPEED, IMPULSE, EVENT_X, EVENT_Y = range(8)
BALL_BALL, BALL_CUSHION, BALL_JAW, BALL_POCKET = range(4)
EVENT_NAMES = ("ball-ball", "cushion", "jaw", "pocket")
# counters
EVENTS, EVENTS_LOST, SUBSTEPS, PAIR_TESTS, CONTACTS, ROUNDS, ITERATIONS, NOT_FINITE = range(8)


class LectureState(NamedTuple):
    """All that a step reads and changes; row i is ball i.

    offsets (n, 2) m from the middle of the table. velocities (n, 2) m/s. orientations (n, 4): unit
    quaternions, scalar first, body to table. in_play (n,) bool. pocketed_by (n,) int: row of the pocket, or
    -1. radii (n,) m. inverse_masses (n,) 1/kg, 0 does not yield.
    """

    offsets: Floats
    velocities: Floats
    orientations: Floats
    in_play: NDArray[np.bool_]
    pocketed_by: NDArray[np.int64]
    radii: Floats
    inverse_masses: Floats


class LectureGeometry(NamedTuple):
    """The table about its middle: half width and length (m), cushions (c, 6), jaws (j, 3), pockets (p, 3)."""

    half_width: float
    half_length: float
    cushions: Floats
    jaws: Floats
    pockets: Floats


class Journal(NamedTuple):
    """What a step reports: events (EVENT_CAPACITY, 8), counters (8,)."""

    events: Floats
    counters: NDArray[np.int64]


class ContactList(NamedTuple):
    """Contacts of one substep, and scratch arrays to solve them in.

    graph: second is a ball, or -1 - row of a wall (cushions first, then jaws). gaps (m,) m. restitutions
    (m,). impulses (m,) N s. scratch: see joint.py.
    """

    graph: ContactGraph
    gaps: Floats
    restitutions: Floats
    impulses: Floats
    scratch: JointScratch


class LectureScratch(NamedTuple):
    """Arrays that a step works in, few because each costs time to hand over.

    events and counters: see Journal. rolled (n, 2) m. links (2, m): first, second. columns (3, m): gaps,
    restitutions, impulses. normals (m, 2). work and sums: the two of JointScratch.
    """

    events: Floats
    counters: NDArray[np.int64]
    rolled: Floats
    links: NDArray[np.int64]
    columns: Floats
    normals: Floats
    work: Floats
    sums: Floats


def checked_rows(name: str, value: ArrayLike, rows: int, columns: int, limit: float) -> Floats:
    """A (rows, columns) float64 copy. ValueError if shape, finiteness or |entries| <= limit fail."""
    try:
        array = np.array(value, dtype=np.float64, order="C")
    except (TypeError, ValueError):
        raise ValueError(f"{name}: must be numbers") from None
    if array.shape != (rows, columns):
        raise ValueError(f"{name}: must have shape ({rows}, {columns}), got {array.shape}")
    good = np.isfinite(array) & (np.abs(array) <= limit)
    if not good.all():
        row, column = np.argwhere(~good)[0]
        raise ValueError(f"{name}[{row}]: must be finite and at most {limit:g}, got {array[row, column]!r}")
    return array


def checked_column(name: str, value: ArrayLike, rows: int, low: float, high: float) -> Floats:
    """A (rows,) float64 copy of a column or a single number, each above `low` and at most `high`.

    ValueError naming the field, and the row that is out of range.
    """
    try:
        array = np.array(np.broadcast_to(np.asarray(value, dtype=np.float64), (rows,)))
    except (TypeError, ValueError):
        raise ValueError(f"{name}: must be one number or {rows} numbers") from None
    good = (array > low) & (array <= high)
    if not good.all():
        row = int(np.argmin(good))
        raise ValueError(f"{name}[{row}]: must be above {low:g} and at most {high:g}, got {array[row]!r}")
    return array


def _about_middle(points: Floats, half: Floats) -> Floats:
    """Points (k, 2) from the middle of the table, on the grid unless they lie on the edge of the bed."""
    offsets = points - half
    return np.where(
        np.abs(np.abs(offsets) - half) < GRID, np.copysign(half, offsets), np.rint(offsets / GRID) * GRID
    )


def geometry_of(table: Table, open_at_pockets: bool) -> LectureGeometry:
    """The table about its middle. Without open pockets its rails are the four sides of the bed, unbroken.

    ValueError if the table is larger than MAX_COORDINATE.
    """
    if max(table.width, table.length) > MAX_COORDINATE:
        raise ValueError(f"table: width and length must be at most {MAX_COORDINATE:g} m")
    half = np.array([0.5 * table.width, 0.5 * table.length])
    half_width, half_length = float(half[0]), float(half[1])
    if open_at_pockets and len(table.pockets):
        cushions, jaws, pockets = table.cushions.copy(), table.jaws.copy(), table.pockets.copy()
        cushions[:, 0:2] = _about_middle(cushions[:, 0:2], half)
        cushions[:, 2:4] = _about_middle(cushions[:, 2:4], half)
        jaws[:, 0:2] = _about_middle(jaws[:, 0:2], half)
        pockets[:, 0:2] = _about_middle(pockets[:, 0:2], half)
        return LectureGeometry(half_width, half_length, cushions, jaws, pockets)
    far = 4.0 * MAX_COORDINATE  # a ball that overshoots a corner is beyond both sides
    sides = [
        [-half_width, -far, -half_width, far, 1.0, 0.0],
        [half_width, far, half_width, -far, -1.0, 0.0],
        [far, -half_length, -far, -half_length, 0.0, 1.0],
        [-far, half_length, far, half_length, 0.0, -1.0],
    ]
    nothing = np.empty((0, 3))
    cushions = np.array(sides) if len(table.cushions) else np.empty((0, 6))
    return LectureGeometry(half_width, half_length, cushions, nothing, nothing)


def scratch_for(balls: int) -> LectureScratch:
    """Scratch arrays for so many balls: all pairs of a few, eight contacts each of many."""
    capacity = min(balls * (balls - 1) // 2, 8 * balls) + 4 * balls
    work, sums = joint_scratch(balls, capacity)
    return LectureScratch(
        events=np.zeros((EVENT_CAPACITY, 8)),
        counters=np.zeros(8, dtype=np.int64),
        rolled=np.zeros((balls, 2)),
        links=np.zeros((2, capacity), dtype=np.int64),
        columns=np.zeros((3, capacity)),
        normals=np.zeros((capacity, 2)),
        work=work,
        sums=sums,
    )

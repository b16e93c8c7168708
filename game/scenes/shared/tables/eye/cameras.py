"""Where the eye stands: behind the cue ball, or at the side from which a stroke is seen best."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.table.table import Table
from game.ui.painters.perspective.eye import Eye, room_heading, room_points

BACK = 0.70  # m behind the cue ball
BALL_LOW = 0.27  # of the picture's height that the cue ball lies below its middle
FOCAL = 1.2  # of the picture's width
SIDE_RISE = math.radians(33.0)  # how high a camera at the side stands, seen from what it looks at
NEAREST, FARTHEST, PACE = 0.7, 5.0, 0.1  # m of such a camera
WITHIN = 0.38  # of the picture to each side of its middle that may be used
IN_THE_WAY = 0.06  # m before a path, from which on a ball may hide it
CLOSER = 1.35  # times, of a camera that follows a ball


class Room(NamedTuple):
    """The rectangle px that a camera fills: left, top, width, height."""

    left: float
    top: float
    width: float
    height: float

    @property
    def middle(self) -> tuple[float, float]:
        """Its middle, px."""
        return self.left + 0.5 * self.width, self.top + 0.5 * self.height


def behind(
    table: Table, place: tuple[float, float], azimuth: float, eye: tuple[float, float], room: Room
) -> Eye:
    """The eye over the cue. place: of the cue ball, m; azimuth: of the stroke, rad of the table's frame.

    eye: height, m, and how much farther it looks down, rad.
    """
    height, lower = eye
    (x, y, _), heading = (
        room_points(np.array((place,)), 0.0, table.width, table.length)[0],
        room_heading(azimuth),
    )
    focal = FOCAL * room.width
    tilt = math.atan2(height, BACK) - math.atan(BALL_LOW * room.height / focal) + lower
    return Eye(
        float(x) - BACK * math.cos(heading), float(y) - BACK * math.sin(heading), height, heading, tilt,
        focal, *room.middle,
    )  # fmt: skip


def looking(place: Floats, at: Floats, room: Room, closer: float = 1.0) -> Eye:
    """An eye at a place (3,) m of the room that has another (3,) in its middle."""
    dx, dy, dz = (at - place).tolist()
    tilt = math.atan2(-dz, math.hypot(dx, dy))
    x, y, z = place.tolist()
    return Eye(x, y, z, math.atan2(dy, dx), tilt, closer * FOCAL * room.width, *room.middle)


def beside(path: Floats, others: Floats, room: Room) -> Eye:
    """The eye that sees a path broadside: at right angles to it, on the side where fewer balls hide it.

    path (n, 3) m of the room, what has to be in view, from its first point to its last; others (k, 3): balls
    at rest. Of two sides alike it is that of the picture's foot, so that left stays left.
    """
    along = path[-1, :2] - path[0, :2]
    length = float(np.sqrt(along @ along))
    along = along / length if length > 1e-6 else np.array((1.0, 0.0))
    middle = 0.5 * (path.min(axis=0) + path.max(axis=0))
    sides = [np.array((along[1], -along[0])), np.array((-along[1], along[0]))]
    sides.sort(key=lambda side: (_hides(path, others, along, side), float(side[1])))
    away = np.array((*(math.cos(SIDE_RISE) * sides[0]), math.sin(SIDE_RISE)))
    for step in range(int((FARTHEST - NEAREST) / PACE)):
        eye = looking(middle + away * (NEAREST + PACE * step), middle, room)
        if _holds(eye, path, room):
            break
    return eye


def _hides(path: Floats, others: Floats, along: Floats, side: Floats) -> int:
    """How many balls stand before a path, seen from a side."""
    if len(others) == 0:
        return 0
    before = (others[:, :2] - path[:, :2].mean(axis=0)) @ side
    across = (others[:, :2] - path[0, :2]) @ along
    reach = (path[:, :2] - path[0, :2]) @ along
    return int(np.count_nonzero((before > IN_THE_WAY) & (across > reach.min()) & (across < reach.max())))


def _holds(eye: Eye, points: Floats, room: Room) -> bool:
    """Whether all points are well in view."""
    seen = eye.seen(points)
    x, y = room.middle
    return bool(
        (seen[:, 2] > 0.1).all()
        and (np.abs(seen[:, 0] - x) < WITHIN * room.width).all()
        and (np.abs(seen[:, 1] - y) < WITHIN * room.height).all()
    )

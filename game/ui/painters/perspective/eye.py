"""A pinhole camera over a table: where it stands, where it looks, and what it sees at which pixel.

The room's frame has its origin in the middle of the bed. x goes along the table, to the right as it is seen
from above. y goes across it, upwards there, and z is the height over the cloth. All m.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats

NEAREST = 0.02  # m before the eye; what is nearer is not seen
TO_ROOM = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # the table's frame turned


class Eye(NamedTuple):
    """A camera without roll.

    x, y, z: place, m. heading: direction of view, rad from x. tilt: how far it looks down, rad. focal: px.
    middle_x, middle_y: pixel at which it looks.
    """

    x: float
    y: float
    z: float
    heading: float
    tilt: float
    focal: float
    middle_x: float
    middle_y: float

    def numbers(self) -> Floats:
        """What kernels take (10,): place, cosine and sine of heading and tilt, focal length, middle."""
        return np.array((
            self.x, self.y, self.z, math.cos(self.heading), math.sin(self.heading), math.cos(self.tilt),
            math.sin(self.tilt), self.focal, self.middle_x, self.middle_y,
        ))  # fmt: skip

    def seen(self, points: Floats) -> Floats:
        """Points (n, 3) m of the room as (right px, down px, depth m), (n, 3); depths before NEAREST count.

        The pixel of a point that is not before the eye has no meaning.
        """
        away = np.asarray(points, float).reshape(-1, 3) - (self.x, self.y, self.z)
        c, s, low, deep = (*_turn(self.heading), *_turn(self.tilt))
        ahead = c * away[:, 0] + s * away[:, 1]
        aside = s * away[:, 0] - c * away[:, 1]
        depth = low * ahead - deep * away[:, 2]
        up = deep * ahead + low * away[:, 2]
        scale = self.focal / np.maximum(depth, NEAREST)
        return np.stack((self.middle_x + scale * aside, self.middle_y - scale * up, depth), axis=1)

    def at(self, x: float, y: float, z: float) -> tuple[float, float]:
        """The pixel of a point that lies before the eye."""
        right, down, _ = self.seen(np.array(((x, y, z),)))[0].tolist()
        return right, down

    def chain(self, points: Floats) -> list[Floats]:
        """A chain of points (n, 3) m as pieces (k, 2) px: what lies before the eye, cut where it leaves."""
        seen = self.seen(points)
        if (seen[:, 2] >= NEAREST).all():
            return [np.ascontiguousarray(seen[:, :2])]
        pieces: list[Floats] = []
        open_piece: list[tuple[float, float]] = []
        for i in range(len(seen)):
            inside = seen[i, 2] >= NEAREST
            if i and inside != (seen[i - 1, 2] >= NEAREST):
                share = (NEAREST - seen[i - 1, 2]) / (seen[i, 2] - seen[i - 1, 2])
                cut = np.asarray(points[i - 1]) + share * (np.asarray(points[i]) - points[i - 1])
                open_piece.append(self.at(*cut.tolist()))
                if not inside:
                    pieces.append(np.array(open_piece))
                    open_piece = []
            if inside:
                open_piece.append((float(seen[i, 0]), float(seen[i, 1])))
        if len(open_piece) > 1:
            pieces.append(np.array(open_piece))
        return pieces


def _turn(angle: float) -> tuple[float, float]:
    """Cosine and sine."""
    return math.cos(angle), math.sin(angle)


def room_points(places: Floats, heights: Floats | float, width: float, length: float) -> Floats:
    """Places (n, 2) m of the table's frame, at heights (n,) m, in the room's frame: (n, 3) m."""
    places = np.asarray(places, float).reshape(-1, 2)
    points = np.empty((len(places), 3))
    points[:, 0] = places[:, 1] - 0.5 * length
    points[:, 1] = 0.5 * width - places[:, 0]
    points[:, 2] = heights
    return points


def room_heading(azimuth: float) -> float:
    """A direction of the table's frame (rad from its x axis) as one of the room."""
    return math.remainder(azimuth - 0.5 * math.pi, 2.0 * math.pi)

"""The hand: it turns the shape, or draws another."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary
from game.scenes.wind_tunnel.model import WindTunnelModel
from game.stage import Part, Pointer
from game.worlds.hands.curves import simplified

FINE = 0.0015  # of the tunnel's height: a drawn line keeps what is farther off than that
MOST_POINTS = 2_000
BACK = 0.25  # of how far a line went from its beginning: nearer than that it has come back


class WindTunnelHand(Part):
    """path: of an outline that is being drawn, m; turning: whether a drag turns, and the pointer's angle."""

    def __init__(self, model: WindTunnelModel):
        self.model = model
        self.path: list[tuple[float, float]] = []
        self.drawing, self.turning, self.bearing = False, False, 0.0

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = (event.x, event.y)
        if event.kind == "down" and event.button in (1, 3):
            draws = event.button == 3 or self.model.parameters.tool == "draw"
            self.drawing, self.turning = draws, not draws
            self.path, self.bearing = [point], self._bearing(point)
            if self.turning and self.model.sweep.running:
                self.turning = False
                return "The sweep turns it; stop it first."
        elif event.kind == "move" and self.drawing:
            far = 0.004 * self.model.tall
            if elementary.dist(point, self.path[-1]) > far and len(self.path) < MOST_POINTS:
                self.path.append(point)
        elif event.kind == "move" and self.turning:
            self._turn(point)
        elif event.kind == "up":
            drawn, self.drawing, self.turning = self.drawing, False, False
            if drawn:
                return self._finish()
        elif event.kind == "cancel":
            self.drawing, self.turning, self.path = False, False, []
        return ""

    def _bearing(self, point: tuple[float, float]) -> float:
        x, y = self.model.tunnel.settings.place
        return elementary.atan2(point[1] - y, point[0] - x)

    def _turn(self, point: tuple[float, float]) -> None:
        """By as much as the pointer has gone round the middle; a turn to the right raises the nose."""
        bearing = self._bearing(point)
        way = math.remainder(bearing - self.bearing, 2.0 * math.pi)
        self.bearing = bearing
        degrees = math.remainder(self.model.parameters.attack - math.degrees(way), 360.0)
        self.model.parameters.attack = degrees
        self.model.turn(degrees)

    def _finish(self) -> str:
        path, self.path = self.path, []
        if len(path) < 3:
            return "Draw once around the shape that you want."
        self.model.draw_outline(simplified(closed_path(np.array(path)), FINE * self.model.tall))
        return ""


def closed_path(points: Floats) -> Floats:
    """A drawn line (n, 2) m up to where, in its second half, it comes back to its beginning, if it does."""
    away = points - points[0]
    squares = (away * away).sum(axis=1)
    middle = len(points) // 2
    nearest = middle + int(np.argmin(squares[middle:]))
    came_back = squares[nearest] < BACK * BACK * float(np.max(squares))
    return points[: nearest + 1] if came_back else points

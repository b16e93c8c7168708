"""The hand at the show: a click fires a shell that bursts there, the other button bursts one at once, and the
listener is dragged along the bank."""

from __future__ import annotations

import math

from game.physics.kernels import elementary
from game.scenes.fireworks.aiming import LEAST_RISE
from game.scenes.fireworks.level import FARTHEST, Point
from game.scenes.fireworks.model import MUZZLE, FireworksModel
from game.stage import Part, Pointer

REACH = 7.0  # m, how near to the listener the pointer takes hold
HIGHEST = 1_000.0  # m


class FireworksHand(Part):
    """``held``: whether the listener is held."""

    def __init__(self, model: FireworksModel):
        self.model = model
        self.held = False

    def take(self, event: Pointer) -> str:
        """A pointer event in world coordinates; what there is to say about it, or ""."""
        point = (_within(event.x, FARTHEST), _within(event.y, HIGHEST))
        if event.kind == "down" and event.button == 1:
            if elementary.dist(point, self.model.listener_place()) < REACH:
                self.held = True
                return ""
            return self._fire(point)
        if event.kind == "down" and event.button == 3:
            if point[1] > 0.0:
                self.model.burst_at(self.model.parameters.shell, *self._in_space(point))
        elif event.kind == "move" and self.held:
            self.model.walk_to = point[0]
        elif event.kind in ("up", "cancel"):
            self.held = False
        return ""

    def _fire(self, point: Point) -> str:
        if point[1] < MUZZLE + LEAST_RISE:
            return f"Click {MUZZLE + LEAST_RISE:.0f} m above the shore or higher: there the shell bursts."
        at, depth = self._in_space(point)
        self.model.fire(self.model.parameters.shell, at, depth=depth)
        return ""

    def _in_space(self, point: Point) -> tuple[Point, float]:
        """The place (m) seen there in the plane through the middle of the fleet, and its depth (m)."""
        turn = math.radians(self.model.bearing)
        return (point[0] * elementary.cos(turn), point[1]), point[0] * elementary.sin(turn)


def _within(value: float, most: float) -> float:
    return min(max(value, -most), most)

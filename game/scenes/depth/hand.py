"""The hand: it drags and turns both shapes."""

from __future__ import annotations

import math

from game.physics.kernels import elementary
from game.scenes.depth.model import DepthModel
from game.stage import Part, Pointer

NOBODY = -1
NOTCH = math.radians(5.0)  # turn by a key
FARTHEST = 3.0  # m from the origin


class DepthHand(Part):
    """Which shape is held, 0 or 1, and how."""

    def __init__(self, model: DepthModel):
        self.model = model
        self.held, self.turning, self.chosen = NOBODY, False, 0
        self.before = (0.0, 0.0)  # m, of the pointer

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        point = (min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST))
        if event.kind == "down" and event.button in (1, 3):
            self.held = self.at(point)
            self.turning = event.shift or event.button == 3
            self.chosen = self.held if self.held != NOBODY else self.chosen
        elif event.kind == "move" and self.held != NOBODY:
            self._lead(point)
        elif event.kind in ("up", "cancel"):
            self.held = NOBODY
        self.before = point

    def at(self, point: tuple[float, float]) -> int:
        """The shape at a point, A before B; NOBODY where there is none."""
        for which, shape in enumerate((self.model.pair.a, self.model.pair.b)):
            x, y, turn = self.model.places[which].tolist()
            for part in shape.placed(x, y, turn):
                after = [*part[1:].tolist(), part[0].tolist()]
                if all(
                    (u - p) * (point[1] - q) >= (v - q) * (point[0] - p)
                    for (p, q), (u, v) in zip(part.tolist(), after, strict=True)
                ):
                    return which
        return NOBODY

    def _lead(self, point: tuple[float, float]) -> None:
        x, y, angle = self.model.places[self.held].tolist()
        if self.turning:
            first = elementary.atan2(self.before[1] - y, self.before[0] - x)
            now = elementary.atan2(point[1] - y, point[0] - x)
            self.turn(math.remainder(now - first, math.tau), self.held)
        else:
            x, y = x + point[0] - self.before[0], y + point[1] - self.before[1]
            self.model.put(self.held, (x, y, angle))

    def turn(self, by: float, which: int) -> None:
        """Turn a shape about its centroid, rad."""
        x, y, angle = self.model.places[which].tolist()
        self.model.put(which, (x, y, angle + by))

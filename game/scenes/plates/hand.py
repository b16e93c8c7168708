"""The hand: a click drops a plate, a drag throws it, the other button takes one away."""

from __future__ import annotations

from game.scenes.plates import model as m
from game.scenes.plates.model import PlatesModel
from game.stage import Part, Pointer

REACH = 0.04  # m, how near to a plate a click takes it as the one that is measured
THROW = 4.0  # 1/s: velocity for a drag's length


class PlatesHand(Part):
    """Where a drag began, and where it is; ``drags`` while it lasts."""

    def __init__(self, model: PlatesModel):
        self.model = model
        self.drags = False
        self.from_x = self.from_y = self.x = self.y = 0.0

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it, or ""."""
        at = (min(max(event.x, m.LEFT), m.RIGHT), min(max(event.y, m.FLOOR), m.CEILING))
        if event.kind == "down" and event.button == 3:
            number = self.model.near(at, 2.0 * REACH)
            if number >= 0:
                self.model.remove(number)
        elif event.kind == "down" and event.button == 1 and m.LEFT <= event.x <= m.RIGHT:
            number = self.model.near(at, REACH)
            if number >= 0:
                self.model.chosen = number
                return ""
            self.drags, self.from_x, self.from_y = True, *at
            self.x, self.y = at
        elif event.kind == "move" and self.drags:
            self.x, self.y = at
        elif event.kind == "up" and self.drags:
            self.drags = False
            return self._drop()
        elif event.kind == "cancel":
            self.drags = False
        return ""

    def _drop(self) -> str:
        if len(self.model.plates) >= m.MOST_PLATES:
            return f"At most {m.MOST_PLATES} plates: take some away with the right button."
        velocity = THROW * (self.x - self.from_x), THROW * (self.y - self.from_y)
        tilt = self.model.parameters.tilt
        self.model.add(self.model.own_plate(), (self.from_x, self.from_y), tilt, velocity, 0.0)
        return ""

"""The hand in the smoke: stirs, paints, sets fire, places and drags solids."""

from __future__ import annotations

from game.scenes.smoke.brush import paint, stir
from game.scenes.smoke.model import TALL, WIDE, SmokeModel
from game.stage import Part, Pointer

STRENGTH, FASTEST = 30.0, 6.0  # m/s of a push for a m of a drag; at most
Point = tuple[float, float]


class SmokeHand(Part):
    """point: where the button is down, m; before: where it was; solid: number of the disc that is dragged."""

    def __init__(self, model: SmokeModel):
        self.model = model
        self.point: Point | None = None
        self.before: Point = (0.0, 0.0)
        self.tool, self.solid = "stir", -1

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = min(max(event.x, 0.0), WIDE), min(max(event.y, 0.0), TALL)
        if event.kind == "down" and event.button in (1, 3):
            self.tool = "dye" if event.button == 3 else self.model.parameters.tool
            self.point = self.before = point
            return self._press(point)
        if event.kind == "move" and event.button and self.point is not None:
            self.point = point
            if self.tool in ("dye", "fire", "clear"):
                paint(self.model, point, self.tool)
        elif event.kind in ("up", "cancel"):
            self.point, self.solid = None, -1
            self.model.rest_solids()
        return ""

    def _press(self, point: Point) -> str:
        if self.tool in ("dye", "fire", "clear"):
            paint(self.model, point, self.tool)
        elif self.tool == "solid":
            self.solid = self.model.solid_at(point)
            if self.solid < 0:
                self.solid = self.model.add_solid(point, self.model.parameters.brush)
            if self.solid < 0:
                return "No more solids fit in."
        return ""

    def work(self, dt: float) -> None:
        """What the hand does in a step."""
        if self.point is None:
            return
        way = (self.point[0] - self.before[0], self.point[1] - self.before[1])
        if self.tool == "solid" and 0 <= self.solid < len(self.model.obstacles.rows):
            if way != (0.0, 0.0):
                self.model.lead_solid(self.solid, self.point, dt)
            else:
                self.model.rest_solids()
        elif self.tool == "stir" and way != (0.0, 0.0):
            push = [min(max(STRENGTH * part / dt / 60.0, -FASTEST), FASTEST) for part in way]
            stir(self.model, self.point, (push[0], push[1]))
        elif self.tool == "fire":
            paint(self.model, self.point, "fire")
        self.before = self.point

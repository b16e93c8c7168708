"""The hand at the fireplace: blows, drags wood, adds a log, holds a match, pours water."""

from __future__ import annotations

from game.scenes.fireplace.model import FireplaceModel
from game.scenes.fireplace.tables import HALF, TALL
from game.stage import Part, Pointer

LONGEST = 3.0  # m/s², that a quick drag blows with, a step
Point = tuple[float, float]


class FireplaceHand(Part):
    """point: where the button is down, m; before: where it was at the last event."""

    def __init__(self, model: FireplaceModel):
        self.model = model
        self.point: Point | None = None
        self.before: Point = (0.0, 0.0)
        self.moved: Point = (0.0, 0.0)

    def way(self) -> Point:
        """How far the pointer moved lately, m."""
        return self.moved

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        x, y = min(max(event.x, -HALF), HALF), min(max(event.y, 0.003), TALL)
        if event.kind == "down" and event.button in (1, 3):
            return self._press((x, y), "log" if event.button == 3 else self.model.parameters.tool)
        if event.kind == "move" and event.button and self.point is not None:
            self._move((x, y))
        elif event.kind in ("up", "cancel"):
            self.let_go()
        return ""

    def let_go(self) -> None:
        """Hold nothing."""
        self.model.let_go()
        self.point, self.moved = None, (0.0, 0.0)
        self.model.match.held = None

    def _press(self, point: Point, tool: str) -> str:
        self.let_go()
        if tool == "log":
            return "" if self.model.add_log(point) else "There is no room for more wood."
        self.point = self.before = point
        if tool == "drag":
            self.model.hold(point)
        elif tool == "match":
            self.model.match.held = point
        elif tool == "water":
            self.model.pour(point)
        return ""

    def _move(self, point: Point) -> None:
        x, y = self.before
        self.moved = (point[0] - x, point[1] - y)
        tool = self.model.parameters.tool
        if tool == "blow":
            self.model.blow(point, self.moved)
        elif tool == "drag":
            self.model.lead(point)
        elif tool == "match":
            self.model.match.held = point
        elif tool == "water":
            self.model.pour(point)
        self.point = self.before = point

"""The hand at the cloth: holds a match to it, writes, washes out, wets, drags it, blows."""

from __future__ import annotations

from game.scenes.burning_cloth.model import BurningClothModel
from game.scenes.burning_cloth.tables import HALF, TALL
from game.stage import Part, Pointer

Point = tuple[float, float]
NO_CLOTH = "There is no cloth here to write on."


class BurningClothHand(Part):
    """point: where the button is down, m; before: where it was at the last event."""

    def __init__(self, model: BurningClothModel):
        self.model = model
        self.point: Point | None = None
        self.before: Point = (0.0, 0.0)
        self.moved: Point = (0.0, 0.0)

    def way(self) -> Point:
        """How far the pointer moved lately, m."""
        return self.moved

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = min(max(event.x, -HALF), HALF), min(max(event.y, 0.003), TALL)
        if event.kind == "down" and event.button in (1, 3):
            self.let_go()
            self.point = self.before = point
            return self._act(point, "water" if event.button == 3 else self.model.parameters.tool, True)
        if event.kind == "move" and event.button and self.point is not None:
            self.moved = (point[0] - self.before[0], point[1] - self.before[1])
            self._act(point, "water" if event.button == 3 else self.model.parameters.tool, False)
            self.point = self.before = point
        elif event.kind in ("up", "cancel"):
            self.let_go()
        return ""

    def let_go(self) -> None:
        """Hold nothing."""
        self.model.cloth.release()
        self.point, self.moved = None, (0.0, 0.0)
        self.model.match.held = None

    def _act(self, point: Point, tool: str, first: bool) -> str:
        model = self.model
        if tool == "match":
            model.match.held = point
        elif tool in ("write", "wash"):
            if not model.write_at(point, tool == "wash") and first:
                return NO_CLOTH
        elif tool == "water":
            model.pour(point)
        elif tool == "drag":
            if first:
                return "" if model.cloth.grab(point) else "There is no cloth here to take hold of."
            model.cloth.drag(point)
        elif not first:
            model.blow(point, self.moved)
        return ""

"""The hand: a drag draws a gust, the other button drops a leaf."""

from __future__ import annotations

from game.scenes.leaves.model import MOST_LEAVES, LeavesModel
from game.stage import Part, Pointer

FARTHEST = 12.0  # m


class LeavesHand(Part):
    """Where a gust that is being drawn began, and where it is."""

    def __init__(self, model: LeavesModel):
        self.model = model
        self.draws = False
        self.from_x = self.from_y = self.x = self.y = 0.0

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it, or ""."""
        x = min(max(event.x, -FARTHEST), FARTHEST)
        y = min(max(event.y, 0.05), FARTHEST)
        if event.kind == "down" and event.button == 1:
            self.draws, self.from_x, self.from_y = True, x, y
        elif event.kind == "down" and event.button == 3:
            if len(self.model.plates) >= MOST_LEAVES:
                return f"At most {MOST_LEAVES} leaves."
            self.model.drop(self.model.parameters.leaf, (x, y))
        elif event.kind == "up" and self.draws:
            self.draws = False
            self.model.blow((self.from_x, self.from_y), (x - self.from_x, y - self.from_y))
        elif event.kind == "cancel":
            self.draws = False
        if self.draws:
            self.x, self.y = x, y
        return ""

"""The hand: it drags a body, within the bound of accelerations."""

from __future__ import annotations

from game.scenes.spacetime.model import SpaceTimeModel
from game.stage import Part, Pointer


class SpaceTimeHand(Part):
    """The body that it holds, or -1, and where it pulls it."""

    def __init__(self, model: SpaceTimeModel):
        self.model = model
        self.held, self.x, self.y = -1, 0.0, 0.0

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        if event.kind == "down" and event.button == 1:
            self.held = self.model.body_at((event.x, event.y))
        elif event.kind in ("up", "cancel"):
            self.held = -1
        if self.held >= 0:
            self.x, self.y = event.x, event.y

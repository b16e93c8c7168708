"""The hand: it stirs."""

from __future__ import annotations

from game.physics.kernels import elementary
from game.scenes.cavity.model import CavityModel
from game.stage import Part, Pointer

FASTEST = 3.0  # m/s


class CavityHand(Part):
    """Where the pointer was last while the button is held."""

    def __init__(self, model: CavityModel):
        self.model = model
        self.x, self.y, self.stirs = 0.0, 0.0, False

    def take(self, event: Pointer) -> None:
        """A pointer event: a drag stirs along its way."""
        if event.kind == "down" and event.button == 1:
            self.stirs = True
        elif event.kind in ("up", "cancel"):
            self.stirs = False
        elif event.kind == "move" and self.stirs:
            way = 30.0 * (event.x - self.x), 30.0 * (event.y - self.y)
            length = elementary.hypot(*way)
            part = min(1.0, FASTEST / length) if length > 0.0 else 0.0
            self.model.stir((event.x, event.y), (part * way[0], part * way[1]))
        self.x, self.y = event.x, event.y

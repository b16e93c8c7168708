"""The hand: it leads the focus, and drops grains."""

from __future__ import annotations

from game.scenes.levitation.model import APART, LevitationModel
from game.stage import Part, Pointer


class LevitationHand(Part):
    """Where the focus is to go while the left button is held; None else."""

    def __init__(self, model: LevitationModel):
        self.model = model
        self.x, self.y, self.leads = 0.0, 0.0, False

    @property
    def place(self) -> tuple[float, float] | None:
        """Where the focus is led, m."""
        return (self.x, self.y) if self.leads else None

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        reach = 0.45 * APART
        place = (min(max(event.x, -reach), reach), min(max(event.y, -reach), reach))
        if event.kind == "down" and event.button == 1:
            self.leads = True
        elif event.kind == "down" and event.button == 3 and self.model.levitator.count < 256:
            self.model.add(self.model.nearest_trap(place))
        elif event.kind in ("up", "cancel"):
            self.leads = False
        if self.leads:
            self.x, self.y = place

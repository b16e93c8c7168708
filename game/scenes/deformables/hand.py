"""The hand: it takes a vertex, with what is around it, and leads it about."""

from __future__ import annotations

from game.physics.constraints.editing import nearest_particle
from game.scenes.deformables.level import HEIGHT, WIDTH
from game.scenes.deformables.model import DeformablesModel
from game.stage import Part, Pointer

REACH, GRIP = 0.12, 0.08  # m: how near the pointer takes a vertex; what is led along
NOBODY = -1


class DeformablesHand(Part):
    """What it holds is in the system."""

    def __init__(self, model: DeformablesModel):
        self.model = model

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        system = self.model.bodies.system
        place = (
            self.model.middle + min(max(event.x - self.model.middle, -0.5 * WIDTH), 0.5 * WIDTH),
            min(max(event.y, 0.0), 2.0 * HEIGHT),
        )
        if event.kind == "down" and event.button == 1:
            index = nearest_particle(system, place, REACH)
            if index != NOBODY:
                system.grab(index, GRIP)
        elif event.kind in ("up", "cancel"):
            system.release()
        if system.held != NOBODY:
            system.drag(place)

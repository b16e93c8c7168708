"""The hand in the broad-phase scenes: boxes are taken, drawn, removed and looked into."""

from __future__ import annotations

import numpy as np

from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.base import NO_BOX, BoxesModel
from game.stage import Part, Pointer

HAND_BUTTON, REMOVE_BUTTON = 1, 3
MOST_POINTED_AT = 5_000  # boxes among which the one below a resting pointer is looked for in every frame


class Hand(Part):
    """What a pointer does with boxes: drag one, draw one, look into one, remove what is right-clicked.

    pointed: where the pointer is; anchor, reach: where a new box was begun, and where its other corner is; m.
    """

    def __init__(self, model: BoxesModel):
        self.model = model
        self.grip = (0.0, 0.0)  # m, from the held box's lower corner to the pointer
        self.anchor: tuple[float, float] | None = None
        self.reach: tuple[float, float] = (0.0, 0.0)
        self.erasing = False
        self.pressed: tuple[float, float] | None = None  # where the box in the hand was taken
        self.pointed: tuple[float, float] | None = None

    @property
    def looked(self) -> int:
        """The box that is looked into: the one in the hand, the one chosen, or the one below the pointer.

        NO_BOX if there is none. Nothing is asked of a structure, so that looking changes none.
        """
        boxes = self.model.boxes
        for box in (self.model.held, self.model.chosen):
            if 0 <= box < len(boxes.alive) and boxes.alive[box]:
                return int(box)
        if self.pointed is None or self.anchor is not None or len(boxes.alive) > MOST_POINTED_AT:
            return NO_BOX
        at = np.array(self.pointed)
        within = (boxes.lowers <= at).all(axis=1) & (at <= boxes.uppers).all(axis=1) & (boxes.alive == 1)
        found = np.flatnonzero(within & np.isfinite(boxes.lowers + boxes.uppers).all(axis=1))
        return int(found[-1]) if len(found) else NO_BOX

    def box_at(self, at: tuple[float, float]) -> int:
        """The box that the hand means at a place, or NO_BOX."""
        return self.model.box_at(at)

    def take(self, event: Pointer) -> None:
        """A pointer event."""
        at, model = (event.x, event.y), self.model
        self.pointed = at
        if event.kind == "down" and event.button == HAND_BUTTON:
            self._grasp(at)
        elif event.kind == "down" and event.button == REMOVE_BUTTON:
            self.erasing = True
            self._erase(at)
        elif event.kind == "move" and self.erasing:
            self._erase(at)
        elif event.kind == "move" and model.held >= 0:
            model.move_held((at[0] - self.grip[0], at[1] - self.grip[1]))
        elif event.kind == "move" and self.anchor is not None:
            self.reach = at
        elif event.kind == "up":
            if self.anchor is not None:
                self._draw_box(self.anchor, at)
            elif model.held >= 0 and at == self.pressed:  # a click
                model.chosen = NO_BOX if model.chosen == model.held else model.held
            self._let_go()
        elif event.kind == "cancel":
            self._let_go()

    def _grasp(self, at: tuple[float, float]) -> None:
        """Take the box at a point, or begin a new one."""
        box = self.box_at(at)
        if box >= 0:
            lower = self.model.boxes.lowers[box]
            self.pressed, self.grip = at, (float(at[0] - lower[0]), float(at[1] - lower[1]))
            self.model.hold(box)
        elif 0.0 <= at[0] <= WIDTH and 0.0 <= at[1] <= HEIGHT:
            self.anchor = self.reach = at

    def _let_go(self) -> None:
        self.model.release()
        self.anchor, self.erasing, self.pressed = None, False, None

    def _erase(self, at: tuple[float, float]) -> None:
        box = self.box_at(at)
        if box >= 0:
            self.model.remove_one(box)

    def _draw_box(self, anchor: tuple[float, float], at: tuple[float, float]) -> None:
        """A new box between two points; a mere click makes one of the typical size."""
        size = self.model.size
        lower, upper = np.minimum(anchor, at), np.maximum(anchor, at)
        if (upper - lower).max() < 0.25 * size:
            lower, upper = lower - size / 2.0, upper + size / 2.0
        self.model.add_one(lower, upper)

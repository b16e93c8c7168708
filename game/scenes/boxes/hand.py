"""The hand in the broad-phase scenes: boxes are taken, drawn, removed and looked into."""

from __future__ import annotations

import math
from collections import deque
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from game.physics.broadphase import BroadPhase
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.stage import Pointer, Scene

Array = NDArray[np.float64]
HAND_BUTTON, REMOVE_BUTTON = 1, 3
MOST_POINTED_AT = 5_000  # boxes among which the one below a resting pointer is looked for in every frame


class HandOnBoxes(Scene):
    """What a pointer does with boxes: drag one, draw one, look into one, remove what is right-clicked."""

    takes: ClassVar[frozenset[str]] = frozenset(("right",))

    lowers: Array
    uppers: Array
    velocities: Array
    alive: NDArray[np.uint8]
    ids: NDArray[np.int64]
    size: float  # m, of most boxes
    speed: float  # m/s
    steps: int
    told: deque[str]

    def empty_hand(self) -> None:
        """Nothing is held, nothing begun."""
        self.held = -1  # box in the hand
        self.held_velocity: tuple[float, ...] = (0.0, 0.0)
        self.grip = (0.0, 0.0)  # m, from its lower corner to the pointer
        self.anchor: tuple[float, float] | None = None  # where a new box was begun
        self.reach: tuple[float, float] = (0.0, 0.0)  # and where its other corner is
        self.erasing = False
        self.pressed: tuple[float, float] | None = None  # where the box in the hand was taken

    # -- what the scene does ------------------------------------------------------------------------

    @property
    def most(self) -> int:
        """The greatest number of boxes."""
        raise NotImplementedError

    def structures(self) -> tuple[BroadPhase, ...]:
        """The broad phases, all with the same boxes."""
        raise NotImplementedError

    def pair_up(self) -> None:
        """Find the pairs of the boxes as they are."""
        raise NotImplementedError

    def add(self, lowers: Array, uppers: Array, velocities: Array) -> NDArray[np.int64]:
        """Add boxes; returns their ids."""
        raise NotImplementedError

    def remove(self, who: NDArray[np.int64]) -> None:
        """Remove boxes."""
        raise NotImplementedError

    def forget_sweep(self) -> None:
        """A box is changed by hand: it is where it is."""
        raise NotImplementedError

    # -- the hand -----------------------------------------------------------------------------------

    def look_at_none(self) -> None:
        """No box is looked into."""
        self.pointed: tuple[float, float] | None = None  # where the pointer is
        self.chosen = -1  # box that was clicked

    @property
    def looked(self) -> int:
        """The box that is looked into: the one in the hand, the one chosen, or the one below the pointer.

        -1 if there is none. Nothing is asked of a structure, so that looking changes none.
        """
        for box in (self.held, self.chosen):
            if 0 <= box < len(self.alive) and self.alive[box]:
                return int(box)
        if self.pointed is None or self.anchor is not None or len(self.alive) > MOST_POINTED_AT:
            return -1
        at = np.array(self.pointed)
        within = (self.lowers <= at).all(axis=1) & (at <= self.uppers).all(axis=1) & (self.alive == 1)
        found = np.flatnonzero(within & np.isfinite(self.lowers + self.uppers).all(axis=1))
        return int(found[-1]) if len(found) else -1

    def pointer(self, event: Pointer) -> None:
        at = (event.x, event.y)
        self.pointed = at
        if event.kind == "down" and event.button == HAND_BUTTON:
            self._grasp(at)
        elif event.kind == "down" and event.button == REMOVE_BUTTON:
            self.erasing = True
            self._erase(at)
        elif event.kind == "move" and self.erasing:
            self._erase(at)
        elif event.kind == "move" and self.held >= 0:
            self._drag(at)
        elif event.kind == "move" and self.anchor is not None:
            self.reach = at
        elif event.kind == "up":
            if self.anchor is not None:
                self._draw_box(self.anchor, at)
            elif self.held >= 0 and at == self.pressed:  # a click
                self.chosen = -1 if self.chosen == self.held else self.held
            self._let_go()
        elif event.kind == "cancel":
            self._let_go()

    def box_at(self, at: tuple[float, float]) -> int:
        """The topmost box at a point, -1 if there is none; boxes without end are left alone."""
        found = self.structures()[0].query_point(at)
        found = found[
            np.isfinite(self.lowers[found]).all(axis=1) & np.isfinite(self.uppers[found]).all(axis=1)
        ]
        return int(found[-1]) if len(found) else -1

    def _grasp(self, at: tuple[float, float]) -> None:
        """Take the box at a point, or begin a new one."""
        box = self.box_at(at)
        if box >= 0:
            self.held, self.pressed = box, at
            self.held_velocity = tuple(self.velocities[box].tolist())
            self.grip = (at[0] - self.lowers[box, 0], at[1] - self.lowers[box, 1])
            self.velocities[box] = 0.0
        elif 0.0 <= at[0] <= WIDTH and 0.0 <= at[1] <= HEIGHT:
            self.anchor = self.reach = at

    def _drag(self, at: tuple[float, float]) -> None:
        self.forget_sweep()
        size = self.uppers[self.held] - self.lowers[self.held]
        lower = np.array([at[0] - self.grip[0], at[1] - self.grip[1]])
        self.lowers[self.held], self.uppers[self.held] = lower, lower + size
        self.pair_up()

    def _let_go(self) -> None:
        if self.held >= 0:
            self.velocities[self.held] = self.held_velocity
        self.held, self.anchor, self.erasing, self.pressed = -1, None, False, None

    def _erase(self, at: tuple[float, float]) -> None:
        box = self.box_at(at)
        if box >= 0:
            self.remove(np.array([box]))
            self.pair_up()

    def _draw_box(self, anchor: tuple[float, float], at: tuple[float, float]) -> None:
        """A new box between two points; a mere click makes one of the typical size."""
        if len(self.ids) >= self.most:
            self.told.append(f"{self.most} boxes are the most.")
            return
        lower, upper = np.minimum(anchor, at), np.maximum(anchor, at)
        if (upper - lower).max() < 0.25 * self.size:
            lower, upper = lower - self.size / 2.0, upper + self.size / 2.0
        random = np.random.default_rng((self.seed, self.steps, 3, len(self.ids)))
        angle = 2.0 * math.pi * random.random()
        velocity = self.speed * np.array([[math.cos(angle), math.sin(angle)]])
        self.add(lower[None], upper[None], velocity)
        self.pair_up()

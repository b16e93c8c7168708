"""A scene that lives in its card: its own stage, led by the scene's demo, drawn in a few pixels."""

from __future__ import annotations

import pygame

from game.app.scene.opening import Opening
from game.app.script import Script, demo_of, demo_steps
from game.app.view import StageView
from game.stage import Stage
from game.stage.catalogue import Entry
from game.ui.look import Look

BEFORE_SHOWN_S = 1.6  # s of simulated time until there is something to be seen
WIDEST_VIEW = 1.8  # width of a scene's view to its height, at most
SMALLER = 0.62  # letters and lines of a card against those of a scene


class LiveScene:
    """Built in a thread, advanced and drawn by the main one."""

    def __init__(self, entry: Entry):
        """Raises whatever the scene raises."""
        self.entry = entry
        self.stage = self._begin()
        self._view: StageView | None = None

    def _begin(self) -> Stage:
        scene_type = self.entry.load()
        stage = Opening().make_stage(scene_type)
        self._end = demo_steps(scene_type, stage.dt)
        self._script = Script(stage, demo_of(scene_type))
        self._script.run(min(round(BEFORE_SHOWN_S / stage.dt), self._end))
        return stage

    def advance(self, elapsed_s: float) -> None:
        """Let it go on; at its end it begins anew."""
        self._script.advance(min(elapsed_s, 0.05))
        if self.stage.step_number >= self._end or self.stage.fault is not None:
            self.stage = self._begin()
            if self._view is not None:
                self._view.stage = self.stage

    def draw(self, size: tuple[int, int], look: Look) -> pygame.Surface | None:
        """Its picture, or None if it cannot be drawn."""
        surface = pygame.Surface(size, 0, 32)
        surface.fill(look.theme.stage)
        small = Look(look.theme, max(0.5, look.k * SMALLER), less_motion=look.less_motion)
        try:
            if (
                self._view is None
                or self._view.look.theme is not look.theme
                or self._view.rect != _frame_of(size)
            ):
                self._view = StageView(self.stage, small, words=False)
                self._view.place(_frame_of(size), small, margin=4.0 * look.k)
            self._view.draw(surface)
        except Exception:  # a scene's own slip; its card then keeps its drawing
            return None
        return surface


def _frame_of(size: tuple[int, int]) -> pygame.Rect:
    """Where the scene is fitted: a wide card lets its foot, where the words stand, cut the scene's off."""
    return pygame.Rect(0, 0, size[0], max(size[1], round(size[0] / WIDEST_VIEW)))

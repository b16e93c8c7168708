"""The picture of a stage: camera and canvas for one scene, in any rectangle of any surface."""

from __future__ import annotations

from typing import Protocol

import pygame

from game.stage import Scene
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look


class Shown(Protocol):
    """What can be drawn: a `Stage`, or a part of one that is gone through once more."""

    @property
    def scene_type(self) -> type[Scene]: ...
    @property
    def scene(self) -> Scene: ...
    @property
    def alpha(self) -> float: ...


MARGIN = 20.0  # design px round the scene's frame
LEAST_SEEN = 16.0  # design px of that frame, or the scene is out of view


class StageView:
    """Draws what a stage shows now. ``stage`` may be changed for another of the same scene."""

    def __init__(self, stage: Shown, look: Look, words: bool = True):
        """``words``: whether labels are drawn as well."""
        scene_type = stage.scene_type
        self.stage = stage
        self.look = look
        self._words = words
        self.rect = pygame.Rect(0, 0, 1, 1)
        self.teaching = True  # whether what explains is drawn: grids, exact curves, vectors, their words
        self.asked = False  # whether marks are asked for by key, beside those that the scene shows by itself
        self.named = False  # whether a story names single things now
        self.camera = Camera(y_up=scene_type.y_up, quarter_turns=scene_type.quarter_turns)
        self._canvas = self._make_canvas()

    def place(self, rect: pygame.Rect, look: Look, margin: float | None = None) -> None:
        """Take a place and an appearance; the scene's frame is fitted with ``margin`` window px about it."""
        if look is not self.look:
            self.look = look
            self._canvas = self._make_canvas()
        self.rect = pygame.Rect(rect)
        self.camera.fit(self.stage.scene.frame(), self.rect, MARGIN * look.k if margin is None else margin)

    def draw(self, surface: pygame.Surface, fresh: bool = True, alpha: float | None = None) -> None:
        """Draw the scene inside its rectangle, with ``fresh`` numbers or those of the last picture.

        ``alpha``: how far between the last two states, if not as the stage's clock has it.

        Whatever the scene raises passes through.
        """
        self._canvas.fresh = fresh
        self._canvas.teaching = self.teaching
        self._canvas.asked = self.asked
        self._canvas.begin(surface, self.rect, self.camera)
        try:
            self.stage.scene.draw(self._canvas, self.stage.alpha if alpha is None else alpha)
            if self.asked or self.named:
                draw_names(self._canvas, self.stage.scene)
        finally:
            self._canvas.end()

    @property
    def lost(self) -> bool:
        """Whether nothing of the scene's own frame is left in view, or less than `LEAST_SEEN` px across."""
        frame, camera = self.stage.scene.frame(), self.camera
        corners = camera.to_screen(frame.left, frame.bottom), camera.to_screen(frame.right, frame.top)
        for low, high, axis in ((self.rect.left, self.rect.right, 0), (self.rect.top, self.rect.bottom, 1)):
            first, last = sorted((corners[0][axis], corners[1][axis]))
            if min(last, high) - max(first, low) < min(LEAST_SEEN * self.look.k, high - low):
                return True
        return False

    def show_marks(self, asked: bool, otherwise: bool = False) -> None:
        """Marks and names on what is seen, or the bare picture; ``otherwise``: what explains stays."""
        self.asked, self.teaching = asked, asked or otherwise

    def _make_canvas(self) -> Canvas:
        canvas = Canvas(self.look)
        canvas.words = self._words
        canvas.unit = self.stage.scene_type.unit
        canvas.covered = self.stage.scene_type.covers
        return canvas


def draw_names(canvas: Canvas, scene: Scene) -> None:
    """The names of single things, each beside a ring about it, clear of one another and of the edges."""
    seen = canvas.camera.visible()
    for number, ((x, y), words) in enumerate(scene.story_names()):
        if seen.left < x < seen.right and seen.bottom < y < seen.top:
            canvas.ring((x, y), 8.0, "chalk", 1.4)
            canvas.label(
                (x, y),
                canvas.figure(("name", number), words),
                "text1",
                12,
                "semibold",
                "left",
                (12.0, 0.0),
                clear=True,
            )

"""A scene that lives in its card: its own stage, led by the scene's demo, drawn in a few pixels."""

from __future__ import annotations

import contextlib
import queue
import threading
from pathlib import Path

import pygame

from game.app.stagehand.opening import Opening
from game.app.stagehand.script import Script, demo_of, demo_steps
from game.app.stagehand.view import StageView
from game.levels import level_files
from game.stage import Frame, Stage
from game.stage.catalogue import CloseUp, Entry
from game.ui.canvas.camera import Camera
from game.ui.look.look import Look

WIDEST_VIEW = 1.8  # width of a scene's view to its height, at most
SMALLER = 0.62  # letters and lines of a card against those of a scene


class LiveScene:
    """Built in a thread, advanced and drawn by the main one."""

    def __init__(self, entry: Entry):
        """Raises whatever the scene raises."""
        self.entry = entry
        self.close_up = entry.close_up()
        self.stage, self._script = self._begin()
        self._end = demo_steps(self.stage.scene_type, self.stage.dt)
        self._view: StageView | None = None
        self._next: queue.SimpleQueue[tuple[Stage, Script]] = queue.SimpleQueue()
        self._beginning = False

    def _begin(self) -> tuple[Stage, Script]:
        """The scene once more, with something to be seen in it."""
        scene_type = self.entry.load()
        level = _level_file(scene_type.name, self.close_up.level)
        stage = Opening(level).make_stage(scene_type)
        script = Script(stage, demo_of(scene_type))
        script.run(min(round(self.close_up.shown_s / stage.dt), demo_steps(scene_type, stage.dt)))
        return stage, script

    def advance(self, elapsed_s: float) -> None:
        """Let it go on; at its end it stands until a thread has begun again."""
        if self._beginning:
            with contextlib.suppress(queue.Empty):
                self.stage, self._script = self._next.get_nowait()
                self._beginning = False
                if self._view is not None:
                    self._view.stage = self.stage
            return
        self._script.advance(min(elapsed_s, 0.05))
        if self.stage.step_number >= self._end or self.stage.fault is not None:
            self._beginning = True
            threading.Thread(target=self._begin_anew, name=f"card {self.entry.name}", daemon=True).start()

    def _begin_anew(self) -> None:
        with contextlib.suppress(Exception):  # what could be built once and now cannot stands still
            self._next.put(self._begin())

    @property
    def camera(self) -> Camera:
        """How the last picture was seen."""
        assert self._view is not None, "nothing has been drawn"
        return self._view.camera

    def draw(self, size: tuple[int, int], look: Look) -> pygame.Surface:
        """Its picture. Whatever the scene raises passes through."""
        surface = pygame.Surface(size, 0, 32)
        surface.fill(look.theme.stage)
        self._view_for(size, look).draw(surface)
        return surface

    def _view_for(self, size: tuple[int, int], look: Look) -> StageView:
        """The view in a card's size and theme, where letters and lines are smaller than in a scene."""
        view, frame = self._view, _frame_of(size)
        if view is None or view.look.theme is not look.theme or view.rect != frame:
            small = Look(look.theme, max(0.5, look.k * SMALLER), less_motion=look.less_motion)
            view = self._view = StageView(self.stage, small, words=False)
            view.place(frame, small, margin=4.0 * look.k)
            _come_closer(view.camera, self.stage.scene.frame(), self.close_up)
        return view


def _level_file(scene: str, name: str) -> Path | None:
    """The file of one of a scene's levels; None for its default."""
    return next((file for file in level_files(scene) if file.stem == name), None) if name else None


def _come_closer(camera: Camera, frame: Frame, close_up: CloseUp) -> None:
    """Bring a point of a frame to the middle, and it so many times nearer."""
    corners = camera.to_screen(frame.left, frame.bottom), camera.to_screen(frame.right, frame.top)
    xs, ys = zip(*corners, strict=True)
    x = min(xs) + close_up.across * (max(xs) - min(xs))
    y = min(ys) + close_up.down * (max(ys) - min(ys))
    camera.pan(camera.rect.centerx - x, camera.rect.centery - y)
    camera.zoom(close_up.zoom, camera.rect.center, smooth=False)


def _frame_of(size: tuple[int, int]) -> pygame.Rect:
    """Where the scene is fitted: a wide card lets its foot, where the words stand, cut the scene's off."""
    return pygame.Rect(0, 0, size[0], max(size[1], round(size[0] / WIDEST_VIEW)))

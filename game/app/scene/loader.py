"""Opening a scene behind the window's back: import, compile, build, while the main thread goes on drawing."""

from __future__ import annotations

import contextlib
import threading
import time
from typing import TYPE_CHECKING

import pygame

from game.app.canvas_warming import CanvasWarming
from game.app.readiness import mark_ready
from game.app.scene.opening import Opening
from game.stage.catalogue import Entry
from game.ui.look import Look
from game.ui.theme import DARK

if TYPE_CHECKING:
    from game.stage import Scene, Stage


class Loader:
    """A thread that makes a scene's stage; ``progress`` tells how far it is."""

    def __init__(self, entry: Entry, opening: Opening, canvas: CanvasWarming):
        self.entry = entry
        self.stage: Stage | None = None
        self.scene_type: type[Scene] | None = None
        self.error = ""
        self.done, self.total, self.name = 0, 0, "modules"
        self._opening = opening
        self._canvas = canvas
        self._began = time.perf_counter()
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name=f"open {entry.name}", daemon=True)
        self._thread.start()

    @property
    def finished(self) -> bool:
        """Whether there is a stage, or an error."""
        return not self._thread.is_alive()

    @property
    def seconds(self) -> float:
        """Time since the beginning."""
        return time.perf_counter() - self._began

    def stop(self) -> None:
        """Stop before the next kernel; what is being compiled is finished behind the scenes."""
        self._stop.set()

    def wait(self, seconds: float | None = None) -> None:
        """Wait for the end, for tests and headless use."""
        self._thread.join(seconds)

    def _work(self) -> None:
        try:
            self.scene_type = self.entry.load()
            self._warm_up(self.scene_type)
            if self._stop.is_set():
                return
            self._rehearse(self.scene_type)
            self.stage = self._opening.make_stage(self.scene_type)
            mark_ready(self.entry)
        except Exception as error:  # whatever a scene's own code raises must not take the window with it
            self.error = " ".join(f"{error}".split()) or type(error).__name__

    def _rehearse(self, scene_type: type[Scene]) -> None:
        """Two steps and one small picture of a scene that is thrown away: what no list of kernels has named
        compiles here, and not in the window's first frame. What fails here will be told by the scene itself.
        """
        import game.app.scene.play
        import game.ui.panel  # noqa: F401
        from game.app.view import StageView

        look = Look(DARK)
        stage = self._opening.make_stage(scene_type)
        with contextlib.suppress(Exception):
            stage.run(2)
            view = StageView(stage, look)
            surface = pygame.Surface((320, 200), 0, 32)
            view.place(surface.get_rect(), look)
            view.draw(surface)

    def _warm_up(self, scene_type: type[Scene]) -> None:
        """Wait for the canvas's kernels and compile the scene's, one by one."""
        warm_ups = tuple(scene_type.warm_ups())
        while not self._canvas.wait(0.02) and not self._stop.is_set():
            self.total = self._canvas.total + len(warm_ups)
            self.done, self.name = self._canvas.done, self._canvas.name
        before = self._canvas.total
        self.total = before + len(warm_ups)
        for i, (name, call) in enumerate(warm_ups):
            if self._stop.is_set():
                return
            self.done, self.name = before + i, name
            call()
        self.done = self.total

"""Opening a scene in the background: import, compile, build, while the main thread goes on drawing."""

from __future__ import annotations

import contextlib
import sys
import threading
import time
from typing import TYPE_CHECKING

import pygame

from game.app.compile.canvas_warming import CanvasWarming
from game.app.compile.precompile import Precompiler
from game.app.compile.readiness import mark_ready
from game.app.stagehand.opening import Opening
from game.compiler.prebuilt import anything_taken
from game.stage.catalogue import Entry
from game.ui.look.look import Look

if TYPE_CHECKING:
    from game.stage import Scene, Stage


class Loader:
    """A thread that makes a scene's stage; ``done`` of ``total`` says how far it is."""

    def __init__(self, entry: Entry, opening: Opening, canvas: CanvasWarming, look: Look, rect: pygame.Rect):
        """``look`` and ``rect``: how and where in the window the scene will be drawn."""
        self.entry = entry
        self.stage: Stage | None = None
        self.scene_type: type[Scene] | None = None
        self.error = ""
        self.done, self.total = 0, 0
        self._at = "modules"
        self._opening = opening
        self._canvas = canvas
        self._look = look
        self._rect = pygame.Rect(rect)
        self._began = time.perf_counter()
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name=f"open {entry.name}", daemon=True)
        self._thread.start()

    @property
    def finished(self) -> bool:
        """Whether there is a stage, or an error."""
        return not self._thread.is_alive()

    @property
    def name(self) -> str:
        """What is being done now: the kernel that the compiler is in, if it is in one."""
        jit = sys.modules.get("game.compiler.progress")  # the window must not import the compiler itself
        inside = jit.compiling().names if jit is not None and hasattr(jit, "compiling") else ()
        return inside[0] if inside else self._at

    @property
    def seconds(self) -> float:
        """Time since the beginning."""
        return time.perf_counter() - self._began

    def stop(self) -> None:
        """Stop before the next kernel; what is being compiled is finished in the background."""
        self._stop.set()

    def wait(self, seconds: float | None = None) -> None:
        """Wait for the end, for tests and headless use."""
        self._thread.join(seconds)

    def _work(self) -> None:
        second = Precompiler(self.entry)
        try:
            self.scene_type = self.entry.load()
            self._warm_up(self.scene_type)
            if self._stop.is_set():
                return
            self._rehearse(self.scene_type)
            self.done = self.total
            self.stage = self._opening.make_stage(self.scene_type)
            if not anything_taken():  # else code for this very processor is still to be compiled
                mark_ready(self.entry)
        except Exception as error:  # whatever a scene's own code raises must not take the window with it
            self.error = " ".join(f"{error}".split()) or type(error).__name__
        finally:
            second.stop()

    def _rehearse(self, scene_type: type[Scene]) -> None:
        """Play and draw a scene that is thrown away: what no list of kernels has named compiles here.

        What fails here, the scene itself says later.
        """
        import game.app.scene.play
        import game.ui.panel.panel  # noqa: F401
        from game.app.compile.rehearsal import rehearse
        from game.ui.panel.manager import prepared_theme

        stage = self._opening.make_stage(scene_type)
        with contextlib.suppress(Exception):
            prepared_theme(self._look)
            rehearse(stage, Look(self._look.theme, self._look.k), self._rect)

    def _warm_up(self, scene_type: type[Scene]) -> None:
        """Wait for the canvas's kernels and compile the scene's, one by one; the rehearsal is one more."""
        warm_ups = tuple(scene_type.warm_ups())
        while not self._canvas.wait(0.02) and not self._stop.is_set():
            self.total = self._canvas.total + len(warm_ups) + 1
            self.done, self._at = self._canvas.done, self._canvas.name
        before = self._canvas.total
        self.total = before + len(warm_ups) + 1
        for i, (name, call) in enumerate(warm_ups):
            if self._stop.is_set():
                return
            self.done, self._at = before + i, name
            call()
        self.done, self._at = self.total - 1, "first picture"

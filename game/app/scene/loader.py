"""Opening a scene behind the window's back: import, compile, build, while the main thread goes on drawing."""

from __future__ import annotations

import threading
import time
from typing import TYPE_CHECKING

from game.app.readiness import mark_ready
from game.app.scene.opening import Opening
from game.stage.catalogue import Entry

if TYPE_CHECKING:
    from game.stage import Scene, Stage


class Loader:
    """A thread that makes a scene's stage; ``progress`` tells how far it is."""

    def __init__(self, entry: Entry, opening: Opening):
        self.entry = entry
        self.stage: Stage | None = None
        self.scene_type: type[Scene] | None = None
        self.error = ""
        self.done, self.total, self.name = 0, 0, "modules"
        self._opening = opening
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
            self.name = "scene"
            self.stage = self._opening.make_stage(self.scene_type)
            mark_ready(self.entry)
        except Exception as error:  # whatever a scene's own code raises must not take the window with it
            self.error = " ".join(f"{error}".split()) or type(error).__name__

    def _warm_up(self, scene_type: type[Scene]) -> None:
        """Compile the canvas's kernels and then the scene's, one by one."""
        from game.ui.raster import WARM_UPS

        warm_ups = [*WARM_UPS, *scene_type.warm_ups()]
        self.total = len(warm_ups)
        for i, (name, call) in enumerate(warm_ups):
            if self._stop.is_set():
                return
            self.done, self.name = i, name
            call()
        self.done = self.total

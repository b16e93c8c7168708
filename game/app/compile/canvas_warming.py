"""The drawing kernels, compiled once in the background of the menu: every scene draws with them."""

from __future__ import annotations

import threading


class CanvasWarming:
    """Begun while a person still looks at the menu; a scene that is opened waits for what is left."""

    def __init__(self) -> None:
        self.done, self.total, self.name = 0, 1, "drawing"
        self.error = ""
        self._lock = threading.Lock()
        self._begun = False
        self._thread = threading.Thread(target=self._work, name="canvas kernels", daemon=True)

    def begin(self) -> None:
        """Start, if it has not been started; any thread may ask."""
        with self._lock:
            if not self._begun:
                self._begun = True
                self._thread.start()

    @property
    def ready(self) -> bool:
        """Whether all of them are there."""
        return self._begun and not self._thread.is_alive()

    def wait(self, seconds: float) -> bool:
        """Wait for so long; True if all are there."""
        self.begin()
        self._thread.join(seconds)
        return self.ready

    def _work(self) -> None:
        try:
            from game.ui.raster import WARM_UPS

            self.total = len(WARM_UPS)
            for name, call in WARM_UPS:
                self.name = name
                call()
                self.done += 1
        except Exception as error:  # reported by the scene that cannot draw
            self.error = " ".join(str(error).split())

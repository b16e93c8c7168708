"""The drawing kernels, compiled once behind the menu's back: every scene draws with them."""

from __future__ import annotations

import threading


class CanvasWarming:
    """Begun while a person still looks at the menu; a scene that is opened waits for what is left."""

    def __init__(self) -> None:
        self.done, self.total, self.name = 0, 1, "drawing"
        self.error = ""
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name="canvas kernels", daemon=True)

    def begin(self) -> None:
        """Start, if it has not been started."""
        if not self._thread.ident:
            self._thread.start()

    @property
    def running(self) -> bool:
        """Whether a kernel may be being compiled now."""
        return self._thread.is_alive()

    @property
    def ready(self) -> bool:
        """Whether all of them are there."""
        return bool(self._thread.ident) and not self._thread.is_alive()

    def wait(self, seconds: float) -> bool:
        """Wait for so long; True if all are there."""
        self.begin()
        self._thread.join(seconds)
        return self.ready

    def stop(self) -> None:
        """Stop before the next kernel."""
        self._stop.set()

    def _work(self) -> None:
        try:
            from game.ui.raster import WARM_UPS

            self.total = len(WARM_UPS)
            for name, call in WARM_UPS:
                if self._stop.is_set():
                    return
                self.name = name
                call()
                self.done += 1
        except Exception as error:  # told by the scene that cannot draw
            self.error = " ".join(str(error).split())

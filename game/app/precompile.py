"""A second process that compiles a scene's kernels into the disk cache, from the end of the list.

The window's own thread compiles them from the beginning; where the two meet, it finds the rest on disk. Two
processes use two cores, which two threads cannot: the compiler lets one in at a time. If the cache cannot be
written, or a process cannot be started, the first one compiles all by itself.
"""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys

from game.app.readiness import is_ready
from game.stage.catalogue import Entry


class Precompiler:
    """Runs beside the opening of one scene; ``stop`` when it is open."""

    def __init__(self, entry: Entry):
        self._process: subprocess.Popen[bytes] | None = None
        ours = entry.module.startswith("game.")  # the other process knows only the real catalogue
        if not ours or (os.cpu_count() or 1) < 2 or getattr(sys, "frozen", False) or is_ready(entry):
            return
        with contextlib.suppress(OSError):
            self._process = subprocess.Popen(
                [sys.executable, "-m", "game.app.precompile", entry.name],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                env={**os.environ, "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy"},
            )

    def stop(self) -> None:
        """End it, wherever it is: what it has finished is on disk."""
        if self._process is None:
            return
        with contextlib.suppress(OSError):
            self._process.terminate()
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(1.0)
        self._process = None


def compile_from_the_end(name: str) -> None:
    """Compile the kernels of the scene of that name, then those of the canvas, each list from its end."""
    from game.scenes import CATALOGUE
    from game.ui.raster import WARM_UPS

    for warm_up in reversed(CATALOGUE[name].load().warm_ups()):
        warm_up.call()
    for _, call in reversed(WARM_UPS):
        call()


if __name__ == "__main__":
    compile_from_the_end(sys.argv[1])

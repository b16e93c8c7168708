"""A second process that compiles a scene's kernels into the disk cache, from the end of the list.

The window's own thread compiles them from the beginning; where the two meet, it finds the rest on disk. Two
processes use two cores, which two threads cannot: the compiler lets one in at a time. If the cache cannot be
written, or a process cannot be started, the first one compiles all by itself.
"""

from __future__ import annotations

import sys

from game.app.compile.readiness import opens_at_once
from game.app.compile.second_process import end, start_quietly
from game.stage.catalogue import Entry


class Precompiler:
    """Runs beside the opening of one scene; ``stop`` when it is open."""

    def __init__(self, entry: Entry):
        # the other process knows only the real catalogue
        wanted = entry.module.startswith("game.") and not opens_at_once(entry)
        command = (sys.executable, "-m", "game.app.compile.precompile", entry.name)
        self._process = start_quietly(command) if wanted else None

    def stop(self) -> None:
        """End it: what it has finished is on disk."""
        end(self._process)
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

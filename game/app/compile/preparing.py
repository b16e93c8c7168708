"""While the menu stands, a process of low priority compiles what has not been opened yet, scene by scene.

What it has finished is on disk, so it may be stopped at any moment; a scene whose name it has printed opens
at once. `python -m game.app.compile.preparing` is that process; it ends when its names are no longer read. It
takes nothing of the machine code that came with Carom, and so compiles for this very processor. With the name
of a scene it does so for that scene alone, while that is played.
"""

from __future__ import annotations

import contextlib
import os
import queue
import subprocess
import sys
import threading
from collections.abc import Iterable, Sequence

from game.app.compile.readiness import is_ready, mark_ready
from game.app.compile.second_process import end, start_quietly
from game.stage.catalogue import Entry

QUIETLY = 10  # added to the process's niceness
OURS = (sys.executable, "-m", "game.app.compile.preparing")


class Preparation:
    """The process and what it has reported; ``command`` prints names of scenes, a line each."""

    def __init__(self, command: Sequence[str] = OURS) -> None:
        self.ready: set[str] = set()
        self._command = tuple(command)
        self._process: subprocess.Popen[str] | None = None
        self._begun = False
        self._names: queue.SimpleQueue[str] = queue.SimpleQueue()

    def begin(self) -> None:
        """Start it, once; nothing happens on one core or where a process cannot be started."""
        if self._begun:
            return
        self._begun = True
        below = getattr(subprocess, "BELOW_NORMAL_PRIORITY_CLASS", 0)
        self._process = start_quietly(self._command, stdout=subprocess.PIPE, text=True, creationflags=below)
        if self._process is not None:
            threading.Thread(target=self._read, args=(self._process,), name="prepared", daemon=True).start()

    def _read(self, process: subprocess.Popen[str]) -> None:
        assert process.stdout is not None
        with process.stdout as lines:
            for line in lines:
                self._names.put(line.strip())

    @property
    def going_on(self) -> bool:
        """Whether there is still something to come."""
        return self._process is not None and self._process.poll() is None

    def news(self) -> bool:
        """Take over what was reported; True if a scene has become ready since the last call."""
        before = len(self.ready)
        with contextlib.suppress(queue.Empty):
            while True:
                self.ready.add(self._names.get_nowait())
        return len(self.ready) > before

    def stop(self) -> None:
        """End it, wherever it is."""
        end(self._process)
        self._process, self._begun = None, False


def native_code_of(entry: Entry) -> Preparation:
    """The process for one scene alone: what it compiles is used from the next start."""
    return Preparation((*OURS, entry.name))


def prepare_scene(entry: Entry) -> None:
    """Compile all that opening a scene compiles, and note that. Raises whatever the scene raises."""
    compile_scene(entry)
    mark_ready(entry)


def compile_scene(entry: Entry) -> None:
    """Compile all that opening a scene compiles. Raises whatever the scene raises."""
    import pygame

    from game.app.compile.rehearsal import SIZE, rehearse
    from game.app.stagehand.opening import Opening
    from game.ui.look.look import Look
    from game.ui.look.theme import DARK

    scene_type = entry.load()
    for warm_up in scene_type.warm_ups():
        warm_up.call()
    rehearse(Opening().make_stage(scene_type), Look(DARK, 1.0), pygame.Rect((0, 0), SIZE))


def prepare_all(entries: Iterable[Entry]) -> None:
    """Prepare one scene after another and print the name of each that is ready.

    One that cannot be prepared is left out: opening it will say why. Ends quietly when its output is closed.
    """
    with contextlib.suppress(BrokenPipeError):
        for entry in entries:
            if not is_ready(entry):
                try:
                    prepare_scene(entry)
                except Exception:  # a scene's own code may raise anything
                    continue
            print(entry.name, flush=True)


def main(names: Sequence[str]) -> None:
    """The process: all scenes, or those named. Nothing is compiled that could not be kept."""
    from game.app.stagehand.headless import prepare
    from game.compiler.cache import can_keep_code
    from game.compiler.prebuilt import VARIABLE
    from game.scenes import CATALOGUE

    if not can_keep_code():
        return
    os.environ[VARIABLE] = "0"
    if hasattr(os, "nice"):
        os.nice(QUIETLY)
    prepare()
    prepare_all([CATALOGUE[name] for name in names] or CATALOGUE)


if __name__ == "__main__":
    main(sys.argv[1:])

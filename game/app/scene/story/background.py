"""The first run of a story, made in the background while it plays, for its length and its chapters."""

from __future__ import annotations

import contextlib
import threading
import time

from game.app.stagehand.stories import kept_rehearsal, rehearsal_of
from game.stage import Scene
from game.stage.script.lines import Story
from game.stage.story.rehearsal import Rehearsal

REST = 1.0  # times what a part of the run took: so long the window has the processor for itself


class BackgroundRehearsal:
    """``found`` is there as soon as it is known: at once if an earlier run was kept."""

    def __init__(self, story: Story, scene_type: type[Scene], background: bool) -> None:
        self.found: Rehearsal | None = kept_rehearsal(story)
        self._stopped = threading.Event()
        self._thread: threading.Thread | None = None
        if self.found is None and background:
            self._thread = threading.Thread(
                target=self._work, args=(story, scene_type), daemon=True, name="rehearsal"
            )
            self._thread.start()

    def _work(self, story: Story, scene_type: type[Scene]) -> None:
        before = time.perf_counter()

        def progress(_: float) -> bool:
            nonlocal before
            self._stopped.wait(min(REST * (time.perf_counter() - before), 0.5))
            before = time.perf_counter()
            return not self._stopped.is_set()

        with contextlib.suppress(Exception):  # the story says itself what is wrong with it
            found = rehearsal_of(story, scene_type, progress)
            if found.ended:
                self.found = found

    def stop(self) -> None:
        """The story is left."""
        self._stopped.set()

    def wait(self, seconds: float | None = None) -> None:
        """Wait for the end, for tests."""
        if self._thread is not None:
            self._thread.join(seconds)

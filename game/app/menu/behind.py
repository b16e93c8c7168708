"""What the menu does behind its back: the canvas's kernels, then those of all scenes, and their pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.app.compile.preparing import Preparation
from game.app.menu.thumbnails import Thumbnails

if TYPE_CHECKING:
    from game.app.application import App

SETTLED_S = 0.4  # s of the menu standing before the compiler is imported behind it


class Behind:
    """``update`` once a frame."""

    def __init__(self, app: App) -> None:
        self.thumbnails = Thumbnails(app)
        self.preparation = Preparation()
        self._app = app
        self._age_s = 0.0
        self._told = self.words()

    def update(self, elapsed_s: float) -> bool:
        """Let time pass; True if there is something else to tell."""
        self._age_s += elapsed_s
        if self._age_s <= SETTLED_S or not self._app.background:
            return False
        self._app.canvas_warming.begin()
        self.thumbnails.begin()
        if self._app.canvas_warming.ready:
            self.preparation.begin()
        if self.preparation.news():
            self.thumbnails.wake()
        before, self._told = self._told, self.words()
        return self._told != before

    def words(self) -> str:
        """How many scenes there are, and how many of them open at once while others are being prepared."""
        number = len(self._app.catalogue)
        count = f"{number} scenes" if number != 1 else "1 scene"
        ready = len(self.preparation.ready)  # none at first: the process has yet to look what there is
        return f"{ready} of {count} prepared" if ready and self.preparation.going_on else count

    def close(self) -> None:
        """End the work, wherever it is."""
        self.preparation.stop()
        self.thumbnails.close()

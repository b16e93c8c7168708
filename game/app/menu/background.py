"""What the menu does in the background: the kernels of canvas and scenes, and their pictures."""

from __future__ import annotations

from game.app.compile.preparing import Preparation
from game.app.menu.thumbnails import Thumbnails
from game.app.screens.host import Host

SETTLED_S = 0.4  # s of the menu standing before the compiler is imported in the background


class Background:
    """``update`` once a frame."""

    def __init__(self, host: Host) -> None:
        self.thumbnails = Thumbnails(host)
        self.preparation = Preparation()
        self._host = host
        self._age_s = 0.0
        self._shown = self.words()

    def update(self, elapsed_s: float) -> bool:
        """Let time pass; True if there is something else to show."""
        self._age_s += elapsed_s
        if self._age_s <= SETTLED_S or not self._host.background:
            return False
        self._host.canvas_warming.begin()
        self.thumbnails.begin(self._host.look)
        if self._host.canvas_warming.ready:
            self.preparation.begin()
        if self.preparation.news():
            self.thumbnails.wake()
        before, self._shown = self._shown, self.words()
        return self._shown != before

    def words(self) -> str:
        """How many scenes there are, and how many of them open at once while others are being prepared."""
        number = len(self._host.catalogue)
        count = f"{number} scenes" if number != 1 else "1 scene"
        ready = len(self.preparation.ready)  # none at first: the process has yet to look what there is
        return f"{ready} of {count} prepared" if ready and self.preparation.going_on else count

    def close(self) -> None:
        """End the work, wherever it is."""
        self.preparation.stop()
        self.thumbnails.close()

"""The page of a paper as a screen; what it compares is measured in a thread while it is open."""

from __future__ import annotations

import threading
from typing import ClassVar

from game.app.screens.host import Host
from game.app.screens.page_screen import PageScreen
from game.levels import level_files
from game.stage.catalogue import Entry
from game.ui.widgets.paper import Comparison, Paper, PaperRow
from game.ui.widgets.paperpage import PaperPage
from game.ui.widgets.wishes import Wish

OPEN = "open"


class Measuring:
    """What a page compares, measured in a thread; what is there so far is seen."""

    def __init__(self, paper: Paper) -> None:
        self.found: tuple[Comparison, ...] = ()
        self.failure: Exception | None = None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, args=(paper,), name="paper", daemon=True)
        self._thread.start()

    @property
    def note(self) -> str:
        """What is still to come, or why there is no more; "" when all is there."""
        if self.failure is not None:
            return f"Not measured: {' '.join(str(self.failure).split()) or type(self.failure).__name__}"
        return "measuring ..." if self._thread.is_alive() else ""

    def stop(self) -> None:
        """Stop after what is being measured."""
        self._stop.set()

    def wait(self, seconds: float | None = None) -> None:
        """Wait for the end, for tests."""
        self._thread.join(seconds)

    def _work(self, paper: Paper) -> None:
        try:
            for one in paper.measure():
                self.found = (*self.found, one)
                if self._stop.is_set():
                    return
        except Exception as error:  # the page's own code; it says so and stays open
            self.failure = error


class PaperCard(PageScreen):
    """The page; a button leads to the scene that shows the paper."""

    called: ClassVar[str] = "The page of the paper"

    def __init__(self, host: Host, row: PaperRow):
        self.row = row
        self.measuring = Measuring(paper := row.load())
        entry: Entry = host.catalogue[row.scene]
        links = ((OPEN, f"Open {entry.task or entry.title}"),)
        self._page = PaperPage(host.look, row, paper, links)
        super().__init__(host, self._page)

    def fulfil(self, wish: Wish) -> None:
        if wish.name == OPEN:
            level = next((path for path in level_files(self.row.scene) if path.stem == self.row.level), None)
            self.host.open_scene(self.row.scene, level=level)

    def update(self, elapsed_s: float) -> None:
        self._page.show(self.measuring.found, self.measuring.note)
        super().update(elapsed_s)

    def closed(self) -> None:
        self.measuring.stop()
        super().closed()

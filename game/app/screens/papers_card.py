"""The list of the course's papers: which are done, and the page of each that is."""

from __future__ import annotations

from typing import ClassVar

from game.app.screens.choices import ChoiceCard
from game.app.screens.host import Host
from game.scenes.papers import PAPERS
from game.ui.widgets.list_row import ListRow
from game.ui.widgets.paper import PaperRow


class PapersCard(ChoiceCard):
    """A click on one that is done opens its page."""

    called: ClassVar[str] = "The list of papers"

    def __init__(self, host: Host):
        scenes = {entry.name for entry in host.catalogue}
        self._done = {row.number for row in PAPERS if row.done and row.scene in scenes}
        rows = [
            list_row(row, row.number in self._done)
            for row in sorted(PAPERS, key=lambda row: (row.number not in self._done, row.number))
        ]
        heading = f"Papers of the course: {len(self._done)} of {len(PAPERS)} done"
        super().__init__(host, heading, rows, self._take)

    def _take(self, row: PaperRow) -> None:
        if row.number in self._done:
            self.host.cards.open_paper(row)
        else:
            self.host.tell(f"{row.number} is not done yet", "Those above can be opened.")


def list_row(row: PaperRow, done: bool) -> ListRow:
    """A paper as a row: what it is called, who wrote it, and how far it is."""
    about = f"{row.authors}, {row.year}"
    return ListRow(f"{row.number}  {row.title}", about, row.scene.upper() if done else "to come", value=row)

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
        done = sum(row.done for row in PAPERS)
        rows = [list_row(row) for row in sorted(PAPERS, key=lambda row: (not row.done, row.number))]
        super().__init__(host, f"Papers of the course: {done} of {len(PAPERS)} done", rows, self._take)

    def _take(self, row: PaperRow) -> None:
        if row.done:
            self.host.open_paper(row)
        else:
            self.host.tell(f"{row.number} is not done yet", "Those above can be opened.")


def list_row(row: PaperRow) -> ListRow:
    """A paper as a row: what it is called, who wrote it, and how far it is."""
    about = f"{row.authors}, {row.year}"
    return ListRow(
        f"{row.number}  {row.title}", about, row.scene.upper() if row.done else "to come", value=row
    )

"""The table of the race: a row for each contestant, with a logarithmic bar for its time."""

from __future__ import annotations

from typing import Any, NamedTuple

from game.scenes.boxes.numbers import log_share, seconds_text
from game.ui.look.numerals import format_number

TABLE_LEFT, TABLE_RIGHT, TABLE_TOP = 12.1, 24.9, 12.2  # m
BAR_LEFT, BAR_RIGHT = 4.3, 8.6  # m from the table's left
LEAST_S, MOST_S = 1e-6, 1.0  # s, ends of the bars


class Contestant(NamedTuple):
    """A row of the table: name of the parameter, words, colour, what its work counts."""

    name: str
    words: str
    color: str
    work: str


def times_text(seconds: float, fastest: float) -> str:
    """How many times the fastest's a time is."""
    if not fastest > 0.0 or not seconds > 0.0:
        return ""
    return "fastest" if seconds == fastest else f"{format_number(seconds / fastest, 2)} times"


class RaceTable:
    """Rows of words, a logarithmic bar and numbers, in world places, heights in design px."""

    def __init__(self, canvas: Any):
        self.canvas = canvas
        self.y = TABLE_TOP
        self._written = 0

    def space(self, height_px: float) -> None:
        self.y -= self.canvas.px(height_px)

    def _words(
        self, x: float, text: str, color: str, weight: str = "medium", anchor: str = "left", size: int = 12
    ) -> None:
        """Words at this height; a number in them changes together with all other numbers in the window."""
        self._written += 1
        text = self.canvas.figure((self._written, "".join(filter(str.isalpha, text))), text)
        self.canvas.label((TABLE_LEFT + x, self.y), text, color, size, weight, anchor, halo=False)

    def words(self, text: str) -> None:
        """A sentence over the width of the table, in as many lines as it takes."""
        width = int((TABLE_RIGHT - TABLE_LEFT) * self.canvas.pixels_per_unit)
        for line in self.canvas.fonts.wrap(text, 12, "medium", width):
            self._words(0.0, line, "text2")
            self.space(17)

    def head(self, words: str) -> None:
        """A section's head."""
        self._words(0.0, words, "text1", "semibold")
        self.space(24)

    def row(
        self,
        contestant: Contestant,
        seconds: float,
        work: str,
        memory: str,
        same: bool | None,
        fastest: float,
    ) -> None:
        """Name, bar with its time and how many times the fastest's that is (s), work, memory, the answer."""
        first = seconds == fastest
        canvas, width = self.canvas, BAR_RIGHT - BAR_LEFT
        left = TABLE_LEFT + BAR_LEFT
        self._words(0.0, contestant.words, "text1" if first else "text2", "semibold" if first else "medium")
        canvas.line((left, self.y), (left + width, self.y), "inset", 6.0)
        length = log_share(seconds, LEAST_S, MOST_S)
        if length > 0.0:
            canvas.line((left, self.y), (left + length * width, self.y), contestant.color, 6.0)
            self._words(BAR_RIGHT + 0.25, seconds_text(seconds), "text1", "semibold")
            right = TABLE_RIGHT - TABLE_LEFT
            self._words(
                right, times_text(seconds, fastest), "text2", "semibold" if first else "medium", "right"
            )
        self.space(17)
        mark = {None: "", True: "same pairs", False: "pairs differ"}[same]
        self._words(0.0, mark, "text3" if same else "vermilion", size=11)
        self._words(BAR_LEFT, work, "text3", size=11)
        self._words(TABLE_RIGHT - TABLE_LEFT, memory, "text3", anchor="right", size=11)
        self.space(25)

    def scale(self) -> None:
        """What the bars' length means."""
        canvas = self.canvas
        for i, words in enumerate(("1 µs", "", "", "1 ms", "", "", "1 s")):
            x = TABLE_LEFT + BAR_LEFT + i / 6.0 * (BAR_RIGHT - BAR_LEFT)
            canvas.label((x, self.y), words, "text3", 11, "medium", "center", halo=False)

"""The practice record beside the table: the sets of what is practised, a curve over time, the rating."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from datetime import datetime

import pygame

from game.billiards.game.games import Ghost
from game.billiards.game.rating import rating_of
from game.files import FileProblem
from game.levels import Level
from game.scenes.billiards.play import Play
from game.scenes.billiards.practice.columns import COLUMN, ROWS
from game.scenes.billiards.practice.sets import standing_set
from game.scenes.shared.tables.beside.rows import Row, draw_ground, draw_rows
from game.scenes.shared.tables.boxes import rect_of
from game.stage.records.history import PracticeSet, history_path, read_history
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.numerals import MINUS
from game.ui.look.shapes import draw_box, draw_disc, draw_line

NOTHING_KEPT = "Kept of drills, and of racks against the ghost."
CHART_ROWS = 4  # rows of the column that the chart takes
MOST_SHOWN = 40  # sets in the chart
RATING_FROM = 10  # racks


class RecordView:
    """Reads the file again when it has changed."""

    def __init__(self) -> None:
        self._stamp: object = None
        self._sets: tuple[PracticeSet, ...] = ()
        self._why = ""

    def sets(self, key: str) -> tuple[PracticeSet, ...]:
        """Sets of a key, the oldest first."""
        try:
            found = history_path().stat()
            stamp: object = (str(history_path()), found.st_mtime_ns, found.st_size)
        except OSError:
            stamp = None
        if stamp != self._stamp:
            self._stamp = stamp
            try:
                self._sets, self._why = read_history(), ""
            except (ValueError, FileProblem) as error:
                self._sets, self._why = (), str(error)
        return tuple(one for one in self._sets if one.key == key)

    def draw(self, canvas: Canvas, look: Look, play: Play, level: Level | None) -> None:
        """Heading, curve and list."""
        standing = standing_set(play, level)
        if standing is None:
            draw_ground(canvas, look, COLUMN, "Practice record", NOTHING_KEPT)
            return
        sets = self.sets(standing.key)
        under = self._why or summary_of(sets, isinstance(play.model.frame.game, Ghost))
        draw_ground(canvas, look, COLUMN, standing.title, under)
        if sets:
            top, foot = rect_of(canvas, COLUMN.row_box(0)), rect_of(canvas, COLUMN.row_box(CHART_ROWS - 1))
            draw_curve(canvas.surface, look, top.union(foot), sets[-MOST_SHOWN:])
            draw_rows(canvas, look, COLUMN, rows_of(sets), CHART_ROWS)


def summary_of(sets: Sequence[PracticeSet], ghost: bool) -> str:
    """All sets in a line: their count, the share of all; against the ghost the rating by the last racks."""
    if not sets:
        return "No set yet. The first try begins one."
    made, tried = sum(one.made for one in sets), sum(one.tried for one in sets)
    line = f"{len(sets)} set{'s' * (len(sets) != 1)}, {made} of {tried}, {100.0 * made / tried:.0f} %"
    return f"{line}; {rating_words(made, tried - made)}" if ghost and tried >= RATING_FROM else line


def rating_words(won: int, lost: int) -> str:
    """The rating of so many racks, with its standard error."""
    rating = rating_of(won, lost)
    return f"rating {rating.points:+.0f} ± {rating.error:.0f}".replace("-", MINUS)


def rows_of(sets: Sequence[PracticeSet]) -> list[Row]:
    """The newest sets first, as many as there is space for."""
    rows = []
    for one in list(reversed(sets))[: ROWS - CHART_ROWS]:
        when = datetime.fromisoformat(one.when)
        more = f" of {one.of}" if one.of and one.tried < one.of else ""
        words = f"{one.made} of {one.tried}" + (f" (not finished{more})" if more else "")
        rows.append(Row(f"{100.0 * one.share:.0f} %", words, f"{when:%d %b %Y, %H:%M}", share=one.share))
    return rows


def draw_curve(surface: pygame.Surface, look: Look, rect: pygame.Rect, sets: Sequence[PracticeSet]) -> None:
    """The share of each set over their order, 0 to 100 %."""
    px, theme = look.px, look.theme
    draw_box(surface, rect, px(6), theme.inset)
    left, right = rect.x + px(44), rect.right - px(14)
    top, foot = rect.y + px(16), rect.bottom - px(24)
    if right - left < px(40) or foot - top < px(30):
        return
    for share in (0.0, 0.5, 1.0):
        y = round(foot + share * (top - foot))
        draw_line(surface, theme.line, (left, y), (right, y), look.border)
        look.text(surface, f"{100.0 * share:.0f} %", (left - px(6), y), 11, "medium", "text3", "right")
    places = points_of(sets, (left, right), (foot, top))
    for a, b in itertools.pairwise(places):
        draw_line(surface, look.color("green"), a, b, max(2, px(2)))
    for place, one in zip(places, sets, strict=True):
        whole = not one.of or one.tried == one.of
        draw_disc(surface, place, max(3.0, 3.5 * look.k), look.color("green" if whole else "inset"),
                  None if whole else look.color("green"), look.border)  # fmt: skip
    first, last = (datetime.fromisoformat(one.when) for one in (sets[0], sets[-1]))
    look.text(surface, f"{first:%d %b}", (left, foot + px(13)), 11, "medium", "text3")
    if len(sets) > 1:
        look.text(surface, f"{last:%d %b}", (right, foot + px(13)), 11, "medium", "text3", "right")


def points_of(
    sets: Sequence[PracticeSet], across: tuple[float, float], up: tuple[float, float]
) -> list[tuple[float, float]]:
    """Where the sets stand between two ends across, and 0 and 1 between two heights, px."""
    (left, right), (foot, top) = across, up
    span = max(len(sets) - 1, 1)
    return [(left + (right - left) * k / span, foot + (top - foot) * one.share) for k, one in enumerate(sets)]

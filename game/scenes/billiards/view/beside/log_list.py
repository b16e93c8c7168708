"""The log of the game as a list: racks, strokes in the order in which they were played, what came of each."""

from __future__ import annotations

from game.billiards.game.log import Log, Logged
from game.billiards.game.rules import listed
from game.scenes.billiards.practice.columns import COLUMN
from game.scenes.billiards.practice.side import LogRow, Side, log_rows
from game.scenes.billiards.view.words import stroke_words
from game.scenes.shared.tables.beside.rows import Row, draw_ground, draw_rows
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look


def draw_log(canvas: Canvas, look: Look, side: Side) -> None:
    """The list, its newest rows at its foot."""
    log, count = side.play.log, len(side.play.log.entries)
    seen = side.rows_seen()
    hidden = len(log_rows(log)) - len(seen)
    under = "Click a stroke to play on from there." if count else "Strokes stand here once they are played."
    if hidden:
        under += " The wheel shows more."
    title = f"Log: {count} stroke{'s' * (count != 1)}"
    draw_ground(canvas, look, COLUMN, title, under)
    line = line_of_play(log)
    draw_rows(canvas, look, COLUMN, [row_of(row, log, line) for row in seen])


def line_of_play(log: Log) -> frozenset[int]:
    """Numbers of the strokes that led to the frame in play."""
    numbers, at = set(), log.find(log.at)
    while at is not None:
        numbers.add(at.number)
        at = log.find(at.after)
    return frozenset(numbers)


def row_of(row: LogRow, log: Log, line: frozenset[int]) -> Row:
    """A row in words."""
    if row.stroke is not None:
        return _stroke_row(row.stroke, log, line)
    if row.rack:
        result = next(one for one in log.racks if one.rack == row.rack)
        count = f"{result.strokes} stroke{'s' * (result.strokes != 1)}"
        won = f", {result.winner} won" if result.winner else ""
        return Row("", f"Rack {row.rack}: {count}{won}", head=True)
    number = log.left[1] if log.left is not None else 0
    return Row("↵", "Back to where you were" + f", after stroke {number}" * (number > 0))


def _stroke_row(entry: Logged, log: Log, line: frozenset[int]) -> Row:
    down = f"{listed(entry.down)} down".replace(" or ", " and ") if entry.down else "nothing down"
    what = "foul" if entry.foul else down
    branch = ("from the beginning, " if not entry.after else f"after {entry.after}, ") * entry.branches
    how = stroke_words(entry.struck.stroke)[0]
    color = "vermilion" if entry.foul else "text1"
    return Row(
        str(entry.number), f"{entry.shooter}: {what}", f"{branch}{how}", color,
        lit=entry.number == log.at, faint=entry.number not in line,
    )  # fmt: skip

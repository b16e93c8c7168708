"""A board: what the hand knows in the geometry scenes, and how it becomes another one.

Outlines, what is chosen and held, the line being drawn, what can be undone. It is frozen; each change gives
another board, so a scene keeps it as a plain attribute and the stage remembers it with the step.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from game.scenes.shared.outlines.outline import Outline, Point, is_inside, nearest_edge, placed

Past = tuple[tuple[Outline, ...], ...]
NOBODY = -1
HISTORY = 64  # edits that can be taken back


class Rules(NamedTuple):
    """What a scene admits. accept: points (n, 2) m and closed to a reason against it, or ""."""

    most_outlines: int = 2
    most_points: int = 1024
    may_be_open: bool = True
    accept: Callable[[NDArray[np.float64], bool], str] = lambda points, closed: ""


class Board(msgspec.Struct, frozen=True):
    """Outlines and the hand in them. drawn: corners of the line being drawn, m; pointer: where the hand is.

    held: "" or what is dragged ("body", "turn", "point"); grip: where it was taken; corner: the chosen corner
    of the chosen outline; told: what the last event has to say, or "".
    """

    outlines: tuple[Outline, ...] = ()
    chosen: int = NOBODY
    corner: int = NOBODY
    drawn: tuple[Point, ...] = ()
    pointer: Point = (0.0, 0.0)
    held: str = ""
    grip: tuple[float, float, float] = (0.0, 0.0, 0.0)
    past: Past = ()
    future: Past = ()
    told: str = ""


def outline_at(board: Board, point: Point, reach: float) -> int:
    """The outline at a point, the chosen one first, or NOBODY."""
    order = sorted(range(len(board.outlines)), key=lambda i: (i != board.chosen, -i))
    for i in order:
        outline = board.outlines[i]
        corners = placed(outline)
        if nearest_edge(point, corners, outline.closed)[1] <= reach:
            return i
        if outline.closed and is_inside(point, corners):
            return i
    return NOBODY


# -- changes ------------------------------------------------------------------------------------------


def with_outlines(board: Board, outlines: tuple[Outline, ...], remember: bool = True) -> Board:
    """The board with other outlines; what they were can be undone if ``remember``.

    The hand lets go of what is there no more.
    """
    past, future = board.past, board.future
    if remember:
        past, future = (*past, board.outlines)[-HISTORY:], ()
    chosen = board.chosen if board.chosen < len(outlines) else NOBODY
    held, corner = board.held, board.corner
    if chosen == NOBODY or corner >= len(outlines[chosen].points):
        held, corner = "", NOBODY
    return msgspec.structs.replace(
        board, outlines=outlines, past=past, future=future, chosen=chosen, held=held, corner=corner
    )


def with_places(board: Board, places: NDArray[np.float64]) -> Board:
    """The board with its outlines moved to places (k, 3) m, m, rad; not to be undone."""
    moved = tuple(
        outline
        if (outline.position[0], outline.position[1], outline.angle) == (x, y, angle)
        else Outline(outline.points, outline.closed, (x, y), angle)
        for outline, (x, y, angle) in zip(board.outlines, places.tolist(), strict=True)
    )
    return msgspec.structs.replace(board, outlines=moved)


def places_of(board: Board) -> NDArray[np.float64]:
    """Places (k, 3) of the outlines: m, m, rad."""
    return np.array([(*outline.position, outline.angle) for outline in board.outlines]).reshape(-1, 3)


def with_fields(board: Board, index: int, **fields: object) -> Board:
    """The board with an outline changed in some of its fields."""
    outline = msgspec.structs.replace(board.outlines[index], **fields)
    outlines = (*board.outlines[:index], outline, *board.outlines[index + 1 :])
    return msgspec.structs.replace(board, outlines=outlines)


def telling(board: Board, words: str) -> Board:
    """The board with something to say."""
    return msgspec.structs.replace(board, told=words)


def with_another(board: Board, made: Outline, rules: Rules) -> Board:
    """The board with one more outline, which is chosen; in place of the chosen one if there is no space."""
    count = len(board.outlines)
    index = count if count < rules.most_outlines else board.chosen if board.chosen != NOBODY else count - 1
    outlines = (*board.outlines[:index], made, *board.outlines[index + 1 :])
    board = with_outlines(board, outlines)
    return msgspec.structs.replace(board, held="", chosen=index, corner=NOBODY)


def undo(board: Board) -> Board:
    """Take the last edit back."""
    if board.drawn:
        return msgspec.structs.replace(board, drawn=board.drawn[:-1])
    if not board.past:
        return telling(board, "Nothing to take back.")
    future = (*board.future, board.outlines)[-HISTORY:]
    return _as_it_was(board, board.past[-1], board.past[:-1], future)


def redo(board: Board) -> Board:
    """Do again what was taken back last."""
    if not board.future:
        return telling(board, "Nothing to do again.")
    past = (*board.past, board.outlines)[-HISTORY:]
    return _as_it_was(board, board.future[-1], past, board.future[:-1])


def _as_it_was(board: Board, outlines: tuple[Outline, ...], past: Past, future: Past) -> Board:
    return Board(outlines, past=past, future=future, pointer=board.pointer)

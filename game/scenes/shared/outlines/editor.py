"""Outlines drawn by clicking, dragged, turned, corrected and taken back: the hand of the geometry scenes.

A scene calls ``take_pointer`` and ``act`` with its board, and goes on with the board that comes back.
"""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.physics.kernels import elementary
from game.scenes.shared.outlines.board import (
    NOBODY,
    Board,
    Rules,
    outline_at,
    redo,
    telling,
    undo,
    with_another,
    with_fields,
    with_outlines,
)
from game.scenes.shared.outlines.outline import (
    Outline,
    Point,
    handle_of,
    nearest_edge,
    outline_through,
    placed,
)
from game.stage import Pointer

TOOLS = ("move", "draw", "points")
FARTHEST = 1e9  # m, from the origin, that the hand may go
NOTCH = math.radians(5.0)  # turn of one notch of a wheel


# -- the pointer --------------------------------------------------------------------------------------


def take_pointer(board: Board, event: Pointer, rules: Rules, tool: str, reach: float) -> Board:
    """The board after a pointer event. reach: m, how near to a thing the pointer takes it."""
    point = (min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST))
    board = msgspec.structs.replace(board, pointer=point, told="")
    if event.kind == "down" and event.button == 1:
        if tool == "draw":
            return _draw(board, point, rules, reach)
        return _take(board, point, rules, reach, tool == "points", event.shift)
    if event.kind == "move" and board.held:
        return _drag(board, point)
    if event.kind == "wheel":
        return turn(board, NOTCH * event.wheel)
    if event.kind == "up" and board.held:
        return _let_go(board, rules)
    if event.kind == "cancel":
        return _take_back(board)
    return board


def _take(board: Board, point: Point, rules: Rules, reach: float, corners: bool, turning: bool) -> Board:
    """Press: a handle, a corner or an outline is taken; what it was can be undone from here."""
    chosen = board.chosen
    if chosen != NOBODY and elementary.dist(point, handle_of(board.outlines[chosen])) <= reach:
        return _hold(board, chosen, "turn", point)
    index = outline_at(board, point, reach)
    if index == NOBODY:
        return msgspec.structs.replace(board, chosen=NOBODY, corner=NOBODY, held="")
    if corners and not turning:
        return _take_corner(board, index, point, rules, reach)
    return _hold(board, index, "turn" if turning else "body", point)


def _hold(board: Board, index: int, held: str, point: Point, corner: int = NOBODY) -> Board:
    outline = board.outlines[index]
    x, y = outline.position
    grip = (point[0] - x, point[1] - y, outline.angle - elementary.atan2(point[1] - y, point[0] - x))
    board = with_outlines(board, board.outlines)
    return msgspec.structs.replace(board, chosen=index, corner=corner, held=held, grip=grip)


def _take_corner(board: Board, index: int, point: Point, rules: Rules, reach: float) -> Board:
    """A corner near the pointer is taken; on an edge a new one is made."""
    outline = board.outlines[index]
    corners = placed(outline)
    off = corners - point
    distance = np.sqrt((off * off).sum(axis=1))
    corner = int(distance.argmin())
    if distance[corner] <= reach:
        return _hold(board, index, "point", point, corner)
    edge, away = nearest_edge(point, corners, outline.closed)
    if away > reach or len(outline.points) >= rules.most_points:
        return _hold(board, index, "body", point)
    board = _hold(board, index, "point", point, edge + 1)
    points = (*outline.points[: edge + 1], _own(outline, point), *outline.points[edge + 1 :])
    return with_fields(board, index, points=points)


def _own(outline: Outline, point: Point) -> Point:
    """A world point as the outline has it."""
    dx, dy = point[0] - outline.position[0], point[1] - outline.position[1]
    c, s = elementary.cos(outline.angle), elementary.sin(outline.angle)
    return c * dx + s * dy, c * dy - s * dx


def _drag(board: Board, point: Point) -> Board:
    index = board.chosen
    outline = board.outlines[index]
    x, y = outline.position
    if board.held == "body":
        return with_fields(board, index, position=(point[0] - board.grip[0], point[1] - board.grip[1]))
    if board.held == "turn":
        angle = math.remainder(elementary.atan2(point[1] - y, point[0] - x) + board.grip[2], 2.0 * math.pi)
        return with_fields(board, index, angle=angle)
    points = list(outline.points)
    points[board.corner] = _own(outline, point)
    return with_fields(board, index, points=tuple(points))


def _let_go(board: Board, rules: Rules) -> Board:
    """The end of a drag; one that changed nothing leaves nothing to undo, a refused one is taken back."""
    before = board.past[-1] if board.past else board.outlines
    let_go = msgspec.structs.replace(board, held="")
    if before == board.outlines:
        return msgspec.structs.replace(let_go, past=board.past[:-1])
    if board.held == "point":
        outline = board.outlines[board.chosen]
        reason = rules.accept(np.array(outline.points), outline.closed)
        if reason:
            return telling(_take_back(board), reason)
    return let_go


def _take_back(board: Board) -> Board:
    """What is held goes back to where it was taken; a line being drawn is given up."""
    if board.held and board.past:
        board = msgspec.structs.replace(board, outlines=board.past[-1], past=board.past[:-1])
    return msgspec.structs.replace(board, held="", drawn=(), corner=NOBODY)


# -- drawing ------------------------------------------------------------------------------------------


def _draw(board: Board, point: Point, rules: Rules, reach: float) -> Board:
    """A click with the pen: another corner, or the end at the first corner (closed) or the last (open)."""
    drawn = board.drawn
    if len(drawn) >= 3 and elementary.dist(point, drawn[0]) <= reach:
        return finish(board, rules, True)
    if drawn and elementary.dist(point, drawn[-1]) <= 0.5 * reach:
        return finish(board, rules, not rules.may_be_open)
    if len(drawn) >= rules.most_points:
        return telling(board, f"An outline has {rules.most_points} points at most.")
    return msgspec.structs.replace(board, drawn=(*drawn, point))


def finish(board: Board, rules: Rules, closed: bool) -> Board:
    """End the line being drawn. It takes the place of the chosen outline if there is no space for more."""
    least = 3 if closed else 2
    if len(board.drawn) < least:
        return telling(board, f"A{' closed' if closed else 'n open'} line needs {least} points.")
    reason = rules.accept(np.array(board.drawn), closed)
    if reason:
        return telling(board, reason)
    made = outline_through(board.drawn, closed)
    return with_another(msgspec.structs.replace(board, drawn=()), made, rules)


# -- named actions ------------------------------------------------------------------------------------


def turn(board: Board, angle: float) -> Board:
    """The chosen outline turned by an angle, rad."""
    if board.chosen == NOBODY:
        return board
    now = board.outlines[board.chosen].angle
    board = with_outlines(board, board.outlines)
    return with_fields(board, board.chosen, angle=math.remainder(now + angle, 2.0 * math.pi))


def delete(board: Board, rules: Rules) -> Board:
    """Take away the last point drawn, or the chosen corner, or the chosen outline."""
    if board.drawn:
        return msgspec.structs.replace(board, drawn=board.drawn[:-1])
    index, corner = board.chosen, board.corner
    if index == NOBODY:
        return telling(board, "Choose an outline first.")
    outline = board.outlines[index]
    least = 3 if outline.closed else 2
    if corner != NOBODY and len(outline.points) > least:
        points = (*outline.points[:corner], *outline.points[corner + 1 :])
        reason = rules.accept(np.array(points), outline.closed)
        if reason:
            return telling(board, reason)
        board = with_fields(with_outlines(board, board.outlines), index, points=points)
        return msgspec.structs.replace(board, held="", corner=NOBODY)
    rest = (*board.outlines[:index], *board.outlines[index + 1 :])
    return msgspec.structs.replace(with_outlines(board, rest), held="", chosen=NOBODY, corner=NOBODY)


def act(board: Board, name: str, rules: Rules) -> Board:
    """One of the named actions undo, redo, delete, close, finish (open) and cancel."""
    board = telling(board, "")
    if name == "undo":
        return undo(board)
    if name == "redo":
        return redo(board)
    if name == "delete":
        return delete(board, rules)
    if name in ("close", "finish"):
        return finish(board, rules, name == "close" or not rules.may_be_open)
    if name == "cancel":
        return _take_back(board)
    raise ValueError(f"outline editor: no action {name!r}")

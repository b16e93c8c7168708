"""The hand of the geometry scenes: outlines clicked, dragged, turned, corrected, taken back."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.shared.outlines import editor
from game.scenes.shared.outlines.board import (
    NOBODY,
    Board,
    Rules,
    outline_at,
    places_of,
    with_outlines,
    with_places,
)
from game.scenes.shared.outlines.outline import Outline, handle_of, placed
from game.stage import Pointer
from game.stage.states.memory import remember

SQUARE = Outline(((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)))
RULES = Rules()


def post(board, kind, x, y, tool="move", rules=RULES, **more):
    return editor.take_pointer(board, Pointer(kind, x, y, **{"button": 1, **more}), rules, tool, 0.1)


def click(board, x, y, tool="move", rules=RULES):
    return post(post(board, "down", x, y, tool, rules), "up", x, y, tool, rules)


def drag(board, start, end, tool="move", rules=RULES, **more):
    board = post(board, "down", *start, tool, rules, **more)
    for part in (0.3, 1.0):
        board = post(
            board, "move", *(a + part * (b - a) for a, b in zip(start, end, strict=True)), tool, rules
        )
    return post(board, "up", *end, tool, rules)


def test_points_are_clicked_and_closed_at_the_first():
    board = Board()
    for point in ((0, 0), (2, 0), (2, 1), (0.02, 0.03)):
        board = click(board, *point, tool="draw")
    assert board.drawn == ()
    assert board.outlines[0].closed and board.chosen == 0
    assert np.allclose(placed(board.outlines[0]), [(0, 0), (2, 0), (2, 1)], rtol=0, atol=1e-15)
    for point in ((5, 0), (6, 0), (6, 2), (6, 2)):  # clicked twice: open
        board = click(board, *point, tool="draw")
    assert len(board.outlines) == 2 and not board.outlines[1].closed
    assert len(board.outlines[1].points) == 3


def test_a_third_takes_the_place_of_the_chosen_one():
    board = Board((SQUARE, Outline(SQUARE.points, position=(5.0, 0.0))), chosen=0)
    for point in ((9, 0), (9, 2), (8, 2)):
        board = click(board, *point, tool="draw")
    board = editor.act(board, "close", RULES)
    assert len(board.outlines) == 2 and board.outlines[0].position == (8.5, 1.0)
    assert board.outlines[1].position == (5.0, 0.0)


def test_drag_by_body_and_by_handle_and_with_shift():
    board = drag(Board((SQUARE,)), (0.2, 0.1), (1.2, 2.1))
    assert board.outlines[0].position == pytest.approx((1.0, 2.0), abs=1e-15)
    x, y = handle_of(board.outlines[0])
    board = drag(board, (x, y), (1.0 - (y - 2.0), 2.0))
    assert board.outlines[0].angle == pytest.approx(math.pi / 2)
    board = drag(board, (1.5, 2.0), (1.0, 2.5), shift=True)
    assert board.outlines[0].angle == pytest.approx(math.pi)
    board = editor.take_pointer(board, Pointer("wheel", 0, 0, wheel=2.0), RULES, "move", 0.1)
    assert board.outlines[0].angle == pytest.approx(-math.pi + math.radians(10))


def test_corners_are_moved_made_and_deleted():
    board = drag(Board((SQUARE,)), (1.0, 1.0), (2.0, 2.0), tool="points")
    assert board.outlines[0].points[2] == (2.0, 2.0) and board.corner == 2
    board = drag(board, (0.0, -1.0), (0.0, -2.0), tool="points")
    assert board.outlines[0].points[1] == (0.0, -2.0) and len(board.outlines[0].points) == 5
    board = editor.act(board, "delete", RULES)
    assert len(board.outlines[0].points) == 4
    board = editor.act(board, "delete", RULES)
    assert board.outlines == () and board.chosen == NOBODY
    assert editor.act(board, "delete", RULES).told


def test_undo_and_redo_take_every_edit_back_and_forth():
    start = Board((SQUARE,))
    board = drag(start, (0, 0), (1, 0))
    board = drag(board, (1, 0), (1, 3))
    board = click(board, 1.0, 3.0)  # a click that changes nothing
    assert len(board.past) == 2
    once = editor.act(board, "undo", RULES)
    twice = editor.act(once, "undo", RULES)
    assert twice.outlines == start.outlines
    assert editor.act(twice, "undo", RULES).told
    again = editor.act(editor.act(twice, "redo", RULES), "redo", RULES)
    assert again.outlines == board.outlines
    assert editor.act(again, "redo", RULES).told


def test_cancel_puts_back_what_is_held_and_gives_up_what_is_drawn():
    board = post(Board((SQUARE,)), "down", 0, 0)
    board = post(board, "move", 4, 4)
    assert editor.take_pointer(board, Pointer("cancel", 4, 4), RULES, "move", 0.1).outlines == (SQUARE,)
    drawing = click(Board(), 1, 1, tool="draw")
    assert editor.act(drawing, "cancel", RULES).drawn == ()
    assert editor.act(drawing, "undo", RULES).drawn == ()


def test_a_scene_may_refuse_an_outline():
    rules = Rules(accept=lambda points, closed: "Too small." if np.ptp(points) < 1.0 else "")
    board = Board()
    for point in ((0, 0), (0.3, 0), (0.3, 0.3)):
        board = click(board, *point, tool="draw", rules=rules)
    board = editor.act(board, "close", rules)
    assert board.told == "Too small." and board.outlines == () and len(board.drawn) == 3
    small = Board((Outline(((0.0, 0.0), (1.5, 0.0), (0.0, 0.5))),))
    back = drag(small, (1.5, 0.0), (0.4, 0.0), tool="points", rules=rules)
    assert back.told == "Too small." and back.outlines == small.outlines


def test_few_points_are_no_line_and_too_many_are_told():
    board = click(Board(), 0, 0, tool="draw")
    assert editor.act(board, "finish", RULES).told and editor.act(board, "close", RULES).told
    rules = Rules(most_points=3, may_be_open=False)
    for point in ((2, 0), (2, 2), (4, 4)):
        board = post(board, "down", *point, tool="draw", rules=rules)
    assert len(board.drawn) == 3 and "3 points" in board.told
    assert editor.act(board, "finish", rules).outlines[0].closed
    with pytest.raises(ValueError, match="dance"):
        editor.act(board, "dance", RULES)


def test_what_is_at_a_point():
    board = Board((SQUARE, Outline(((0.0, 0.0), (4.0, 0.0)), closed=False, position=(0.0, 0.5))))
    assert outline_at(board, (0.0, 0.0), 0.1) == 0
    assert outline_at(board, (3.0, 0.55), 0.1) == 1
    assert outline_at(board, (3.0, 0.8), 0.1) == NOBODY
    assert outline_at(board, (0.5, 0.5), 0.1) == 1
    chosen = Board(board.outlines, chosen=0)
    assert outline_at(chosen, (0.5, 0.5), 0.1) == 0
    point = Board((Outline(((0.0, 0.0),), closed=False),))
    assert outline_at(point, (0.05, 0.0), 0.1) == 0


def test_places_are_set_without_history():
    board = Board((SQUARE, SQUARE))
    places = places_of(board)
    places[1] = 3.0, 4.0, 0.5
    moved = with_places(board, places)
    assert moved.outlines[0] is board.outlines[0] and moved.outlines[1].position == (3.0, 4.0)
    assert moved.past == () and np.array_equal(places_of(moved), places)


def test_a_board_is_plain_for_the_stage():
    class Holder:
        pass

    holder = Holder()
    holder.board = Board((SQUARE,))
    assert "board" in remember(holder).attributes


@pytest.mark.parametrize("tool", ["move", "points"])
def test_what_is_deleted_while_it_is_held_is_held_no_more(tool: str):
    board = Board((SQUARE, Outline(SQUARE.points, position=(5.0, 0.0))), chosen=0)
    board = post(board, "down", 1.0, 0.3, tool)
    assert board.held
    for _ in range(2):  # a corner, and then the outline
        board = editor.act(board, "delete", RULES)
    left = board.outlines
    for kind in ("move", "move", "up", "cancel"):
        board = post(board, kind, 7.0, 3.0, tool)
        assert board.outlines == left and not board.held


def test_any_hand_leaves_as_many_outlines_as_there_may_be():
    hand = np.random.default_rng(5)
    board = Board((SQUARE, Outline(SQUARE.points, position=(5.0, 0.0))))
    names = ("undo", "redo", "delete", "close", "finish", "cancel")
    for _ in range(4000):
        x, y = hand.uniform((-3.0, -3.0), (8.0, 3.0))
        kind = hand.integers(8)
        if kind < 6:
            word = str(hand.choice(["down", "move", "move", "up", "wheel", "cancel"]))
            tool = str(hand.choice(editor.TOOLS))
            board = post(board, word, x, y, tool, wheel=1.0 if word == "wheel" else 0.0)
        elif kind == 6:
            board = editor.act(board, str(hand.choice(names)), RULES)
        else:
            kept = board.outlines[: hand.integers(3)]
            board = with_outlines(board, kept, remember=False)
        assert len(board.outlines) <= RULES.most_outlines
        assert -1 <= board.chosen < len(board.outlines)
        if board.held:
            assert board.chosen >= 0 and board.corner < len(board.outlines[board.chosen].points)

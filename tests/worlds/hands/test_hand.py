"""The hand: which tool a button has in it, what a drag tells the tool, when it lets go."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from game.stage import Pointer
from game.worlds.hands.hand import Hand, Tool, Use, hint_of, legend_of, tool_keys

TOOLS = (
    Tool("push", "Push", "push it"),
    Tool("draw", "Draw", "draw it", "drag a line"),
    Tool("look", "Look"),
)


@pytest.fixture
def told():
    return []


@pytest.fixture
def hand(told) -> Hand:
    def act(words):
        return lambda hand: told.append((words, hand.verb, hand.at, hand.moved)) or words

    model = SimpleNamespace(
        parameters=SimpleNamespace(tool="push"),
        content=SimpleNamespace(view=SimpleNamespace(bottom=1.0, top=6.0)),
    )
    uses = {"push": Use(act("pressed"), act("moved"), act("released")), "draw": Use(press=act("drawn"))}
    return Hand(model, uses, (-5.0, 0.0), (5.0, 9.0), right="draw", drop=lambda _: told.append("let go"))


def test_a_drag_presses_moves_and_releases_its_tool(hand, told) -> None:
    assert hand.take(Pointer("down", 1.0, 2.0, 1)) == "pressed"
    assert hand.take(Pointer("move", 1.5, 4.0, 1)) == "moved"
    assert hand.take(Pointer("up", 1.5, 4.0, 1)) == "released"
    assert told == [
        "let go", ("pressed", "push", (1.0, 2.0), (0.0, 0.0)), ("moved", "push", (1.5, 4.0), (0.5, 2.0)),
        ("released", "push", (1.5, 4.0), (0.0, 0.0)), "let go",
    ]  # fmt: skip
    assert hand.point is None and hand.verb == "" and hand.take(Pointer("move", 0.0, 1.0, 0)) == ""


def test_the_right_button_has_a_tool_of_its_own(hand, told) -> None:
    assert hand.take(Pointer("down", 0.0, 1.0, 3)) == "drawn"
    assert hand.take(Pointer("down", 0.0, 1.0, 2)) == ""
    hand._right = ""
    told.clear()
    assert hand.take(Pointer("down", 0.0, 1.0, 3)) == "" and told == []


def test_places_beyond_its_corners_are_at_them(hand) -> None:
    hand.take(Pointer("down", 99.0, -99.0, 1))
    assert hand.point == (5.0, 0.0) and hand.start == (5.0, 0.0)


def test_a_cancelled_drag_releases_nothing(hand, told) -> None:
    hand.take(Pointer("down", 0.0, 1.0, 1))
    hand.take(Pointer("cancel", 0.0, 0.0))
    assert told[-1] == "let go" and not any(one[0] == "released" for one in told)


def test_it_reaches_a_share_of_the_view(hand) -> None:
    assert hand.reach(0.02) == pytest.approx(0.1) and hand.reach(0.02, 0.05) == 0.05


def test_tools_are_keys_hints_and_legend() -> None:
    assert [(one.name, one.key) for one in tool_keys(TOOLS, "tool-")] == [
        ("tool-push", "1"),
        ("tool-draw", "2"),
    ]
    assert hint_of(TOOLS, "push") == () and "drag a line" in hint_of(TOOLS, "draw")[0]
    assert legend_of(TOOLS, "draw") == [("ring:accent", "drag a line", "")] and legend_of(TOOLS, "look") == []


def test_a_hand_without_a_choice_of_tools_has_one_in_each_button(told) -> None:
    model = SimpleNamespace(parameters=SimpleNamespace())
    uses = {name: Use(lambda hand: told.append(hand.verb) or "") for name in ("blow", "drop")}
    hand = Hand(model, uses, (-5.0, 0.0), (5.0, 9.0), left="blow", right="drop")
    for button in (1, 3, 2):
        hand.take(Pointer("down", 1.0, 2.0, button))
    assert told == ["blow", "drop"]

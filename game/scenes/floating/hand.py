"""What a hand does to a floating body: grab it in either tank, draw it, set it down, put ballast."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementary
from game.scenes.floating.world import FloatingWorld
from game.worlds.hands.curves import simplified
from game.worlds.hands.grab import GRAB, let_loose
from game.worlds.hands.hand import Hand, Use

SMOOTH = 0.006  # of the tank's width: how far a drawn outline may be from the line
BALLAST = 0.5  # mass of lead beside the body's own, where there was none
NEAR = 1.3  # of the body's reach: how near it is taken


def _in_chart(hand: Hand) -> bool:
    _, low, _, high = hand.model.content.chart
    return bool(low <= hand.at[1] <= high)


def _set_by_chart(hand: Hand) -> str:
    left, _, right, _ = hand.model.content.chart
    share = min(max((hand.at[0] - left) / (right - left), 0.0), 1.0)
    hand.model.set_down(math.tau * (share - 0.5))
    return ""


def _press_chart(hand: Hand) -> bool:
    """Whether the press was in the chart, and so sets the body down."""
    if _in_chart(hand):
        hand.kind = "chart"
        _set_by_chart(hand)
        return True
    return False


def _follow_chart(hand: Hand) -> str:
    return _set_by_chart(hand) if hand.kind == "chart" else ""


def _grab(hand: Hand) -> str:
    if _press_chart(hand):
        return ""
    model: FloatingWorld = hand.model
    if hand.at[0] > model.content.apart:
        return GRAB.press(hand)
    own = model.own_place(hand.at)
    if own is None:
        return "The body is not there."
    model.law.held, model.law.goal = own, hand.at
    return ""


def _pull(hand: Hand) -> str:
    if hand.kind == "chart":
        return _set_by_chart(hand)
    hand.model.law.goal = hand.at
    return GRAB.move(hand)


def _let_go(hand: Hand) -> None:
    hand.model.law.held = None
    let_loose(hand)


def _begin(hand: Hand) -> str:
    _press_chart(hand)
    return ""


def _draw(hand: Hand) -> str:
    if hand.kind == "chart":
        return _follow_chart(hand)
    step = 0.003 * hand.model.content.tank[0]
    if elementary.dist(hand.at, hand.path[-1]) > step:
        hand.path.append(hand.at)
    return ""


def _close(hand: Hand) -> str:
    if hand.kind == "chart":
        return ""
    if len(hand.path) < 3:
        return "Draw an outline: hold the button, and go round."
    points = simplified(np.array(hand.path), SMOOTH * hand.model.content.tank[0])
    return str(hand.model.take_outline(points))


def _tilt(hand: Hand) -> str:
    if hand.kind == "chart":
        return _follow_chart(hand)
    model: FloatingWorld = hand.model
    x, y = model.centre_near(hand.start or hand.at)
    dx, dy = hand.at[0] - x, hand.at[1] - y
    if elementary.hypot(dx, dy) > 0.2 * model.floater.reach:
        model.set_down(float(elementary.atan2(-dx, dy)))
    return ""


def _ballast(hand: Hand) -> str:
    if _press_chart(hand):
        return ""
    model: FloatingWorld = hand.model
    own = model.own_place(hand.at)
    if own is None:
        return "Click in the body: ballast lies in it."
    if model.parameters.ballast == 0.0:
        model.parameters.ballast = BALLAST
    model.put_ballast(own)
    return ""


def floating_hand(model: FloatingWorld) -> Hand:
    """All tools; a press in the chart sets the body down at that angle."""
    view = model.content.view
    uses = {
        "grab": Use(_grab, _pull), "draw": Use(_begin, _draw, _close), "tilt": Use(_begin, _tilt),
        "ballast": Use(_ballast, _follow_chart),
    }  # fmt: skip
    return Hand(model, uses, (view.left, view.bottom), (view.right, view.top), drop=_let_go)

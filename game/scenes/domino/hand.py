"""The hand among the dominoes: pushes, drags, adds, removes, while it runs."""

from __future__ import annotations

import numpy as np

from game.arrays import Point
from game.scenes.domino.world import DominoWorld
from game.worlds.hands.hand import NOBODY, Hand, Use
from game.worlds.members.solids import nearest_box

REACH, MOST_REACH = 0.02, 0.5  # of the height in view, m: how near to a domino the pointer takes it
FARTHEST = (1e4, 1e4)  # m


def domino_at(hand: Hand) -> int:
    """Number of the domino at the pointer, or NOBODY."""
    model: DominoWorld = hand.model
    there, table = model.dominoes.there(), model.dominoes.table
    sizes = np.stack([table.thick[there], table.tall[there]], axis=1)
    best, outside = nearest_box(model.world, table.body[there], sizes, hand.at)
    return int(there[best]) if outside <= hand.reach(REACH, MOST_REACH) else NOBODY


def _push(hand: Hand) -> str:
    number = domino_at(hand)
    if number == NOBODY:
        _grab_ball(hand)
    else:
        hand.model.dominoes.push(number, hand.shift)
        hand.point = None
    return ""


def _grab(hand: Hand) -> str:
    hand.held = domino_at(hand)
    if hand.held == NOBODY:
        _grab_ball(hand)
    return ""


def _grab_ball(hand: Hand) -> None:
    hand.held, hand.kind = hand.model.ball_at(hand.at), "ball"
    if hand.held == NOBODY:
        hand.let_go()


def _drag(hand: Hand) -> str:
    model: DominoWorld = hand.model
    if hand.kind == "ball":
        body = model.ball_ids[hand.held]
        model.world.set_pose(body, hand.at, float(model.world.bodies.angles[body]))
        model.world.set_velocity(body, (0.0, 0.0), 0.0)
        return ""
    place = model.floor_below(hand.at)
    if place is not None and hand.held != NOBODY:
        model.dominoes.move(hand.held, place)
    return ""


def _add(hand: Hand) -> str:
    place = hand.model.floor_below(hand.at)
    hand.point = None
    if place is None:
        return "There is no floor below."
    return "" if hand.model.dominoes.add(place) else "No more dominoes fit in."


def _remove(hand: Hand) -> str:
    number = domino_at(hand)
    hand.point = None
    if number != NOBODY:
        hand.model.dominoes.take_away(number)
    return ""


USES = {"push": Use(_push, _drag), "drag": Use(_grab, _drag), "add": Use(_add), "remove": Use(_remove)}


def domino_hand(model: DominoWorld) -> Hand:
    """The right button removes."""
    low: Point = (-FARTHEST[0], -FARTHEST[1])
    return Hand(model, USES, low, FARTHEST, right="remove")

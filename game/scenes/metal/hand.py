"""The hand in the marble run: moves, makes and sizes balls, bends and draws tracks, while it runs."""

from __future__ import annotations

from game.arrays import Flags
from game.physics.kernels import elementary
from game.physics.solids.tracks.motion import RADIUS
from game.scenes.metal.balls import NONE
from game.scenes.metal.level import MOST_BALLS, MOST_TRACKS, BallEntry
from game.scenes.metal.world import MetalWorld
from game.worlds.hands.hand import NOBODY, Hand, Use
from game.worlds.hands.tracks import TrackTools

FARTHEST = 1e3  # m
LEAST, LARGEST = 0.03, 0.5  # m, of a ball's radius
MOST_POINTS = 400  # of a track that is drawn
LANDING = 0.6  # m: so near to a track a ball that is put down lies on it, in parts of its radius, at most
TOOLS = TrackTools(0.02, 0.3, 0.3, MOST_TRACKS, MOST_POINTS)


def _there(model: MetalWorld) -> Flags:
    return model.balls.there()


def ball_at(hand: Hand) -> int:
    """The ball under the pointer, or NOBODY."""
    return TOOLS.ball_at(hand, _there(hand.model))


def _grab(hand: Hand) -> str:
    hand.held = hand.model.held = ball_at(hand)
    return ""


def _make(hand: Hand) -> str:
    model: MetalWorld = hand.model
    if len(model.balls.table.body) >= MOST_BALLS:
        return f"There can be at most {MOST_BALLS} balls."
    model.changed = True
    hand.held = model.held = model.add(BallEntry(at=hand.at, radius=model.parameters.radius))
    return ""


def _move(hand: Hand) -> str:
    if hand.held != NOBODY:
        hand.model.changed = True
        hand.model.balls.hold(hand.held, hand.at)
    return ""


def _put_down(hand: Hand) -> str:
    if hand.held != NOBODY:
        hand.model.put_down(hand.held, LANDING * float(hand.model.balls.rows[hand.held, RADIUS]))
        hand.model.held = NOBODY
    return ""


def _take_size(hand: Hand) -> str:
    ball = ball_at(hand)
    if ball != NOBODY and hand.model.balls.table.rod[ball] != NONE:
        return "A ball of a cradle keeps its size: its rod is made for it."
    hand.held = ball
    return ""


def _size(hand: Hand) -> str:
    if hand.held != NOBODY:
        away = elementary.dist(hand.model.place(hand.held), hand.at)
        hand.model.changed = True
        hand.model.balls.resize(hand.held, min(max(away, LEAST), LARGEST))
    return ""


def _drop(hand: Hand) -> None:
    if hand.model.held != NOBODY:
        hand.model.put_down(hand.model.held, 0.0)
    hand.model.held = NOBODY


USES = {
    "hand": Use(_grab, _move, _put_down), "ball": Use(_make, _move, _put_down),
    "size": Use(_take_size, _size), "draw": TOOLS.draw(), "bend": TOOLS.bend(),
    "delete": TOOLS.delete(_there),
}  # fmt: skip


def metal_hand(model: MetalWorld) -> Hand:
    """The right button takes away."""
    return Hand(model, USES, (-FARTHEST, -FARTHEST), (FARTHEST, FARTHEST), right="delete", drop=_drop)

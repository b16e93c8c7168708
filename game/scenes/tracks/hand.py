"""The hand on tracks: moves and makes balls, draws, bends and takes away tracks while it runs."""

from __future__ import annotations

from game.scenes.tracks.level import BallEntry
from game.scenes.tracks.world import COLOURS, TracksWorld
from game.worlds.hands.hand import NOBODY, Hand, Use
from game.worlds.hands.tracks import TrackTools

FARTHEST = 1e4  # m
SHARES = {"disc": 0.5, "sphere": 0.4, "ring": 1.0}
MOST_TRACKS, MOST_BALLS = 40, 2_000
TOOLS = TrackTools(0.03, 1e9, 0.1, MOST_TRACKS)


def _grab(hand: Hand) -> str:
    hand.held = hand.model.held = TOOLS.ball_at(hand)
    return _move(hand)


def _make(hand: Hand) -> str:
    model: TracksWorld = hand.model
    count, parameters = len(model.balls.energies), model.parameters
    if count >= MOST_BALLS:
        return f"There can be at most {MOST_BALLS} balls."
    entry = BallEntry(
        position=hand.at, radius=parameters.radius, share=SHARES[parameters.form],
        colour=COLOURS[count % (len(COLOURS) - 1)], seated=False,  # type: ignore[arg-type]
    )  # fmt: skip
    hand.held = model.held = model.add(entry)
    return ""


def _move(hand: Hand) -> str:
    if hand.held != NOBODY:
        hand.model.hold(hand.held, hand.at)
    return ""


def _put_down(hand: Hand) -> str:
    if hand.held != NOBODY:
        hand.model.put_down(hand.held, 0.5 * TOOLS.reach(hand))
    return ""


def _select(hand: Hand) -> str:
    """Show what the ball under the pointer has of its own; none beside all balls."""
    ball, hand.point = TOOLS.ball_at(hand), None
    hand.model.inspect(ball)
    return ""


def _drop(hand: Hand) -> None:
    model: TracksWorld = hand.model
    if 0 <= model.held < len(model.balls.energies):
        model.begin_here(model.held)
    model.held = NOBODY


USES = {
    "hand": Use(_grab, _move, _put_down), "select": Use(_select),
    "ball": Use(_make, _move, _put_down), "draw": TOOLS.draw(), "bend": TOOLS.bend(),
    "delete": TOOLS.delete(),
}  # fmt: skip


def track_hand(model: TracksWorld) -> Hand:
    """The right button selects."""
    return Hand(model, USES, (-FARTHEST, -FARTHEST), (FARTHEST, FARTHEST), right="select", drop=_drop)

"""Replay and set-up: two ways to look at the billiard table, or lay it out, without playing."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from game.billiards.game.arrangement import is_free, nearest_free, racked
from game.billiards.game.games import Practice
from game.billiards.game.rules import CUE_BALL, Call, Hand
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards import round as rounds
from game.scenes.billiards.play import AIMING, REPLAY, REPLAY_S, SET_UP, lay_out, shown_s, start_phase

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards

REPLAY_SPEEDS = (0.0625, 0.125, 0.25, 0.5, 1.0, 2.0)


def watch(scene: Billiards) -> None:
    """Into the replay of the last stroke, or out of it."""
    if scene.phase == REPLAY:
        leave(scene)
    elif scene.phase == AIMING and scene.round.last is not None:
        scene.grip = ""
        scene.cue.let_go()
        scene.clock[REPLAY_S] = 0.0
        scene.replay_runs = True
        start_phase(scene, REPLAY)
    elif scene.phase == AIMING:
        scene.told.append("Nothing to show. No stroke has been played.")


def run_replay(scene: Billiards, dt: float) -> None:
    """Let the replay go on; it stops at the end of the stroke."""
    if not scene.replay_runs or scene.grip == "scrub":
        return
    scene.clock[REPLAY_S] = min(scene.clock[REPLAY_S] + dt * scene.replay_speed, shown_s(scene))
    if scene.clock[REPLAY_S] >= shown_s(scene):
        scene.replay_runs = False


def toggle_replay(scene: Billiards) -> None:
    """Run or stand; from the end it begins anew."""
    if not scene.replay_runs and scene.clock[REPLAY_S] >= shown_s(scene):
        scene.clock[REPLAY_S] = 0.0
    scene.replay_runs = not scene.replay_runs


def change_replay_speed(scene: Billiards) -> None:
    """The next slower speed, and after the slowest the fastest."""
    place = REPLAY_SPEEDS.index(scene.replay_speed)
    scene.replay_speed = REPLAY_SPEEDS[(place - 1) % len(REPLAY_SPEEDS)]


def set_up(scene: Billiards) -> None:
    """Into the free placing of balls, or out of it."""
    if scene.phase == SET_UP:
        leave(scene)
    elif scene.phase == AIMING:
        scene.grip = ""
        scene.cue.let_go()
        scene.plays_itself = False
        scene.round = msgspec.structs.replace(scene.round, earlier=rounds.shortened(scene.round))
        start_phase(scene, SET_UP)


def leave(scene: Billiards) -> None:
    """Out of replay or set-up; what was set up is practised."""
    if scene.phase == SET_UP and scene.round.earlier is not None:
        before = scene.round.earlier
        if before.places != scene.round.places:
            numbers = tuple(number for number, _, _ in scene.round.places if number != CUE_BALL)
            hand: Hand = "" if scene.round.white is not None else "anywhere"
            game = Practice(rack="", on_table=numbers, opening=False, in_hand=hand)
            scene.round = rounds.with_white(
                msgspec.structs.replace(scene.round, game=game, last=None, words=(), call=Call())
            )
            lay_out(scene)
        else:
            scene.round = before
    scene.grip = ""
    start_phase(scene, AIMING)


def fill_table(scene: Billiards, full: bool) -> None:
    """While balls are placed: all of them racked, or the white one alone."""
    if scene.phase != SET_UP:
        return
    frame = scene.round.frame
    lie = racked(frame.table, "eight-ball", scene.round.conditions.balls)
    kept = lie if full else lie.without(*range(1, 16))
    scene.round = msgspec.structs.replace(scene.round, places=rounds.places_from(kept))
    lay_out(scene)


def ball_to_place(scene: Billiards, x: float, y: float) -> int:
    """Number of the ball on the table or in the tray at a point; -1 if there is none."""
    for number, bx, by in scene.round.places:
        if layout.near((bx, by), x, y, BALL_RADIUS):
            return number
    for number in range(16):
        if layout.near(layout.tray_place(number), x, y, BALL_RADIUS):
            return number
    return -1


def drag_ball(scene: Billiards, number: int, x: float, y: float) -> None:
    """The ball goes where the pointer is, if it may lie there."""
    if scene.phase != SET_UP or not layout.TABLE.holds(x, y):
        return
    lie, table = scene.round.lie, scene.round.conditions.table
    if not is_free(lie, table, number, x, y):
        try:
            x, y = nearest_free(lie, table, number, x, y)
        except ValueError:
            return
    placed = lie.with_ball(number, (x, y))
    scene.round = msgspec.structs.replace(scene.round, places=rounds.places_from(placed))
    lay_out(scene)


def put_down(scene: Billiards, number: int, x: float, y: float) -> None:
    """A ball let go beside the table goes back into the tray."""
    if scene.phase == SET_UP and not layout.TABLE.holds(x, y) and number in scene.round.lie.numbers:
        lie = scene.round.lie.without(number)
        scene.round = msgspec.structs.replace(scene.round, places=rounds.places_from(lie))

"""What is called before a stroke: the ball aimed at, and the pocket on its line."""

from __future__ import annotations

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.table.aim import first_contact
from game.billiards.table.table import Table
from game.physics.kernels import elementary


def call_for(frame: Frame, call: Call, stroke: Stroke) -> Call:
    """What is announced: by hand (``call``), or else the ball aimed at and the pocket on its line."""
    if call.safety or call.push_out or not frame.game.needs_call():
        return call
    balls, table = frame.layout, frame.table
    in_play = np.ones(len(balls.numbers), dtype=np.bool_)
    row = balls.numbers.index(CUE_BALL)
    first = first_contact(row, stroke.azimuth, balls.positions, balls.radii, in_play, table)
    ball = call.ball
    if ball is None and first.kind == "ball":
        ball = balls.numbers[first.target]
    if ball is None or ball == CUE_BALL or ball not in balls.numbers:
        return call
    if call.pocket is None and first.kind == "ball" and balls.numbers[first.target] == ball:
        direction = elementary.atan2(first.normal[1], first.normal[0])
        onward = first_contact(first.target, direction, balls.positions, balls.radii, in_play, table)
        pocket = onward.target if onward.kind == "pocket" else nearest_pocket(table, onward.ghost)
        return Call(ball, pocket)
    return Call(ball, call.pocket)


def nearest_pocket(table: Table, place: tuple[float, float]) -> int | None:
    """Row of the pocket nearest to a place; None where there is none."""
    pockets = table.pockets
    if not len(pockets):
        return None
    apart = pockets[:, :2] - np.asarray(place)
    return int((apart * apart).sum(axis=1).argmin())


def announced(frame: Frame, call: Call) -> Call:
    """A push-out where one is allowed, then a safety where shots are called; once more takes it back."""
    if frame.game.may_push_out() and not (call.push_out or call.safety):
        return Call(push_out=True)
    if frame.game.needs_call():
        return Call(safety=not call.safety)
    return Call() if frame.game.may_push_out() else call

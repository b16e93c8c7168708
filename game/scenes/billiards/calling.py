"""What is announced before a stroke: ball and pocket, by hand or by the aim; safeties, push-outs."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import CUE_BALL, Call
from game.billiards.table.aim import first_contact
from game.scenes.billiards.play import AIMING

if TYPE_CHECKING:
    from game.scenes.billiards.scene import Billiards


def call_for(scene: Billiards, stroke: Stroke) -> Call:
    """What is announced: by hand, or else the ball aimed at and the pocket on its line."""
    call = scene.call
    if call.safety or call.push_out or not scene.round.game.needs_call():
        return call
    lie, table = scene.round.lie, scene.round.conditions.table
    in_play = np.ones(len(lie.numbers), dtype=np.bool_)
    row = lie.numbers.index(CUE_BALL)
    first = first_contact(row, stroke.azimuth, lie.positions, lie.radii, in_play, table)
    ball = call.ball
    if ball is None and first.kind == "ball":
        ball = lie.numbers[first.target]
    if ball is None or ball == CUE_BALL or ball not in lie.numbers:
        return call
    if call.pocket is None and first.kind == "ball" and lie.numbers[first.target] == ball:
        way = math.atan2(first.normal[1], first.normal[0])
        onward = first_contact(first.target, way, lie.positions, lie.radii, in_play, table)
        pocket = onward.target if onward.kind == "pocket" else nearest_pocket(scene, onward.ghost)
        return Call(ball, pocket)
    return Call(ball, call.pocket)


def nearest_pocket(scene: Billiards, place: tuple[float, float]) -> int | None:
    """Row of the pocket nearest to a place; None where there is none."""
    pockets = scene.round.conditions.table.pockets
    if not len(pockets):
        return None
    apart = pockets[:, :2] - np.asarray(place)
    return int((apart * apart).sum(axis=1).argmin())


def announce(scene: Billiards) -> None:
    """A push-out where one is allowed, else a safety; once more takes it back."""
    if scene.phase != AIMING:
        return
    if scene.round.game.may_push_out():
        scene.call = Call(push_out=not scene.call.push_out)
    elif scene.round.game.needs_call():
        scene.call = Call(safety=not scene.call.safety)

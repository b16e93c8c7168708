"""What a stroke was, in figures: how far, how thin, how likely, and how far it strayed."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromPlayed
from game.billiards.game.carom_summary import BALL as BALL_TOUCHED
from game.billiards.game.frame import Frame, Played
from game.billiards.game.kinds import BREAK, POINT, POT
from game.billiards.game.rules import CUE_BALL
from game.billiards.game.summary import summarize
from game.billiards.map.carom import Position
from game.billiards.search.aims import all_aims
from game.billiards.search.candidates import BALL, CHANCE
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise
from game.billiards.search.view import View
from game.billiards.shot.trajectory import Trajectory
from game.billiards.table.aim import first_contact
from game.billiards.table.carom import BALL_RADIUS
from game.physics.kernels import elementary

MANY = 64  # candidates that are looked at
DRAWS, SEED = 96, 67  # strokes of a hand that a point's chance is counted from
CUSHION_CUT = 0.0  # degrees; said of a ball that is met by way of a cushion


class Measured(NamedTuple):
    """kind: POT, BREAK or POINT. distance m to the contact; cut, degrees; made: the ball that was hit fell,
    or the point was made; chance: of its likeliest pocket by geometry, or of the point for a hand of usual
    noise; stray: of the cue ball from where it was meant, m, or None; cushions: before the first ball.
    """

    kind: str
    distance: float
    cut: float
    made: bool
    chance: float
    stray: float | None
    cushions: int = 0


def measured(before: Frame, played: Played, meant: Stroke) -> Measured | None:
    """A stroke in figures; None if it was aimed at no ball. before: the frame it was played on; meant: the
    stroke as the person aimed it.
    """
    layout = before.layout
    if CUE_BALL not in layout.numbers:
        return None
    cue = layout.numbers.index(CUE_BALL)
    every = np.ones(len(layout.numbers), dtype=np.bool_)
    hit = first_contact(cue, meant.azimuth, layout.positions, layout.radii, every, before.table)
    if hit.kind != "ball":
        return None
    number = layout.numbers[hit.target]
    view = View(Board(layout, before.table, before.physics), Noise())
    candidates = view.candidates(all_aims(layout.numbers, (number,), (), 0), ("direct",), MANY)
    mine = candidates[candidates[:, BALL] == hit.target] if len(candidates) else candidates
    chance = float(mine[:, CHANCE].max()) if len(mine) else 0.0
    return Measured(
        BREAK if before.game.opening else POT, float(hit.distance), math.degrees(hit.cut),
        number in played.summary.balls_down, min(max(chance, 0.0), 1.0), _stray(before, played, meant),
    )  # fmt: skip


def measured_point(position: Position, played: CaromPlayed, meant: Stroke) -> Measured | None:
    """A stroke of carom in figures; None if its line leads to nothing. position: that it was played from."""
    rows = position.places[position.order]
    hit = first_contact(
        0, meant.azimuth, rows, np.full(3, BALL_RADIUS), np.ones(3, dtype=np.bool_), position.board.table
    )
    if hit.kind not in ("ball", "cushion"):
        return None
    strokes = with_noise(np.array([meant]), draw_noise(SEED, DRAWS), Noise(), BALL_RADIUS)
    chance = float(position.wanted.scores(position.play(strokes)).mean())
    struck, stray = played.frame.last, None
    if struck is not None and struck.stroke != meant:
        there = position.play(np.array([meant])).ends[0, 0].tolist()
        here = played.summary.rest[position.cue].tolist()
        stray = elementary.hypot(there[0] - here[0], there[1] - here[1])
    path = [kind for kind, _ in played.summary.path]
    first = path.index(BALL_TOUCHED) if BALL_TOUCHED in path else len(path)
    cut = math.degrees(hit.cut) if hit.kind == "ball" else CUSHION_CUT
    return Measured(POINT, float(hit.distance), cut, played.verdict.scored, chance, stray, first)


def _stray(before: Frame, played: Played, meant: Stroke) -> float | None:
    """How far apart the cue ball lies from where the stroke as it was meant would have left it, m."""
    struck = played.frame.last
    if struck is None or struck.stroke == meant:
        return None
    try:
        wanted = before.play(meant, struck.call).trajectory
    except ValueError:
        return None
    there, here = _rest(wanted), _rest(played.trajectory)
    if there is None or here is None:
        return None
    return elementary.hypot(there[0] - here[0], there[1] - here[1])


def _rest(trajectory: Trajectory) -> tuple[float, float] | None:
    """Where the cue ball comes to rest, m; None if it goes down or off."""
    for number, x, y in summarize(trajectory).rest:
        if number == CUE_BALL:
            return x, y
    return None

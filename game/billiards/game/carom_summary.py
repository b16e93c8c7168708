"""From a played stroke at carom to what the referee sees of it: what the cue ball touched, in order."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.rules import CUE_BALL, ShotSummary
from game.billiards.laws import state as s
from game.billiards.shot.trajectory import Trajectory
from game.billiards.table.balk import FREE, Barred, Zone, zone_at
from game.billiards.table.carom import BALL_NAMES, RED, frozen_cushions, touching

BALL, CUSHION = "ball", "cushion"
LOOKS = 8  # at each stretch of a path, for whether it leaves a corner


class CaromSummary(NamedTuple):
    """What a stroke did. Balls: WHITE, YELLOW, RED; cushions: left, right, lower, upper, 0 to 3.

    path: what the cue ball touched, in order, without the cushion that it lay against and was played into.
    into: balls that it lay against and was played into. rest (3, 2) m. off_table: balls that left the table.
    left_corner, left_anchor: object balls that were outside the barred corner or box they began in, or
    outside the anchor, if only for a moment.
    """

    path: tuple[tuple[str, int], ...]
    rest: Floats
    into: tuple[int, ...] = ()
    off_table: tuple[int, ...] = ()
    left_corner: tuple[int, ...] = ()
    left_anchor: tuple[int, ...] = ()

    def scoring(self, cue: int) -> Scoring | None:
        """Order of touches up to the second object ball; None if the cue ball did not touch both."""
        met: set[int] = set()
        for at, (kind, number) in enumerate(self.path):
            if kind == BALL:
                met.add(number)
            if met == {1 - cue, RED}:
                order = self.path[: at + 1]
                return Scoring(order, sum(1 for kind, _ in order if kind == CUSHION))
        return None


class Scoring(NamedTuple):
    """A cannon: touches of the cue ball up to the second object ball, and how many were cushions."""

    order: tuple[tuple[str, int], ...]
    cushions: int


def summarize_carom(trajectory: Trajectory, cue: int, barred: Barred = FREE) -> CaromSummary:
    """Summary of a played stroke with ball `cue`, balls named as BALL_NAMES are. ValueError for others.

    barred: the zones of the game.
    """
    numbers = [_number(name) for name in trajectory.shot.ids]
    row = numbers.index(cue)
    start = trajectory.shot.positions
    against = frozen_cushions((float(start[row, 0]), float(start[row, 1])))
    places = np.empty((3, 2))
    places[numbers] = start
    near = touching(places, cue)
    path: list[tuple[str, int]] = []
    into: tuple[int, ...] = ()
    for _, event, i, j in trajectory.rows.tolist():
        if event == s.BALL_BALL and row in (i, j):
            ball = numbers[int(j if i == row else i)]
            if not path and ball in near:
                into = (ball,)
            path.append((BALL, ball))
        elif event == s.BALL_CUSHION and i == row and (path or int(j) not in against):
            path.append((CUSHION, int(j)))
        elif event == s.BALL_CUSHION and i == row:
            against = ()  # it has left that cushion; from now on it counts
    rest = np.empty((3, 2))
    rest[numbers] = trajectory.end[:, [s.IN_X, s.IN_Y]]
    left, away = (
        tuple(ball for ball in (1 - cue, RED) if _leaves(trajectory, numbers.index(ball), zones))
        for zones in (barred.boxes, barred.anchors)
    )
    off = tuple(numbers[int(i)] for _, event, i, _ in trajectory.rows.tolist() if event == s.BALL_OFF)
    return CaromSummary(tuple(path), rest, into, off, left, away)


def as_shot(summary: CaromSummary, cue: int) -> ShotSummary:
    """A stroke at carom as goals see strokes: the cue ball is 0, the other one 1, the red ball 2.

    What pool alone asks for (pockets, balls driven to cushions) is empty.
    """
    number = {cue: CUE_BALL, 1 - cue: 1, RED: RED}
    path = tuple((kind, number[one] if kind == BALL else one) for kind, one in summary.path)
    met = tuple(dict.fromkeys(one for kind, one in path if kind == BALL))
    return ShotSummary(
        first=met[:1], off_table=tuple(number[ball] for ball in summary.off_table), cue_path=path,
        touched=met,
        rest=tuple(
            (number[ball], float(x), float(y)) for ball, (x, y) in enumerate(summary.rest.tolist())
            if ball not in summary.off_table
        ),
    )  # fmt: skip


def _number(name: str) -> int:
    if name not in BALL_NAMES:
        raise ValueError(f"balls: carom is played with {', '.join(BALL_NAMES)}, not {name!r}")
    return BALL_NAMES.index(name)


def _leaves(trajectory: Trajectory, row: int, zones: tuple[Zone, ...]) -> bool:
    """True if a ball that begins in one of the zones is seen outside it."""
    x, y = trajectory.shot.positions[row].tolist()
    zone = zone_at(zones, (x, y))
    if zone < 0:
        return False
    segments = trajectory.segments
    times = [*segments[segments[:, s.SEG_BALL] == row, s.SEG_TIME].tolist(), trajectory.end_time]
    for begin, end in pairwise(times):
        for share in np.linspace(0.0, 1.0, LOOKS).tolist():
            px, py = trajectory.state_at(begin + share * (end - begin)).positions[row].tolist()
            if zone_at(zones[zone : zone + 1], (px, py)) < 0:
                return True
    return False

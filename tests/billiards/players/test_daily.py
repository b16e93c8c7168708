"""The challenge of a day: from the date alone, solvable, and its par is that of a stroke that was played."""

from __future__ import annotations

import math

import pytest

from game.billiards.game.arrangement import arrange
from game.billiards.game.goals import missed
from game.billiards.game.rules import CUE_BALL
from game.billiards.players.daily import (
    LEAST_PAR,
    MOST_PAR,
    NEAR,
    challenge_of,
    distance,
    frame_of,
)
from game.billiards.table.table import Table

DAYS = ("2026-11-23", "2026-11-24", "2027-02-28")


@pytest.mark.parametrize("day", DAYS)
def test_the_solution_reaches_par_and_meets_every_goal(day):
    found = challenge_of(day)
    assert LEAST_PAR <= found.par <= MOST_PAR
    layout = arrange({number: (x, y) for number, x, y in found.balls})
    played = frame_of(layout, Table.pool()).play(found.stroke)
    rest = {ball: (x, y) for ball, x, y in played.summary.rest}
    assert math.dist(rest[CUE_BALL], found.place) == pytest.approx(found.par, rel=1e-9)
    assert 1 in {one.ball for one in played.summary.pocketed}
    near, as_near = found.goals[1].zones[0].radius, found.goals[2].zones[0].radius
    assert near == pytest.approx(NEAR * as_near) and as_near == found.par
    assert not missed(found.goals[0], played.summary) and not missed(found.goals[1], played.summary)
    weak = frame_of(layout, Table.pool()).play(found.stroke._replace(cue_speed=0.1))
    assert distance(weak, found.place) is None


def test_a_day_is_the_same_for_all_and_no_other_day_is():
    assert challenge_of(DAYS[0]) == challenge_of(DAYS[0])
    assert len({challenge_of(day).balls for day in DAYS}) == len(DAYS)
    with pytest.raises(ValueError, match="isoformat"):
        challenge_of("tomorrow")

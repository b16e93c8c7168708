"""A match that plays itself: every round holds when it is played again from its own record."""

from __future__ import annotations

import copy
import json
from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

from game.billiards import Table, simulate
from game.billiards.game.arrangement import Stroke, arrange
from game.billiards.game.summary import summarize
from game.billiards.players import match_search
from game.billiards.players.match import (
    check_match_data,
    match_data,
    play_match,
    unlike_balls,
    what_counts,
)
from game.billiards.players.match_search import count_neighbours, is_clean
from game.billiards.search.candidates import AIM, COLUMNS, SPREAD, WINDOW
from game.billiards.search.fans import make_styles
from game.billiards.search.outcomes import DOWN
from game.billiards.search.strokes import AZIMUTH, Board
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot_file import parse_shot
from game.billiards.shot.shot_writing import shot_data
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from tests.billiards.search.search_tables import POOL, random_strokes, scattered

PHYSICS = Physics()
SEEDS = (1, 2)


@pytest.fixture(scope="module")
def matches():
    return {seed: play_match(seed) for seed in SEEDS}


@pytest.fixture
def record(matches):
    """A record as it comes back from a file; each test may spoil its own."""
    return json.loads(json.dumps(match_data(matches[1], "A title")))


@pytest.mark.compiled
@pytest.mark.parametrize("seed", SEEDS)
def test_every_round_holds_by_its_own_record(matches, seed):
    match = matches[seed]
    data = json.loads(json.dumps(match_data(match)))
    check_match_data(data)
    assert len(match.rounds) == 15
    assert sorted(one.fallen.ball for one in match.rounds) == list(range(1, 16))
    assert [one.player for one in match.rounds] == [k % 2 for k in range(15)]
    for one, said in zip(match.rounds, data["rounds"], strict=True):
        again = simulate(parse_shot(said["shot"]))
        assert again.digest == one.trajectory.digest
        assert again.final[said["ball"]] == "pocketed" and again.final["0"] != "pocketed"
        assert ("ball-pocket", (said["ball"], said["pocket"])) in [(e.type, e.ids) for e in again.events]


@pytest.mark.compiled
@pytest.mark.parametrize("seed", SEEDS)
def test_every_ball_but_the_last_falls_by_way_of_another(matches, seed):
    """Told by the contacts alone: after the break the ball that falls was hit once, by a numbered one."""
    *rounds, last = matches[seed].rounds
    assert all(len(one.fallen.chain) >= 3 for one in rounds) and last.fallen.chain == (0, last.fallen.ball)
    for one in rounds[1:]:
        hits = [e.ids for e in one.trajectory.events if e.type == "ball-ball"]
        ball = str(one.fallen.ball)
        fell = next(e.time for e in one.trajectory.events if e.type == "ball-pocket")
        before = [e.ids for e in one.trajectory.events if e.type == "ball-ball" and e.time < fell]
        mine = [ids for ids in before if ball in ids]
        assert len(mine) == 1 and "0" not in mine[0]
        assert hits[0][0] == "0"


@pytest.mark.compiled
@pytest.mark.parametrize("seed", SEEDS)
def test_balls_lie_where_the_round_before_left_them(matches, seed):
    rounds = matches[seed].rounds
    for before, after in pairwise(rounds):
        left = {name: place for name, place in before.trajectory.final.items() if place != "pocketed"}
        now = dict(zip(after.shot.ids, after.shot.positions.tolist(), strict=True))
        assert set(now) == set(left)
        assert all(now[name] == pytest.approx(left[name], abs=1e-12) for name in now)


@pytest.mark.compiled
def test_a_match_is_long_enough_to_watch_and_its_balls_differ(matches):
    match = matches[1]
    assert match.playing_time > 45.0
    breaks = [one.rounds[0].stroke.cue_speed for one in matches.values()]
    assert all(4.0 <= speed <= 6.0 for speed in breaks), "a match begins with a break"
    assert len(set(match.balls.radii.tolist())) == len(set(match.balls.masses.tolist())) == 16
    assert match.balls.radii[0] == BALL_RADIUS and match.balls.masses[0] == BALL_MASS
    assert not np.array_equal(unlike_balls(1).radii, unlike_balls(2).radii)


@pytest.mark.compiled
def test_equal_seeds_give_equal_matches_on_any_number_of_threads(matches):
    again = play_match(2, threads=1)
    assert [one.trajectory.digest for one in again.rounds] == [
        one.trajectory.digest for one in matches[2].rounds
    ]
    assert match_data(again) == match_data(matches[2])


SPOILED = [
    (lambda d: d["rounds"].pop(4), "balls that the round before left"),
    (lambda d: d["rounds"].pop(), "1 balls are left"),
    (lambda d: d["rounds"][3]["chain"].insert(1, "15"), r"rounds\[3\]: ball, pocket and chain"),
    (lambda d: d["rounds"][3].update(pocket="nowhere"), r"rounds\[3\]: ball, pocket"),
    (lambda d: d["rounds"][2]["shot"]["balls"][0].update(velocity=[0.0, 0.1]), r"rounds\[2\].shot: no ball"),
    (lambda d: d["rounds"][2]["shot"].pop("table"), "table: is missing"),
]


@pytest.mark.compiled
@pytest.mark.parametrize(("spoil", "complaint"), SPOILED)
def test_a_record_that_does_not_hold_is_refused(record, spoil, complaint):
    check_match_data(copy.deepcopy(record))
    spoil(record)
    with pytest.raises(ValueError, match=complaint):
        check_match_data(record)


def test_a_ball_that_falls_directly_does_not_count():
    layout = arrange({0: (0.8, 1.27), 1: (0.3, 1.27), 2: (0.9, 0.4)})
    shot = layout.shot(POOL, PHYSICS, Stroke(1.0, np.pi, tip_up=-0.3))
    assert what_counts(simulate(shot), 2) is None
    alone = layout.without(2).shot(POOL, PHYSICS, Stroke(1.0, np.pi, tip_up=-0.3))
    assert what_counts(simulate(alone), 1).chain == (0, 1)


@pytest.mark.parametrize("chain", [0, 3])
def test_clean_is_what_the_referee_calls_so(chain):
    layout = scattered(12)
    strokes = random_strokes(4, 600)
    outcomes = Board(layout, POOL).play(strokes)
    clean = is_clean(outcomes, chain)
    down = np.flatnonzero(outcomes.facts[:, DOWN])
    assert not clean[np.setdiff1d(np.arange(len(strokes)), down)].any() and clean.any()
    for k in down.tolist():
        trajectory = simulate(layout.shot(POOL, PHYSICS, Stroke(*strokes[k].tolist())))
        summary = summarize(trajectory)
        expected = len(summary.pocketed) == 1 and not summary.cue_pocketed
        if expected and chain:
            fallen = summary.pocketed[0]
            hits = sum(str(fallen.ball) in e.ids for e in trajectory.events if e.type == "ball-ball")
            expected = hits == 1 and what_counts(trajectory, 15) == fallen
        assert clean[k] == expected


def test_neighbours_in_a_run():
    good = np.array([0, 1, 1, 1, 0, 1, 1, 1, 1], np.int64)
    fans = np.array([0, 0, 0, 0, 0, 0, 0, 1, 1], np.int64)
    room = np.empty(9, np.int64)
    count_neighbours(good, fans, room)
    assert room.tolist() == [0, 1, 3, 1, 0, 1, 1, 1, 1]


def test_a_written_shot_reads_back_to_the_same_play():
    shot = scattered(3).shot(POOL, PHYSICS, Stroke(2.0, 1.0, 0.2, 0.3, -0.2))
    data = json.loads(json.dumps(shot_data(shot)))
    again = parse_shot(data)
    assert again.ids == shot.ids and again.physics == shot.physics
    assert np.allclose(again.balls, shot.balls, rtol=0.0, atol=1e-15)
    assert shot_data(parse_shot(shot_data(again))) == shot_data(again)
    bare = arrange({0: (0.5, 0.5)}).shot(Table.bare(1.0, 2.0), PHYSICS, Stroke(1.0, 0.0))
    assert parse_shot(shot_data(bare)).table.cushions.tolist() == bare.table.cushions.tolist()


def test_a_window_is_as_wide_as_its_rays_lie_apart(monkeypatch):
    """What a stroke of a fan counts for is the angle to the next one."""
    seen = []
    monkeypatch.setattr(match_search, "_ranked", lambda view, *given: seen.extend(given[:3]) or [])
    candidates = np.zeros((2, COLUMNS))
    candidates[:, AIM], candidates[:, SPREAD], candidates[:, WINDOW] = (0.3, 2.0), (0.02, 0.3), (0.02, 0.01)
    view = SimpleNamespace(board=Board(arrange({0: (0.8, 1.27), 1: (0.3, 1.27)}), POOL))
    styles = make_styles((1.0, 2.0), (-0.3, 0.3), (0.0,))
    match_search._from_fans(view, candidates, styles, 3, 1, None)
    strokes, steps, fans = seen
    within = np.diff(fans) == 0
    assert len(steps) == len(strokes) and len(set(fans.tolist())) == 8
    assert steps[1:][within] == pytest.approx(np.diff(strokes[:, AZIMUTH])[within], rel=1e-9)

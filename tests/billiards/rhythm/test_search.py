"""The search for a shot on the beat: impacts are where they should be, the same ones for the same seed."""

import math

import numpy as np
import pytest

from game.billiards.rhythm.candidates import EXTRA, FARTHEST_MISS, STROKE, Candidates, are_apart
from game.billiards.rhythm.hearing import clicks_of
from game.billiards.rhythm.search import MOST_BEATS, Rhythm, RhythmSearch, check_beats, rhythm_of
from game.billiards.shot.physics import Physics
from game.billiards.simulation import simulate_exact
from game.billiards.table.table import Table

TABLE = Table.pool()
BEATS = (0.0, 0.4, 0.7, 1.1)


@pytest.fixture(scope="module")
def found():
    return RhythmSearch(BEATS, TABLE, seed=2).run(6, good_s=1e-9)


def test_every_beat_has_its_impact_to_rounding(found):
    assert found is not None and found.extras == 0
    assert max(map(abs, found.misses)) < 1e-9
    assert len(found.impacts) == len(BEATS)


@pytest.mark.parametrize(("impacts", "extras"), [(1, 0), (2, 0), (5, 3)])
def test_the_cost_is_the_mean_miss_capped_and_what_every_extra_impact_costs(impacts, extras):
    misses = (0.01, -0.02, 10.0 * FARTHEST_MISS)
    made = Rhythm(None, (0.0, 0.5), tuple(0.1 * k for k in range(impacts)), misses, (), 1.0)
    mean = math.sqrt((0.01**2 + 0.02**2 + FARTHEST_MISS**2) / 3.0)
    assert made.extras == extras
    assert made.cost == pytest.approx(mean + extras * EXTRA, rel=1e-12)


def test_the_shot_played_again_is_heard_the_same(found):
    heard = clicks_of(simulate_exact(found.shot))
    assert heard[: len(found.impacts)] == found.impacts and all(t > BEATS[-1] for t in heard[len(BEATS) :])
    row = np.array(found.candidate)
    again = Candidates(TABLE, Physics(), len(BEATS)).shot(row)
    assert again.balls.tolist() == found.shot.balls.tolist()


def test_the_same_seed_finds_the_same_and_another_another(found):
    assert RhythmSearch(BEATS, TABLE, seed=2).run(6, good_s=1e-9).candidate == found.candidate
    assert RhythmSearch(BEATS, TABLE, seed=3).run(6, good_s=1e-9).candidate != found.candidate


def test_varying_never_makes_it_worse():
    search = RhythmSearch((0.0, 1.0, 2.0, 3.0), TABLE, seed=1)
    costs = []
    for _ in range(9):
        search.improve()
        if search.laid:
            costs.append(search.best().cost)
    assert len(costs) == 7 and costs == sorted(costs, reverse=True)


def test_rough_costs_are_those_of_all_impacts(found):
    candidates = Candidates(TABLE, Physics(), len(BEATS))
    rng = np.random.default_rng(4)
    rows = np.array(found.candidate) + rng.normal(0.0, 0.05, (40, STROKE + 2 * len(BEATS)))
    costs = candidates.rough_costs(rows, np.array(BEATS))
    assert np.isfinite(costs).sum() > 20
    for row, cost in zip(rows, costs.tolist(), strict=True):
        if math.isfinite(cost):
            times = [one[0] for one in simulate_exact(candidates.shot(row)).rows.tolist() if one[1] < 4]
            times = [time for time in times if time <= BEATS[-1] + 0.012]
            misses = [min([FARTHEST_MISS, *(abs(t - beat) for t in times)]) for beat in BEATS[1:]]
            merged = [0.0]
            for time in times:
                if time - merged[-1] >= 0.012 and time <= BEATS[-1] + 0.012:
                    merged.append(time)
            extras = max(len(merged) - len(BEATS), 0)
            assert cost == pytest.approx(
                math.sqrt(sum(miss * miss for miss in misses) / len(BEATS)) + EXTRA * extras, abs=1e-9
            )


def test_balls_in_one_another_or_outside_cost_infinitely_much(found):
    candidates = Candidates(TABLE, Physics(), len(BEATS))
    row = np.array(found.candidate)
    inside = np.array([row, row, row])
    inside[1, STROKE : STROKE + 2] = inside[1, STROKE + 2 : STROKE + 4] + 1e-3
    inside[2, STROKE] = -0.2
    costs = candidates.rough_costs(inside, np.array(BEATS))
    assert math.isfinite(costs[0]) and costs[1] == costs[2] == math.inf
    assert are_apart(np.array([[0.0, 1.0]]), np.zeros((1, 2)), 0.9).tolist() == [True]
    assert are_apart(np.array([[0.0, 1.0]]), np.zeros((1, 2)), 1.1).tolist() == [False]


def test_misses_are_signed_late_is_positive(found):
    played = simulate_exact(found.shot, until=2.0)
    early = rhythm_of(played, (0.0, 0.39, 0.7, 1.12), np.array(found.candidate))
    assert early.misses[1] == pytest.approx(0.01) and early.misses[3] == pytest.approx(-0.02)
    assert early.error_s == pytest.approx(math.sqrt((0.01**2 + 0.02**2) / 4.0))


@pytest.mark.parametrize(
    ("beats", "said"),
    [
        ((), "2 to 16"),
        ((0.0,), "2 to 16"),
        (tuple(range(MOST_BEATS + 1)), "2 to 16"),
        ((0.0, 0.01), "between"),
        ((0.0, 0.5, 0.4), "between"),
        ((0.0, math.nan), "between"),
        ((0.0, 99.0), "in all"),
    ],
)
def test_beats_that_make_no_sense_are_refused(beats, said):
    with pytest.raises(ValueError, match=said):
        check_beats(beats)


def test_beats_count_from_the_first():
    assert check_beats((2.0, 2.5, 3.5)) == (0.0, 0.5, 1.5)


def test_the_last_impact_may_be_a_little_late(found):
    """What comes after the last beat, but together with it for the ear, is how far that beat is missed."""
    candidates = Candidates(TABLE, Physics(), len(BEATS))
    early = np.array([*BEATS[:-1], BEATS[-1] - 0.005])
    (cost,) = candidates.rough_costs(np.array([found.candidate]), early)
    assert cost == pytest.approx(0.005 / math.sqrt(len(BEATS)), abs=1e-7)

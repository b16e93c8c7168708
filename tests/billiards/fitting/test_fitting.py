"""Tracks made on a table that is known are explained again; what the errors of a fit are."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from game.billiards.fitting.errors import Goal
from game.billiards.fitting.evolution import Evolution
from game.billiards.fitting.fitting import (
    FittedShot,
    FittedStroke,
    computed_shot,
    fit_data,
    fit_shot,
    medians,
    split,
)
from game.billiards.fitting.made import MadeShot, as_fitted, make_tracks
from game.billiards.fitting.strokes import EVERYTHING, Bench, first_guess, root_mean_squares
from game.billiards.fitting.tables import START_OF_CAROM, FittedTable, TableSearch, resting_places, target_of
from game.billiards.fitting.tracks import TableSize, Track, TrackedShot, TrackFile
from game.billiards.laws.contacts import CUSHION_MODELS
from game.billiards.simulation import simulate_exact

TRUTH = FittedTable(
    TableSize(),
    START_OF_CAROM._replace(
        sliding=0.22, rolling=0.006, ball_friction=0.06, cushion_restitution=0.82, cushion_friction=0.2,
        ball_restitution=0.96, cushion_restitution_fall=0.02,
    ),
)  # fmt: skip
NOISE = 0.001


@pytest.fixture(scope="module")
def made() -> list[MadeShot]:
    return make_tracks(TRUTH, 6, seed=4, noise=NOISE)


def row_of(stroke: FittedStroke) -> np.ndarray:
    return np.array([stroke])


def moved(shot: TrackedShot, ball: int, by: tuple[float, float]) -> TrackedShot:
    """The shot with one ball's track, but for where it lay, seen elsewhere."""
    track = shot.tracks[ball]
    places = track.places + np.array(by)
    places[0] = track.places[0]
    tracks = list(shot.tracks)
    tracks[ball] = Track(track.times, places)
    return shot._replace(tracks=tuple(tracks))


def exact_track(seed: int = 1) -> MadeShot:
    return make_tracks(TRUTH, 1, seed=seed, noise=0.0)[0]


def test_the_true_stroke_explains_a_track_without_noise() -> None:
    for seed in range(5):
        one = exact_track(seed)
        sums, costs = Bench(target_of(one.tracked, TRUTH)).errors(
            TRUTH.ground, row_of(one.stroke), Goal(EVERYTHING, 0.1)
        )
        assert max(root_mean_squares(sums[0])) < 1e-9
        assert costs[0] < 1e-12
        assert sums[0, :, 2].tolist() == [len(track.times) for track in one.tracked.tracks]


@pytest.mark.parametrize(("way", "before"), [(0.0, 0.0), (0.06, 0.03), (0.3, 0.04)])
def test_the_first_guess_begins_when_the_ball_began_to_roll(way: float, before: float) -> None:
    """At its second sample it has come so far, at 2 m/s: it set out before that, but at most 40 ms."""
    times = 0.2 + np.array([-0.2, 0.0, 0.05, 0.1])
    gone = np.array([0.0, way, way + 0.1, way + 0.2])
    samples = np.column_stack([times, 0.5 + 0.6 * gone, 0.5 + 0.8 * gone])
    guess = first_guess(SimpleNamespace(ranges=np.array([[0, 4]]), samples=samples))
    assert guess[:2] == pytest.approx((math.atan2(0.8, 0.6), 2.0))
    assert guess[4] == pytest.approx(0.2 - before)


def test_errors_are_those_of_a_trajectory_asked_at_each_sample(made: list[MadeShot]) -> None:
    for one in made[:3]:
        stroke = one.stroke._replace(azimuth=one.stroke.azimuth + 0.01, speed=one.stroke.speed * 1.02)
        sums, _ = Bench(target_of(one.tracked, TRUTH)).errors(
            TRUTH.ground, row_of(stroke), Goal(EVERYTHING, 0.1)
        )
        played = simulate_exact(computed_shot(one.tracked, as_fitted(one)._replace(stroke=stroke), TRUTH))
        for ball, track in enumerate(one.tracked.tracks):
            places = [played.state_at(t - stroke.start).positions[ball] for t in track.times]
            squares = ((np.array(places) - track.places) ** 2).sum()
            assert sums[0, ball, 0] == pytest.approx(squares, rel=1e-9)


def test_rmse_is_over_all_samples_of_a_ball_and_of_all_balls() -> None:
    one = exact_track(2)
    counts = [len(track.times) for track in one.tracked.tracks]
    shot = moved(moved(one.tracked, 0, (0.003, 0.004)), 1, (0.0, 0.012))
    sums, costs = Bench(target_of(shot, TRUTH)).errors(
        TRUTH.ground, row_of(one.stroke), Goal(EVERYTHING, 0.1)
    )
    cue, every = root_mean_squares(sums[0])
    assert cue == pytest.approx(0.005 * math.sqrt((counts[0] - 1) / counts[0]), rel=1e-9)
    squares = (counts[0] - 1) * 0.005**2 + (counts[1] - 1) * 0.012**2
    assert every == pytest.approx(math.sqrt(squares / sum(counts)), rel=1e-9)
    robust = [0.1**2 * math.log1p((off / 0.1) ** 2) for off in (0.005, 0.012)]
    expected = (counts[0] - 1) * robust[0] + (counts[1] - 1) * robust[1]
    assert costs[0] == pytest.approx(expected, rel=1e-9)


def test_only_samples_before_the_horizon_count() -> None:
    one = exact_track(3)
    bench = Bench(target_of(one.tracked, TRUTH))
    sums, _ = bench.errors(TRUTH.ground, row_of(one.stroke), Goal(1.0, 0.1))
    assert sums[0, :, 2].tolist() == [int((track.times <= 1.0).sum()) for track in one.tracked.tracks]


def test_what_no_cue_can_do_costs() -> None:
    one = exact_track(1)
    bench = Bench(target_of(one.tracked, TRUTH))
    for change in ({"tip_left": 0.9}, {"tip_up": -0.9}, {"start": 1.0}, {"start": -1.0}, {"speed": -1.0}):
        stroke = one.stroke._replace(**change)
        sums, costs = bench.errors(TRUTH.ground, row_of(stroke), Goal(EVERYTHING, 0.1))
        assert costs[0] > sums[0, :, 1].sum() + 0.1


def test_a_stroke_is_found_again(made: list[MadeShot]) -> None:
    found = [fit_shot(one.tracked, TRUTH) for one in made]
    for shot, one in zip(found, made, strict=True):
        # what the noise leaves is sqrt(2) of it; balls begin where they were seen, and errors grow on the way
        assert shot.rmse_cue < 6.0 * NOISE
        assert shot.rmse_all < 6.0 * NOISE
        assert abs(math.remainder(shot.stroke.azimuth - one.stroke.azimuth, math.tau)) < 0.01
        assert shot.stroke.start == pytest.approx(one.stroke.start, abs=0.006)
    assert medians(found)[0] < 4.0 * NOISE
    # speed and tip of a shot that meets a ball at once can be told apart badly: the usual one is asked for
    off = np.abs([np.subtract(shot.stroke, one.stroke) for shot, one in zip(found, made, strict=True)])
    speed, left, up = np.median(off, axis=0)[1:4]
    assert speed < 0.03
    assert left < 0.02
    assert up < 0.02


def test_the_stroke_that_is_told_leads_to_the_error_that_is_told(made: list[MadeShot]) -> None:
    found = fit_shot(made[0].tracked, TRUTH)
    played = simulate_exact(computed_shot(made[0].tracked, found, TRUTH))
    track = made[0].tracked.tracks[0]
    places = [played.state_at(t - found.stroke.start).positions[0] for t in track.times]
    off = np.hypot(*(np.array(places) - track.places).T)
    assert found.rmse_cue == pytest.approx(math.sqrt((off**2).mean()), rel=1e-6)


def test_the_table_is_found_again(made: list[MadeShot]) -> None:
    start = FittedTable(TableSize(), START_OF_CAROM)
    fixed = ("spinning",)  # made with the value of the start
    search = TableSearch([one.tracked for one in made], start, fixed)
    found = search.run(((30, 1.0), (20, 0.4))).physics
    assert found.cushion_restitution == pytest.approx(TRUTH.physics.cushion_restitution, abs=0.02)
    assert found.rolling == pytest.approx(TRUTH.physics.rolling, abs=0.0005)
    assert found.ball_friction == pytest.approx(TRUTH.physics.ball_friction, abs=0.01)
    assert found.cushion_friction == pytest.approx(TRUTH.physics.cushion_friction, abs=0.03)
    assert found.ball_restitution == pytest.approx(TRUTH.physics.ball_restitution, abs=0.03)
    assert found.spinning == START_OF_CAROM.spinning


def test_the_same_tracks_give_the_same_table_and_strokes(made: list[MadeShot]) -> None:
    shots = [one.tracked for one in made[:2]]
    start = FittedTable(TableSize(), START_OF_CAROM)
    results = []
    for _ in range(2):
        table = TableSearch(shots, start).run(((2, 1.0),))
        results.append((table.physics, fit_shot(shots[0], table)))
    assert results[0] == results[1]


def test_what_is_fixed_stays() -> None:
    shot = exact_track(1).tracked
    start = FittedTable(TableSize(), START_OF_CAROM)
    names = list(TableSearch([shot], start).ranges)
    search = TableSearch([shot], start, fixed=names[1:])
    found = search.run(((1, 1.0),)).physics
    assert names[0] == "sliding"
    assert found.sliding != START_OF_CAROM.sliding
    assert found._replace(sliding=START_OF_CAROM.sliding) == START_OF_CAROM


def test_balls_seen_in_each_other_or_in_a_cushion_are_put_beside() -> None:
    radius = TRUTH.radius
    seen = np.array([[radius - 0.002, 0.5], [radius + 0.05, 0.5], [1.0, 2.0]])
    places = resting_places(seen.copy(), TRUTH)
    assert places[0, 0] >= radius
    assert math.hypot(*(places[0] - places[1])) >= 2.0 * radius
    assert np.abs(places - seen).max() < 0.012
    np.testing.assert_array_equal(places[2], seen[2])


def test_every_second_shot_trains_and_medians_are_of_the_middle() -> None:
    shots = [one.tracked for one in make_tracks(TRUTH, 5, seed=1, noise=0.0)]
    train, held = split(shots)
    assert [shot.id for shot in train] == ["1", "3", "5"]
    assert [shot.id for shot in held] == ["2", "4"]
    stroke = FittedStroke(0.0, 1.0, 0.0, 0.0, 0.0)
    found = [FittedShot(str(k), stroke, c, a, True) for k, (c, a) in enumerate([(1, 9), (5, 2), (3, 4)])]
    assert medians(found) == (3.0, 4.0)
    data = fit_data(TrackFile(TableSize(), tuple(shots)), TRUTH, found)
    assert data["shots"][1]["rmse_cue_m"] == 5
    assert data["shots"][1]["rmse_all_m"] == 2
    assert data["table"]["cushion_restitution"] == 0.82
    assert set(data["shots"][0]["stroke"]) >= {"azimuth", "speed", "tip_left", "tip_up", "start"}


def test_the_cue_speed_gives_the_ball_its_speed() -> None:
    stroke = FittedStroke(0.7, 3.0, 0.3, -0.2, 0.01)
    blow = stroke.strike(0.03)
    assert math.hypot(*blow.velocity[:2]) == pytest.approx(3.0, rel=1e-12)
    assert math.atan2(blow.velocity[1], blow.velocity[0]) == pytest.approx(0.7, rel=1e-12)


@pytest.mark.parametrize("cushion", sorted(CUSHION_MODELS))
def test_tracks_can_be_made_with_every_cushion(cushion: str) -> None:
    table = TRUTH._replace(physics=TRUTH.physics._replace(cushion=cushion))
    one = make_tracks(table, 1, seed=2, noise=0.0)[0]
    sums, _ = Bench(target_of(one.tracked, table)).errors(
        table.ground, row_of(one.stroke), Goal(EVERYTHING, 0.1)
    )
    assert max(root_mean_squares(sums[0])) < 1e-9


def test_made_tracks_repeat_and_have_the_noise_that_is_stated() -> None:
    one = make_tracks(TRUTH, 2, seed=9, noise=0.002)[1]
    again = make_tracks(TRUTH, 2, seed=9, noise=0.002)[1]
    for a, b in zip(one.tracked.tracks, again.tracked.tracks, strict=True):
        np.testing.assert_array_equal(a.places, b.places)
    played = simulate_exact(one.shot)
    track = one.tracked.tracks[0]
    off = track.places - [played.state_at(t - one.stroke.start).positions[0] for t in track.times]
    assert off.std() == pytest.approx(0.002, rel=0.15)
    with pytest.raises(ValueError, match="noise"):
        make_tracks(TRUTH, 1, seed=1, noise=-1.0)


def test_evolution_finds_the_bottom_of_a_bent_valley() -> None:
    def valley(p: np.ndarray) -> float:  # Rosenbrock 1960
        return float(100.0 * (p[1] - p[0] ** 2) ** 2 + (1.0 - p[0]) ** 2)

    search = Evolution(np.array([-1.0, 1.0]), np.array([0.5, 0.5]), seed=1)
    for _ in range(120):
        search.turn(valley)
    np.testing.assert_allclose(search.mean, 1.0, atol=1e-4)
    with pytest.raises(ValueError, match="positive"):
        Evolution(np.zeros(2), np.array([1.0, 0.0]), seed=1)


def test_the_first_turn_sizes_its_steps_as_the_tutorial_says() -> None:
    """Hansen 2016, with the weights and constants worked out by hand for 2 numbers and 10 values a turn."""
    weights = np.log(5.5) - np.log([1, 2, 3, 4, 5])
    weights /= weights.sum()
    mu_eff = 1.0 / (weights**2).sum()
    c_sigma = (mu_eff + 2.0) / (2 + mu_eff + 5.0)
    d_sigma = 1.0 + 2.0 * max(0.0, math.sqrt((mu_eff - 1.0) / 3.0) - 1.0) + c_sigma
    expected = math.sqrt(2.0) * (1.0 - 1.0 / 8.0 + 1.0 / 84.0)
    search = Evolution(np.array([30.0, 40.0]), np.array([0.5, 0.5]), seed=3)
    search.turn(lambda p: float(p @ p))
    moved = (search.mean - (30.0, 40.0)) / 0.5
    path = math.sqrt(c_sigma * (2.0 - c_sigma) * mu_eff) * math.hypot(*moved)
    assert search._size == pytest.approx(math.exp(c_sigma / d_sigma * (path / expected - 1.0)), rel=1e-12)

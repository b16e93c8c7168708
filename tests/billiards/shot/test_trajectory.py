"""State at any time, orientation, digests."""

import math
from dataclasses import replace

import numpy as np
import pytest

from game.billiards import Physics, Table, make_shot, simulate
from game.billiards.table.rack import BALL_RADIUS

R = BALL_RADIUS
OPEN = Table.open()


@pytest.fixture(scope="module")
def played():
    places = [[0.3, 0.3], [0.6, 0.62], [0.9, 1.8], [0.3, 2.0]]
    shot = make_shot(Table.pool(), places).struck(0, (2.1, 2.3), (30.0, -20.0, 60.0))
    return simulate(shot)


def test_paths_have_no_jumps_and_velocity_is_their_slope(played):
    for time in np.linspace(0.0, played.end_time, 200)[1:-1]:
        h = 1e-7
        if np.abs(played.times - time).min() < 3.0 * h:
            continue
        before, here, after = (played.state_at(time + k * h) for k in (-1, 0, 1))
        in_play = here.motions != 4
        slope = (after.positions - before.positions) / (2.0 * h)
        assert slope[in_play] == pytest.approx(here.velocities[in_play], abs=2e-8)


def test_before_the_start_and_after_the_end(played):
    assert np.array_equal(played.state_at(-5.0).positions, played.shot.positions)
    end = played.state_at(played.end_time + 100.0)
    assert end.time == played.end_time
    assert np.array_equal(end.positions, played.end[:, :2])
    with pytest.raises(ValueError, match="nan"):
        played.state_at(math.nan)


def test_the_end_is_what_final_says(played):
    for i, name in enumerate(played.shot.ids):
        if played.final[name] != "pocketed":
            assert played.final[name] == tuple(played.end[i, :2])


def _turned(trajectory, time):
    return trajectory.orientations_at(time)


def test_orientations_are_rotations(played):
    for time in np.linspace(0.0, played.end_time, 40):
        turned = _turned(played, time)
        assert turned @ turned.transpose(0, 2, 1) == pytest.approx(
            np.broadcast_to(np.eye(3), turned.shape), abs=1e-12
        )
        assert np.linalg.det(turned) == pytest.approx(1.0, abs=1e-12)


def test_a_rolling_ball_turns_by_way_over_radius():
    shot = make_shot(OPEN, [[0.0, 0.0]], [(1.0, 0.0)], [(0.0, 1.0 / R, 0.0)], motions=["rolling"])
    trajectory = simulate(shot)
    for time in (0.1, 1.0, 5.0):
        angle = trajectory.state_at(time).positions[0, 0] / R
        turned = _turned(trajectory, time)[0]
        # about y: the top of the ball goes forward
        wanted = [
            [math.cos(angle), 0.0, math.sin(angle)],
            [0.0, 1.0, 0.0],
            [-math.sin(angle), 0.0, math.cos(angle)],
        ]
        assert turned == pytest.approx(np.array(wanted), abs=1e-12)


def test_a_ball_spinning_in_place_turns_by_the_integral_of_its_spin():
    trajectory = simulate(make_shot(OPEN, [[0.0, 0.0]], spins=[(0.0, 0.0, 40.0)]))
    decay = 2.5 * 0.0127 * 9.81 / R
    for time in (0.5, 2.0, trajectory.end_time):
        angle = 40.0 * time - 0.5 * decay * time**2
        assert _turned(trajectory, time)[0, 1, 0] == pytest.approx(math.sin(angle), abs=1e-10)


def test_turning_against_fine_integration(played):
    """Rotation vectors of small steps, multiplied up, for balls that slide and spin about changing axes."""
    end = 1.5
    steps = 30_000
    h = end / steps
    turned = np.broadcast_to(np.eye(3), (4, 3, 3)).copy()
    for k in range(steps):
        w = played.state_at((k + 0.5) * h).spins
        angle = np.linalg.norm(w, axis=1) * h
        axis = w / np.maximum(np.linalg.norm(w, axis=1), 1e-300)[:, None]
        cross = np.zeros((4, 3, 3))
        cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -axis[:, 2], axis[:, 1], -axis[:, 0]
        cross -= cross.transpose(0, 2, 1)
        s, c = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
        turned = (np.eye(3) + s * cross + (1.0 - c) * cross @ cross) @ turned
    in_play = played.state_at(end).motions != 4
    assert _turned(played, end)[in_play] == pytest.approx(turned[in_play], abs=2e-3)


def test_orientation_starts_from_what_is_given(played):
    start = np.broadcast_to(np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), (4, 3, 3))
    assert np.array_equal(played.orientations_at(0.0, start), start)
    assert played.orientations_at(1.0, start) == pytest.approx(played.orientations_at(1.0) @ start, abs=1e-15)


def test_events_name_balls_and_elements():
    shot = make_shot(
        Table.bare(1.0, 1.0),
        [[0.2, 0.5], [0.5, 0.5]],
        [(1.0, 0.0), (0.0, 0.0)],
        ids=("cue", "red"),
        physics=Physics("elastic", "mirror"),
    )
    events = simulate(replace(shot, cushion_ids=("west", "east", "south", "north"))).events
    hit = next(e for e in events if e.type == "ball-ball")
    rail = next(e for e in events if e.type == "ball-cushion")
    assert set(hit.ids) == {"cue", "red"} and rail.ids == ("red", "east")

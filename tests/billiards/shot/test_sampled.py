"""A trajectory of samples: linear in between, and balls turn by the mean of the spins at both ends."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from game.billiards import Table, make_shot
from game.billiards.shot.physics import ShotError
from game.billiards.shot.sampled import sampled_trajectory

TIMES = np.array([0.0, 0.2, 0.5])
SPINS = np.array([[2.0, -1.0, 3.0], [4.0, -2.0, 6.0], [1.0, 5.0, 2.0]])  # rad/s at the samples
PLACES = np.array([[0.0, 0.0], [0.4, 0.1], [0.4, -0.5]])
VELOCITIES = np.array([[2.0, 0.5], [2.0, 0.5], [0.0, -2.0]])


@pytest.fixture
def sampled():
    samples = np.zeros((3, 1, 8))
    samples[:, 0, 0:2], samples[:, 0, 2:4], samples[:, 0, 4:7], samples[:, 0, 7] = (
        PLACES,
        VELOCITIES,
        SPINS,
        1,
    )
    return sampled_trajectory(make_shot(Table.open(), [PLACES[0]]), np.empty((0, 4)), TIMES, samples, {})


def turned(spin, seconds: float) -> np.ndarray:
    return Rotation.from_rotvec(np.asarray(spin) * seconds).as_matrix()


def test_between_samples_everything_is_linear(sampled):
    state = sampled.state_at(0.05)
    assert state.positions[0] == pytest.approx(0.25 * PLACES[1])
    assert state.velocities[0] == pytest.approx([2.0, 0.5])
    assert state.spins[0] == pytest.approx(1.25 * SPINS[0])
    assert sampled.state_at(0.35).positions[0] == pytest.approx([0.4, -0.2])
    assert sampled.state_at(9.0).positions[0] == pytest.approx(PLACES[2])
    assert sampled.final[sampled.shot.ids[0]] == tuple(PLACES[2])


def test_balls_turn_by_the_mean_spin_from_sample_to_sample_and_between(sampled):
    quarter = turned(SPINS[0] + 1.25 * SPINS[0], 0.5 * 0.05)
    first = turned(SPINS[0] + SPINS[1], 0.5 * 0.2)
    second = turned(SPINS[1] + SPINS[2], 0.5 * 0.3)
    assert sampled.orientations_at(0.05)[0] == pytest.approx(quarter)
    assert sampled.orientations_at(0.2)[0] == pytest.approx(first)
    assert sampled.orientations_at(0.5)[0] == pytest.approx(second @ first)
    start = turned([0.3, 0.2, 0.1], 1.0)
    assert sampled.orientations_at(0.5, start[None])[0] == pytest.approx(second @ first @ start)


def test_samples_that_end_nowhere_are_refused(sampled):
    samples = sampled.samples.copy()
    samples[-1, 0, 1] = np.nan
    with pytest.raises(ShotError, match="finite"):
        sampled_trajectory(sampled.shot, np.empty((0, 4)), TIMES, samples, {})

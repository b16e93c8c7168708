"""A sail: its force beside that of a plate, the threads' length, what a slack one does."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.cloth.sail import BACK, FX, FY, FZ, LEAN, TURN, VX, VZ, Sail, Wind, X, Y, Z

CORNERS = np.array([(0.05, 1.0), (0.05, 5.0), (4.0, 5.0), (4.0, 1.0)])
STRONG = 0.5 * 1.2 * 1.25


def held_flat(angle: float, wind: Wind) -> np.ndarray:
    """Force on a sail before it has moved."""
    sail = Sail(CORNERS, 9, 9, fullness=0.0)
    sail.hoist(angle)
    return sail.step(angle, 0.0, wind, 0.0, 1e-9, 1).copy()


@pytest.mark.parametrize("off", [90.0, 60.0, 30.0, 10.0])
def test_a_flat_sail_takes_the_force_of_a_plate(off: float) -> None:
    """c ½ ρ V² A 2 s / (1 + s²) (Duchemin 1842), normal to it."""
    turned, strong = math.radians(off), 8.0
    wind = Wind(-strong * math.cos(turned), 0.0, strong * math.sin(turned), STRONG)
    found = held_flat(0.0, wind)
    s = math.sin(turned)
    assert found[FZ] == pytest.approx(STRONG * strong**2 * 3.95 * 4.0 * 2.0 * s / (1.0 + s * s), rel=1e-6)
    assert abs(found[FX]) < 1e-6 and abs(found[FY]) < 1e-6


def test_moments_are_those_of_a_force_in_its_middle() -> None:
    found = held_flat(0.0, Wind(0.0, 0.0, 6.0, STRONG))
    assert found[LEAN] == pytest.approx(3.0 * found[FZ], rel=1e-6)
    assert found[TURN] == pytest.approx(2.025 * found[FZ], rel=1e-6)
    assert abs(found[BACK]) < 1e-6


def test_a_swung_out_sail_drives_ahead() -> None:
    found = held_flat(math.radians(60.0), Wind(0.0, 0.0, 6.0, STRONG))
    assert found[FX] > 0.0 and found[FX] == pytest.approx(math.tan(math.radians(60.0)) * found[FZ], rel=1e-6)


def test_threads_keep_their_length_and_the_cloth_its_belly() -> None:
    sail = Sail(CORNERS, 13, 11, fullness=0.04)
    sail.hoist(0.3)
    for _ in range(300):
        sail.step(0.3, 0.0, Wind(1.0, 0.0, 9.0, STRONG), 9.81, 1.0 / 60.0, 8)
    across = np.diff(sail.nodes[X : Z + 1], axis=2)
    lengths = np.sqrt(np.sum(across * across, axis=0))
    off = np.abs(lengths[1:-1] / sail.rests[0, 1:-1, :-1] - 1.0)
    assert np.median(off) < 0.02 and off.max() < 0.08  # most at the corner of the boom, which holds the leech
    assert 0.1 < sail.belly() < 1.2
    assert sail.flapping() < 0.2


def test_a_sail_in_line_with_the_wind_has_hardly_a_force() -> None:
    sail = Sail(CORNERS, 13, 11)
    sail.hoist(0.0)
    wind = Wind(-10.0, 0.0, 0.0, STRONG)
    forces = [float(sail.step(0.0, 0.0, wind, 9.81, 1.0 / 60.0, 8)[FZ]) for _ in range(300)]
    assert abs(float(np.mean(forces[100:]))) < 0.1 * STRONG * 100.0 * sail.area
    assert np.isfinite(sail.nodes).all() and np.abs(sail.nodes[VX : VZ + 1]).max() < 40.0


def test_without_wind_it_hangs_between_its_spars() -> None:
    sail = Sail(CORNERS, 9, 9)
    sail.hoist(0.0)
    for _ in range(600):
        found = sail.step(0.0, 0.0, Wind(0.0, 0.0, 0.0, STRONG), 9.81, 1.0 / 60.0, 8)
    assert np.abs(found).max() < 20.0 and sail.nodes[Y].min() > 0.5
    assert sail.area == pytest.approx(3.95 * 4.0, rel=1e-9)


def test_nonsense_is_refused() -> None:
    with pytest.raises(ValueError):
        Sail(CORNERS[:3], 9, 9)
    with pytest.raises(ValueError):
        Sail(CORNERS, 2, 9)

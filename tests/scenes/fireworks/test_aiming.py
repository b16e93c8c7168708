"""How mortars are laid, against closed forms and a finer flight."""

import math

import pytest

from game.scenes.fireworks.aiming import aim, fly_shell, fuse_for


def test_height_and_time_of_the_top():
    """v0 60 m/s, terminal speed 25 m/s: 60.87611 m after 2.996955 s (Bernoulli 1719)."""
    speed, seconds = fuse_for(60.876112, 9.81, 9.81 / 25.0**2)
    assert speed == pytest.approx(60.0, rel=1e-6) and seconds == pytest.approx(2.996955, rel=1e-6)
    speed, seconds = fuse_for(100.0, 9.81, 0.0)
    assert speed == pytest.approx(math.sqrt(2.0 * 9.81 * 100.0)) and seconds == pytest.approx(speed / 9.81)


@pytest.mark.parametrize("wind", [0.0, 15.0, -40.0])
@pytest.mark.parametrize("way", [(0.0, 100.0), (80.0, 60.0), (-200.0, 140.0)])
def test_the_shell_goes_the_way(way, wind):
    velocity, seconds = aim(way, 9.81, 0.0012, wind)
    assert fly_shell(velocity, seconds, 9.81, 0.0012, wind) == pytest.approx(way, abs=2e-3)


def test_odd_worlds_give_finite_answers():
    for way, gravity, drag in (
        ((0.0, 5.0), 0.0, 0.0),
        ((900.0, 1000.0), 30.0, 120.0),
        ((0.0, -3.0), 9.81, 1e-9),
    ):
        velocity, seconds = aim(way, gravity, drag)
        assert all(map(math.isfinite, velocity)) and 0.0 < seconds < 200.0

"""The tunnel: a cylinder whose drag is known, still air, mirror images, what is refused, and its state."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from game.lab.studies.flow.wind_tunnel import CHANNEL_DRAG, CHANNEL_LIFT, channel
from game.physics.tunnel import Tunnel, TunnelSettings, shape_named
from game.physics.tunnel.averages import Average
from game.physics.tunnel.balance import held

SMALL = TunnelSettings(cells=6.0, width=7.0, height=5.0, reynolds=40.0, nudge=0.0)


def copied(state):
    """A state's arrays as they are now."""
    return type(state)(*(copied(part) if hasattr(part, "_fields") else part.copy() for part in state))


def averaged(tunnel: Tunnel, settle: float, window: float):
    average = Average(settle, window)
    while not average.done:
        tunnel.step()
        average.take(tunnel.reading, tunnel.step_length)
    return average.mean()


def test_the_cylinder_of_schaefer_and_turek_is_dragged_as_it_should_be():
    """2D-1 on 10 cells to the diameter: the book 1.3 % above, the wall 4.3 % below."""
    mean = averaged(Tunnel(shape_named("disc"), channel(10.0, width=10.0)), 14.0, 1.0)
    assert mean.book[0] == pytest.approx(CHANNEL_DRAG, rel=0.02)
    assert mean.wall[0] == pytest.approx(CHANNEL_DRAG, rel=0.06)
    assert mean.book[1] == pytest.approx(CHANNEL_LIFT, abs=0.02)
    assert mean.drift < 0.005 and mean.spread[0] < 0.01


def test_in_still_air_nothing_pushes():
    tunnel = Tunnel(shape_named("aerofoil"), replace(SMALL, wind=0.0), 0.3)
    for _ in range(5):
        tunnel.step()
    assert not tunnel.reading.any() and not tunnel.gas.u.any()


def test_a_mirrored_angle_has_the_mirrored_force():
    """A plate at +25 and -25 degrees, each in a flow of its own: what is left is the solver's tolerance."""
    found = []
    for sign in (1.0, -1.0):
        tunnel = Tunnel(shape_named("plate"), SMALL, sign * math.radians(25.0))
        for _ in range(40):
            tunnel.step()
        found.append(tunnel.forces())
    for way in ("wall", "book"):
        one, other = getattr(found[0], way), getattr(found[1], way)
        assert one[0] == pytest.approx(other[0], abs=2e-3)
        assert one[1] == pytest.approx(-other[1], abs=2e-3)
        assert one[2] == pytest.approx(-other[2], abs=2e-3)
        assert one[1] > 0.5 and one[0] > 0.3 and one[2] > 0.05


def test_both_ways_to_measure_agree_better_on_a_finer_grid():
    gaps = []
    for cells in (6.0, 12.0):
        mean = averaged(Tunnel(shape_named("disc"), replace(SMALL, cells=cells)), 8.0, 1.0)
        gaps.append(abs(mean.wall[0] - mean.book[0]) / mean.book[0])
    assert gaps[1] < 0.7 * gaps[0] < 0.2


def test_coefficients_do_not_go_by_the_size_of_chord_and_wind():
    """The same flow at twice the size and three times the wind."""
    ones = Tunnel(shape_named("square"), SMALL, 0.2)
    large = Tunnel(
        shape_named("square", 2.0),
        replace(SMALL, cells=3.0, width=14.0, height=10.0, wind=3.0),
        0.2,
    )
    for _ in range(20):
        ones.step()
        large.step()
    assert large.step_length == pytest.approx(2.0 / 3.0 * ones.step_length)
    assert large.reading == pytest.approx(ones.reading, abs=1e-4)
    assert large.viscosity == pytest.approx(6.0 * ones.viscosity)


def test_a_turned_shape_is_measured_at_its_new_angle_and_the_books_go_on():
    tunnel = Tunnel(shape_named("plate"), SMALL, 0.0)
    for _ in range(30):
        tunnel.step()
    flat = tunnel.forces().book
    assert abs(flat[1]) < 0.01
    tunnel.turn(math.radians(90.0))
    assert tunnel.blockage == pytest.approx(0.2)
    faces, (x, y) = tunnel.gas.faces, tunnel.settings.place
    now = np.zeros(3)
    numbers = np.array([tunnel.grid.cell, 0.0, -x, -y])
    held(tunnel.gas.u, tunnel.gas.v, faces.ax, faces.ay, tunnel.box, numbers, now)
    assert np.array_equal(tunnel.held, now)
    for _ in range(60):
        tunnel.step()
    upright = tunnel.forces().book
    assert upright[0] > 2.5 * flat[0]


def test_a_state_that_is_restored_goes_on_to_the_same_bits():
    """With another angle and another outline in between."""
    tunnel = Tunnel(shape_named("leaf"), SMALL, 0.3)
    for _ in range(8):
        tunnel.step()
    kept = copied(tunnel.state())
    for _ in range(6):
        tunnel.step()
    then = copied(tunnel.state())
    tunnel.turn(-1.0)
    tunnel.change_outline(shape_named("disc"), 0.1)
    tunnel.step()
    tunnel.restore(kept)
    assert tunnel.outline.area == pytest.approx(shape_named("leaf").area)
    for _ in range(6):
        tunnel.step()
    now = tunnel.state()
    for name in now.gas._fields:
        assert np.array_equal(getattr(now.gas, name), getattr(then.gas, name)), name
    assert np.array_equal(now.reading, then.reading) and np.array_equal(now.held, then.held)


def test_a_shape_that_reaches_the_walls_is_refused_and_nothing_changes():
    tunnel = Tunnel(shape_named("disc"), SMALL)
    with pytest.raises(ValueError, match="too near to the tunnel's walls"):
        tunnel.change_outline(shape_named("disc", 4.5))
    assert tunnel.outline.chord == 1.0
    with pytest.raises(ValueError, match="too near"):
        Tunnel(shape_named("plate"), replace(SMALL, at=(0.4, 2.5)))


@pytest.mark.parametrize(
    "change",
    [
        {"cells": 1.0}, {"cells": math.nan}, {"wind": -1.0}, {"reynolds": 0.0}, {"walls": "glass"},
        {"profile": "odd"}, {"courant": 0.0}, {"cells": 400.0, "width": 100.0}, {"advection": "none"},
    ],
)  # fmt: skip
def test_settings_that_make_no_sense_are_refused_by_name(change):
    with pytest.raises(ValueError, match=next(iter(change))):
        replace(SMALL, **change)


def test_a_tunnel_that_stands_takes_another_wind_but_not_another_grid():
    tunnel = Tunnel(shape_named("disc"), SMALL)
    tunnel.change_settings(replace(SMALL, wind=2.0, reynolds=80.0))
    assert tunnel.gas.settings.viscosity == pytest.approx(2.0 / 80.0)
    assert tunnel.gas.edges.velocities[0, 0, 0] == 2.0
    with pytest.raises(ValueError, match="cells"):
        tunnel.change_settings(replace(SMALL, cells=7.0))
    with pytest.raises(ValueError, match="attack"):
        tunnel.turn(math.inf)


def test_a_parabolic_wind_has_its_mean_and_nothing_at_the_walls():
    tunnel = Tunnel(shape_named("disc"), replace(SMALL, profile="parabolic", walls="no-slip"))
    flows_in = tunnel.gas.edges.velocities[0, : tunnel.grid.ny, 0]
    assert flows_in.mean() == pytest.approx(1.0, rel=2e-3)
    assert flows_in.max() == pytest.approx(1.5, rel=2e-3) and flows_in[0] < 0.12

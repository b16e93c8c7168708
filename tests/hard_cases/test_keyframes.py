"""C01: the hard cases of key-framing, H1 to H11."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.animation import (
    INTERPOLATIONS,
    CubicBezier,
    Easing,
    Keyframes,
    mix_rotations,
    rotation,
    shortest_turn,
)

NAMES = [name for name in INTERPOLATIONS if name != "bezier"]
every = pytest.mark.parametrize("name", NAMES)


@every
def test_no_key_and_one_key(name):
    with pytest.raises(ValueError, match="times"):
        Keyframes([], np.zeros((0, 2)), name)
    one = Keyframes([0.4], [(1.5, -2.5)], name)
    assert one.sample([-1e9, 0.0, 0.4, 7.0]).tolist() == [[1.5, -2.5]] * 4
    assert one.rate([-1.0, 0.4, 1.0]).tolist() == [[0.0, 0.0]] * 3
    assert Keyframes([0.4], [3.0], name, loop=True).sample(0.9) == 3.0


@every
def test_before_after_and_on_a_key(name):
    rng = np.random.default_rng(1)
    times, values = np.sort(rng.random(9)) * 0.7, rng.normal(size=(9, 3))
    track = Keyframes(times, values, name)
    assert np.array_equal(track.sample(times), values)
    assert np.array_equal(track.sample([-5.0, times[0] - 1e-17]), values[[0, 0]])
    assert np.array_equal(track.sample([times[-1] + 1e-16, 1e300]), values[[-1, -1]])
    for wrong in (math.nan, math.inf, -math.inf):
        with pytest.raises(ValueError, match="times"):
            track.sample([0.1, wrong])


@every
def test_a_key_that_jumps(name):
    track = Keyframes([0.0, 0.5, 0.5, 0.5, 1.0], [0.0, 1.0, 99.0, 3.0, 4.0], name)
    below = math.nextafter(0.5, 0.0)
    assert track.sample(below) == pytest.approx(1.0, abs=1e-12)
    assert track.sample(0.5) == 3.0
    assert track.sample(math.nextafter(0.5, 1.0)) == pytest.approx(3.0, abs=1e-12)
    at = np.linspace(0, 1, 1001)
    assert np.isfinite(track.sample(at)).all()
    assert np.isfinite(track.rate(at)).all()
    only = Keyframes([0.5, 0.5], [1.0, 2.0], name)
    assert only.sample([0.4, 0.5, 0.6]).tolist() == [1.0, 2.0, 2.0]


@every
def test_keys_in_any_order(name):
    rng = np.random.default_rng(3)
    times, values, at = rng.random(10), rng.normal(size=(10, 2)), rng.random(200)
    known = Keyframes(times, values, name).sample(at)
    for _ in range(5):
        order = rng.permutation(10)
        assert np.array_equal(Keyframes(times[order], values[order], name).sample(at), known)
    first = Keyframes([0.5, 0.5, 0.0], [1.0, 2.0, 0.0], name)
    second = Keyframes([0.5, 0.5, 0.0], [2.0, 1.0, 0.0], name)
    assert (first.sample(0.5), second.sample(0.5)) == (2.0, 1.0)  # of equal times the order is kept


@every
def test_close_far_and_negative_times(name):
    tiny = Keyframes([0.0, 1e-300, 1.0], [0.0, 1.0, 2.0], name)
    tiny.check()
    at = [0.0, 2e-301, 9.9e-301, 1e-300, 1e-16, 0.5, 1.0]
    assert np.isfinite(tiny.sample(at)).all()
    assert np.isfinite(tiny.rate(at)).all()
    assert np.all((tiny.sample(at) >= 0.0) & (tiny.sample(at) <= 2.0))
    smallest = Keyframes([0.0, 5e-324], [0.0, 1.0], name)
    assert smallest.sample([0.0, 5e-324]).tolist() == [0.0, 1.0]
    for start in (1e9, -1e9, -0.5):
        times = start + np.arange(5) * 0.25
        track = Keyframes(times, np.arange(5.0), name)
        values = track.sample(start + np.linspace(0.0, 1.0, 2001))
        assert np.all(np.diff(values) >= 0.0)  # monotone keys, monotone between: u is
        assert np.array_equal(track.sample(times), np.arange(5.0))
    largest = Keyframes([-1e150, 1e150], [-1e150, 1e150], name)
    assert np.isfinite(largest.sample(np.linspace(-1e150, 1e150, 7))).all()


@pytest.mark.parametrize(
    "points",
    [
        [(0, 0), (0, 0), (2, 1), (3, 0)],
        [(0, 0), (1, 1), (3, 0), (3, 0)],
        [(0, 0), (0, 0), (0, 0), (3, 0)],
        [(1, 2)] * 4,
        [(0, 0), (1, 1), (0, 1), (1, 0)],
        [(0, 0), (2, 1), (-1, 1), (1, 0)],
        [(0, 0), (2, 0), (-1, 0), (1, 0)],
    ],
    ids=["P0=P1", "P2=P3", "P0=P1=P2", "all", "cusp", "loop", "there and back"],
)
def test_coincident_control_points_cusp_and_loop(points):
    curve, u = CubicBezier(points), np.linspace(0, 1, 501)
    curve.check()
    for found in (curve.point(u), curve.tangent(u), curve.direction(u), curve.flatten(1e-3)):
        assert np.isfinite(found).all()
    ways = np.linspace(0, curve.length, 100)
    there = curve.parameter_at(ways)
    assert np.abs(curve.length_to(there) - ways).max() < 1e-12
    size = np.linalg.norm(curve.direction(u), axis=1)
    assert np.allclose(size, 0.0 if curve.length == 0.0 else 1.0, rtol=0, atol=1e-14)
    steps = np.linalg.norm(np.diff(curve.point(there), axis=0), axis=1)
    assert steps.max() <= ways[1] * (1 + 1e-9)


def test_zero_slope_and_steep_timing():
    parts = np.linspace(0, 1, 20_001)
    for x1, x2 in ((0, 0), (0, 1), (1, 1), (1, 0), (0, 0.5), (0.5, 1), (1, 1e-9)):
        # with y = x the curve gives back how well x was met
        assert np.abs(Easing((x1, x1, x2, x2))(parts) - parts).max() <= 1e-12
        assert np.isfinite(Easing((x1, 0, x2, 1)).slope(parts)).all()


@pytest.mark.parametrize("handles", [(-0.01, 0, 1, 1), (0, 0, 1.01, 1), (2, 0, -1, 1)])
def test_timing_that_turns_back_is_refused(handles):
    with pytest.raises(ValueError, match="x1 and x2"):
        Easing(handles)


@every
def test_the_shortest_way_round(name):
    if name == "nearest":
        return
    degrees = Keyframes([0.0, 1.0], [350.0, 10.0], name, angles=(0,), turn=360.0)
    assert degrees.sample(0.5) % 360.0 == pytest.approx(0.0, abs=1e-12)
    assert degrees.sample([0.0, 1.0]).tolist() == [350.0, 10.0]
    radians = Keyframes([0.0, 1.0], np.radians([350.0, 10.0]), name, angles=(0,))
    assert math.cos(radians.sample(0.5)) == pytest.approx(1.0, abs=1e-15)
    half = Keyframes([0.0, 1.0, 2.0], [0.0, 180.0, 0.0], "linear", angles=(0,), turn=360.0)
    assert half.sample([0.5, 1.5]).tolist() == [90.0, 270.0]  # half a turn goes counterclockwise, both times
    assert shortest_turn([180.0, -180.0, 190.0, -190.0, 720.0], 360.0).tolist() == [180, 180, -170, 170, 0]
    plain = Keyframes([0.0, 1.0], [350.0, 10.0], name)
    assert plain.sample(0.5) == 180.0


def test_mixed_rotation_matrices_are_singular_halfway():
    mixed = mix_rotations(0.3, 0.3 + math.pi, [0.0, 0.25, 0.5, 1.0])
    sizes = np.linalg.det(mixed)
    assert sizes[[0, 3]] == pytest.approx([1.0, 1.0], abs=1e-15)
    assert abs(sizes[2]) < 1e-31
    assert sizes[1] == pytest.approx(0.25, abs=1e-15)
    angle = Keyframes([0.0, 1.0], [0.3, 0.3 + math.pi], angles=(0,)).sample(np.linspace(0, 1, 101))
    assert np.abs(np.linalg.det(rotation(angle)) - 1.0).max() < 1e-15
    quarter = np.linalg.det(mix_rotations(0.0, math.pi / 2, 0.5))
    assert quarter == pytest.approx(math.cos(math.pi / 4) ** 2, abs=1e-15)


@every
def test_any_order_of_playback_gives_the_same_bits(name):
    rng = np.random.default_rng(11)
    times = np.cumsum(rng.random(50) ** 8)  # clusters: the guide table has to search
    track = Keyframes(times, rng.normal(size=(50, 3)), name)
    at = np.sort(rng.random(2000) * times[-1])
    forward = track.sample(at)
    assert np.array_equal(track.sample(at[::-1])[::-1], forward)
    order = rng.permutation(2000)
    assert np.array_equal(track.sample(at[order]), forward[order])
    assert all(
        np.array_equal(track.sample(float(t)), row) for t, row in zip(at[::50], forward[::50], strict=True)
    )
    place = np.searchsorted(times, at, side="right") - 1
    twin = Keyframes(times, np.arange(50.0), "linear").sample(at)
    assert np.array_equal(np.floor(twin), place)
    again = Keyframes(times.astype(np.float64)[::1].tolist(), track.values.tolist(), name)
    assert np.array_equal(again.sample(at), forward)

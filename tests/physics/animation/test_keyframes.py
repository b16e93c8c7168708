"""Key-frames: exactness, orders, twins, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline, PchipInterpolator

from game.physics.animation import INTERPOLATIONS, Keyframes
from game.physics.animation.tangents import RULES, piece_slopes

EPS = 2.0**-52
SMOOTH = tuple(name for name in INTERPOLATIONS if name not in ("nearest", "linear", "flat", "bezier"))


def wave(t):
    return np.exp(np.sin(2 * np.pi * t))


def wave_slope(t):
    return 2 * np.pi * np.cos(2 * np.pi * t) * wave(t)


def key_times(keys, uneven):
    if not uneven:
        return np.linspace(0, 1, keys + 1)
    times = np.concatenate(([0.0], np.cumsum(np.tile([1.0, 3.0], keys // 2))))
    return times / times[-1]


def wave_track(name, times, shape=wave, slope=wave_slope):
    handles = None
    if name == "bezier":
        h, d = np.diff(times), slope(times)
        handles = np.zeros((len(times), 2, 1))
        handles[1:, 0, 0], handles[:-1, 1, 0] = -d[1:] * h / 3, d[:-1] * h / 3
    return Keyframes(times, shape(times)[:, None], name, handles=handles)


def worst_error(name, times, samples=20_001):
    at = np.linspace(0, 1, samples)
    return float(np.abs(wave_track(name, times).sample(at)[:, 0] - wave(at)).max())


ORDERS = {  # over evenly spaced keys, over keys 1 : 3 apart
    "nearest": (1, 1), "linear": (2, 2), "bezier": (4, 4), "flat": (1, 1), "catmull-rom": (3, 1),
    "secant": (3, 2), "monotone": (2, 2), "parabolic": (3, 3), "natural-spline": (2, 2), "spline": (4, 4),
}  # fmt: skip


@pytest.mark.parametrize("uneven", [False, True])
@pytest.mark.parametrize("name", ORDERS)
def test_orders(name, uneven):
    counts = (32, 64, 128, 256, 512)
    errors = [worst_error(name, key_times(n, uneven)) for n in counts]
    order = -np.polyfit(np.log(counts), np.log(errors), 1)[0]
    assert ORDERS[name][uneven] - 0.15 <= order <= ORDERS[name][uneven] + 0.25


@pytest.mark.compiled
def test_true_errors_on_a_sine():
    """Sixteen keys on a sine: true maxima, within the analytic bounds M1 h/2, M2 h²/8 and M4 h⁴/384."""
    times, at = np.linspace(0, 1, 17), np.linspace(0, 1, 400_001)
    sine, cosine = (lambda t: np.sin(2 * np.pi * t)), (lambda t: 2 * np.pi * np.cos(2 * np.pi * t))
    found = {
        name: np.abs(wave_track(name, times, sine, cosine).sample(at)[:, 0] - sine(at)).max()
        for name in ("nearest", "linear", "bezier")
    }
    # keys of the table around the ends as well, so that every piece has neighbours at both sides
    wide = Keyframes(np.arange(-2, 19) / 16, sine(np.arange(-2, 19) / 16), "catmull-rom")
    found["catmull-rom"] = np.abs(wide.sample(at) - sine(at)).max()
    known = {
        "nearest": 0.195090322016128, "linear": 0.0188463120935618, "bezier": 6.05855510277253e-5,
        "catmull-rom": 0.000996313431701021,
    }  # fmt: skip
    bounds = {"nearest": 0.196349540849362, "linear": 0.0192765710958777, "bezier": 6.19310322024043e-5}
    for name, value in known.items():
        assert found[name] == pytest.approx(value, rel=0, abs=2e-9 if name != "nearest" else 2e-5)
        assert found[name] <= bounds.get(name, 1.0)


@pytest.mark.parametrize(("name", "degree"), [("linear", 1), ("catmull-rom", 2), ("bezier", 3)])
def test_polynomials_are_exact(name, degree):
    times, at = np.linspace(-1, 2, 7), np.linspace(-1, 2, 301)
    factors = np.array([0.7, -1.3, 0.4, 0.9])[: degree + 1]
    track = wave_track(
        name,
        times,
        lambda t: np.polyval(factors[::-1], t),
        lambda t: np.polyval(np.polyder(factors[::-1]), t),
    )
    scale = np.abs(track.values).max()
    assert np.abs(track.sample(at)[:, 0] - np.polyval(factors[::-1], at)).max() <= 16 * EPS * scale


def test_splines_and_harmonic_means_are_those_of_a_twin():
    rng = np.random.default_rng(4)
    times = np.sort(rng.random(12))
    values, at = rng.normal(size=(12, 3)), np.linspace(times[0], times[-1], 400)[:-1]
    twins = {
        "spline": CubicSpline(times, values),
        "natural-spline": CubicSpline(times, values, bc_type="natural"),
        "monotone": PchipInterpolator(times, values),
    }
    for name, twin in twins.items():
        track = Keyframes(times, values, name)
        assert np.abs(track.sample(at) - twin(at)).max() < 1e-12
        assert np.abs(track.rate(at) - twin(at, 1)).max() < 1e-9
    for few in (2, 3):
        mine = Keyframes(times[:few], values[:few], "spline").sample(at[:50])
        inside = at[:50] <= times[few - 1]
        known = CubicSpline(times[:few], values[:few])(at[:50])
        assert np.allclose(mine[inside], known[inside], rtol=0, atol=1e-12)


def test_a_closed_spline_is_that_of_a_twin_and_all_go_round_smoothly():
    rng = np.random.default_rng(5)
    times, values = np.sort(rng.random(9)), rng.normal(size=(9, 2))
    values[-1] = values[0]
    at = np.linspace(times[0], times[-1], 300)[:-1]
    twin = CubicSpline(times, values, bc_type="periodic")
    assert np.abs(Keyframes(times, values, "spline", loop=True).sample(at) - twin(at)).max() < 1e-12
    even = np.linspace(0, 1, 9)
    for name in (*SMOOTH, "flat"):
        track = Keyframes(even, values, name, loop=True)
        before, after = track.rate(np.array([1.0 - 1e-12, 0.0]))
        tight = name not in ("centripetal", "chordal")  # these have one direction at a key, and two speeds
        a, b = (before, after) if tight else (before / np.linalg.norm(before), after / np.linalg.norm(after))
        assert np.allclose(a, b, rtol=0, atol=1e-6)
        assert np.allclose(track.sample(2.25), track.sample(0.25), rtol=0, atol=1e-12)
        assert np.allclose(track.sample(-0.75), track.sample(0.25), rtol=0, atol=1e-12)


def test_monotone_keys_stay_monotone_and_others_overshoot():
    values = np.array([0.0, 0.0, 0.1, 5.0, 5.0, 5.2])
    at = np.linspace(0, 1, 500)
    times = np.linspace(0, 1, 6)
    calm = Keyframes(times, values, "monotone").sample(at)
    assert np.all(np.diff(calm) >= -1e-15)
    assert calm.min() >= 0.0
    assert Keyframes(times, values, "spline").sample(at).max() > 5.2


def test_centripetal_knots_make_no_loop_where_uniform_ones_do():
    """A short piece between long ones: uniform knots overshoot into a loop (Yuksel and others 2011)."""
    places = np.array([(0.0, 0.0), (4.0, 1.0), (4.2, 0.8), (3.0, -4.0)])
    turns = {}
    for name in ("catmull-rom", "centripetal"):
        way = Keyframes(np.arange(4.0), places, name).rate(np.linspace(1, 2, 200)[:-1])
        angle = np.unwrap(np.arctan2(way[:, 1], way[:, 0]))
        turns[name] = np.ptp(angle)
    assert turns["centripetal"] < math.pi < turns["catmull-rom"]


@pytest.mark.parametrize("name", INTERPOLATIONS)
def test_rates_are_the_derivatives(name):
    rng = np.random.default_rng(3)
    times, values = np.arange(6.0), rng.normal(size=(6, 3))
    handles = rng.normal(size=(6, 2, 3)) if name == "bezier" else None
    track = Keyframes(times, values, name, handles=handles)
    track.check()
    at, step = rng.random(40) * 5.0, 1e-6
    at = at[np.abs((at % 1.0) - 0.5) < 0.45]  # a difference must not reach over a key
    if name == "nearest":
        at = at[np.abs((at % 1.0) - 0.5) > 0.01]
    differences = (track.sample(at + step) - track.sample(at - step)) / (2 * step)
    assert np.abs(track.rate(at) - differences).max() < 1e-7


def test_any_number_of_columns_and_plain_numbers():
    times, at = np.arange(5.0), np.linspace(-1, 6, 57)
    for m in (1, 2, 4, 7):
        values = np.random.default_rng(m).normal(size=(5, m))
        whole = Keyframes(times, values, "parabolic").sample(at)
        assert whole.shape == (57, m)
        for j in range(m):
            assert np.array_equal(whole[:, j], Keyframes(times, values[:, j], "parabolic").sample(at))
    track = Keyframes([0.0, 1.0], [3.0, 5.0])
    assert track.sample(0.5) == 4.0
    assert track.sample(0.5).shape == ()
    assert Keyframes([0, 1], [(0, 0), (2, 4)]).sample(0.5).tolist() == [1.0, 2.0]


def test_samples_into_an_array():
    track = Keyframes([0, 1], [(0, 0), (2, 4)])
    out = np.empty((3, 2))
    assert track.sample([0.0, 0.5, 1.0], out) is out
    assert out.tolist() == [[0, 0], [1, 2], [2, 4]]
    for wrong in (np.empty((2, 2)), np.empty((3, 2), np.float32), np.empty((2, 3)).T):
        with pytest.raises(ValueError, match="out"):
            track.sample([0.0, 0.5, 1.0], wrong)


@pytest.mark.parametrize(
    ("changed", "named"),
    [
        ({"times": [0.0, math.nan]}, "times"),
        ({"times": [0.0, math.inf]}, "times"),
        ({"times": [[0.0, 1.0]]}, "times"),
        ({"values": [(0, 0), (1, math.nan)]}, "values"),
        ({"values": [(0, 0)]}, "values"),
        ({"values": [(0, 0), (1, 1e200)]}, "values"),
        ({"interpolation": "quintic"}, "interpolation"),
        ({"interpolation": "bezier"}, "handles"),
        ({"handles": np.zeros((2, 2, 2))}, "handles"),
        ({"interpolation": "bezier", "handles": np.zeros((2, 2, 3))}, "handles"),
        ({"angles": (2,)}, "angles"),
        ({"turn": 0.0}, "turn"),
        ({"geometry": (0, 0)}, "geometry"),
    ],
)
def test_what_makes_no_sense_is_refused(changed, named):
    arguments = {"times": [0.0, 1.0], "values": [(0, 0), (1, 1)], **changed}
    times, values = arguments.pop("times"), arguments.pop("values")
    with pytest.raises(ValueError, match=named):
        Keyframes(times, values, **arguments)


def test_handles_that_are_another_rule():
    rng = np.random.default_rng(8)
    times, values, at = np.sort(rng.random(7)), rng.normal(size=(7, 3)), rng.random(100)
    for rule in RULES:
        like = Keyframes(times, values, rule, angles=(2,))
        handles = like.automatic_handles(rule)
        mine = Keyframes(times, values, "bezier", handles=handles, angles=(2,))
        assert np.abs(mine.sample(at) - like.sample(at)).max() < 1e-12
    with pytest.raises(ValueError, match="rule"):
        like.automatic_handles("nearest")


def test_the_path_is_what_is_sampled():
    rng = np.random.default_rng(9)
    times, values = np.arange(6.0), rng.normal(size=(6, 3))
    for name in ("linear", "spline", "centripetal"):
        track = Keyframes(times, values, name, angles=(2,))
        path, at = track.path((0, 1)), np.linspace(0, 5, 101)
        assert np.abs(path.point(at) - track.sample(at)[:, :2]).max() < 1e-14
        assert np.abs(path.tangent(at[:-1]) - track.rate(at[:-1])[:, :2]).max() < 1e-13
        turned = track.path((2,)).point(at[:-1])[:, 0] - track.sample(at[:-1])[:, 2]
        assert np.abs(np.sin(0.5 * turned)).max() < 1e-14


@settings(max_examples=60, deadline=None)
@given(
    st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=12),
    st.sampled_from([name for name in INTERPOLATIONS if name != "bezier"]),
    st.randoms(use_true_random=False),
)
def test_every_key_is_met_in_any_order(times, name, order):
    """Sorted by time; the last of equal times counts; no cached place changes a value."""
    values = [(math.sin(3 * i), math.cos(2 * i)) for i in range(len(times))]
    track = Keyframes(times, values, name)
    track.check()
    at = [*times, *(t + 0.37 for t in times)]
    together = track.sample(at)
    mixed = list(range(len(at)))
    order.shuffle(mixed)
    assert np.array_equal(track.sample([at[i] for i in mixed]), together[mixed])
    assert all(np.array_equal(track.sample(t), row) for t, row in zip(at, together, strict=True))
    for t in set(times):
        last = max(i for i, other in enumerate(times) if other == t)
        assert tuple(track.sample(t)) == values[last] or name == "nearest" or t != max(times)
        assert tuple(track.sample(t)) == values[last]


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("second", "slope"), [(-1.0, 2.0), (-2.6, 2.8), (-3.4, 3.0), (-9.0, 3.0)])
def test_the_ends_of_a_monotone_curve_are_at_most_three_chords_steep(sign, second, slope):
    """The parabola's slope, (3 d - e) / 2 for equal pieces, up to 3 d where the chords differ in sign."""
    steps = sign * np.array([[1.0], [second]])
    begins, ends = piece_slopes("monotone", np.array([0.0, 1.0, 2.0]), steps)
    assert begins[0, 0] == pytest.approx(sign * slope, rel=1e-15)
    assert ends[0, 0] == begins[1, 0] == 0.0
    backwards = piece_slopes("monotone", np.array([0.0, 1.0, 2.0]), -steps[::-1])[1]
    assert backwards[-1, 0] == pytest.approx(-sign * slope, rel=1e-15)


@pytest.mark.parametrize("least", [1e-307, 1e-310, 5e-324])
def test_a_chord_without_an_inverse_makes_a_flat_key(least):
    with np.errstate(all="raise", under="ignore"):
        begins, ends = piece_slopes("monotone", np.arange(4.0), np.array([[least], [least], [1.0]]))
    assert np.isfinite(begins).all() and np.isfinite(ends).all()
    assert 0.0 <= begins[1, 0] <= 3.0 * least and 0.0 <= begins[2, 0] <= 3.0 * least

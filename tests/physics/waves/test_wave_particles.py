"""Wave particles: places, heights and sums beside closed forms and naive twins; floats; a hull's wedge."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from game.physics.waves.floats import FVX as SPEED
from game.physics.waves.floats import (
    FX,
    FY,
    FZ,
    HUMP,
    TOOK,
    TRAIN,
    FloatingBodies,
    FloatSettings,
    level_at,
)
from game.physics.waves.hull import Hull, outline_of
from game.physics.waves.wave_particles import (
    ANGLE,
    AWAY,
    COS,
    FADED,
    HEIGHT,
    KIND,
    MADE,
    REFUSED,
    SIN,
    SPLIT,
    WaveParticles,
    WaveSettings,
    X,
    Y,
    speed_of,
)

SIZE = (16.0, 9.0)
EXACT = WaveSettings(fading=0.0, lowest=0.0)
PRINTED = EXACT._replace(keeps=0)


def pond(settings=EXACT, radii=(0.25,), cell=0.05, size=SIZE, capacity=60_000):
    return WaveParticles(size, radii, cell, settings, capacity)


def run(water, seconds, dt=1.0 / 60.0):
    for _ in range(round(seconds / dt)):
        water.step(dt)
    return water.find_heights()


def test_speeds_are_those_of_airys_waves():
    assert speed_of(1.0, 5.0, 9.81) == pytest.approx(1.7670936544119118, rel=1e-12)
    assert speed_of(2.0, 0.8, 9.81) == pytest.approx(2.304190282292868, rel=1e-12)


def test_a_ring_is_where_its_speed_says_and_all_of_it_is_on_one_circle():
    water = pond()
    water.add_ring((8.0, 4.5), 0.05, 0.5)
    run(water, 3.0)
    away = np.hypot(water.fields[X] - 8.0, water.fields[Y] - 4.5)
    expected = 0.5 + 3.0 * float(water.speeds[0])
    assert water.books[SPLIT] > 50 and np.allclose(away, expected, atol=1e-9)
    assert np.allclose(water.fields[AWAY], expected, atol=1e-9)
    turns = np.sort(np.arctan2(water.fields[Y] - 4.5, water.fields[X] - 8.0))
    assert np.allclose(np.diff(turns), math.tau / water.count, atol=1e-9), "evenly all around"


@pytest.mark.parametrize(("settings", "power"), [(PRINTED, 1.0), (EXACT, 0.5)])
def test_a_crest_sinks_as_its_rule_says(settings, power):
    water = pond(settings)
    water.add_ring((8.0, 4.5), 0.05, 0.5)
    for _ in range(4):
        run(water, 0.8)
        away = float(water.fields[AWAY][0])
        looks = [level_at(water.heights, water.cell, 8.0 + away * math.cos(k), 4.5 + away * math.sin(k))[0]
                 for k in np.linspace(0.0, 6.2, 97)]  # fmt: skip
        assert np.mean(looks) == pytest.approx(0.05 * (0.5 / away) ** power, rel=0.05)
        assert np.std(looks) < 0.05 * np.mean(looks), "even"


def test_what_each_rule_keeps_is_kept():
    for settings, what in ((PRINTED, WaveParticles.volume), (EXACT, WaveParticles.energy)):
        water = pond(settings)
        water.add_ring((8.0, 4.5), 0.05, 0.5)
        run(water, 0.0)
        before = what(water)
        run(water, 3.0)
        assert what(water) == pytest.approx(before, rel=1e-12 if settings is PRINTED else 0.02)


def test_heights_are_the_sum_of_humps_by_a_naive_twin():
    rng = np.random.default_rng(4)
    water = pond(radii=(0.2, 0.5), cell=0.1, size=(6.0, 4.0))
    for _ in range(30):
        x, y, tall = rng.uniform(1.2, 2.8), rng.uniform(1.2, 2.8), rng.normal()
        x, y = (round(one / 0.1 - 0.5) * 0.1 + 0.05 for one in (x, y))  # on points of the grid
        water.add((x, y), (1.0, 0.0), tall, 0.1, 1.0, int(rng.integers(0, 2)))
    found = water.find_heights()
    ny, nx = found.shape
    gx, gy = np.meshgrid((np.arange(nx) + 0.5) * water.cell, (np.arange(ny) + 0.5) * water.cell)
    expected = np.zeros_like(found)
    for p in range(water.count):
        radius = water.radii[int(water.fields[KIND, p])]
        humps = [
            np.where(np.abs(off) < radius, 0.5 * (1.0 + np.cos(math.pi * off / radius)), 0.0)
            for off in (gx - water.fields[X, p], gy - water.fields[Y, p])
        ]
        expected += water.fields[HEIGHT, p] * humps[0] * humps[1]
    assert np.allclose(found, expected, atol=1e-9)


def test_water_at_a_bank_is_folded_back_and_none_is_lost():
    water = pond(PRINTED, size=(6.0, 3.4))
    water.add_ring((1.1, 1.1), 0.05, 0.5)
    before = water.volume()
    for _ in range(8):
        heights = run(water, 0.5)
        assert water.volume() == pytest.approx(before, rel=1e-12)
        assert heights.sum() * water.cell**2 == pytest.approx(before, rel=2e-3)
        assert ((water.fields[X] >= 0.0) & (water.fields[X] <= 6.0)).all()
        assert ((water.fields[Y] >= 0.0) & (water.fields[Y] <= 3.4)).all()


def test_a_bank_mirrors_place_direction_and_origin():
    water, free = pond(size=(6.0, 4.0)), pond(size=(20.0, 20.0))
    for one, at in ((water, (5.5, 3.6)), (free, (5.5, 3.6))):
        one.add(at, (0.6, 0.8), 0.1, 0.4, 0.6)
    run(water, 1.5)
    run(free, 1.5)
    assert water.count == free.count > 3
    mirrored = np.array(free.fields)
    for axis, end in ((X, 6.0), (Y, 4.0)):
        beyond = mirrored[axis] > end
        mirrored[axis] = np.where(beyond, 2.0 * end - mirrored[axis], mirrored[axis])
        mirrored[COS if axis == X else SIN] *= np.where(beyond, -1.0, 1.0)
    assert np.allclose(water.fields, mirrored, atol=1e-12)


def test_low_ones_are_left_out_and_booked():
    water = pond(PRINTED._replace(fading=1.0, lowest=0.01))
    water.add_ring((8.0, 4.5), 0.05, 0.5)
    before = water.volume()
    run(water, 4.0)
    assert water.count == 0 and water.books[FADED] == water.books[MADE] + 2 * water.books[SPLIT]
    assert 0.0 < water.lost[0] < before


def test_without_a_place_a_particle_goes_on_whole():
    water = pond(PRINTED, capacity=40)
    water.add_ring((8.0, 4.5), 0.05, 0.5)
    before = water.volume()
    run(water, 2.0)
    assert water.count <= 40 and water.books[REFUSED] > 0
    assert water.volume() == pytest.approx(before, rel=1e-12)


def test_a_state_is_taken_up_to_the_bit():
    water = pond()
    water.drop((5.0, 4.0), 0.05)
    run(water, 1.0)
    kept = type(water.state())(*(np.copy(field) for field in water.state()))
    after = run(water, 1.0).copy()
    other = pond()
    other.restore(kept)
    assert np.array_equal(run(other, 1.0), after)


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ({"size": (0.0, 9.0)}, "size"), ({"size": (math.nan, 9.0)}, "size"), ({"cell": 0.0}, "cell"),
        ({"radii": ()}, "radii"), ({"radii": (0.01,)}, "radii"), ({"radii": (4.0,)}, "radii"),
        ({"capacity": 0}, "capacity"),
    ],
)  # fmt: skip
def test_nonsense_is_refused(words, name):
    with pytest.raises(ValueError, match=f"^{name}"):
        pond(**words)


# -- floats -----------------------------------------------------------------------------------------


FREE = FloatSettings(0.0, 0.0)


def still(settings=FREE):
    water = pond()
    water.find_heights()
    return water, FloatingBodies(water, settings)


@pytest.mark.parametrize("density", [0.2, 0.5, 0.9])
def test_a_float_heaves_at_the_period_of_its_draft(density):
    _, floats = still()
    floats.add((8.0, 4.5), 0.3, 0.4, density)
    floats.rows[0, FZ] += 0.01
    dt, places = 1.0 / 1000.0, []
    for _ in range(3000):
        floats.step(dt)
        places.append(floats.rows[0, FZ] + density * 0.4)
    places = np.array(places)
    rises = np.nonzero((places[:-1] < 0.0) & (places[1:] >= 0.0))[0]
    assert np.diff(rises).mean() * dt == pytest.approx(math.tau * math.sqrt(density * 0.4 / 9.81), rel=5e-3)
    assert np.abs(places).max() == pytest.approx(0.01, rel=0.01)


def test_floats_that_lie_still_stay_so_and_send_nothing():
    water, floats = still(FloatSettings())
    floats.add((8.0, 4.5), 0.3, 0.4, 0.5)
    before = floats.rows.copy()
    for _ in range(600):
        floats.step(1.0 / 60.0)
    floats.send_waves(0)
    assert water.count == 0 and np.allclose(floats.rows, before, atol=1e-15)


def test_floats_that_meet_keep_their_momentum():
    _, floats = still()
    floats.add((4.0, 4.0), 0.3, 0.2, 0.5)
    floats.add((5.0, 4.1), 0.2, 0.2, 0.9)
    floats.rows[0, SPEED], floats.rows[1, SPEED] = 2.0, -1.0
    mass = floats.rows[:, 10]
    before = (mass[:, None] * floats.rows[:, SPEED : SPEED + 2]).sum(axis=0)
    for _ in range(60):
        floats.step(1.0 / 60.0)
    after = (mass[:, None] * floats.rows[:, SPEED : SPEED + 2]).sum(axis=0)
    assert np.allclose(after, before, atol=1e-12)
    assert floats.rows[0, SPEED] < 1.0, "they did meet"


def test_waves_of_a_float_cost_no_more_than_its_drag_took():
    water, floats = still(FloatSettings(1.0, 4.0))
    floats.add((8.0, 4.5), 0.3, 0.4, 0.3)
    floats.rows[0, FZ] += 0.5
    for _ in range(12):
        floats.step(1.0 / 60.0)
    for _ in range(20):
        floats.step(1.0 / 60.0)
        took = float(floats.rows[0, TOOK])
        first = water.count
        floats.send_waves(0)
        sent = water.fields[:, first:]
        cost = TRAIN * HUMP * 9.81 * float(np.sum(sent[HEIGHT] ** 2)) * 0.25**2
        assert cost <= took * (1.0 + 1e-12)
    assert water.count > 0


def test_what_drag_takes_is_taken_from_the_waves_below():
    water, floats = still(FloatSettings(1.0, 4.0))
    floats.add((8.0, 4.5), 0.5, 0.4, 0.3)
    for k in range(5):
        water.add((8.0 + 0.05 * k, 4.5), (1.0, 0.0), 0.1, 0.01, 1.0)
    water.add((12.0, 4.5), (1.0, 0.0), 0.1, 0.01, 1.0)
    before = HUMP * 9.81 * float(np.sum(water.fields[HEIGHT] ** 2)) * 0.25**2
    floats.rows[0, TOOK] = 0.3 * before
    floats.send_waves(0)
    after = HUMP * 9.81 * float(np.sum(water.fields[HEIGHT] ** 2)) * 0.25**2
    assert before - after == pytest.approx(0.3 * before, rel=1e-9)
    assert water.fields[HEIGHT, 5] == 0.1, "one that is elsewhere is left alone"


def test_a_float_drifts_down_the_slope():
    water, floats = still(FloatSettings())
    water.heights[:] = 0.01 * (np.arange(water.heights.shape[1]) + 0.5) * water.cell
    floats.add((8.0, 4.5), 0.3, 0.4, 0.5)
    for _ in range(10):
        floats.step(1.0 / 60.0)
    assert floats.rows[0, SPEED] < -1e-3 and abs(floats.rows[0, FY] - 4.5) < 1e-12


def test_a_float_that_is_nonsense_is_refused():
    _, floats = still()
    for words in (
        ((1.0, 1.0), 0.0, 0.1, 0.5),
        ((1.0, 1.0), 0.1, 0.1, 99.0),
        ((math.nan, 1.0), 0.1, 0.1, 0.5),
    ):
        with pytest.raises(ValueError, match="expected"):
            floats.add(*words)
    assert len(floats) == 0


# -- a hull -----------------------------------------------------------------------------------------


def test_a_hull_is_closed_and_turned_outwards():
    outline = outline_of(1.4, 0.46)
    water = pond()
    hull = Hull(water, (8.0, 4.5), 1.4, 0.46, 0.14)
    assert np.allclose((hull.normals * hull.lengths[:, None]).sum(axis=0), 0.0, atol=1e-12)
    assert ((hull.middles * hull.normals).sum(axis=1) > 0.0).all()
    assert np.allclose(outline[0], (0.7, 0.0)) and outline[:, 1].max() == pytest.approx(0.23)


def test_a_hull_raises_as_much_as_it_lowers():
    water = pond(PRINTED)
    hull = Hull(water, (4.0, 4.5), 1.4, 0.46, 0.14)
    for _ in range(6):
        hull.step((1.5, 0.3), 1.0 / 60.0)
    hull.send_waves(0)
    assert water.count > 10 and water.fields[HEIGHT].max() > 0.0
    assert water.volume() == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("ratio", [1.5, 2.0, 3.0])
def test_the_wedge_of_a_fast_hull_is_machs(ratio):
    water = pond(EXACT._replace(lowest=1e-4), size=(24.0, 13.5), cell=0.1, capacity=120_000)
    hull = Hull(water, (2.0, 6.75), 1.4, 0.46, 0.14)
    speed = ratio * float(water.speeds[0])
    seconds = 10.0 / speed
    for n in range(round(60.0 * seconds)):
        hull.step((speed, 0.0), 1.0 / 60.0)
        water.step(1.0 / 60.0)
        if n % 2 == 0:
            hull.send_waves(0)
    back, side = hull.pose[0] - water.fields[X], np.abs(water.fields[Y] - 6.75)
    whole = (1.0 - 1.0 / ratio**2) * 10.0
    edges = np.linspace(whole / 3.0, whole, 9)
    outermost = [side[(back >= low) & (back < high)].max() for low, high in itertools.pairwise(edges)]
    slope = np.polyfit(0.5 * (edges[1:] + edges[:-1]), outermost, 1)[0]
    assert math.degrees(math.atan(slope)) == pytest.approx(math.degrees(math.asin(1.0 / ratio)), abs=1.5)


def test_a_hull_slower_than_its_waves_is_overtaken():
    water = pond()
    hull = Hull(water, (4.0, 4.5), 1.4, 0.46, 0.14)
    for n in range(180):
        hull.step((0.4, 0.0), 1.0 / 60.0)
        water.step(1.0 / 60.0)
        if n % 3 == 0:
            hull.send_waves(0)
    assert water.fields[X].max() > hull.bow()[0] + 0.5


def test_a_hull_stays_on_the_pond_and_puts_floats_aside():
    water, floats = still(FloatSettings())
    hull = Hull(water, (14.0, 4.5), 1.4, 0.46, 0.14)
    floats.add((15.0, 4.55), 0.2, 0.2, 0.5)
    for _ in range(120):
        hull.step((3.0, 0.0), 1.0 / 60.0)
        hull.push_aside(floats.rows)
        floats.step(1.0 / 60.0)
    assert hull.pose[0] == 16.0 and hull.speed == 0.0
    off = math.hypot(floats.rows[0, FX] - 16.0, floats.rows[0, FY] - 4.5)
    assert off > 0.4 and floats.rows[0, FX] <= 16.0
    with pytest.raises(ValueError, match="length, width, draft"):
        Hull(water, (1.0, 1.0), 0.0, 1.0, 1.0)


def test_angles_are_shared_by_three():
    water = pond()
    water.add((8.0, 4.5), (1.0, 0.0), 0.3, 0.9, 0.2)
    water.step(1.0 / 60.0)
    assert water.count == 3 and np.allclose(water.fields[ANGLE], 0.3) and water.books[SPLIT] == 1

"""Shallow water: exact solutions, what it keeps, hard cases, what is refused."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.lab.studies.water.waves import DamTrial
from game.lab.study import Setting
from game.physics.waves import (
    Bowl,
    ShallowSettings,
    ShallowWater,
    bernoulli_depth,
    critical_depth,
    dam_break,
)

G = 9.81
OPEN = ("open", "open", "wall", "wall")


def channel(
    depth, bed=None, cell=0.05, ends=("wall", "wall", "wall", "wall"), values=(0.0, 0.0, 0.0, 0.0), **own
):
    depth = np.asarray(depth, dtype=float)
    return ShallowWater(
        depth, np.zeros_like(depth) if bed is None else bed, cell, ShallowSettings(**own), ends, values
    )


def flow_on(water, seconds):
    """Go on for long."""
    for _ in range(round(seconds)):
        water.advance(1.0)


def of_cells(exact, x, cell, *args, parts=16):
    """Means of an exact depth over cells."""
    inside = (np.arange(parts) + 0.5) / parts - 0.5
    return np.mean([exact(x + part * cell, *args)[0] for part in inside], axis=0)


def dam_error(cells, right, method="linear"):
    trial = DamTrial(Setting(method, 20.0 / cells, {}, {"right": right}))
    trial.reset()
    trial.run()
    return trial.outcome().error


@pytest.mark.parametrize("right", [0.0, 0.1])
def test_a_dam_breaks_as_exactly_known(right):
    """L1 over 20 m after 0.8 s. Bounds at 2,000 cells: 0.0048 m² linear, 0.0247 constant."""
    assert dam_error(2000, right) < 0.0048
    assert dam_error(2000, right, "constant") < 0.0247
    errors = [dam_error(n, right) for n in (500, 1000, 2000)]
    assert all(1.7 < a / b < 2.6 for a, b in itertools.pairwise(errors)), errors


def test_at_the_dam_the_flow_is_that_of_the_fan():
    cell = 0.01
    x = (np.arange(2000) + 0.5) * cell - 10.0
    water = channel(np.where(x < 0.0, 1.0, 0.0), cell=cell, ends=OPEN)
    water.advance(0.8)
    assert np.mean(water.depth[0, 999:1001]) == pytest.approx(4.0 / 9.0, rel=0.003)
    assert np.mean(water.along[0, 999:1001]) == pytest.approx(0.9280272452364934, rel=1e-4)


@pytest.mark.parametrize(("right", "tolerance"), [(0.1, 0.01), (0.5, 0.01), (0.001, 0.02)])
def test_a_bore_runs_at_its_speed(right, tolerance):
    dam, cell = dam_break(1.0, right), 0.01
    x = (np.arange(2000) + 0.5) * cell - 10.0
    water = channel(np.where(x < 0.0, 1.0, right), cell=cell, ends=OPEN)
    places = []
    for _ in range(2):
        water.advance(0.6)
        places.append(x[np.nonzero(water.depth[0] > 0.5 * (right + dam.middle))[0][-1]])
    assert (places[1] - places[0]) / 0.6 == pytest.approx(dam.bore, rel=tolerance)
    behind = int(np.searchsorted(x, places[1] - 0.3))
    assert water.depth[0, behind] == pytest.approx(dam.middle, rel=tolerance)


def test_a_bore_that_meets_a_wall():
    """Rankine and Hugoniot, twice: of 0.5 m over 0.2 m; 0.95467 m at the wall after."""
    speed = (0.5 - 0.2) * math.sqrt(0.5 * G * (0.5 + 0.2) / (0.5 * 0.2))
    x = (np.arange(1000) + 0.5) * 0.01
    water = channel(
        np.where(x < 5.0, 0.5, 0.2),
        cell=0.01,
        ends=("flow", "wall", "wall", "wall"),
        values=(0.5 * speed, 0, 0, 0),
    )
    water.along[0] = np.where(x < 5.0, 0.5 * speed, 0.0)
    water.advance(2.4)
    assert water.depth[0, -1] == pytest.approx(0.954673846971554, rel=0.003)


def test_a_wall_driven_into_still_water():
    """A piston of 1 m/s into 0.5 m, as the stream that meets a wall: 0.747119 m."""
    water = channel(
        np.full(800, 0.5), cell=0.01, ends=("wall", "flow", "wall", "wall"), values=(0, -0.5, 0, 0)
    )
    water.along[:] = -0.5
    water.advance(0.8)
    assert water.depth[0, :60] == pytest.approx(0.7471191834926859, rel=0.003)


def bump(x):
    return np.maximum(0.2 - 0.05 * x * x, 0.0)


@pytest.mark.parametrize(
    ("flow", "below", "upstream", "crest", "downstream"),
    [
        (4.42, 2.0, 2.0, 1.7073474679150338, 2.0),
        (1.53, 0.40578, 1.0144467983010192, 0.6202564436995096, 0.405780945345038),
    ],
)
def test_steady_flow_over_a_bump(flow, below, upstream, crest, downstream):
    x = (np.arange(500) + 0.5) * 0.05 - 12.5
    last = "level" if below > critical_depth(flow) else "open"
    ends, values = ("flow", last, "wall", "wall"), (flow, below, 0.0, 0.0)
    water = channel(np.full(500, below) - bump(x), bump(x), ends=ends, values=values)
    flow_on(water, 200.0)
    assert np.ptp(water.along) < 0.02 * flow
    depths = water.depth[0]
    found = depths[50], depths[249], depths[450]
    assert found == pytest.approx((upstream, crest, downstream), rel=0.006)


def test_a_standing_jump_behind_a_bump():
    """Goutal and Maurel (1997), 0.18 m²/s and 0.33 m: the jump 1.6656 m behind the crest."""
    x = (np.arange(1000) + 0.5) * 0.025 - 12.5
    ends, values = ("flow", "level", "wall", "wall"), (0.18, 0.33, 0.0, 0.0)
    water = channel(np.maximum(0.33 - bump(x), 0.0), bump(x), 0.025, ends, values)
    flow_on(water, 300.0)
    depth = water.depth[0]
    beyond = np.nonzero((x > 0.5) & (depth > 0.17))[0][0]
    assert x[beyond] == pytest.approx(1.6656183843153405, abs=0.06)
    head = 1.5 * critical_depth(0.18) + 0.2
    before = bernoulli_depth(head - float(bump(x[beyond - 4])), 0.18, fast=True)
    assert depth[beyond - 4] == pytest.approx(before, rel=0.02)
    assert depth[0] == pytest.approx(bernoulli_depth(head, 0.18), rel=0.01)


def test_the_bowl_swings_with_second_order_but_for_its_shores():
    bowl, errors = Bowl(0.5, 1.0, 0.25), []
    for cells in (100, 200, 400):
        cell = 4.0 / cells
        x = (np.arange(cells) + 0.5) * cell - 2.0
        water = channel(of_cells(bowl.at, x, cell, 0.0), bowl.bed(x), cell)
        water.advance(2.0 * math.pi / bowl.rate)
        errors.append(float(np.sum(np.abs(water.depth[0] - of_cells(bowl.at, x, cell, water.time)))) * cell)
        assert (water.depth >= 0.0).all() and water.volume() == pytest.approx(2.0 / 3.0, rel=1e-3)
    assert errors[2] < 1e-3 and math.log2(errors[0] / errors[2]) / 2.0 > 1.3, errors


def test_round_water_breathes_in_a_round_bowl():
    """Thacker (1981): D 0.1, a 1, r0 0.8: 0.0651012 m deep in the middle after 1 s; the same in x and y."""
    n, cell = 150, 2.8 / 150
    x = (np.arange(n) + 0.5) * cell - 1.4
    r2 = x[:, None] ** 2 + x[None] ** 2
    share = (1.0 - 0.8**4) / (1.0 + 0.8**4)
    bed = 0.1 * r2
    root = math.sqrt(1.0 - share * share)
    level = 0.1 * (root / (1.0 - share) - r2 * ((1.0 - share * share) / (1.0 - share) ** 2 - 1.0))
    water = ShallowWater(np.maximum(level - bed, 0.0), bed, cell)
    volume = water.volume()
    water.advance(1.0)
    middle = water.depth[n // 2 - 1 : n // 2 + 1, n // 2 - 1 : n // 2 + 1].mean()
    later = 1.0 - share * math.cos(math.sqrt(0.8 * G))
    exact = 0.1 * (root / later - r2 * ((1.0 - share * share) / (later * later) - 1.0))
    error = np.abs(water.depth - np.maximum(exact - bed, 0.0)).mean()
    assert middle == pytest.approx(0.06510118759658438, rel=0.02)
    assert water.volume() == pytest.approx(volume, rel=1e-13)
    assert np.max(np.abs(water.depth - water.depth[::-1])) < 1e-12
    assert error < 8.5e-5  # m
    assert np.abs(water.depth - water.depth.T).mean() < 0.2 * error  # the sweeps' order alone tells x from y


def test_a_channel_along_y_does_as_one_along_x():
    rng = np.random.default_rng(3)
    depth, bed = rng.uniform(0.0, 1.0, 60), rng.uniform(0.0, 0.3, 60)
    along = channel(np.tile(depth, (2, 1)), np.tile(bed, (2, 1)), roughness=0.03)
    upright = channel(np.tile(depth, (2, 1)).T.copy(), np.tile(bed, (2, 1)).T.copy(), roughness=0.03)
    for _ in range(50):
        along.step(0.002)
        upright.step(0.002)
    assert np.array_equal(along.depth, upright.depth.T) and np.array_equal(along.along, upright.across.T)


def test_what_goes_across_at_one_speed_keeps_it():
    """Also where cells give all they have: thin water that runs off a slope."""
    x = np.arange(80) * 0.05
    water = ShallowWater(np.tile(np.where(x < 1.0, 0.3, 0.0), (1, 1)), (-0.5 * x)[None], 0.05, ends=OPEN)
    water.across[:] = 0.7 * water.depth
    for _ in range(200):
        water.step(0.9 * water.longest_step() / water.settings.courant)
        wet = water.depth > 1e-5
        assert water.across[wet] == pytest.approx(0.7 * water.depth[wet], rel=1e-5)


def lake(island):
    x = np.arange(200) * 0.05
    bed = np.where(x > 8.0, 0.7, 0.0) + 1.3 * np.exp(-(((x - 3.0) / 0.7) ** 2)) * island
    return bed, np.maximum(1.0 - bed, 0.0)


@pytest.mark.parametrize("method", ["constant", "linear"])
@pytest.mark.parametrize("island", [0.5, 1.0])
def test_a_lake_at_rest_does_not_move_at_all(method, island):
    """Over a hump or an island and a step, in 100,000 steps: not by a bit."""
    bed, depth = lake(island)
    water = channel(depth[:100], bed[:100], method=("constant", "linear").index(method))
    for _ in range(20_000):
        water.step(0.01)
    assert np.max(np.abs(water.along)) < 1e-13 and np.max(np.abs(water.depth - depth[:100])) < 1e-13


def test_a_thin_lake_at_rest():
    bed, _ = lake(0.5)
    depth = np.maximum(1e-3 - bed, 0.0)
    water = channel(depth, bed)
    water.advance(20.0)
    assert np.array_equal(water.depth[0], depth) and not water.along.any()


def test_puddles_and_a_moving_shore_stay_sane():
    """No depth below nothing, none is lost, no speed above twice the fastest wave's."""
    x = np.arange(400) * 0.025
    bed = 0.15 * np.abs(x - 5.0)
    depth = np.where(x < 2.0, 0.6, 1e-9)
    water = channel(depth, bed, 0.025)
    volume = water.volume()
    most = 2.0 * math.sqrt(G * 1.4) + 2.0 * math.sqrt(2.0 * G * 0.8)
    for _ in range(200):
        water.advance(0.05)
        assert (water.depth >= 0.0).all() and np.max(np.abs(water.velocity()[0])) < most
    assert water.volume() == pytest.approx(volume, rel=1e-12)


@pytest.mark.parametrize("method", ["constant", "linear"])
@pytest.mark.parametrize(("slope", "cell"), [(0.2, 0.1), (0.75, 0.5), (1.0, 0.1)])
def test_a_film_down_a_slope_is_not_faster_than_its_fall(slope, cell, method):
    """Its tip leaves a lake 0.5 m deep with 2 sqrt(g h): u² = 4 g h + 2 g drop at most; and nearly that."""
    x = (np.arange(200) + 0.5) * cell
    drop = slope * np.maximum(x - 40 * cell, 0.0)
    ends = ("wall", "open", "wall", "wall")
    water = channel(
        np.where(drop > 0.0, 0.0, 0.5), -drop, cell, ends, method=("constant", "linear").index(method)
    )
    most = 0.0
    for _ in range(60):
        water.advance(0.05)
        most = max(most, float(np.max(np.abs(water.velocity()[0][0]) / np.sqrt(G * (2.0 + 2.0 * drop)))))
    assert 0.85 < most < 1.0


@pytest.mark.parametrize("shore", [((0, 20), (12, 3), (20, 0)), ((0, 17), (7, 9), (15, 3), (22, 0))])
def test_a_shore_that_falls_dry_lets_its_last_water_go(shore):
    """No film stays behind on it, to fall and fall; none is faster than Ritter's tip, 2 sqrt(g h)."""
    x = (np.arange(256) + 0.5) * 0.5
    bed = np.interp(x, *zip(*shore, strict=True))
    depth = np.where(x < 48.0, np.maximum(10.0 - bed, 0.0), 0.0)
    water = channel(depth, bed, 0.5, ("wall", "open", "wall", "wall"))
    for _ in range(200):
        water.advance(0.1)
        assert np.max(np.abs(water.velocity()[0])) < 2.0 * math.sqrt(10.0 * G)
    assert np.max(water.depth[0, bed > 4.0]) < 1e-3


def test_streams_that_part_faster_than_the_vacuum_leave_dry_ground():
    """What is left between them goes as the cells do."""
    left, right = 0.4 * (-5.0 + 2.0 * math.sqrt(G * 0.5)) + 0.1, 0.4 * (5.0 - 2.0 * math.sqrt(G * 0.3)) - 0.1
    means = []
    for cells in (200, 400, 800):
        x = (np.arange(cells) + 0.5) * 10.0 / cells - 5.0
        water = channel(np.where(x < 0.0, 0.5, 0.3), cell=10.0 / cells, ends=OPEN)
        water.along[0] = np.where(x < 0.0, -5.0 * 0.5, 5.0 * 0.3)
        water.advance(0.4)
        means.append(water.depth[0, (x > left) & (x < right)].mean())
        assert np.isfinite(water.along).all() and (water.depth >= 0.0).all()
    assert means[0] < 0.01 and means[0] > 1.7 * means[1] > 1.7 * 1.7 * means[2]


def test_waves_leave_through_an_open_end():
    """A long wave of 1 cm on a metre of water: less than 2 % comes back."""
    x = np.arange(800) * 0.025
    water = channel(1.0 + 0.01 * np.exp(-(((x - 10.0) / 0.6) ** 2)), cell=0.025, ends=OPEN)
    water.advance(10.0)
    assert np.max(np.abs(water.depth - 1.0)) < 0.02 * 0.005


def test_a_wave_goes_round_and_round():
    x = (np.arange(200) + 0.5) * 0.05
    water = channel(
        1.0 + 0.01 * np.cos(2.0 * math.pi * x / 10.0), ends=("periodic", "periodic", "wall", "wall")
    )
    water.advance(10.0 / math.sqrt(G))
    assert water.depth[0] == pytest.approx(1.0 + 0.01 * np.cos(2.0 * math.pi * x / 10.0), abs=3e-4)


def test_green_says_how_high_a_swell_grows():
    """From 4 m to 0.5 m of depth over a slow slope: 1.6818 times as high."""
    x = np.arange(2400) * 0.125
    bed = np.interp(x, [20.0, 220.0], [0.0, 3.5])
    water = channel(4.0 - bed, bed, 0.125, ends=("flow", "open", "wall", "wall"))
    speed, most = math.sqrt(G * 4.0), 0.0
    for step in range(800):
        t = 0.1 * step
        water.values[0] = 1e-4 * speed * math.sin(2.0 * math.pi * t / 4.0) if t < 16.0 else 0.0
        water.advance(0.1)
        if t > 55.0:
            most = max(most, float(np.max(np.abs(water.depth[0, 1900:2100] + bed[1900:2100] - 4.0))))
    assert most / 1e-4 == pytest.approx(1.681792830507429, rel=0.03)


@pytest.mark.parametrize("rows", [1, 5])
def test_what_comes_through_the_ends_and_as_rain_is_counted(rows):
    """Against the change of the volume, in a river that fills, drains and is rained on."""
    bed = np.tile(np.linspace(0.5, 0.0, 50), (rows, 1))
    ends, values = ("flow", "open", "open", "wall"), (0.2, 0.0, 0.0, 0.0)
    water = ShallowWater(np.full((rows, 50), 0.1), bed, 0.1, ShallowSettings(rain=1e-3), ends, values)
    start = water.volume()
    for _ in range(200):
        water.advance(0.02)
    assert abs(water.came[0]) > 0.02 and water.came[1] == pytest.approx(
        4.0 * 1e-3 * 5.0 * (1 if rows == 1 else 0.5)
    )
    assert water.volume() - start == pytest.approx(water.came.sum(), rel=1e-10)


def test_rain_fills_a_valley():
    """1e-4 m/s on a V of slopes 0.05 and 10 m: sqrt(i L t s) deep in the middle after 100 s."""
    x = (np.arange(400) + 0.5) * 0.025 - 5.0
    water = channel(np.zeros(400), 0.05 * np.abs(x), 0.025, rain=1e-4)
    water.advance(100.0)
    assert water.volume() == pytest.approx(1e-4 * 100.0 * 10.0, rel=1e-12)
    settled = channel(water.depth, water.bed, 0.025, roughness=0.01)
    flow_on(settled, 300.0)
    assert settled.depth[0, 199:201] == pytest.approx(0.07071067811865477 - 0.05 * 0.0125, rel=0.03)


def test_manning_slows_a_river_to_its_normal_depth():
    """q = h^(5/3) sqrt(S) / n on a slope of 0.01."""
    x = (np.arange(400) + 0.5) * 0.25
    q, n = 0.5, 0.03
    normal = (q * n / math.sqrt(0.01)) ** 0.6
    bed = 0.01 * (100.0 - x)
    water = channel(
        np.full(400, normal),
        bed,
        0.25,
        ("flow", "level", "wall", "wall"),
        (q, bed[-1] + normal, 0, 0),
        roughness=n,
    )
    flow_on(water, 120.0)
    assert water.depth[0, 100:300] == pytest.approx(normal, rel=0.01)


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0.3, 0.9]), st.integers(1, 6))
def test_whatever_lies_there_nothing_is_lost_and_energy_falls(seed, courant, rows):
    rng = np.random.default_rng(seed)
    shape = (rows, 40)
    bed = rng.uniform(0.0, 1.0, shape) * rng.integers(0, 2, shape)
    depth = rng.uniform(0.0, 2.0, shape) * rng.integers(0, 2, shape)
    water = ShallowWater(depth, bed, 0.1, ShallowSettings(courant=courant))
    volume, energy = water.volume(), water.energy()
    for _ in range(10):
        water.advance(0.02)
        assert (water.depth >= 0.0).all()
    assert water.volume() == pytest.approx(volume, rel=1e-12, abs=1e-12)
    assert water.energy() <= energy * (1.0 + 1e-3) + 1e-12


def test_a_step_that_is_too_long_is_refused():
    water = channel(np.ones(50))
    limit = 0.05 / math.sqrt(G)
    for _ in range(20):
        water.step(0.9 * limit)
    with pytest.raises(ValueError, match="more than a cell"):
        water.step(1.1 * limit)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"depth": [-1.0, 1.0]}, "at least 0"),
        ({"depth": [math.nan, 1.0]}, "finite"),
        ({"bed": [[0.0]]}, "alike"),
        ({"depth": []}, "alike"),
        ({"cell": 0.0}, "cell"),
        ({"ends": ("periodic", "wall", "wall", "wall")}, "periodic in pairs"),
        ({"ends": ("sea", "wall", "wall", "wall")}, "sea"),
        ({"values": (math.inf, 0.0, 0.0, 0.0)}, "finite"),
    ],
)
def test_nonsense_is_refused(change, words):
    given = {"depth": [1.0, 1.0], "bed": [0.0, 0.0], "cell": 0.1} | change
    with pytest.raises(ValueError, match=words):
        ShallowWater(**given)


def test_it_goes_on_from_a_state_as_it_was():
    rng = np.random.default_rng(5)
    water = ShallowWater(rng.uniform(0.0, 1.0, (12, 17)), rng.uniform(0.0, 0.4, (12, 17)), 0.1)
    water.advance(0.3)
    saved = type(water.state())(*(field.copy() for field in water.state()))
    water.advance(0.3)
    after = water.depth.copy()
    water.restore(saved)
    water.advance(0.3)
    assert np.array_equal(after, water.depth)

"""Grains in a trap: how they swing, follow, fall and meet; the order of a step."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.acoustics import Levitator, LevitatorSettings, escape_estimate, facing_rows, figure_path
from game.physics.acoustics.effects import GRAINS, SOUND
from game.physics.acoustics.levitator import AIR, FREQUENCY, POLYSTYRENE
from game.physics.acoustics.paths import FIGURES, WAY
from game.physics.constraints.effects import CONTACTS
from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND

DT = 1.0 / 240.0
WAVE = AIR.sound / FREQUENCY


def trap(places=((0.02, 0.0),), grain=POLYSTYRENE, **settings) -> Levitator:
    settings = {"speed": 0.0, **settings}
    array = facing_rows(2, 17, 0.01, 0.2, 10.0)
    return Levitator(array, places, grain, "circle", 0.02, LevitatorSettings(**settings))


def test_a_grain_swings_as_its_trap_is_stiff():
    start = 1e-3 * WAVE
    swinging = trap([(0.02, start)], effects=SOUND, substeps=32)
    pull = float(swinging.sample([(0.02, start)])[0, 5])
    period = 2.0 * math.pi * math.sqrt(POLYSTYRENE.mass * start / -pull)
    times, heights = [], []
    for step in range(240):
        swinging.step(DT / 8.0)
        times.append((step + 1) * DT / 8.0)
        heights.append(swinging.positions[0, 1])
    heights = np.array(heights)
    down = np.flatnonzero((heights[:-1] > 0.0) & (heights[1:] <= 0.0))
    crossings = [times[i] + DT / 8.0 * heights[i] / (heights[i] - heights[i + 1]) for i in down]
    assert np.mean(np.diff(crossings)) == pytest.approx(period, rel=2e-3)
    assert np.max(np.abs(heights[-60:])) == pytest.approx(start, rel=0.01)  # nothing lost, nothing gained


def test_in_still_air_a_grain_falls_as_fast_as_its_drag_allows():
    falling = trap([(0.0, 0.09)], effects=GRAVITY | DRAG)
    for _ in range(120):
        falling.step(DT)
    reached = -falling.fields[3, 0]
    assert reached == pytest.approx(escape_estimate(POLYSTYRENE.mass * 9.81, POLYSTYRENE, AIR), rel=1e-3)
    number = 2.0 * POLYSTYRENE.radius * AIR.density * reached / AIR.viscosity
    drag = 6.0 * math.pi * AIR.viscosity * POLYSTYRENE.radius * reached * (1.0 + 0.15 * number**0.687)
    assert drag == pytest.approx(POLYSTYRENE.mass * 9.81, rel=1e-3)


def test_a_step_is_of_second_order():
    def end(substeps: int) -> np.ndarray:
        moved = trap([(0.0203, 0.0)], speed=0.3, substeps=substeps)
        for _ in range(6):
            moved.step(1.0 / 60.0)
        return moved.positions[0]

    fine = end(1000) + (end(1000) - end(500)) / 3.0
    errors = [float(np.hypot(*(end(n) - fine))) for n in (40, 80, 160)]
    slopes = np.diff(np.log2(errors))
    assert np.all((slopes < -1.8) & (slopes > -2.3))


def test_a_slow_focus_carries_and_a_fast_one_loses():
    for speed, kept in ((0.3, True), (4.0, False)):
        led = trap(speed=speed, acceleration=2.0, substeps=16)
        for _ in range(720):
            led.step(DT)
        away = float(np.hypot(*(led.positions[0] - led.place)))
        assert (away < 0.25 * WAVE) == kept and bool(led.held()[0]) == kept


def test_without_sound_all_fall_and_come_to_rest_on_the_lower_row():
    falling = trap([(0.01 * k, 0.0) for k in range(5)], effects=GRAVITY | GROUND | DRAG)
    for _ in range(1200):
        falling.step(DT)
    assert np.allclose(falling.positions[:, 1], -falling.half + POLYSTYRENE.radius, atol=1e-5)
    assert not falling.held().any() and np.max(np.abs(falling.fields[2:])) < 0.01


def test_grains_in_one_trap_stay_apart_and_keep_their_momentum():
    pair = trap([(0.02, 0.0), (0.02 + 0.5e-3, 0.0)])
    for _ in range(240):
        pair.step(DT)
    gap = float(np.hypot(*(pair.positions[0] - pair.positions[1])))
    assert gap == pytest.approx(2.0 * POLYSTYRENE.radius, rel=0.02) and pair.held().all()
    meeting = trap([(0.0, 0.0), (2e-3, 1e-4)], effects=CONTACTS)
    meeting.fields[2, 0] = 1.0
    for _ in range(4):
        meeting.step(DT)
    assert np.allclose(np.sum(meeting.fields[2:], axis=1), (1.0, 0.0), atol=1e-15)
    assert 0.0 < meeting.fields[2, 0] < meeting.fields[2, 1]


def test_the_hand_leads_the_focus_no_faster_than_allowed():
    led = trap(speed=0.5)
    led.hand = (0.0, 0.03)
    before = led.place
    led.step(DT)
    assert math.dist(before, led.place) == pytest.approx(0.5 * DT, rel=1e-9)
    for _ in range(60):
        led.step(DT)
    assert led.place == pytest.approx((0.0, 0.03), abs=1e-12)


def test_the_focus_speeds_up_as_told_and_runs_along_its_figure():
    led = trap([], speed=0.2, acceleration=1.0)
    for _ in range(240):
        led.step(DT)
    assert led.focus[1] == pytest.approx(0.2, rel=1e-12)
    assert led.focus[0] == pytest.approx(0.2 * 1.0 - 0.2**2 / 2.0, rel=1e-9)
    assert math.hypot(*led.place) == pytest.approx(0.02, rel=1e-4)


@pytest.mark.parametrize("figure", FIGURES)
def test_figures_are_closed_and_as_wide_as_told(figure):
    path = figure_path(figure, 0.03)
    assert np.allclose(path[0, :2], path[-1, :2], atol=1e-12)
    assert np.all(np.diff(path[:, WAY]) > 0.0)
    assert 0.8 * 0.03 < np.max(np.abs(path[:, 0])) <= 0.03 + 1e-12


def test_put_back_it_goes_on_as_before():
    one = trap(speed=0.3)
    for _ in range(10):
        one.step(DT)
    kept = type(one.state())(*(array.copy() for array in one.state()))
    for _ in range(10):
        one.step(DT)
    after = one.positions
    one.restore(kept)
    for _ in range(10):
        one.step(DT)
    assert np.array_equal(after, one.positions)


def test_an_effect_that_is_off_equals_its_number_at_nothing():
    def end(**settings) -> np.ndarray:
        moved = trap(speed=0.3, **settings)
        for _ in range(30):
            moved.step(DT)
        return moved.positions

    without = EffectSet([effect for effect in GRAINS.known if effect is not GRAVITY])
    assert np.array_equal(end(effects=without), end(gravity=0.0))
    assert not np.array_equal(end(), end(gravity=0.0))

"""Readouts are sampled where a chart will show them, and again at once after a long run that was stopped."""

from __future__ import annotations

from game.stage import Stage
from tests.stage.example_scene import BouncingBall


def test_a_long_run_samples_only_what_the_charts_will_show() -> None:
    stage = Stage(BouncingBall)
    steps = 3 * round(stage.series.window_s / stage.dt)
    stage.run(steps)
    times = stage.series.times
    assert times[-1] > stage.time_s - 1.5 / stage.series.rate_hz
    assert len(times) <= stage.series.window_s * stage.series.rate_hz + 2
    assert times[0] >= stage.time_s - stage.series.window_s - 2.0 * stage.dt


def test_a_run_that_was_stopped_is_sampled_from_its_next_step_on() -> None:
    stage = Stage(BouncingBall)
    made = stage.run(1_000_000, progress=lambda done, total: False)
    assert made < 1_000_000 and stage.series.times[-1] < stage.time_s
    stage.run(1)
    assert stage.series.times[-1] == stage.time_s


def test_a_step_back_forgets_the_samples_since() -> None:
    stage = Stage(BouncingBall)
    stage.run(10)
    stage.step_back()
    assert stage.series.times[-1] <= stage.time_s
    stage.step()
    assert stage.series.times[-1] == stage.time_s

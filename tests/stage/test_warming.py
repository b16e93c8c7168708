"""Compiling in the background, and what effects cost: neither depends here on how fast the machine is."""

from __future__ import annotations

import math
import threading
from random import Random
from typing import NamedTuple

import numpy as np
import pytest

from game.levels import Level
from game.physics.effects import EffectSet, declare_effect
from game.stage import EffectMeter, Scene, SetEffect, Stage, Warming, WarmUp
from tests.stage.example_scene import BouncingBall

CHEAP = declare_effect("test-gravity", "Gravity", "Pulls everything down.")
DEAR = declare_effect("test-ground", "Ground", "The ball comes back from the ground.")


class TestWarming:
    def test_in_order_and_in_another_thread(self) -> None:
        seen = []
        main = threading.get_ident()

        def note(name: str):
            return WarmUp(name, lambda: seen.append((name, threading.get_ident() != main)))

        warming = Warming([note(name) for name in "abc"])
        assert warming.wait(600.0)
        assert seen == [("a", True), ("b", True), ("c", True)]
        progress = warming.progress
        assert (progress.done, progress.total, progress.name) == (3, 3, "")
        assert warming.finished
        assert warming.errors == []

    def test_the_main_thread_goes_on_and_sees_how_far_it_is(self) -> None:
        begun, go_on = threading.Event(), threading.Event()

        def slow() -> None:
            begun.set()
            assert go_on.wait(600.0)

        ticks = iter(range(100))
        warming = Warming([WarmUp("slow", slow)], clock=lambda: float(next(ticks)))
        assert begun.wait(600.0)
        assert not warming.finished
        progress = warming.progress
        assert (progress.done, progress.total, progress.name) == (0, 1, "slow")
        assert warming.progress.seconds > progress.seconds
        go_on.set()
        assert warming.wait(600.0)
        assert warming.progress.seconds == warming.progress.seconds

    def test_errors_are_told_and_the_next_one_is_called(self) -> None:
        seen = []

        def fail() -> None:
            raise RuntimeError("no\n  compiler")

        def silent() -> None:
            raise KeyError

        warming = Warming([WarmUp("a", fail), WarmUp("b", silent), WarmUp("c", lambda: seen.append("c"))])
        assert warming.wait(600.0)
        assert warming.errors == [("a", "no compiler"), ("b", "KeyError")]
        assert seen == ["c"]
        assert warming.progress.done == 3

    def test_cancelling_stops_between_two(self) -> None:
        begun, go_on, seen = threading.Event(), threading.Event(), []

        def first() -> None:
            begun.set()
            assert go_on.wait(600.0)
            seen.append("first")

        warming = Warming([WarmUp("first", first), WarmUp("second", lambda: seen.append("second"))])
        assert begun.wait(600.0)
        warming.cancel()
        assert not warming.finished
        go_on.set()
        assert warming.wait(600.0)
        assert seen == ["first"]

    def test_nothing_to_do(self) -> None:
        warming = Warming([])
        assert warming.wait(600.0)
        assert warming.progress.total == 0

    def test_the_default_of_a_scene_is_one_step(self) -> None:
        warming = Warming(BouncingBall.warm_ups())
        assert warming.wait(200.0)
        assert warming.errors == []


class Time(NamedTuple):
    """spent: (1,) s."""

    spent: np.ndarray


class Costly(Scene):
    """Its steps cost what the test's clock says they do, and they do what its effects say."""

    name, task, title = "costly", "X05", "Costly"
    effects = CHEAP | DEAR
    clock_s = 0.0

    def build(self, level):
        self.time = Time(np.zeros(1))

    def advance(self, dt):
        Costly.clock_s += 2e-6 + 1e-6 * (CHEAP in self.active) + 5e-6 * (DEAR in self.active)
        self.time.spent[0] += dt

    def state(self):
        return self.time


def measured(stage: Stage) -> EffectMeter:
    meter = EffectMeter(stage, clock=lambda: Costly.clock_s)
    finish(meter)
    return meter


def finish(meter: EffectMeter) -> None:
    """Slices until all is measured; code compiles in a thread meanwhile."""
    pause = threading.Event()
    for _ in range(100_000):
        meter.slice(1e-4)
        if meter.done:
            return
        pause.wait(0.0005)
    raise AssertionError("it never ends")


class TestEffectMeter:
    def test_what_is_saved_and_what_is_added(self) -> None:
        meter = measured(Stage(Costly))
        assert meter.costs == pytest.approx({"test-gravity": 1e-6, "test-ground": 5e-6})
        assert meter.bare == pytest.approx(2e-6)
        meter = measured(Stage(Costly, effects_off=["test-ground"]))
        assert meter.costs == pytest.approx({"test-gravity": 1e-6, "test-ground": 5e-6})

    def test_copies_are_built_behind_the_picture(self) -> None:
        stage, builders = Stage(Costly), []
        build = stage.build_scene

        def noted(values, active):
            builders.append(threading.get_ident())
            return build(values, active)

        stage.build_scene = noted  # type: ignore[method-assign]
        measured(stage)
        assert len(builders) == 6 and threading.get_ident() not in builders

    def test_a_scene_that_takes_long_is_measured_in_the_thread_alone(self) -> None:
        steps: list[bool] = []

        class Large(Costly):
            def takes_long(self, event: object) -> bool:
                return True

            def advance(self, dt: float) -> None:
                steps.append(threading.current_thread() is threading.main_thread())
                super().advance(dt)

        meter = measured(Stage(Large))
        assert steps and not any(steps)
        assert meter.costs == pytest.approx({"test-gravity": 1e-6, "test-ground": 5e-6})

    def test_the_scene_is_only_read(self) -> None:
        stage, twin = Stage(Costly), Stage(Costly)
        stage.run(10)
        measured(stage)
        stage.run(10)
        twin.run(20)
        assert stage.digest() == twin.digest()
        assert stage.scene.active == Costly.effects

    def test_a_slice_takes_about_its_budget(self) -> None:
        meter = EffectMeter(Stage(Costly), clock=lambda: Costly.clock_s)
        spent = []
        for _ in range(100_000):
            before = Costly.clock_s
            meter.slice(1e-3)
            spent.append(Costly.clock_s - before)
            if meter.done:
                break
        # a slice may begin one more pair of measurements, of a quarter of the budget each
        assert max(spent) < 1.6e-3 + 3 * 2 * 8e-6

    def test_a_switched_effect_begins_again(self) -> None:
        stage = Stage(Costly)
        meter = measured(stage)
        stage.post(SetEffect("test-gravity", False))
        meter.slice(1e-4)
        assert not meter.done
        assert set(meter.costs) == {"test-gravity", "test-ground"}
        finish(meter)
        assert meter.costs["test-gravity"] == pytest.approx(1e-6)

    def test_an_effect_that_cannot_be_left_out(self) -> None:
        class Needs(Costly):
            name = "needs"

            def advance(self, dt):
                if DEAR not in self.active:
                    raise ZeroDivisionError
                super().advance(dt)

        meter = measured(Stage(Needs))
        assert set(meter.costs) == {"test-gravity"}
        assert math.isnan(meter.bare)

    def test_a_scene_without_effects(self) -> None:
        class Plain(Costly):
            name = "plain"
            effects = EffectSet()

        meter = measured(Stage(Plain))
        assert meter.costs == {}
        assert meter.bare == pytest.approx(2e-6)

    def test_nothing_is_measured_while_the_scene_is_stopped(self) -> None:
        stage = Stage(Costly)
        stage.scene.state().spent[0] = math.nan
        stage.run(1)
        assert stage.fault is not None
        meter = EffectMeter(stage)
        meter.slice(1.0)
        assert not meter.done
        assert meter.costs == {}

    def test_another_level_forgets_what_was_measured(self) -> None:
        stage = Stage(Costly)
        meter = measured(stage)
        stage.load_level(Level(scene=Costly.name, title="Another"))
        meter.slice(1e-4)
        assert meter.costs == {} and math.isnan(meter.bare) and not meter.done

    def test_what_is_less_than_the_noise_is_no_cost(self) -> None:
        noise = Random(1)

        class Noisy(Costly):
            name = "noisy"

            def advance(self, dt):
                super().advance(dt)
                Costly.clock_s += 4e-6 * noise.random() - (5e-6 if DEAR in self.active else 0.0)

        meter = measured(Stage(Noisy))  # the ground now costs nothing, gravity less than the noise
        assert meter.costs["test-ground"] == 0.0

        class Clear(Costly):
            name = "clear"

            def advance(self, dt):
                super().advance(dt)
                Costly.clock_s += 1e-6 * noise.random()

        assert measured(Stage(Clear)).costs["test-ground"] == pytest.approx(5e-6, rel=0.2)

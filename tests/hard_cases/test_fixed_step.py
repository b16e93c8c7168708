"""The fixed-step core: frames of any length, pauses, odd times and input between steps."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.stage import (
    FASTEST,
    SLOWEST,
    FixedStep,
    Pointer,
    SetEffect,
    SetParameter,
    Stage,
    blend,
    blend_angles,
    blend_quaternions,
    jumped,
    replay_scene,
)
from tests.stage.example_scene import KICK, BouncingBall

DT = 1.0 / 60.0
EPS = 2.0**-52


def steps_after_hitch(cost: float, max_steps: int, frames: int) -> tuple[list[int], FixedStep]:
    """Steps of each frame after one second's hitch, when a step takes ``cost`` times its own length."""
    clock = FixedStep(DT, max_steps)
    made = [clock.advance(1.0)]
    while len(made) < frames:
        made.append(clock.advance(made[-1] * cost * DT))
    return made, clock


class TestRandomFrames:
    """Frames of any length make as many steps as fit their sum."""

    @given(st.lists(st.floats(1e-6, 15 * DT), min_size=1, max_size=60))
    def test_whole_steps_of_the_total_time(self, frames: list[float]) -> None:
        clock = FixedStep(DT)
        steps = sum(clock.advance(frame) for frame in frames)
        total = math.fsum(frames)
        rounding = 8 * len(frames) * EPS * total
        assert steps * DT <= total + rounding
        assert total - rounding < (steps + 1) * DT
        assert clock.dropped_s <= rounding

    @settings(max_examples=25)
    @given(st.lists(st.floats(1e-4, 15 / 120), min_size=1, max_size=30))
    def test_state_is_that_of_constant_frames(self, frames: list[float]) -> None:
        stage, constant = Stage(BouncingBall), Stage(BouncingBall)
        for frame in frames:
            stage.advance(frame)
        while constant.step_number < stage.step_number:
            assert constant.advance(1.0 / 120.0) == 1
        assert stage.digest() == constant.digest()


class TestHitch:
    """A frame of one second, and a step that costs 0.9 of its length"""

    def test_without_a_clamp_the_backlog_drains_slowly(self) -> None:
        made, _ = steps_after_hitch(0.9, 10**6, 16)
        assert made[:4] == [60, 54, 48, 43]
        assert made[14] > 5

    def test_with_a_clamp_it_drains_at_once(self) -> None:
        made, clock = steps_after_hitch(0.9, 15, 3)
        assert made == [15, 13, 12]
        assert clock.dropped_s == pytest.approx(0.75, abs=2 * DT)


class TestSpiralOfDeath:
    """Steps that cost more than their own length"""

    @pytest.mark.parametrize(("cost", "expected"), [(1.1, [60, 66, 72, 79]), (2.0, [60, 120, 240, 480])])
    def test_without_a_clamp_it_asks_for_ever_more(self, cost: float, expected: list[int]) -> None:
        assert steps_after_hitch(cost, 10**6, 4)[0] == expected

    @pytest.mark.parametrize("cost", [1.1, 2.0])
    @pytest.mark.parametrize("most", [15, 6])
    def test_with_a_clamp_it_is_capped_and_counted(self, cost: float, most: int) -> None:
        made, clock = steps_after_hitch(cost, most, 50)
        assert max(made) == most
        assert made[-1] == most
        elapsed = 1.0 + sum(made[:-1]) * cost * DT
        handed_out = sum(made) * DT
        assert clock.dropped_s == pytest.approx(elapsed - handed_out - clock.alpha * DT, abs=1e-9)

    def test_the_stage_shows_what_it_dropped(self) -> None:
        stage = Stage(BouncingBall)
        assert stage.advance(1.0) == 15
        assert stage.dropped_s == pytest.approx(1.0 - 15 / 120, abs=1 / 120)


class TestOddTimes:
    """Frames of no length, of negative length, and of none that is a number."""

    def test_no_time_no_step(self) -> None:
        clock = FixedStep(DT)
        assert clock.advance(0.0) == 0
        assert clock.alpha == 0.0

    def test_a_clock_set_back_counts_as_no_time(self) -> None:
        clock = FixedStep(DT)
        assert clock.advance(-5.0) == 0
        assert clock.advance(1.5 * DT) == 1
        assert clock.advance(-math.inf) == 0

    def test_not_a_number_is_refused(self) -> None:
        with pytest.raises(ValueError, match="elapsed_s is not a number"):
            FixedStep(DT).advance(math.nan)
        stage = Stage(BouncingBall)
        for paused in (False, True):
            stage.paused = paused
            with pytest.raises(ValueError, match="elapsed_s is not a number"):
                stage.advance(math.nan)

    @pytest.mark.parametrize("elapsed", [1e9, math.inf, 1e300])
    def test_ages_are_clamped(self, elapsed: float) -> None:
        clock = FixedStep(DT)
        assert clock.advance(elapsed) == 15
        assert 0.0 <= clock.alpha < 1.0
        assert clock.advance(0.0) == 0

    @pytest.mark.parametrize("dt", [0.0, -DT, math.nan, math.inf, "1", None, True])
    def test_a_step_length_that_is_none_is_refused(self, dt: object) -> None:
        with pytest.raises(ValueError, match="dt = "):
            FixedStep(dt)  # type: ignore[arg-type]
        with pytest.raises(ValueError, match="dt = "):
            FixedStep(DT).change_dt(dt)  # type: ignore[arg-type]

    @pytest.mark.parametrize("most", [0, -1, 1.5, True])
    def test_max_steps_must_be_a_count(self, most: object) -> None:
        with pytest.raises(ValueError, match="max_steps"):
            FixedStep(DT, most)  # type: ignore[arg-type]


class TestTransport:
    """Pause, single steps, slow and fast motion change when a state is reached, never which"""

    def states(self, stage: Stage, play) -> list[str]:
        seen = []
        while stage.step_number < 60:
            before = stage.step_number
            play(stage)
            if stage.step_number == before + 1:
                seen.append(stage.digest())
        return seen

    @pytest.mark.parametrize("speed", [SLOWEST, 0.1, 0.5, 1.0, FASTEST])
    def test_speed(self, speed: float) -> None:
        plain = Stage(BouncingBall)
        expected = self.states(plain, lambda stage: stage.run(1))
        stage = Stage(BouncingBall)
        stage.speed = speed
        frame = stage.dt / speed
        assert self.states(stage, lambda stage: stage.advance(frame)) == expected

    def test_eight_times_as_fast(self) -> None:
        clock = FixedStep(DT)
        assert sum(clock.advance(DT * 8.0) for _ in range(100)) in (799, 800)

    def test_pause_and_single_steps(self) -> None:
        plain = Stage(BouncingBall)
        expected = self.states(plain, lambda stage: stage.run(1))
        stage = Stage(BouncingBall)

        def play(stage: Stage) -> None:
            stage.step()
            assert stage.paused
            assert stage.advance(10.0) == 0

        assert self.states(stage, play) == expected

    def test_time_while_paused_is_not_made_up_for(self) -> None:
        stage = Stage(BouncingBall)
        stage.paused = True
        stage.advance(100.0)
        stage.paused = False
        assert stage.advance(0.9 * stage.dt) == 0
        assert stage.dropped_s == 0.0

    @pytest.mark.parametrize("speed", [0.0, 1 / 17, 4.1, -1.0, math.nan, math.inf])
    def test_other_speeds_are_refused(self, speed: float) -> None:
        with pytest.raises(ValueError, match="outside 1/16 to 4"):
            Stage(BouncingBall).speed = speed


class TestInterpolation:
    """What is drawn lies between the last two states."""

    @given(st.lists(st.floats(0.0, 0.5), min_size=1, max_size=50))
    def test_alpha_is_in_zero_to_one(self, frames: list[float]) -> None:
        clock = FixedStep(DT)
        for frame in frames:
            clock.advance(frame)
            assert 0.0 <= clock.alpha < 1.0

    def test_alpha_of_a_time_just_short_of_a_step(self) -> None:
        clock = FixedStep(DT)
        clock.advance(math.nextafter(DT, 0.0))
        assert clock.alpha < 1.0

    def test_alpha_zero_shows_the_older_state(self) -> None:
        before, now = np.array([[1.0, 2.0]]), np.array([[3.0, 7.0]])
        assert np.array_equal(blend(before, now, 0.0), before)

    def test_previous_is_the_state_before_the_last_step(self) -> None:
        stage, twin = Stage(BouncingBall), Stage(BouncingBall)
        stage.advance(7.5 / 120)
        twin.run(6)
        assert stage.step_number == 7
        assert np.array_equal(stage.scene.previous.position, twin.scene.state().position)
        assert stage.alpha == pytest.approx(0.5)

    def test_the_newest_state_is_shown_when_it_stands_still(self) -> None:
        stage = Stage(BouncingBall)
        stage.advance(3.25 / 120)
        stage.step()
        assert 1.0 - 1e-15 < stage.alpha < 1.0

    def test_going_on_does_not_show_an_older_picture(self) -> None:
        stage = Stage(BouncingBall)
        stage.advance(3.25 / 120)
        stage.step()
        shown = stage.scene.state().position.copy()
        stage.resume()
        assert np.array_equal(stage.scene.previous.position, shown)

    def test_angles_take_the_short_way(self) -> None:
        before, now = np.radians([350.0, 10.0]), np.radians([10.0, 350.0])
        middle = blend_angles(before, now, 0.5)
        assert np.cos(middle) == pytest.approx([1.0, 1.0])

    def test_half_a_turn_goes_counterclockwise(self) -> None:
        assert blend_angles(np.array([0.0, math.pi]), np.array([math.pi, 0.0]), 0.5) == pytest.approx(
            [math.pi / 2, 1.5 * math.pi]
        )

    def test_quaternions_take_the_short_way(self) -> None:
        ten = math.radians(5.0)
        before = np.array([[math.cos(ten), 0.0, 0.0, math.sin(ten)]])
        now = -np.array([[math.cos(3 * ten), 0.0, 0.0, math.sin(3 * ten)]])
        middle = blend_quaternions(before, now, 0.5)[0]
        expected = np.array([math.cos(2 * ten), 0.0, 0.0, math.sin(2 * ten)])
        assert abs(float(middle @ expected)) == pytest.approx(1.0, abs=1e-15)

    def test_nothing_is_blended_across_a_teleport(self) -> None:
        before = np.array([[0.0, 0.0], [5.0, 5.0]])
        now = np.array([[0.1, 0.0], [0.0, 0.0]])
        jumps = jumped(before, now, 1.0)
        assert jumps.tolist() == [False, True]
        assert blend(before, now, 0.5, jumps).tolist() == [[0.05, 0.0], [0.0, 0.0]]


class TestTimeBase:
    """Time is counted in steps, never added up."""

    def test_time_is_a_count_times_the_length(self) -> None:
        stage = Stage(BouncingBall, dt=DT, record=False, snapshot_bytes=0)
        stage.run(3600)
        assert stage.time_s == 3600 * DT

    def test_a_running_sum_is_off_by_what_is_known(self) -> None:
        """CORE.time_accumulation: one hour of 1/60 s added up."""
        double, single = 0.0, np.float32(0.0)
        for _ in range(216_000):
            double += DT
            single += np.float32(DT)
        assert abs(double - 3600.0) == pytest.approx(1.8e-8, rel=0.1)
        assert abs(float(single) - 3600.0) == pytest.approx(2.79, abs=0.01)
        assert 216_000 * DT == 3600.0


class TestInput:
    """Events belong to steps, so a replay at any frame rate comes to the same state"""

    events = (
        (0, SetParameter("gravity", 3.0)),
        (5, Pointer("down", 0.2, 0.7, 1)),
        (9, Pointer("move", 0.3, 0.9, 1)),
        (12, Pointer("up", 0.3, 0.9, 1)),
        (12, KICK),
        (40, SetEffect("test-ground", False)),
        (90, SetEffect("test-ground", True)),
        (100, SetParameter("height", 2.5)),
    )

    @pytest.mark.parametrize("frame", [1 / 24, 1 / 60, 1 / 144, 1 / 1000])
    def test_at_any_frame_rate(self, frame: float) -> None:
        stage = Stage(BouncingBall)
        waiting = list(self.events)
        while stage.step_number < 150:
            while waiting and waiting[0][0] <= stage.step_number:
                stage.post(waiting.pop(0)[1])
            stage.advance(frame)
        recording = stage.recording
        assert [stamped.event for stamped in recording.events] == [event for _, event in self.events]
        again = replay_scene(recording, BouncingBall)
        assert again.digest() == stage.digest()
        assert again.recording == recording


def test_a_hitch_keeps_the_part_of_a_step_that_had_gathered():
    """What is dropped is whole steps: otherwise the picture would jump back by a part of one."""
    clock = FixedStep(0.25, max_steps=3)
    assert clock.advance(2.0 + 0.1875) == 3
    assert clock.alpha == 0.75
    assert clock.dropped_s == 1.25
    assert clock.advance(0.0625) == 1

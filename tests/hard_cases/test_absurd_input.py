"""What is no number, negative, zero, huge or of another kind, as far as the stage is concerned."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import Level, LevelError, parse_level
from game.stage import FixedStep, ParameterError, Pointer, SetParameter, Stage
from tests.stage.example_scene import BallState, BouncingBall, step_ball
from tests.stage.odd_scenes import Cloud, CloudContent, Fragile

NOT_FINITE = [math.nan, math.inf, -math.inf]


class TestNotFinite:
    """NaN and the infinities, at every way in."""

    @pytest.mark.parametrize("value", NOT_FINITE)
    def test_at_every_door(self, value: float) -> None:
        stage = Stage(BouncingBall)
        with pytest.raises(ValueError, match="finite"):
            stage.post(SetParameter("gravity", value))
        with pytest.raises(ValueError, match="finite"):
            stage.post(Pointer("move", value, 0.0))
        with pytest.raises(ValueError, match="finite"):
            Stage(BouncingBall, parameters={"gravity": value})
        with pytest.raises(ValueError, match="dt"):
            Stage(BouncingBall, dt=value)
        with pytest.raises(ValueError, match="finite"):
            stage.scene.gravity = value
        with pytest.raises(ValueError, match="finite"):
            BouncingBall.gravity.parse(str(value))
        with pytest.raises(LevelError, match="finite"):
            Stage(BouncingBall, level=Level(scene="example", parameters={"gravity": value}))
        with pytest.raises(ValueError, match=r"not finite in the state|further than 100 m"):
            Stage(Cloud, level=Level(scene="cloud", content=CloudContent(points=[(value, 0.0)])))
        word = {"nan": "nan", "inf": "inf", "-inf": "-inf"}[str(value)]
        with pytest.raises(LevelError, match="points"):
            parse_level(f"scene='cloud'\n[content]\npoints=[[{word}, 0.0]]", "cloud", CloudContent)
        assert stage.recording.events == []


class TestNegativeAndZero:
    """Numbers that have to be above zero."""

    @pytest.mark.parametrize("value", [0.0, -1.0])
    def test_lengths_of_a_step(self, value: float) -> None:
        with pytest.raises(ValueError, match="dt = "):
            FixedStep(value)
        with pytest.raises(ValueError, match="dt = "):
            Stage(BouncingBall, dt=value)
        with pytest.raises(ParameterError, match="step_length"):
            Stage(Cloud, dt=value)

    def test_counts(self) -> None:
        with pytest.raises(ParameterError, match="first"):
            Stage(Cloud, parameters={"first": -1})
        assert len(Stage(Cloud, parameters={"first": 0}).scene.state().points) == 0


class TestWithinAStep:
    """What becomes not finite in the middle of a step; see also tests/stage/test_faults.py"""

    @pytest.mark.parametrize("value", NOT_FINITE)
    @pytest.mark.parametrize("field", ["position", "velocity"])
    def test_it_is_stopped_at_the_end_of_the_step(self, value: float, field: str) -> None:
        stage, neighbour = Stage(BouncingBall), Stage(BouncingBall)
        stage.run(77)
        neighbour.run(77)
        getattr(stage.scene.state(), field)[0] = value
        stage.run(1)
        assert stage.fault is not None
        assert stage.fault.step == 78
        assert stage.digest() == neighbour.digest()
        assert neighbour.fault is None
        stage.reset()
        assert stage.run(10) == 10

    def test_a_whole_run_stops_there(self) -> None:
        stage = Stage(Fragile, parameters={"break_at": 33})
        assert stage.run(10_000) == 32
        assert stage.fault is not None


class TestExtremes:
    """The largest and the smallest floats."""

    @pytest.mark.parametrize("x", [1e300, -1e300, 5e-324, 1e-300])
    def test_far_and_tiny_positions(self, x: float) -> None:
        stage = Stage(BouncingBall)
        stage.post(Pointer("down", x, x, 1))
        stage.post(Pointer("up", x, x, 1))
        stage.run(300)
        state = stage.scene.state()
        assert np.isfinite(state.position).all()
        assert stage.digest()

    def test_ages_in_one_frame(self) -> None:
        stage = Stage(BouncingBall, dt=5e-324)
        assert stage.advance(1.0) == 15
        assert 0.0 <= stage.alpha < 1.0
        stage = Stage(BouncingBall, dt=1e300)
        assert stage.advance(1e9) == 0
        stage.run(3)
        assert stage.fault is not None or np.isfinite(stage.scene.state().position).all()


class TestKindsOfNumbers:
    """Equal numbers of different types do the same."""

    def test_parameters(self) -> None:
        digests = set()
        for value in (4, 4.0, np.float32(4.0), np.int16(4), np.float64(4.0)):
            stage = Stage(BouncingBall, parameters={"height": value, "gravity": value})
            stage.run(100)
            digests.add(stage.digest())
        assert len(digests) == 1

    def test_negative_zero(self) -> None:
        digests = set()
        for value in (0.0, -0.0, 0):
            stage = Stage(BouncingBall)
            stage.post(SetParameter("gravity", value))
            stage.run(100)
            digests.add(stage.digest())
        assert len(digests) == 1

    def test_read_only_and_strided_states_are_watched(self) -> None:
        position = np.array([1.0, 9.0, 2.0, 9.0])[::2]
        velocity = np.zeros(2)
        position.flags.writeable = False
        state = BallState(position, velocity, np.zeros(1, dtype=np.int64))

        class Odd(BouncingBall):
            def build(self, level):
                self.ball, self.held = state, False

            def advance(self, dt):
                self.ball = state._replace(velocity=np.array([math.nan, 0.0])[::1])

        stage = Stage(Odd)
        assert stage.run(1) == 0
        assert stage.fault is not None
        assert stage.fault.quantity == "velocity"

    def test_a_kernel_takes_what_it_is_given(self) -> None:
        plain = BallState(np.array([0.0, 1.0]), np.zeros(2), np.zeros(1, dtype=np.int64))
        strided = BallState(np.array([0.0, 7.0, 1.0])[::2], np.zeros(2), np.zeros(1, dtype=np.int64))
        for state in (plain, strided):
            step_ball(state, 9.81, True, 0.8, 0.01)
        assert np.array_equal(plain.position, strided.position)

"""What goes wrong in a scene is stopped at its last good state, named, and can be undone."""

from __future__ import annotations

import numpy as np
import pytest

from game.stage import Action, ParameterError, Pointer, SetParameter, Stage
from tests.stage.odd_scenes import BURST, Crowd, Fragile


def broken(how: str, at: int = 50) -> Stage:
    stage = Stage(Fragile, parameters={"break_at": at})
    stage.post(Action(how))
    assert stage.run(200) == at - 1
    return stage


@pytest.mark.parametrize(
    ("how", "quantity", "message"),
    [
        ("nan", "height", "height is not finite at step 50"),
        ("raise", "ZeroDivisionError", "step 50 failed: ZeroDivisionError: nothing to divide by"),
    ],
)
class TestStep:
    def test_it_is_named(self, how, quantity, message) -> None:
        fault = broken(how).fault
        assert fault is not None
        assert (fault.quantity, fault.step, fault.message) == (quantity, 50, message)

    def test_the_scene_stands_at_its_last_good_state(self, how, quantity, message) -> None:
        stage, twin = broken(how), Stage(Fragile, parameters={"break_at": 50})
        twin.post(Action(how))
        twin.run(49)
        assert stage.step_number == 49
        assert stage.digest() == twin.digest()
        assert np.isfinite(stage.scene.previous.height).all()

    def test_it_stays_there(self, how, quantity, message) -> None:
        stage = broken(how)
        assert stage.advance(1.0) == 0
        assert stage.run(10) == 0
        stage.step()
        assert stage.step_number == 49
        assert stage.fault is not None

    def test_reset_goes_on_with_the_parameters_of_now(self, how, quantity, message) -> None:
        stage = broken(how)
        stage.post(SetParameter("break_at", 1e9))
        stage.post(SetParameter("weight", 2.0))
        stage.reset()
        assert stage.fault is None
        assert stage.run(100) == 100
        assert stage.scene.height[0] == pytest.approx(2.0 * 100 * stage.dt)

    def test_stepping_back_forgets_it(self, how, quantity, message) -> None:
        stage = broken(how)
        assert stage.step_back()
        assert stage.fault is None
        assert stage.step_number == 48
        stage.paused = False
        assert stage.run(10) == 1
        assert stage.fault is not None


class TestInjected:
    """G-N3: a NaN put into the state from outside"""

    def test_the_state_before_comes_back(self) -> None:
        stage, twin, neighbour = Stage(Fragile), Stage(Fragile), Stage(Fragile)
        for one in (stage, twin, neighbour):
            one.run(100)
        stage.scene.height[0] = np.nan
        assert stage.advance(1.0 / 120.0) == 0
        assert stage.fault is not None
        assert stage.fault.step == 101
        assert stage.digest() == twin.digest()
        assert neighbour.fault is None
        assert neighbour.digest() == twin.digest()

    def test_poison_outside_the_state_leads_back_to_a_snapshot(self) -> None:
        stage = Stage(Fragile)
        stage.run(100)
        stage.scene.values["weight"] = np.nan
        stage.run(5)
        assert stage.fault is not None
        assert np.isfinite(stage.scene.height).all()

    def test_what_may_be_infinite_is_no_fault(self) -> None:
        stage = Stage(Fragile)
        assert np.isinf(stage.scene.field).all()
        assert stage.run(10) == 10


class TestEvents:
    def test_an_event_that_makes_a_state_infinite_is_undone(self) -> None:
        stage, twin = Stage(Fragile), Stage(Fragile)
        stage.run(40)
        twin.run(40)
        stage.post(BURST)
        assert stage.fault is not None
        assert stage.fault.quantity == "height"
        assert stage.digest() == twin.digest()
        assert stage.recording.events == []

    def test_an_event_that_fails_is_undone(self) -> None:
        stage, twin = Stage(Fragile), Stage(Fragile)
        stage.run(40)
        twin.run(40)
        stage.post(Pointer("down", 0.0, 0.0, 1))
        assert stage.fault is not None
        assert isinstance(stage.fault.error, RuntimeError)
        assert stage.digest() == twin.digest()

    def test_an_event_that_is_refused_is_undone_without_a_fault(self) -> None:
        stage, twin = Stage(Fragile), Stage(Fragile)
        stage.run(40)
        twin.run(40)
        with pytest.raises(ParameterError, match="not now"):
            stage.post(Action("refuse"))
        assert stage.fault is None
        assert stage.digest() == twin.digest()
        assert stage.recording.events == []

    def test_a_build_that_is_refused_leaves_the_scene(self) -> None:
        stage = Stage(Fragile)
        stage.run(10)
        digest = stage.digest()
        with pytest.raises(ParameterError, match="seven"):
            stage.post(SetParameter("size", 7))
        assert stage.digest() == digest
        assert stage.scene.size == 4
        stage.post(SetParameter("size", 5))
        assert stage.scene.field.shape == (5, 5)

    def test_a_state_comes_back_that_its_parameters_alone_would_not_allow(self) -> None:
        """Twenty who are slim have room; twenty as broad as the parameter now says would not."""
        stage, twin = Stage(Crowd), Stage(Crowd)
        for one in (stage, twin):
            one.post(SetParameter("breadth", 10.0))
            one.run(200)
        with pytest.raises(ParameterError, match="no room for 30"):
            stage.post(SetParameter("count", 30))
        assert stage.fault is None
        assert (stage.scene.values, stage.digest()) == (twin.scene.values, twin.digest())
        stage.run(50)
        assert stage.step_back()
        twin.run(49)
        assert stage.digest() == twin.digest()


class TestBeginning:
    def test_a_state_that_begins_infinite_is_refused(self) -> None:
        class Born(Fragile):
            def build(self, level):
                super().build(level)
                self.height[0] = np.inf

        with pytest.raises(ValueError, match="height is not finite"):
            Stage(Born)

"""The stage itself: beginnings, levels, seeds, step length, running, readouts, the catalogue."""

from __future__ import annotations

import math

import msgspec
import numpy as np
import pytest

from game.levels import Level, LevelError
from game.stage import (
    Action,
    Catalogue,
    Entry,
    ParameterError,
    Pointer,
    SetEffect,
    SetParameter,
    Stage,
    replay_scene,
)
from tests.stage.example_scene import GROUND, KICK, BouncingBall
from tests.stage.odd_scenes import Cloud, CloudContent, Fragile, FragileState


class TestBeginning:
    def test_parameters_and_effects(self) -> None:
        stage = Stage(BouncingBall, parameters={"gravity": 2.0}, effects_off=["test-ground"])
        assert stage.scene.gravity == 2.0
        assert GROUND not in stage.scene.active
        stage.run(200)
        assert stage.scene.state().position[1] < 0.0

    def test_effects_off_come_to_those_of_the_level(self) -> None:
        level = Level(scene="example", effects_off=("test-ground",))
        stage = Stage(BouncingBall, level=level, effects_off=("test-gravity",))
        assert len(stage.scene.active) == 0

    @pytest.mark.parametrize(
        ("arguments", "error", "message"),
        [
            (
                {"parameters": {"colour": 1.0}},
                ParameterError,
                "colour: example has no such parameter; it has gravity",
            ),
            (
                {"parameters": {"gravity": math.nan}},
                ParameterError,
                "gravity = nan: expected a finite number",
            ),
            ({"parameters": {"gravity": "9"}}, ParameterError, "gravity = '9': expected a number"),
            ({"effects_off": ["wind"]}, ParameterError, "wind: example declares no such effect"),
            ({"dt": 0.0}, ValueError, "dt = 0.0"),
            ({"dt": math.nan}, ValueError, "dt = nan"),
            ({"seed": -1}, ValueError, "seed = -1"),
            ({"seed": 1.5}, ValueError, "seed = 1.5"),
            ({"max_steps": 0}, ValueError, "max_steps = 0"),
            ({"snapshot_bytes": -1}, ValueError, "snapshot_bytes = -1"),
        ],
    )
    def test_what_is_refused(self, arguments, error, message) -> None:
        with pytest.raises(error) as caught:
            Stage(BouncingBall, **arguments)
        assert message in str(caught.value)

    def test_the_seed(self) -> None:
        level = Level(scene="cloud", seed=4)
        digests = [
            Stage(Cloud, level=level).digest(),
            Stage(Cloud, seed=4).digest(),
            Stage(Cloud, level=level, seed=5).digest(),
            Stage(Cloud).digest(),
            Stage(Cloud, seed=0).digest(),
        ]
        assert digests[0] == digests[1]
        assert digests[3] == digests[4]
        assert len(set(digests)) == 3


class TestLevels:
    def test_a_level_brings_parameters_effects_and_content(self) -> None:
        stage = Stage(Cloud)
        stage.run(10)
        content = CloudContent(points=[(1.0, 2.0)])
        stage.load_level(Level(scene="cloud", parameters={"first": 0, "step_length": 0.05}, content=content))
        assert stage.step_number == 0
        assert stage.dt == 0.05
        assert stage.scene.state().points.tolist() == [[1.0, 2.0]]

    @pytest.mark.parametrize(
        ("level", "field"),
        [
            (Level(scene="c01"), "scene"),
            (Level(scene="cloud", parameters={"colour": 1.0}), "parameters.colour"),
            (Level(scene="cloud", parameters={"births": 2.0}), "parameters.births"),
            (Level(scene="cloud", effects_off=("wind",)), "effects.off"),
            (Level(scene="cloud", content=CloudContent(points=[(1e3, 0.0)])), "content"),
            (Level(scene="cloud", content=CloudContent(points=[(math.nan, 0.0)])), "content"),
        ],
    )
    def test_a_refused_level_leaves_everything(self, level: Level, field: str) -> None:
        stage = Stage(Cloud, parameters={"births": 0.5})
        stage.run(30)
        digest, recording = stage.digest(), stage.recording
        with pytest.raises(LevelError) as caught:
            stage.load_level(level)
        assert caught.value.field == field
        assert stage.digest() == digest
        stage.run(10)
        twin = Stage(Cloud, parameters={"births": 0.5})
        twin.run(40)
        assert stage.digest() == twin.digest()
        assert stage.recording.events == recording.events

    def test_back_to_the_defaults(self) -> None:
        stage = Stage(Cloud, level=Level(scene="cloud", parameters={"births": 1.0}))
        stage.load_level(None)
        assert stage.level is None
        assert stage.digest() == Stage(Cloud).digest()


class TestStepLength:
    def test_the_scene_the_caller_and_the_parameter(self) -> None:
        assert Stage(BouncingBall).dt == 1.0 / 120.0
        assert Stage(BouncingBall, dt=0.01).dt == 0.01
        assert Stage(Cloud).dt == 0.01
        stage = Stage(Cloud, dt=0.02)
        assert (stage.dt, stage.scene.step_length) == (0.02, 0.02)

    def test_the_clock_follows_the_parameter(self) -> None:
        stage = Stage(Cloud)
        assert stage.advance(0.1) in (9, 10)
        stage.post(SetParameter("step_length", 0.05))
        assert stage.clock.dt == stage.dt == 0.05
        before = stage.step_number
        stage.advance(0.1)
        assert stage.step_number - before in (2, 3)

    def test_the_clock_begins_with_each_session(self) -> None:
        stage = Stage(Cloud)
        stage.post(SetParameter("step_length", 0.05))
        for begin in (stage.reset, lambda: stage.load_level(Level(scene="cloud"))):
            stage.run(50)
            assert (stage.clock.steps, stage.clock.dt) == (stage.step_number, stage.dt)
            begin()
            assert stage.step_number == 0
            assert (stage.clock.steps, stage.clock.dt) == (0, stage.dt)
        assert stage.dt == 0.01  # as the level has it

    @pytest.mark.parametrize("speed", [0.25, 1.0, 4.0])
    def test_so_many_seconds_go_by_for_one_that_passes(self, speed: float) -> None:
        stage = Stage(BouncingBall)
        stage.speed = speed
        assert stage.advance(8.5 * stage.dt / speed) == 8

    def test_time_goes_on_from_where_it_was(self) -> None:
        stage = Stage(Cloud)
        stage.run(100)
        stage.post(SetParameter("step_length", 0.05))
        assert stage.time_s == 100 * 0.01
        stage.run(10)
        assert stage.time_s == 100 * 0.01 + 10 * 0.05
        for _ in range(20):
            stage.step_back()
        assert stage.time_s == 90 * 0.01
        assert stage.dt == 0.01

    def test_a_step_that_is_refused(self) -> None:
        with pytest.raises(ParameterError, match=r"step_length = 1\.0: outside 0\.0001 to 0\.1 s"):
            Stage(Cloud, dt=1.0)


class TestRunning:
    def test_progress(self) -> None:
        seen = []
        assert Stage(BouncingBall).run(1000, lambda done, total: seen.append((done, total))) == 1000
        assert len(seen) == 100
        assert seen[-1] == (1000, 1000)

    def test_the_last_portion_is_no_longer_than_what_is_left(self) -> None:
        stage, seen = Stage(BouncingBall), []
        assert stage.run(350, lambda done, total: seen.append(done)) == 350
        assert seen[-1] == stage.step_number == 350

    def test_progress_may_stop_it(self) -> None:
        stage = Stage(BouncingBall)
        assert stage.run(1000, lambda done, total: done < 300) == 300
        assert stage.step_number == 300

    @pytest.mark.parametrize("steps", [-1, 1.0, True, None])
    def test_steps_are_counted(self, steps) -> None:
        with pytest.raises(ValueError, match="steps = "):
            Stage(BouncingBall).run(steps)

    def test_one_run_is_many_steps(self) -> None:
        one, many = Stage(BouncingBall), Stage(BouncingBall)
        one.run(250)
        for _ in range(250):
            many.step()
        assert one.digest() == many.digest()
        assert one.recording == many.recording

    def test_the_cost_of_a_step_is_measured(self) -> None:
        stage = Stage(BouncingBall)
        assert math.isnan(stage.step_cost_s)
        stage.run(10)
        assert 0.0 < stage.step_cost_s < 1.0


class TestCharts:
    def test_a_run_ends_with_the_last_ten_seconds(self) -> None:
        stage = Stage(BouncingBall)
        stage.run(120 * 60)
        assert stage.series.times[0] == pytest.approx(50.0, abs=0.1)
        assert stage.series.times[-1] == pytest.approx(60.0, abs=0.02)
        assert np.diff(stage.series.times).max() < 0.03
        assert len(stage.series.values("energy")) == len(stage.series)

    @pytest.mark.parametrize("dt", [1.0 / 120.0, 1.0 / 60.0, 0.02, 0.05])
    def test_a_run_leaves_out_nothing_that_the_charts_can_show(self, dt: float) -> None:
        """The oldest sample is at the window's beginning or before, as where every step was sampled."""
        stage = Stage(BouncingBall, dt=dt)
        stage.run(round(60.0 / dt))
        series = stage.series
        assert series.times[0] <= stage.time_s - series.window_s + 1e-9
        assert series.times[-1] == pytest.approx(stage.time_s, abs=1.0 / series.rate_hz)

    def test_stepping_back_takes_samples_back(self) -> None:
        stage = Stage(BouncingBall)
        stage.run(100)
        for _ in range(50):
            stage.step_back()
        assert stage.series.times[-1] <= stage.time_s
        stage.run(50)
        assert (np.diff(stage.series.times) > 0.0).all()

    def test_reset_clears_them(self) -> None:
        stage = Stage(BouncingBall)
        stage.run(100)
        stage.reset()
        assert stage.series.times.tolist() == [0.0]


class TestEvents:
    @pytest.mark.parametrize(
        ("event", "message"),
        [
            (Pointer("down", math.nan, 0.0), "finite coordinates"),
            (Pointer("move", 0.0, math.inf), "finite coordinates"),
            (Pointer("wheel", 0.0, 0.0, wheel=math.nan), "finite coordinates"),
            (Pointer("poke", 0.0, 0.0), "'poke' is not one of move, down, up, wheel, cancel"),
            (Action("fly"), "fly: example has no such action"),
            (SetParameter("colour", 1.0), "no such parameter"),
            (SetParameter("gravity", 101.0), "gravity = 101.0: outside 0 to 100 m/s²"),
            (SetParameter("gravity", True), "expected a number"),
            (SetParameter("frozen", 1), "expected true or false"),
            (SetEffect("wind", True), "declares no such effect"),
            ("kick", "str is no stage event"),
            (Pointer("move", "left", 0.0), "pointer: expected numbers"),
            (Pointer("move", None, 0.0), "pointer: expected numbers"),
            (Pointer("move", 10**400, 0.0), "pointer: expected numbers"),
        ],
    )
    def test_what_is_refused_changes_nothing(self, event, message) -> None:
        stage = Stage(BouncingBall)
        stage.run(5)
        before = stage.digest(), dict(stage.scene.values), stage.scene.active
        with pytest.raises(ParameterError) as caught:
            stage.post(event)
        assert message in str(caught.value)
        assert (stage.digest(), stage.scene.values, stage.scene.active) == before
        assert stage.recording.events == []

    def test_effects_on_and_off(self) -> None:
        stage = Stage(BouncingBall)
        stage.post(SetEffect("test-ground", False))
        assert GROUND not in stage.scene.active
        stage.post(SetEffect("test-ground", True))
        assert GROUND in stage.scene.active

    def test_parameters_that_shape_the_scene_build_it_anew(self) -> None:
        stage = Stage(BouncingBall)
        stage.run(50)
        scene = stage.scene
        stage.post(SetEffect("test-ground", False))
        stage.post(SetParameter("height", 9.0))
        assert stage.scene is not scene
        assert stage.scene.state().position[1] == 9.0
        assert GROUND not in stage.scene.active
        assert stage.step_number == 50
        assert stage.scene.previous.position[1] == 9.0

    def test_numbers_of_any_kind_can_be_kept(self) -> None:
        stage = Stage(BouncingBall)
        stage.post(Pointer("down", np.float32(0.5), np.int64(1), np.int64(1)))
        stage.post(SetParameter("gravity", np.float32(0.1)))
        stage.run(20)
        recording = msgspec.json.decode(msgspec.json.encode(stage.recording), type=type(stage.recording))
        assert replay_scene(recording, BouncingBall).digest() == stage.digest()

    def test_events_are_stamped_with_the_steps_made(self) -> None:
        stage = Stage(BouncingBall)
        stage.post(KICK)
        stage.run(7)
        stage.post(KICK)
        assert [stamped.step for stamped in stage.recording.events] == [0, 7]


class TestCatalogue:
    row = Entry(
        "example", "X00", "Bouncing ball", "falls", "Tests", "tests.stage.example_scene", "BouncingBall"
    )

    def test_rows(self) -> None:
        other = self.row._replace(name="other", category="More")
        catalogue = Catalogue((self.row, other))
        assert len(catalogue) == 2
        assert [entry.name for entry in catalogue] == ["example", "other"]
        assert catalogue.categories() == ("Tests", "More")
        assert catalogue.neighbour("example", -1) is other
        assert catalogue["example"].load() is BouncingBall

    def test_an_unknown_name(self) -> None:
        with pytest.raises(KeyError, match="no scene is called x; there are example"):
            Catalogue((self.row,))["x"]

    @pytest.mark.parametrize("name", ["exampel", "Example ", "bouncing", "exam"])
    def test_a_name_that_is_nearly_right(self, name: str) -> None:
        with pytest.raises(KeyError, match=r"\(did you mean example\?\); there are example"):
            Catalogue((self.row,))[name]

    def test_two_of_one_name(self) -> None:
        with pytest.raises(ValueError, match="two scenes have one name"):
            Catalogue((self.row, self.row))

    def test_a_row_that_says_otherwise(self) -> None:
        with pytest.raises(ValueError, match=r"title is .Bouncing ball., in the catalogue .Something else."):
            self.row._replace(title="Something else").load()


def test_a_scene_says_what_it_cannot_restore() -> None:
    class Hidden(Fragile):
        def build(self, level):
            super().build(level)
            self.fields = [self.height, self.field]
            del self.field

        def state(self):
            height, field = self.fields
            return FragileState(height, field)

        def advance(self, dt):
            self.fields[1] = np.zeros((1, 1))

    stage = Stage(Hidden)
    stage.run(1)
    with pytest.raises(NotImplementedError, match=r"Hidden\.restore must set field"):
        stage.step_back()


@pytest.mark.parametrize("event", [KICK, SetParameter("gravity", 2.0)])
def test_what_is_changed_while_paused_is_sampled_at_once(event) -> None:
    stage = Stage(BouncingBall)
    stage.run(50)
    stage.pause()
    before = stage.series.values("energy")[-1]
    stage.post(event)
    energy = stage.readouts()[0].value
    assert stage.series.values("energy")[-1] == energy != before
    assert stage.series.times[-1] == stage.time_s

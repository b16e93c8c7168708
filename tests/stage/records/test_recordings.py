"""Recordings: kept, read back, replayed; whatever is wrong with a file is told in one line."""

from __future__ import annotations

import json
from pathlib import Path

import msgspec
import pytest

from game.levels import Level
from game.stage import (
    Catalogue,
    Entry,
    Pointer,
    Recording,
    RecordingError,
    SetEffect,
    SetParameter,
    Stage,
    replay,
    replay_scene,
)
from game.stage.records.recording import CHECK_INTERVAL
from tests.stage.example_scene import KICK, BouncingBall
from tests.stage.odd_scenes import BURST, Cloud, CloudContent, Fragile

CATALOGUE = Catalogue(
    (Entry("example", "X00", "Bouncing ball", "", "Tests", "tests.stage.example_scene", "BouncingBall"),)
)


def played() -> Stage:
    stage = Stage(BouncingBall, parameters={"gravity": 5.0}, effects_off=("test-ground",))
    stage.run(130)
    stage.post(SetEffect("test-ground", True))
    stage.post(KICK)
    stage.run(100)
    stage.post(Pointer("down", 0.1, 0.2, 1))
    stage.post(SetParameter("height", 3.0))
    stage.run(45)
    stage.post(KICK)
    return stage


def written(tmp_path: Path, change) -> Path:
    """A file of a recording in which ``change`` was made to the decoded JSON."""
    document = json.loads(msgspec.json.encode(played().recording))
    change(document)
    path = tmp_path / "broken.json"
    path.write_text(json.dumps(document))
    return path


class TestRoundTrip:
    def test_a_file_gives_back_the_same(self, tmp_path: Path) -> None:
        recording = played().recording
        recording.save(tmp_path / "deep" / "session.json")
        assert Recording.load(tmp_path / "deep" / "session.json") == recording

    def test_a_replay_comes_to_the_same_state(self) -> None:
        stage = played()
        again = replay(stage.recording, CATALOGUE)
        assert again.digest() == stage.digest()
        assert again.recording == stage.recording
        assert again.scene.values == stage.scene.values
        assert again.scene.active == stage.scene.active

    def test_digests_are_kept_on_the_way(self) -> None:
        assert [check.step for check in played().recording.checks] == [CHECK_INTERVAL, 2 * CHECK_INTERVAL]

    def test_a_digest_belongs_to_the_step_it_was_taken_at(self) -> None:
        stage = Stage(BouncingBall)
        stage.run(CHECK_INTERVAL)
        assert [check.step for check in stage.recording.checks] == [CHECK_INTERVAL]
        stage.step_back()
        assert stage.recording.checks == []

    def test_the_level_travels_in_it(self, tmp_path: Path) -> None:
        content = CloudContent(points=[(1.0 / 3.0, -2.5e-17), (1e100 * 1e-99, 5.0)], speed=0.1)
        level = Level(scene="cloud", title="Two", seed=12, parameters={"births": 0.25}, content=content)
        stage = Stage(Cloud, level=level, parameters={"first": 4}, seed=99)
        stage.post(SetParameter("step_length", 0.02))
        stage.run(200)
        stage.post(BURST)
        stage.post(SetParameter("first", 9))
        stage.run(20)
        stage.recording.save(tmp_path / "r.json")
        again = replay_scene(Recording.load(tmp_path / "r.json"), Cloud)
        assert again.digest() == stage.digest()
        assert again.level == level
        assert again.scene.seed == 99

    def test_effects_that_a_level_switches_off_may_be_on(self) -> None:
        level = Level(scene="example", effects_off=("test-ground",))
        stage = Stage(BouncingBall, level=level)
        assert "test-ground" not in stage.scene.active
        stage.post(SetEffect("test-ground", True))
        stage.reset()
        stage.run(100)
        assert replay_scene(stage.recording, BouncingBall).digest() == stage.digest()

    def test_a_step_length_of_the_caller(self) -> None:
        stage = Stage(BouncingBall, dt=0.02)
        stage.run(50)
        assert replay_scene(stage.recording, BouncingBall).dt == 0.02

    def test_reset_begins_a_new_one(self) -> None:
        stage = played()
        stage.reset()
        assert stage.recording.events == []
        assert stage.recording.steps == 0
        assert stage.recording.parameters["height"] == 3.0

    def test_what_was_not_recorded_cannot_be_had(self) -> None:
        stage = Stage(BouncingBall, record=False)
        with pytest.raises(RecordingError, match="not recorded"):
            stage.recording  # noqa: B018


class TestReplayGoesWrong:
    def test_another_digest_on_the_way(self) -> None:
        recording = played().recording
        wrong = msgspec.structs.replace(recording.checks[1], digest="0" * 32)
        recording = msgspec.structs.replace(recording, checks=[recording.checks[0], wrong])
        with pytest.raises(RecordingError, match="step 240: the replay went another way"):
            replay_scene(recording, BouncingBall)
        assert replay_scene(recording, BouncingBall, check=False).step_number == 275

    def test_another_digest_at_the_end(self) -> None:
        recording = msgspec.structs.replace(played().recording, digest="")
        with pytest.raises(RecordingError, match="step 275: the replay ended otherwise"):
            replay_scene(recording, BouncingBall)

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"scene": "nothing"}, "scene: no scene is called nothing"),
            ({"parameters": {"colour": 1.0}}, "colour: example has no such parameter"),
            ({"parameters": {"gravity": -1.0}}, "outside 0 to 100"),
            ({"effects_off": ["magic"]}, "declares no such effect"),
            ({"level": "scene = 'c01'"}, "level.scene: expected 'example', not 'c01'"),
            ({"level": "scene = "}, "level: not TOML"),
            ({"level": "scene = 'example'\n[content]\na = 1"}, "level.content: this scene has none"),
        ],
    )
    def test_what_the_scene_refuses(self, change, message) -> None:
        recording = msgspec.structs.replace(played().recording, **change)
        with pytest.raises(RecordingError) as caught:
            replay(recording, CATALOGUE)
        assert message in str(caught.value)
        assert "\n" not in str(caught.value)

    def test_a_scene_that_fails(self) -> None:
        stage = Stage(Fragile, parameters={"break_at": 60})
        stage.run(50)
        recording = msgspec.structs.replace(stage.recording, steps=100)
        with pytest.raises(RecordingError, match="step 60: height is not finite"):
            replay_scene(recording, Fragile)


BROKEN = {
    "events[1].step": lambda d: d["events"][1].update(step=5),
    "events[0].step": lambda d: d["events"][0].update(step=10_000),
    "events[2].event": lambda d: d["events"][2]["event"].update(type="mystery"),
    "events[0].event": lambda d: d["events"][0]["event"].update(more=1),
    "dt": lambda d: d.update(dt=0.0),
    "seed": lambda d: d.update(seed=-1),
    "steps": lambda d: d.update(steps=10**12),
    "format": lambda d: d.update(format=2),
    "content": lambda d: d.pop("scene"),
    "effects_off": lambda d: d.update(effects_off=["x"] * 100),
    "parameters[...]": lambda d: d.update(parameters={"gravity": None}),
}


class TestBrokenFiles:
    @pytest.mark.parametrize("field", list(BROKEN))
    def test_the_field_is_named(self, tmp_path: Path, field: str) -> None:
        path = written(tmp_path, BROKEN[field])
        with pytest.raises(RecordingError) as caught:
            Recording.load(path)
        assert caught.value.field.startswith(field)
        assert str(caught.value).startswith(f"{path}: {field}")
        assert "\n" not in str(caught.value)

    @pytest.mark.parametrize(
        "data", [b"", b"   \n", b"\xff\xfe\x00", b"{", b"[]", b"null", b"[" * 100_000, b"\x00" * 100]
    )
    def test_what_is_no_recording(self, tmp_path: Path, data: bytes) -> None:
        path = tmp_path / "bad.json"
        path.write_bytes(data)
        with pytest.raises(RecordingError) as caught:
            Recording.load(path)
        assert str(path) in str(caught.value)
        assert "\n" not in str(caught.value)

    def test_what_is_no_file(self, tmp_path: Path) -> None:
        for path in (tmp_path, tmp_path / "missing", tmp_path / "a" / "b"):
            with pytest.raises(RecordingError):
                Recording.load(path)

    def test_saving_where_nothing_can_be_written(self, tmp_path: Path) -> None:
        (tmp_path / "file").write_text("x")
        with pytest.raises(RecordingError, match="not written"):
            played().recording.save(tmp_path / "file" / "r.json")
        with pytest.raises(RecordingError, match="not written"):
            played().recording.save(tmp_path)

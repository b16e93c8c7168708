"""The real table: what is compared, whose tracks, and what the numbers beside the table are."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from game.app.commands import run_command_line
from game.billiards.fitting.tracks import load_tracks
from game.levels import level_files, load_level
from game.scenes import CATALOGUE
from game.stage import SetParameter, Stage
from game.stage.events import Action

RealTable = CATALOGUE["real-table"].load()


@pytest.fixture(scope="module")
def stage() -> Stage:
    return Stage(RealTable)


def readout(stage: Stage, name: str) -> float:
    return next(one.value for one in stage.scene.readouts() if one.name == name)


def test_the_model_that_made_the_tracks_explains_them(stage: Stage) -> None:
    models = stage.scene.model.compared.models
    assert list(models) == ["han", "stepped", "lecture", "mathavan", "stronge"]
    assert models["han"].rmse_cue < 0.003  # 1 mm of noise in x and y
    for name in ("mathavan", "stronge", "stepped", "lecture"):
        assert models[name].rmse_cue > 2.0 * models["han"].rmse_cue
        assert models[name].price_s > 0.0


def test_errors_are_those_of_the_samples(stage: Stage) -> None:
    shot = stage.scene.model.shot
    for played in stage.scene.model.compared.models.values():
        for ball, track in enumerate(shot.tracks):
            for k in (0, len(track.times) // 2, len(track.times) - 1):
                place = played.trajectory.state_at(track.times[k] - played.stroke.start).positions[ball]
                off = np.hypot(*(place - track.places[k]))
                assert played.errors[ball][k] == pytest.approx(off, abs=1e-12)
        assert played.rmse_cue == pytest.approx(np.sqrt(np.mean(played.errors[0] ** 2)))
        assert played.rmse_all == pytest.approx(np.sqrt(np.mean(np.concatenate(played.errors) ** 2)))


def test_a_wrong_cushion_is_seen_at_once_and_taken_back() -> None:
    stage = Stage(RealTable)
    before = stage.scene.model.compared.models["han"].rmse_cue
    stage.post(SetParameter("han_restitution", 0.75))
    stage.run(1)
    assert stage.scene.model.compared.models["han"].rmse_cue > 5.0 * before
    stage.post(SetParameter("han_restitution", 0.86))
    stage.run(1)
    assert stage.scene.model.compared.models["han"].rmse_cue == before


@pytest.mark.parametrize(
    ("name", "value", "changed"),
    [
        ("mathavan_restitution", 0.8, {"mathavan"}),
        ("mathavan_friction", 0.1, {"mathavan"}),
        ("stronge_restitution", 0.7, {"stronge"}),
        ("stronge_friction", 0.1, {"stronge"}),
        ("stronge_compliance", 3.0, {"stronge"}),
        ("stepped_step", 0.002, {"stepped"}),
        ("han_friction", 0.1, {"han", "mathavan", "stronge", "stepped", "lecture"}),
        ("rolling", 0.01, {"han", "mathavan", "stronge", "stepped", "lecture"}),
    ],
)
def test_each_number_is_that_of_its_model(stage: Stage, name: str, value: float, changed: set[str]) -> None:
    other = Stage(RealTable, parameters={name: value})
    before, after = stage.scene.model.compared.models, other.scene.model.compared.models
    different = {model for model in before if before[model].rmse_all != after[model].rmse_all}
    assert different == changed


def test_time_goes_along_the_track_and_begins_again() -> None:
    stage = Stage(RealTable)
    end = stage.scene.model.shot.end_time
    stage.run(round(2.0 / stage.scene.dt))
    assert readout(stage, "track") == pytest.approx(2.0, abs=0.02)
    track = stage.scene.model.shot.tracks[0]
    at = int(np.searchsorted(track.times, stage.scene.model.time, side="right")) - 1
    assert readout(stage, "han") == stage.scene.model.compared.models["han"].errors[0][at]
    stage.run(round((end + 1.0) / stage.scene.dt))
    assert readout(stage, "track") < 2.0


def test_the_next_shot_is_the_first_after_the_last() -> None:
    stage = Stage(RealTable)
    seen = []
    for _ in range(7):
        seen.append(stage.scene.model.shot.id)
        stage.post(Action("next"))
        stage.run(1)
    assert seen == ["1", "2", "3", "4", "5", "6", "1"]
    stage.post(SetParameter("shot", 4))
    stage.run(1)
    assert stage.scene.model.shot.id == "4"


def test_track_files_of_ones_own_are_opened(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    stage = Stage(RealTable)
    stage.post(Action("open"))
    stage.run(1)
    assert "no track files" in stage.scene.messages()[0]
    folder = tmp_path / "tracks"
    folder.mkdir()
    run_command_line(["tracks", str(folder / "mine.json"), "--shots", "1", "--seed", "8"])
    (folder / "wrong.json").write_text("{}")
    stage.post(Action("open"))
    stage.run(1)
    assert stage.scene.model.source.endswith("mine.json")
    mine = load_tracks(folder / "mine.json").shots[0].tracks[0].places
    np.testing.assert_array_equal(stage.scene.model.shot.tracks[0].places, mine)
    stage.post(Action("open"))
    stage.run(1)
    assert "wrong.json: shots: is missing" in stage.scene.messages()[0]
    assert stage.scene.model.source.endswith("mine.json")


def test_levels_say_that_their_tracks_are_made_and_with_what_noise() -> None:
    for path in level_files("real-table"):
        level = load_level(path, "real-table", RealTable.content_type)
        assert "made" in level.about.lower()
        assert f"{level.content.made.noise_mm:g} mm of noise" in level.about

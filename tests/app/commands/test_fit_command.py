"""``fit`` and ``tracks``: files in, files out, complaints in one line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from game.app.commands import run_command_line
from game.billiards.fitting import tables
from game.billiards.fitting.tracks import load_tracks

QUICK_ROUNDS = ((2, 1.0),)


@pytest.fixture
def tracks(tmp_path: Path) -> Path:
    path = tmp_path / "made.json"
    assert run_command_line(["tracks", str(path), "--shots", "3", "--noise", "0.5", "--seed", "2"]) == 0
    return path


def complaint(words: list[str], capsys: pytest.CaptureFixture[str]) -> str:
    assert run_command_line(words) == 2
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    return said


def test_made_tracks_say_what_they_are_and_repeat(tracks: Path, tmp_path: Path) -> None:
    file = load_tracks(tracks)
    assert [shot.id for shot in file.shots] == ["1", "2", "3"]
    data = json.loads(tracks.read_text())
    assert "noise of 0.5 mm" in data["note"]
    again = tmp_path / "again.json"
    run_command_line(["tracks", str(again), "--shots", "3", "--noise", "0.5", "--seed", "2"])
    assert again.read_bytes() == tracks.read_bytes()


def test_a_fit_says_table_shots_and_medians(
    tracks: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tables, "ROUNDS", QUICK_ROUNDS)
    results = []
    for name in ("one.json", "two.json"):
        assert run_command_line(["fit", str(tracks), "--json", str(tmp_path / name)]) == 0
        results.append((tmp_path / name).read_bytes())
    assert results[0] == results[1]
    said = capsys.readouterr().out
    assert f"table found with 2 shots: every second shot of {tracks}" in said
    assert "held-out shots (1): median rmse " in said
    data = json.loads(results[0])
    assert [shot["id"] for shot in data["shots"]] == ["1", "2", "3"]
    assert [shot["held_out"] for shot in data["shots"]] == [False, True, False]
    assert data["table"]["models"] == {"ball_ball": "wallace-1988", "cushion": "han-2005"}
    for shot in data["shots"]:
        assert 0.0 < shot["rmse_cue_m"] < 0.2
        assert set(shot["stroke"]) == {"azimuth", "speed", "tip_left", "tip_up", "start", "cue_speed"}


def test_shots_trained_with_another_file_are_all_held_out(
    tracks: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tables, "ROUNDS", QUICK_ROUNDS)
    words = ["fit", str(tracks), "--train", str(tracks), "--json", "-", "--fix", "rolling=0.005"]
    assert run_command_line(words) == 0
    data = json.loads(capsys.readouterr().out)
    assert all(shot["held_out"] for shot in data["shots"])
    assert data["table"]["rolling"] == 0.005


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--cushion", "rubber"], "--cushion rubber: expected one of mirror, "),
        (["--balls", "soft"], "--balls soft: expected one of elastic, "),
        (["--fix", "rolling"], "--fix rolling: expected a number"),
        (["--fix", "weight=1"], "--fix weight=1: expected K=V with K one of sliding, "),
        (["--fix", "rolling=-1"], "--fix: friction.rolling: must be 0, or between"),
        (["--train", "nowhere.json"], "nowhere.json: no such file"),
        (["--json", "no/such/folder.json"], "--json no/such/folder.json: there is no folder"),
    ],
)
def test_what_is_wrong_is_said_in_one_line(
    words: list[str], said: str, tracks: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said in complaint(["fit", str(tracks), *words], capsys)


def test_a_wrong_file_is_named_with_field_and_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "wrong.json"
    path.write_text(
        '{"shots": [{"id": 1, "balls": {"0": {"t": [0, 2, 1], "x": [1, 1, 1], "y": [1, 1, 1]}}}]}'
    )
    assert "wrong.json: shots[0].balls.0.t[2]: times must not fall" in complaint(["fit", str(path)], capsys)


def test_a_training_file_of_another_table_is_refused(
    tracks: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    data = json.loads(tracks.read_text())
    data["table"]["length"] = 3.0
    other = tmp_path / "other.json"
    other.write_text(json.dumps(data))
    said = complaint(["fit", str(tracks), "--train", str(other)], capsys)
    assert "other.json: table: not the one of" in said


@pytest.mark.parametrize("words", [["--shots", "0"], ["--shots", "1.5"], ["--noise", "-1"], ["--noise", "x"]])
def test_tracks_that_cannot_be_made(
    words: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert f"{words[0]} {words[1]}: expected a" in complaint(["tracks", str(tmp_path / "a"), *words], capsys)

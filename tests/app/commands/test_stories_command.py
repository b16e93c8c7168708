"""Stories on the command line: listed, run and checked, filmed; mistakes are one line and status 2."""

from __future__ import annotations

import json

import pytest

import game.scenes
from game.app.commands import run_command_line
from game.stage.story.rehearsal import rehearse
from tests.app.scene.test_story_window import STORIES
from tests.stage.story.bouncing import TEXT, StoryBall, story


@pytest.fixture(autouse=True)
def story_scenes(monkeypatch, tmp_path):
    """A catalogue of the scene with the story; a cache of its own."""
    monkeypatch.setattr(game.scenes, "CATALOGUE", STORIES)
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path / "cache"))
    monkeypatch.setenv("CAROM_HOME", str(tmp_path / "home"))


def test_stories_are_listed_with_length_and_chapters(capsys):
    assert run_command_line(["stories"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].split() == ["story-ball", "story", lines[0].split()[2], "A", "ball"]
    assert [line.split(maxsplit=1)[1] for line in lines[1:]] == ["Beginning", "Three bounces", "Five"]
    assert run_command_line(["stories", "story-ball", "--json", "-"]) == 0
    row = json.loads(capsys.readouterr().out)["stories"][0]
    found = rehearse(story(), StoryBall)
    assert (row["name"], row["film_s"], row["failures"]) == ("story", found.film_s, [])
    assert [one["film_s"] for one in row["chapters"]] == [one.film_s for one in found.chapters]


def test_a_rehearsal_is_kept(capsys, monkeypatch):
    assert run_command_line(["stories"]) == 0
    first = capsys.readouterr().out
    monkeypatch.setattr("game.app.stagehand.stories.rehearse", None)
    assert run_command_line(["stories"]) == 0
    assert capsys.readouterr().out == first


def test_a_story_is_run_and_measured(capsys):
    assert run_command_line(["run", "story-ball", "--story", "--json", "-"]) == 0
    told = json.loads(capsys.readouterr().out)
    found = rehearse(story(), StoryBall)
    assert told["digest"] == told["story"]["digest"] == found.digest
    assert [one["name"] for one in told["story"]["moments"]] == ["three", "five"]
    assert told["story"]["expectations"][0]["value"] == 5.0
    assert told["story"]["failures"] == []


def test_an_expectation_that_fails_is_status_2_and_one_line(capsys, tmp_path):
    path = tmp_path / "story-odd.toml"
    path.write_text(TEXT.replace("least = 5.0", "least = 6.0"), encoding="utf-8")
    out = tmp_path / "a.json"
    assert run_command_line(["run", "story-ball", "--story", str(path), "--json", str(out)]) == 2
    words = capsys.readouterr().err
    assert words.count("\n") == 1 and "bounces is 5 at 'five'; expected at least 6" in words
    assert json.loads(out.read_text())["story"]["failures"]


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["run", "story-ball", "--story", "none"], "no such story; it has story"),
        (["run", "story-ball", "--story", "--set", "gravity=1"], "--set: goes not with --story"),
        (["run", "story-ball", "--story", "gone.toml"], "gone.toml"),
        (["record", "story-ball", "--story", "--out", "a.mp4", "--from", "100"], "the story has ended"),
        (["record", "story-ball", "--from", "3", "--out", "a.mp4"], "go only with --story"),
        (["run", "story-ball", "--quality", "film"], "--quality: goes only with --story"),
        (["run", "story-ball", "--story", "--quality", "best"], "quality"),
        (["play", "story-ball", "--story", "none"], "no such story"),
        (["stories", "nobody"], "no scene is called nobody"),
    ],
)
def test_mistakes_are_one_line(words, reason, capsys, tmp_path, monkeypatch):
    pytest.importorskip("av")
    monkeypatch.chdir(tmp_path)
    assert run_command_line(words) in (1, 2)
    told = capsys.readouterr().err
    assert reason in told and told.count("\n") == 1


def test_a_story_is_run_at_a_quality(capsys):
    assert run_command_line(["run", "story-ball", "--story", "--quality", "film", "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["parameters"]["quality"] == "film"


def test_a_story_is_filmed(capsys, tmp_path):
    pytest.importorskip("av")
    out = tmp_path / "a.mp4"
    words = ["record", "story-ball", "--story", "--out", str(out), "--size", "160x90", "--fps", "5"]
    assert run_command_line([*words, "--seconds", "2"]) == 0
    assert "2.0 s, 10 pictures" in capsys.readouterr().out
    assert sorted(path.name for path in tmp_path.glob("a.*")) == ["a.mp4", "a.png", "a.srt"]

"""``open`` on the command line: a text is checked without a window, and told in one line what is wrong."""

from __future__ import annotations

import io
import json
import sys
from pathlib import Path

import pytest

from game.stage import Stage
from game.stage.records.run_text import text_of
from tests.app.commands.test_commands import run
from tests.stage.example_scene import KICK, BouncingBall


@pytest.fixture
def text() -> str:
    stage = Stage(BouncingBall)
    stage.run(20)
    stage.post(KICK)
    stage.run(40)
    return text_of(stage.recording)


def test_a_text_is_checked_without_a_window(capsys, tmp_path: Path, text: str):
    status, out, err = run(capsys, "open", text, "--json", "-")
    assert (status, err) == (0, "")
    report = json.loads(out)
    assert report["same"] is True and report["steps"] == 60 and report["digest"] == text.split(".")[2]


def test_a_text_comes_in_by_the_standard_input_as_well(capsys, monkeypatch, text: str):
    monkeypatch.setattr(sys, "stdin", io.StringIO(f"> {text[:50]}\n> {text[50:]}\n"))
    assert run(capsys, "open", "-", "--json", "-")[0] == 0


@pytest.mark.parametrize("command", [("open", "--json", "-"), ("replay", "--json", "-"), ("open",)])
@pytest.mark.parametrize(
    ("change", "why"),
    [(lambda text: text[:-9], "damaged"), (lambda text: text.replace("carom1", "carom7"), "format 7"),
     (lambda text: text.replace(".example.", ".elsewhere."), "elsewhere")],
)  # fmt: skip
def test_a_mistake_is_one_line(capsys, text: str, command: tuple[str, ...], change, why: str):
    status, out, err = run(capsys, command[0], change(text), *command[1:])
    assert (status, out) == (2, "") and err.count("\n") == 1 and why in err and len(err) < 600


def test_a_wrong_digest_does_not_pass(capsys, text: str):
    wrong = text.replace(text.split(".")[2], "0" * 32)
    status, _, err = run(capsys, "open", wrong, "--json", "-")
    assert status == 2 and "digests differ" in err and err.count("\n") == 1


def test_a_recording_becomes_a_text_and_back(capsys, tmp_path: Path):
    file = str(tmp_path / "s.json")
    run(capsys, "run", "example", "--seconds", "1", "--record", file)
    status, out, err = run(capsys, "replay", file, "--text", "-")
    assert (status, err) == (0, "") and out.startswith("carom1.example.") and out.count("\n") == 1
    assert json.loads(run(capsys, "open", out, "--json", "-")[1])["steps"] == 120


def test_without_a_display_it_says_what_else_there_is(capsys, monkeypatch, text: str):
    monkeypatch.setattr("game.app.commands.play.display_missing", lambda: "none is set")
    status, _, err = run(capsys, "open", text)
    assert status == 2 and err == "carom: no display: none is set; open --json checks it without a window\n"

"""The command ``match``: what it prints and writes, and what it refuses."""

from __future__ import annotations

import json
from pathlib import Path

from game.app.commands import run_command_line
from game.billiards.players.match import check_match_data


def test_a_match_is_written_and_told(capsys, tmp_path: Path):
    file = tmp_path / "log.json"
    assert run_command_line(["match", "--seed", "2", "--json", str(file), "--title", "Final"]) == 0
    out = capsys.readouterr().out.splitlines()
    data = json.loads(file.read_text())
    check_match_data(data)
    assert (data["title"], data["seed"], len(data["rounds"])) == ("Final", 2, 15)
    seen = {
        "lower-left": "upper left",
        "lower-right": "lower left",
        "middle-left": "upper middle",
        "middle-right": "lower middle",
        "upper-left": "upper right",
        "upper-right": "lower right",
    }
    for line, one in zip(out, data["rounds"], strict=False):
        assert f" {seen[one['pocket']]} pocket, " in line, "as in the film, whose picture is turned"
    assert len(out) == 16 and out[0].startswith("round  1  cue ball - ") and out[-1].startswith("15 rounds")
    first = tmp_path / "shot.json"
    first.write_text(json.dumps(data["rounds"][0]["shot"]))
    assert run_command_line(["shot", str(first), "--json", "-"]) == 0
    assert json.loads(capsys.readouterr().out)["final"][data["rounds"][0]["ball"]] == "pocketed"


def test_mistakes_are_one_line(capsys, tmp_path: Path):
    for arguments in (
        ["--seed", "x"],
        ["--seed", "-1"],
        ["--title", "x" * 200],
        ["--json", str(tmp_path / "no" / "x.json")],
    ):
        assert run_command_line(["match", *arguments]) == 2
        assert capsys.readouterr().err.count("\n") == 1

"""``precompile``: machine code for a generic processor, in a file that another process then takes it from."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from game.app.commands import precompile
from game.app.commands.precompile import Turn, compile_all
from game.app.window.mistake import MistakeError
from game.compiler.prebuilt import unpack
from game.scenes import CATALOGUE
from tests.app.commands.test_commands import run
from tests.paths import ROOT

SCENE = "lecture-balls"


@pytest.fixture(autouse=True)
def real_scenes(monkeypatch: pytest.MonkeyPatch, examples: None) -> None:
    """The process that compiles knows only these."""
    monkeypatch.setattr("game.scenes.CATALOGUE", CATALOGUE)


def test_what_was_packed_opens_a_scene_elsewhere_without_the_compiler(capsys, tmp_path: Path):
    file = tmp_path / "some.kernels"
    status, out, err = run(capsys, "precompile", SCENE, "--out", str(file), "--processes", "1")
    assert (status, err) == (0, "")
    made = unpack(file.read_bytes())
    assert made.scenes == {SCENE} and f"{len(made)} kernels of 1 scenes" in out
    assert file.stat().st_mode & 0o777 == 0o644
    environment = {
        **os.environ,
        "CAROM_PREBUILT": str(file),
        "CAROM_CACHE_DIR": str(tmp_path / "empty"),
        "NUMBA_DISABLE_JIT": "0",
    }
    command = [sys.executable, "-m", "game.app.compile.collecting", SCENE]
    done = subprocess.run(command, env=environment, cwd=ROOT, capture_output=True, text=True, timeout=900)
    scene, whole = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    assert scene == {"scene": SCENE, "opened": True, "trouble": [], "compiled": 0}
    assert whole == {"used": [], "compiled": 0}
    assert not (tmp_path / "empty" / "kernels").exists()


def test_it_says_whether_code_is_taken(capsys, monkeypatch):
    monkeypatch.setenv("CAROM_PREBUILT", "0")
    assert run(capsys, "precompile") == (1, "no machine code is taken: none came with this Carom\n", "")


def test_turns_end_when_one_compiles_nothing(monkeypatch, capsys):
    turns = [Turn([Path(str(n))], [SCENE], n) for n in (7, 2, 0, 5)]
    monkeypatch.setattr(precompile, "_turn", lambda names, processes: turns.pop(0))
    assert compile_all([SCENE], 1) == Turn([Path("0")], [SCENE], 0)
    assert len(turns) == 1


def test_without_a_cache_folder_it_gives_up(monkeypatch, capsys):
    monkeypatch.setattr(precompile, "_turn", lambda names, processes: Turn([], [], 1))
    with pytest.raises(MistakeError, match="is there a cache folder to write to"):
        compile_all([SCENE], 1)


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (("no-such-scene", "--out", "FILE"), "no-such-scene"),
        (("--out", "FILE", "--processes", "0"), "--processes 0: expected a whole number from 1 to 64"),
        (("--out", "no/such/folder/x"), "--out no/such/folder/x: there is no folder"),
    ],
)
def test_a_mistake_is_told_in_one_line(capsys, tmp_path: Path, arguments, complaint: str):
    words = [str(tmp_path / "x") if word == "FILE" else word for word in arguments]
    status, out, err = run(capsys, "precompile", *words)
    assert status == 2 and out == "" and err.count("\n") == 1
    assert complaint in err


def test_an_installed_carom_makes_no_wheel(capsys, tmp_path: Path, monkeypatch):
    monkeypatch.setattr("game.compiler.prebuilt.PACKAGE", tmp_path / "game")
    status, _, err = run(capsys, "precompile", SCENE, "--wheel", str(tmp_path))
    assert status == 2 and err == (
        "carom: --wheel: wheels are made in a checkout, and this Carom is an installed one\n"
    )

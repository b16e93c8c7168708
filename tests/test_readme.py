"""What the README shows must run."""

import re
from pathlib import Path

import pytest

README = Path(__file__).resolve().parents[1] / "README.md"
TEXT = README.read_text(encoding="utf-8")
PROGRAMS = [
    block for block in re.findall(r"```python\n(.*?)```", TEXT, re.S) if not block.startswith("class ")
]
PRINTED = ("events in", "cm high", "into pocket", "pairs, near a corner", "Verlet order 2")


@pytest.mark.parametrize(("program", "printed"), list(zip(PROGRAMS, PRINTED, strict=True)))
def test_programs_run(program, printed, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    exec(compile(program, "README.md", "exec"), {})
    assert printed in capsys.readouterr().out


def test_pictures_are_there():
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", TEXT)
    assert pictures and all((README.parent / picture).is_file() for picture in pictures)


def test_both_commands_are_one_line_each():
    for mark in ("play", "test"):
        fence = re.search(rf"<!-- {mark} -->\n```\n(.*?)```", TEXT, re.S)
        assert fence is not None and len(fence.group(1).strip().splitlines()) == 1


def test_every_scene_is_named():
    from game.scenes import CATALOGUE

    assert [entry.name for entry in CATALOGUE if f"`{entry.name}`" not in TEXT] == []

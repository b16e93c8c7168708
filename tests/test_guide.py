"""What the guide and the README show must run, one program after the other."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from game.physics import effects

ROOT = Path(__file__).resolve().parents[1]
GUIDE = (ROOT / "assets" / "GUIDE.md").read_text(encoding="utf-8")


@pytest.fixture
def no_trace(monkeypatch: pytest.MonkeyPatch):
    """Effects declared by the guide are forgotten again."""
    monkeypatch.setattr(effects, "_by_name", dict(effects._by_name))


def programs(heading: str) -> str:
    """All code of a section, in order."""
    section = re.search(rf"^## {heading}\n(.*?)(?=^## |\Z)", GUIDE, re.S | re.M)
    assert section is not None
    return "\n".join(re.findall(r"```python\n(.*?)```", section.group(1), re.S))


def run(heading: str) -> dict:
    names: dict = {"__name__": "guide"}
    exec(compile(programs(heading), "GUIDE.md", "exec", dont_inherit=True), names)
    return names


def test_a_scene(capsys):
    names = run("Add a scene")
    assert "240 steps, digest" in capsys.readouterr().out
    stage = names["stage"]
    before = stage.digest()
    assert stage.step_back()
    stage.step()
    assert stage.digest() == before


def test_an_effect(capsys, no_trace):
    run("Add an effect")
    assert capsys.readouterr().out.strip() == "[0.05 0.05 0.05]"


def test_an_integrator(capsys):
    run("Add an integrator")
    for line in capsys.readouterr().out.splitlines():
        measured, expected = map(float, re.findall(r"[\d.]+", line.split(": ")[1]))
        assert measured == pytest.approx(expected, abs=0.25), line


def test_files_it_names_are_there():
    for name in re.findall(r"`((?:game|tests|levels)/[\w/.]+)`", GUIDE):
        assert "NAME" in name or (ROOT / name).exists(), name

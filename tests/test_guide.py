"""What the guide and the README show must run, one program after the other."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from game.billiards.laws.contacts import CUSHION_MODELS
from game.levels import parse_level
from game.physics import effects
from game.scenes import CATALOGUE
from game.stage import ParameterError, SetParameter, Stage
from game.stage.script.course import LEAST_S
from game.stage.script.lines import VERBS
from game.ui.canvas.canvas import Canvas
from game.ui.look.theme import DARK

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
    said = capsys.readouterr().out
    assert "240 steps, digest" in said and "1.592 turns" in said
    assert names["PENDULUM"].names == ("pendulum", "X01", "Pendulum")
    stage = names["stage"]
    before = stage.digest()
    assert stage.step_back()
    stage.step()
    assert stage.digest() == before


def test_a_scene_of_the_guide_keeps_the_law_of_the_floors():
    from tests.test_floors import blas_calls, libm_calls

    tree = ast.parse(programs("Add a scene"))
    assert [*libm_calls(tree), *blas_calls(tree)] == []


def test_a_task():
    section = re.search(r"^## Write a task\n.*?```toml\n(.*?)```", GUIDE, re.S | re.M)
    assert section is not None
    level = parse_level(section.group(1), "bouncing-ball", None)
    stage = Stage(CATALOGUE["bouncing-ball"].load(), level=level)
    assert level.teaching is not None and len(level.teaching.questions) == 3
    with pytest.raises(ParameterError, match="locked"):
        stage.post(SetParameter("restitution", 0.1))


def test_a_story(capsys):
    names = run("Write a story")
    said = capsys.readouterr().out
    assert said.startswith("[] ['The lowest point'] ")
    assert names["found"].film_s == pytest.approx(2.0 + LEAST_S + 1.5 + 2.0, abs=0.1)  # title, say, do, end
    assert names["found"].ended


def test_verbs_of_a_story_it_names_are_all():
    section = GUIDE[GUIDE.index("## Write a story") : GUIDE.index("## Add an effect")]
    rows = re.findall(r"^\| (`[^|]+) \|", section, re.M)
    named = [verb for row in rows for verb in re.findall(r"`(\w+)`", row)]
    assert sorted(named) == sorted([*VERBS, "expect"])


def test_an_effect(capsys, no_trace):
    run("Add an effect")
    assert capsys.readouterr().out.strip() == "[0.05 0.05 0.05]"


def test_a_contact_model(capsys):
    run("Add a contact model")
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == len(CUSHION_MODELS)
    assert all(float(line.split()[-2]) > 1.0 for line in lines)


def test_levels_it_shows_are_read():
    lesson = GUIDE.index("## Write a task")
    (text,) = re.findall(r"```toml\n(.*?)```", GUIDE[:lesson], re.S)
    level = parse_level(text.replace("[content]", "# [content]"), "pendulum", None)
    assert (level.seed, level.parameters, level.effects_off) == (7, {"start": 3.0}, ("gravity",))
    assert CATALOGUE["pendulum"].load()(level).active.names == ()


def test_verbs_and_colours_it_names_are_there():
    table = GUIDE[GUIDE.index("### The canvas") : GUIDE.index("### Into the program")]
    for verb in re.findall(r"`([a-z_]+)\(", table):
        assert callable(getattr(Canvas, verb)), verb
    for color in re.findall(r"`([a-z]+\d?)`", table.split("| verb")[0]):
        assert color == "unit" or hasattr(DARK, color), color


def test_an_integrator(capsys):
    run("Add an integrator")
    for line in capsys.readouterr().out.splitlines():
        measured, expected = map(float, re.findall(r"[\d.]+", line.split(": ")[1]))
        assert measured == pytest.approx(expected, abs=0.25), line


def test_files_it_names_are_there():
    for name in re.findall(r"`((?:game|tests|levels)/[\w/.]+)`", GUIDE):
        assert "NAME" in name or (ROOT / name).exists(), name

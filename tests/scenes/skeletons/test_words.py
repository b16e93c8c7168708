"""What the skeleton scenes say: hints of the tool in the hand, the next click, why a solver stops short."""

from __future__ import annotations

import pytest

from game.app.fuzz.driver import Driver
from game.levels import parse_level
from game.scenes import CATALOGUE
from game.scenes.skeletons.editing import PARENT, next_click
from game.scenes.skeletons.inverse_kinematics import InverseKinematics
from game.scenes.skeletons.level import FigureContent
from game.scenes.skeletons.parameters import SHOWN
from game.scenes.skeletons.skinning import Skinning
from game.stage import Action, SetEffect, SetParameter, Stage
from game.ui.look.numerals import quantity
from tests.scenes.particle_stages import click, open_level

ELBOW = """scene = "c03"
[parameters]
motion = false
compare = false
[content]
bones = [
  { name = "upper", length = 0.5, limits = [-180.0, 180.0] },
  { name = "lower", parent = "upper", length = 0.5, angle = 5.0, limits = [-5.0, 5.0] },
]
chain = { start = "upper", end = "lower", target = [%s] }
"""


def elbow(target):
    stage = Stage(InverseKinematics, level=parse_level(ELBOW % target, "c03", FigureContent))
    stage.run(200)
    return stage


def hindrances(stage):
    return [stage.scene.model.hindrance(k) for k in range(len(SHOWN))]


def test_a_solver_at_a_limit_says_so_until_the_limits_are_off():
    stage = elbow("0.4, 0.3")
    assert hindrances(stage) == ["stuck at a limit"] * 6
    stage.post(SetEffect("joint-limits", False))
    stage.run(300)
    assert hindrances(stage) == [""] * 6


def test_a_target_out_of_reach_is_called_so():
    assert hindrances(elbow("0.9, 0.9")) == ["out of reach"] * 6
    assert hindrances(elbow("0.985, 0.17")) == [""] * 6


def test_a_solver_on_its_way_is_not_stuck():
    stage = open_level(InverseKinematics, "default")
    for _ in range(12):
        stage.run(10)
        assert "stuck at a limit" not in [
            words for k, words in enumerate(hindrances(stage)) if stage.scene.model.measured[k].error < 1e-3
        ]


def test_each_tool_names_the_next_click():
    stage = open_level(Skinning, "bent-bar", motion=False)
    scene = stage.scene

    def words():
        return next_click(scene.model.bench, scene.parameters.tool)

    assert words() == ""
    stage.post(Action("bone"))
    assert words() == PARENT
    skeleton = scene.model.rig.skeleton
    click(stage, 0.5 * (skeleton.bases[1] + skeleton.ends[1]))
    assert words() == "click where the new bone ends"
    stage.post(Action("skin"))
    said = []
    for corner in ((-1.1, -0.3), (1.1, -0.3), (1.1, 0.3)):
        said.append(words())
        click(stage, corner)
    assert said == ["click the first corner", "click the next corner", "click the next corner"]
    assert "Enter closes" in words()


def test_both_ends_of_a_chain_are_asked_for():
    stage = open_level(InverseKinematics, "default", motion=False, compare=False, tool="chain")
    scene = stage.scene
    assert next_click(scene.model.bench, "chain") == "click one end of the chain"
    bench = scene.model.bench.__class__(scene.model.bench.figure, picked=2)
    assert next_click(bench, "chain") == "click its other end"


@pytest.mark.parametrize("scene_type", [Skinning, InverseKinematics])
def test_hints_are_those_of_the_tool(scene_type):
    stage = Stage(scene_type)
    usual = stage.scene.hints_now()
    assert usual == scene_type.hints
    stage.post(SetParameter("tool", "skin"))
    assert [hint.keys for hint in stage.scene.hints_now()[:2]] == [("Click",), ("Enter",)]
    for tool in stage.scene.parameters.tools:
        stage.post(SetParameter("tool", tool))
        assert stage.scene.hints_now()
    stage.post(SetParameter("tool", stage.scene.parameters.tools[0]))
    assert stage.scene.hints_now() == usual


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    made = Driver(tmp_path, (1280, 720), CATALOGUE)
    made.open("c03")
    yield made
    made.close()


def test_bar_and_figures_show_one_error(driver):
    shell, scene = driver.top.shell, driver.stage.scene
    for _ in range(30):
        driver.frames(7)
        _, error, unit = shell.bar.state.readouts[1]
        shown = scene.view.words[scene.parameters.master].error
        assert shown == " ".join(quantity(error, unit))


def test_the_hint_bar_follows_the_tool(driver):
    driver.top.play.post(SetParameter("tool", "skin"))
    driver.frames(30)
    assert (("Enter",), "close the skin") in driver.top.shell.hints.hints

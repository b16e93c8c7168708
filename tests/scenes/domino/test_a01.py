"""World of Domino: what is measured, what a hand does, what is heard, what is kept."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

from game.levels import format_level, level_files, load_level, parse_level
from game.physics.effects import EffectSet
from game.scenes.domino.course import Standing
from game.scenes.domino.dominoes import STRUCK_ANGLE
from game.scenes.domino.level import DominoContent
from game.scenes.domino.scene import Domino
from game.stage import Action, ParameterError, Pointer, SetEffect, SetParameter, Stage
from tests.scenes.listening import heard_in

LEVELS = {path.stem: path for path in level_files("a01")}
ROW = """
scene = "a01"
{more}
[content]
pushed_at = 0.1
[[content.floors]]
start = [-10.0, 0.0]
pieces = [{{ run = 60.0 }}]
[[content.rows]]
x = 0.0
count = {count}
"""


def open_level(name: str, **parameters: Any) -> Stage:
    return Stage(Domino, level=load_level(LEVELS[name], "a01", DominoContent), parameters=parameters)


def row_of(count: int, more: str = "", **parameters: Any) -> Stage:
    level = parse_level(ROW.format(count=count, more=more), "a01", DominoContent)
    return Stage(Domino, level=level, parameters=parameters)


def read(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.scene.readouts()}


def click(stage: Stage, x: float, y: float, button: int = 1, shift: bool = False) -> None:
    stage.post(Pointer("down", x, y, button, shift=shift))
    stage.post(Pointer("up", x, y, button))


@pytest.mark.parametrize("spin", [0.7, -1.9])
def test_a_domino_that_turns_evenly_has_left_its_place_at_the_angle_over_the_rate(spin: float) -> None:
    """Between two steps: linear interpolation is exact for it."""
    stage = row_of(2, "")
    model = stage.scene.model
    model.world.set(effects=EffectSet([]))
    model.world.set_velocity(int(model.dominoes.table.body[1]), (0.0, 0.0), spin)
    for _ in range(8):
        model.advance(0.01)
    assert model.dominoes.table.struck[1] == pytest.approx(STRUCK_ANGLE / abs(spin), rel=1e-6)
    assert model.dominoes.table.struck[0] < 0.0


def drag(stage: Stage, start: tuple[float, float], end: tuple[float, float]) -> None:
    stage.post(Pointer("down", *start, 1))
    stage.post(Pointer("move", *end, 1))
    stage.post(Pointer("up", *end, 1))


# -- the wave ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(("gap", "within"), [(0.2, 0.07), (0.3, 0.03), (0.5, 0.03), (0.7, 0.03)])
def test_the_wave_is_as_fast_as_the_theory(gap: float, within: float) -> None:
    stage = row_of(44, spacing=gap, tier="teach")
    for _ in range(80):
        stage.run(10)
        if read(stage)["struck"] == 44:
            break
    found = read(stage)
    assert found["struck"] == 44
    assert found["wave speed"] == pytest.approx(found["theory"], rel=within)
    assert found["wave error"] == pytest.approx(100.0 * abs(found["wave speed"] / found["theory"] - 1.0))


def test_taller_gravity_makes_it_faster() -> None:
    """As the square root of it."""
    speeds = []
    for gravity in (9.81, 4.0 * 9.81 / 1.5):
        stage = row_of(44, spacing=0.4, gravity=gravity)
        stage.run(500)
        speeds.append(read(stage)["wave speed"])
    assert speeds[1] / speeds[0] == pytest.approx(math.sqrt(4.0 / 1.5), rel=0.03)


def test_friction_between_dominoes_slows_it() -> None:
    speeds = []
    for friction in (0.1, 0.4):
        stage = row_of(44, spacing=0.4, friction=friction)
        stage.run(600)
        speeds.append(read(stage)["wave speed"])
    assert speeds[1] < 0.85 * speeds[0]


def test_a_changed_gap_in_the_row_is_not_measured() -> None:
    stage = row_of(30)
    drag(stage, (0.46 * 20, 0.5), (0.46 * 20 + 0.05, 0.5))
    stage.run(480)
    found = read(stage)
    assert found["struck"] == 30
    assert math.isnan(found["wave speed"])


def test_who_has_not_been_struck_sleeps() -> None:
    stage = row_of(60)
    stage.run(3)
    stage = open_level("default")
    stage.run(60)
    assert read(stage)["awake"] == 0
    stage.post(Action("push"))
    stage.run(120)
    found = read(stage)
    assert 10 < found["struck"] == found["awake"] < 30


# -- the hand ---------------------------------------------------------------------------------------


def test_a_click_pushes_and_shift_pushes_back() -> None:
    for shift, struck in ((False, range(10, 20)), (True, range(10, -1, -1))):
        stage = open_level("default")
        stage.run(60)
        click(stage, 2.0 + 0.46 * 10, 18.5, shift=shift)
        stage.run(180)
        times = stage.scene.model.dominoes.table.struck
        order = [times[k] for k in struck]
        assert all(a < b for a, b in itertools.pairwise(order[:7]))
        assert min(order[:6]) > 0.0
        assert (times[:10] >= 0.0).any() == shift


def test_one_that_is_taken_away_stops_the_wave() -> None:
    stage = row_of(20, spacing=0.6)
    click(stage, 0.76 * 8, 0.5, button=3)
    stage.run(480)
    found = read(stage)
    assert found["dominoes"] == 19
    assert found["struck"] == 8


def test_one_that_is_added_closes_the_gap() -> None:
    stage = row_of(20, spacing=0.6, tool="add")
    click(stage, 0.76 * 8, 0.5, button=3)
    click(stage, 0.76 * 8, 1.3)
    stage.run(480)
    found = read(stage)
    assert found["dominoes"] == found["struck"] == 20


def test_a_drag_stands_one_elsewhere_and_up_again() -> None:
    stage = row_of(8)
    stage.run(400)
    stage.post(SetParameter("tool", "drag"))
    model = stage.scene.model
    body = int(model.dominoes.table.body[7])
    drag(stage, tuple(model.world.bodies.positions[body].tolist()), (20.0, 0.4))
    stage.run(60)
    assert model.world.bodies.positions[body].tolist() == pytest.approx([20.0, 0.5], abs=1e-2)
    assert float(model.world.bodies.angles[body]) == pytest.approx(0.0, abs=1e-6)


def test_a_ball_is_dragged() -> None:
    stage = open_level("default")
    drag(stage, (61.2, 18.45), (30.0, 24.0))
    assert stage.scene.story_targets()["glass"] == pytest.approx((30.0, 24.0))


def test_without_a_floor_below_nothing_is_added() -> None:
    stage = row_of(3, tool="add")
    click(stage, 300.0, 4.0)
    assert read(stage)["dominoes"] == 3
    assert tuple(stage.scene.messages()) == ("There is no floor below.",)


def test_what_a_hand_has_changed_is_saved() -> None:
    stage = row_of(20, spacing=0.6, tool="add")
    click(stage, 0.76 * 8, 0.5, button=3)
    click(stage, 30.0, 1.3)
    level = stage.level.__class__(scene="a01", title="mine", content=stage.scene.save_content())
    again = Stage(Domino, level=parse_level(format_level(level), "a01", DominoContent))
    assert read(again)["dominoes"] == 20
    places = again.scene.model.dominoes.table.x
    assert np.sort(places) == pytest.approx(
        np.sort(stage.scene.model.dominoes.table.x[[*range(8), *range(9, 21)]])
    )


# -- what rolls and slides --------------------------------------------------------------------------


def test_blocks_slide_as_far_as_the_formula_says_whatever_they_weigh() -> None:
    stage = open_level("hard-sliding", step_length=1.0 / 500.0)
    stage.run(500 * 5)
    found = read(stage)
    assert found["at rest"] >= 3
    assert found["slide error"] < 1.0
    assert found["block 1"] == pytest.approx(found["block 2"], rel=2e-3)
    assert found["block 3"] > 1.5 * found["block 1"]


def test_a_giant_falls() -> None:
    stage = open_level("hard-heavy-light")
    stage.run(480)
    assert read(stage)["struck"] == 9


def test_a_thousand_stand_and_sleep() -> None:
    stage = open_level("hard-thousand")
    stage.run(35)
    assert (read(stage)["dominoes"], read(stage)["awake"]) == (1000, 0)
    stage.run(120)
    assert read(stage)["awake"] < 40


@pytest.mark.parametrize("name", ["hard-wide-gap", "hard-narrow-gap", "hard-frictionless"])
def test_a_hard_level_comes_to_what_it_expects(name: str) -> None:
    stage = open_level(name)
    expected = stage.scene.model.content.expected[0]
    stage.run(540)
    assert read(stage)[expected.readout] == pytest.approx(expected.value, abs=expected.within)


def test_without_gravity_nothing_falls() -> None:
    stage = row_of(10)
    stage.post(SetEffect("gravity", False))
    stage.run(60)
    assert read(stage)["struck"] < 10
    assert math.isnan(read(stage)["theory"])


# -- sounds, step back, refusals --------------------------------------------------------------------


def test_wood_is_heard_on_wood_once_for_each_domino_at_least() -> None:
    frames = [2] * 150
    heard = heard_in(row_of(12, spacing=0.5), frames)
    wood = [speed for kind, speed in heard if kind == "wood"]
    assert len(wood) >= 11 and max(wood) > 0.5
    assert {kind for kind, _ in heard} <= {"wood", "thud"}


@pytest.mark.parametrize("name", sorted(LEVELS))
def test_a_step_back_leads_on_the_same(name: str) -> None:
    if name.startswith("story"):
        pytest.skip("a story is played by test_every_story")
    stage = open_level(name)
    stage.run(90)
    stage.post(Action("push"))
    stage.run(60)
    digest = stage.digest()
    for _ in range(9):
        assert stage.step_back()
    stage.run(9)
    assert stage.digest() == digest


def test_a_level_that_cannot_be_is_refused() -> None:
    text = ROW.format(count=3, more="").replace("x = 0.0", "x = 0.0\nfloor = 4")
    with pytest.raises(ValueError, match="floor = 4"):
        Stage(Domino, level=parse_level(text, "a01", DominoContent))
    text = ROW.format(count=3, more="").replace("{ run = 60.0 }", "{ steps = 3 }")
    with pytest.raises(ValueError, match="goes nowhere"):
        Stage(Domino, level=parse_level(text, "a01", DominoContent))
    with pytest.raises(ParameterError):
        row_of(3, spacing=2.0)


def test_a_domino_that_is_added_is_like_its_nearest_neighbour():
    more = ROW.format(count=3, more="") + "[[content.rows]]\nx = 20.0\ncount = 2\nsize = [0.3, 2.0]\n"
    stage = Stage(Domino, level=parse_level(more, "a01", DominoContent))
    for x, tall in ((22.0, 2.0), (1.5, 1.0)):
        assert stage.scene.model.dominoes.add(Standing(x, 0.0, 0.0, 1.0))
        assert stage.scene.model.dominoes.table.tall[-1] == tall


def test_the_first_domino_is_pushed_at_its_time_and_once() -> None:
    stage = row_of(3)
    model, pushes = stage.scene.model, []
    push = model.dominoes.push
    model.dominoes.push = lambda number: (pushes.append((number, model.time)), push(number))
    stage.run(round(0.3 / stage.dt))
    assert [number for number, _ in pushes] == [0]
    assert pushes[0][1] == pytest.approx(0.1, abs=0.5 * stage.dt)

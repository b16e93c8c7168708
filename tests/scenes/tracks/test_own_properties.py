"""A ball that is clicked has mass, friction, restitution and colour of its own: shown, changed, saved."""

from __future__ import annotations

import pytest

from game.levels import parse_level
from game.physics.solids.tracks.motion import BOUNCE, FRICTION, MASS, VX
from game.scenes.tracks.level import TrackContent
from game.scenes.tracks.parameters import OF_CHOSEN
from game.scenes.tracks.scene import Tracks
from game.stage import Action, Pointer, SetParameter, Stage
from tests.scenes.tracks.test_hand import WORDS

FIRST, SECOND, BESIDE = (-1.0, 4.0), (1.0, 4.0), (3.0, 2.0)
GIVEN = (2.5, 0.1, 0.8, "violet")


@pytest.fixture
def stage() -> Stage:
    return Stage(Tracks, level=parse_level(WORDS, "tracks", TrackContent), parameters={"gravity": 0.0})


def click(stage: Stage, place, button: int = 3) -> None:
    for kind in ("down", "up"):
        stage.post(Pointer(kind, *place, button=button))


def give(stage: Stage) -> None:
    for name, value in zip(OF_CHOSEN, GIVEN, strict=True):
        stage.post(SetParameter(name, value))


def test_a_right_click_or_the_tool_shows_what_a_ball_has_and_beside_it_nothing(stage):
    stage.scene.model.rows[1, MASS] = 4.0
    assert stage.scene.inspected() is None and stage.scene.why_idle("own_mass")
    click(stage, SECOND)
    assert stage.scene.inspected().title == "Ball 2" and stage.scene.values["own_mass"] == 4.0
    assert not stage.scene.why_idle("own_mass")
    stage.post(Action("select"))
    click(stage, FIRST, 1)
    assert stage.scene.inspected().title == "Ball 1" and stage.scene.values["own_mass"] == 1.0
    assert stage.scene.values["own_friction"] == 0.6 and stage.scene.values["own_colour"] == "chalk"
    click(stage, BESIDE, 1)
    assert stage.scene.inspected() is None
    click(stage, FIRST)
    stage.post(Action("card"))
    assert stage.scene.inspected() is None and stage.scene.model.held == -1


def test_what_is_given_is_the_balls_own_and_saved_and_costs_no_energy(stage):
    model = stage.scene.model
    model.rows[:, VX] = 1.0
    click(stage, FIRST)
    lost = model.lost()
    give(stage)
    assert model.lost() == pytest.approx(lost, abs=1e-12) and model.rows[0, VX] == 1.0
    stage.post(SetParameter("friction", 1.5))  # of the world: not of what has its own
    stage.post(SetParameter("restitution", 0.3))
    assert model.rows[:, (MASS, FRICTION, BOUNCE)].tolist() == [[2.5, 0.1, 0.8], [1.0, 1.5, 0.3]]
    first, second = stage.scene.save_content().balls
    assert (first.mass, first.friction, first.restitution, first.colour) == GIVEN
    assert (second.mass, second.friction, second.restitution, second.colour) == (1.0, None, None, "chalk")


def test_nothing_is_given_while_nothing_is_chosen_or_after_the_ball_is_gone(stage):
    before = stage.scene.save_content()
    give(stage)
    assert stage.scene.save_content() == before
    click(stage, FIRST)
    stage.post(Action("delete"))
    click(stage, FIRST, 1)
    assert len(stage.scene.model.rows) == 1 and stage.scene.inspected() is None
    give(stage)
    assert stage.scene.save_content().balls == before.balls[1:]

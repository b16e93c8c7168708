"""A body that is clicked has density, friction, restitution and colour of its own: shown, changed, saved."""

import pytest

from game.physics.solids.arrays.state import DYNAMIC
from game.scenes.solids.parameters import OF_CHOSEN, TOOLS
from game.scenes.solids.scene import Solids
from game.stage import Action, Pointer, SetParameter
from tests.scenes.particle_stages import click, open_level
from tests.scenes.solids.test_hand import boxes, saved, use
from tests.scenes.solids.test_solids import bodies


def right_click(stage, place):
    for kind in ("down", "up"):
        stage.post(Pointer(kind, *place, button=3))
    stage.run(1)


def shapes_of(stage, body):
    world = stage.scene.model.world
    return world.shapes, world.shapes_of(body)[0]


def test_a_click_shows_what_a_body_has():
    stage = boxes((0.0, 3.0), (3.0, 3.0), density=4.0, friction=0.3)
    assert stage.scene.inspected() is None
    right_click(stage, (3.0, 3.0))
    shown = stage.scene.inspected()
    assert shown is not None and shown.parameters == OF_CHOSEN
    assert stage.scene.hand.inspected == bodies(stage)[1]
    values = stage.scene.values
    assert [values[name] for name in OF_CHOSEN[:3]] == [4.0, 0.3, 0.0]
    assert len(bodies(stage)) == 2  # nothing was cut


def test_the_tool_that_selects_shows_the_same_and_beside_bodies_nothing():
    stage = boxes((0.0, 3.0))
    use(stage, "select")
    click(stage, (0.0, 3.0))
    stage.run(1)
    assert stage.scene.inspected() is not None
    click(stage, (4.0, 4.0))
    stage.run(1)
    assert stage.scene.inspected() is None


def test_what_is_changed_is_the_bodys_own_and_saved_with_the_level():
    stage = boxes((0.0, 3.0), (3.0, 3.0))
    right_click(stage, (0.0, 3.0))
    body, other = bodies(stage)
    for name, value in zip(OF_CHOSEN, (5.0, 0.1, 0.8, "violet"), strict=True):
        stage.post(SetParameter(name, value))
    stage.run(1)
    world = stage.scene.model.world
    assert world.bodies.inverse_masses[other] == pytest.approx(5.0 * world.bodies.inverse_masses[body])
    stage.post(SetParameter("friction", 1.5))  # of the world: not of what has its own
    stage.run(1)
    shapes, slot = shapes_of(stage, body)
    assert (shapes.frictions[slot], shapes.restitutions[slot]) == (0.1, 0.8)
    assert shapes.frictions[shapes_of(stage, other)[1]] == 1.5
    again = saved(stage)
    first, second = again.scene.save_content().bodies
    assert (first.density, first.friction, first.restitution, first.colour) == (5.0, 0.1, 0.8, "violet")
    assert second.friction is None and second.restitution is None and second.density == 1.0


def test_nothing_is_changed_while_nothing_is_chosen():
    stage = boxes((0.0, 3.0))
    before = stage.scene.save_content().bodies[0]
    stage.post(SetParameter("own_density", 50.0))
    stage.run(1)
    assert stage.scene.save_content().bodies[0].density == before.density
    assert all(stage.scene.why_idle(name) for name in OF_CHOSEN)


def test_the_card_goes_by_its_key_and_with_its_body():
    stage = boxes((0.0, 3.0))
    right_click(stage, (0.0, 3.0))
    for there in (False, True):
        stage.post(Action("card"))
        stage.run(1)
        assert (stage.scene.inspected() is not None) is there
    stage.post(Action("delete-chosen"))
    stage.run(1)
    assert stage.scene.inspected() is None and not len(bodies(stage))


def test_a_step_back_takes_back_what_was_changed():
    stage = boxes((0.0, 3.0))
    right_click(stage, (0.0, 3.0))
    step, events, digest = stage.step_number, stage.events_acted, stage.digest()
    stage.post(SetParameter("own_density", 9.0))
    stage.run(3)
    stage.return_to(step, events)
    assert stage.digest() == digest and stage.scene.values["own_density"] == 1.0


def test_every_tool_has_a_key_of_its_own_and_a_sign():
    keys = [tool.key for tool in TOOLS]
    assert all(len(key) == 1 and key.isalpha() for key in keys) and len(set(keys)) == len(TOOLS)
    buttons = boxes().scene.tool_bar()
    assert [one.action for one in buttons] == [tool.name for tool in TOOLS]
    assert [one.action for one in buttons if one.chosen] == ["box"]


def test_the_empty_sheet_is_empty_and_has_a_floor():
    stage = open_level(Solids, "empty")
    stage.run(5)
    world = stage.scene.model.world
    assert not len(bodies(stage)) and not (world.bodies.flags & DYNAMIC).any()
    assert stage.scene.model.content.floor == 0.0

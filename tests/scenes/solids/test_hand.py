"""What a person does in the playground, by posted events: weld, motor, rope, spring, cut, throw, save."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import format_level, parse_level
from game.physics.solids.arrays.layout import JOINT_NAMES, NO_JOINT
from game.scenes.solids.level import JointEntry, SolidContent
from game.scenes.solids.scene import Solids
from game.stage import Action, SetParameter, Stage
from tests.scenes.particle_stages import click, drag, open_level, readouts
from tests.scenes.solids.test_solids import EMPTY, bodies, draw, empty


def use(stage, tool):
    stage.post(SetParameter("tool", tool))
    stage.run(1)


def boxes(*places, size=0.5, **parameters):
    """A stage without gravity and a box about each place."""
    stage = empty(tool="box", gravity=0.0, **parameters)
    for x, y in places:
        draw(stage, [(x - size, y - size), (x + size, y + size)])
    return stage


def kinds(stage):
    rows = stage.scene.model.world.joints.kinds
    return sorted(JOINT_NAMES[k] for k in rows[rows != NO_JOINT].tolist())


def saved(stage) -> Stage:
    """The stage again, from a file of what it holds."""
    level = stage.scene.level
    text = format_level(
        type(level)(
            scene="solids", title="Saved", about="Saved.",
            parameters={"gravity": stage.scene.parameters.gravity},
            content=stage.scene.save_content(), path=level.path,
        )
    )  # fmt: skip
    return Stage(Solids, level=parse_level(text, "solids", SolidContent, "saved.toml"))


def angles(stage):
    return stage.scene.model.world.bodies.angles[bodies(stage)]


def places(stage):
    return stage.scene.model.world.bodies.positions[bodies(stage)]


def test_a_weld_makes_two_bodies_one():
    stage = boxes((0.0, 2.0), (0.8, 2.0))
    use(stage, "weld")
    click(stage, (0.4, 2.0))
    stage.run(1)
    assert kinds(stage) == ["weld"]
    apart = math.dist(*places(stage))
    world, ids = stage.scene.model.world, bodies(stage)
    world.push(int(ids[0]), (0.0, 2.5), (1.0, 0.3))
    stage.run(60)
    assert abs(angles(stage)[0]) > 0.1
    assert angles(stage)[0] == pytest.approx(angles(stage)[1], abs=1e-4)
    assert math.dist(*places(stage)) == pytest.approx(apart, abs=1e-4)


def test_a_motor_turns_a_body_on_the_ground_at_its_speed():
    stage = boxes((0.0, 3.0), motor_speed=5.0)
    use(stage, "motor")
    click(stage, (0.0, 3.0))
    stage.run(30)
    world = stage.scene.model.world
    assert world.bodies.spins[bodies(stage)[0]] == pytest.approx(5.0, rel=1e-3)
    again = saved(stage)
    again.run(30)
    assert again.scene.model.world.bodies.spins[bodies(again)[0]] == pytest.approx(5.0, rel=1e-3)


def test_a_rope_holds_a_body_and_hangs_slack():
    stage = boxes((0.0, 5.0))
    use(stage, "rope")
    draw(stage, [(0.0, 5.0), (0.0, 7.0)])
    assert kinds(stage) == ["rope"]
    stage.post(SetParameter("gravity", 9.81))
    stage.run(240)
    assert places(stage)[0] == pytest.approx([0.0, 5.0], abs=0.01)
    stage.scene.model.world.push(int(bodies(stage)[0]), (0.0, 5.0), (0.0, 4.0))
    highest = 0.0
    for _ in range(120):
        stage.run(1)
        highest = max(highest, float(places(stage)[0, 1]))
        assert places(stage)[0, 1] > 4.98
    assert highest == pytest.approx(5.0 + 16.0 / (2.0 * 9.81), abs=0.03)


def test_a_cut_across_a_rope_lets_the_body_fall():
    stage = boxes((0.0, 5.0))
    use(stage, "rope")
    draw(stage, [(0.0, 5.0), (0.0, 7.0)])
    stage.post(SetParameter("gravity", 9.81))
    stage.run(10)
    drag(stage, (-1.0, 6.3), (1.0, 6.3), button=3, steps=3)
    stage.run(1)
    assert kinds(stage) == []
    stage.run(150)
    assert places(stage)[0, 1] < 0.6


def test_a_spring_between_two_bodies_swings_with_its_frequency():
    stage = boxes((-2.0, 3.0), (2.0, 3.0), spring_rate=1.0, step_length=1.0 / 240.0)
    use(stage, "spring")
    draw(stage, [(-2.0, 3.0), (2.0, 3.0)])
    assert kinds(stage) == ["spring"]
    world, (left, right) = stage.scene.model.world, bodies(stage).tolist()
    world.push(left, (-2.0, 3.0), (1.0, 0.0))
    world.push(right, (2.0, 3.0), (-1.0, 0.0))
    apart = []
    for _ in range(480):
        stage.run(1)
        apart.append(float(np.ptp(places(stage)[:, 0])) - 4.0)
    below = np.array(apart) < 0.0
    rises = np.flatnonzero(below[:-1] & ~below[1:])
    assert len(rises) >= 2
    assert (rises[1] - rises[0]) / 240.0 == pytest.approx(1.0, rel=0.02)


def test_a_rope_from_a_body_to_itself_is_refused_in_words():
    stage = boxes((0.0, 2.0))
    use(stage, "rope")
    stage.scene.messages()
    draw(stage, [(-0.2, 2.0), (0.2, 2.0)])
    assert kinds(stage) == []
    assert any("from one body to another" in words for words in stage.scene.messages())


def test_a_joint_is_deleted_by_a_click_and_the_body_stays():
    stage = boxes((0.0, 3.0))
    use(stage, "pin")
    click(stage, (0.0, 3.0))
    use(stage, "delete")
    click(stage, (0.0, 3.0))
    stage.run(1)
    assert kinds(stage) == [] and len(bodies(stage)) == 1
    click(stage, (0.2, 3.2))
    stage.run(1)
    assert len(bodies(stage)) == 0


@pytest.mark.parametrize("tool", ["pin", "weld", "motor"])
def test_fastening_nothing_says_what_to_do(tool):
    stage = empty(tool=tool)
    click(stage, (3.0, 3.0))
    stage.run(1)
    assert kinds(stage) == []
    assert any("Click a body" in words for words in stage.scene.messages())


@pytest.mark.parametrize(
    ("key", "tool"), [("throw", "throw"), ("disc", "disc"), ("cut", "cut"), ("pin", "pin")]
)
def test_keys_choose_tools(key, tool):
    stage = empty()
    stage.post(Action(key))
    stage.run(1)
    assert stage.scene.parameters.tool == tool


def test_a_throw_goes_against_the_drag():
    stage = boxes((0.0, 3.0))
    use(stage, "throw")
    draw(stage, [(0.0, 3.0), (-0.5, 2.0)])
    world = stage.scene.model.world
    assert world.bodies.velocities[bodies(stage)[0]] == pytest.approx([2.0, 4.0], rel=1e-6)


def test_every_joint_goes_on_from_its_file_as_it_was():
    """A pin with limits that has turned, a slider on a body that has turned, a soft weld, a slack rope."""
    stage = boxes((0.0, 3.0), (2.0, 3.0), (4.0, 3.0))
    model, ids = stage.scene.model, bodies(stage).tolist()
    model.join(JointEntry(kind="pin", bodies=(-1, 0), at=(0.0, 3.0), limits=(-2.0, 2.0)), ids)
    model.join(JointEntry(kind="slider", bodies=(0, 1), at=(2.0, 3.0), limits=(-0.5, 0.5)), ids)
    model.join(JointEntry(kind="rope", bodies=(1, 2), at=(2.5, 3.0), other=(3.5, 3.0), length=1.6), ids)
    model.world.push(ids[0], (0.0, 3.5), (-1.0, 0.0))
    stage.run(40)
    again = saved(stage)
    for one in (stage, again):
        one.run(40)
    assert places(again) == pytest.approx(places(stage), abs=2e-3)
    assert angles(again) == pytest.approx(angles(stage), abs=2e-3)
    for one in (stage, again):
        one.scene.model.world.push(bodies(one).tolist()[0], (0.0, 3.5), (-30.0, 0.0))
        one.run(120)
    assert angles(again)[0] == pytest.approx(angles(stage)[0], abs=0.02)  # at the same stop


@pytest.mark.parametrize("name", ["hard-14-hand-over", "hard-13-driven", "hard-13-lift"])
def test_what_is_driven_goes_on_in_its_swing_from_a_file(name):
    stage = open_level(Solids, name)
    stage.run(round(0.3 / stage.dt))
    again = saved(stage)
    again.post(SetParameter("step_length", stage.dt))
    again.run(1)
    stage.run(1)
    for one in (stage, again):
        one.run(round(0.2 / one.dt))
    driven = stage.scene.model.shakes[0].body
    first, second = (one.scene.model.world.bodies for one in (stage, again))
    assert second.positions[driven] == pytest.approx(first.positions[driven], abs=1e-6)
    assert second.velocities[driven] == pytest.approx(first.velocities[driven], abs=1e-4)


def test_what_is_to_be_set_free_or_to_go_does_so_from_a_file_too():
    disc = "[[content.bodies]]\nshapes = [{{ disc = 0.5 }}]\nposition = [{}, 9.0]\n"
    disc += 'kind = "fixed"\n{}_at = 1.0\n'
    text = EMPTY + disc.format(0.0, "gone") + disc.format(3.0, "free")
    stage = Stage(Solids, level=parse_level(text, "solids", SolidContent, "gone.toml"))
    stage.run(30)
    again = saved(stage)
    for one in (stage, again):
        assert len(bodies(one)) == 2
    again.run(20)
    assert len(bodies(again)) == 2 and places(again)[1, 1] == 9.0
    again.run(20)
    assert len(bodies(again)) == 1 and places(again)[0, 1] < 9.0
    assert readouts(again)["bodies"] == 1

"""A joint that is clicked has a card: kind, limits, drive, stiffness and load; what is changed is its own."""

import math

import pytest

from game.physics.solids.arrays.state import ASLEEP
from game.physics.solids.joints.options import JointOptions
from game.scenes.solids.joint_card import OF_JOINT, OF_KIND, card_of
from game.scenes.solids.level import JointEntry
from game.scenes.solids.model import ANCHOR
from game.scenes.solids.scene import Solids
from game.stage import SetParameter
from tests.scenes.particle_stages import click
from tests.scenes.solids.test_hand import boxes, saved, use
from tests.scenes.solids.test_own_properties import right_click
from tests.scenes.solids.test_solids import bodies

TOP = (0.0, 3.5)


def hung(kind="pin", **options):
    """A box that hangs from the ground by a joint at its top; the stage, and the joint."""
    stage = boxes((0.0, 3.0))
    (body,) = bodies(stage)
    model = stage.scene.model
    model.join(JointEntry(kind=kind, bodies=(0, 1), at=TOP, **options), [ANCHOR, body])
    (joint,) = [k for k in range(len(model.world.joints.kinds)) if model.world.joints.kinds[k] >= 0]
    return stage, joint


def give(stage, **values):
    for name, value in values.items():
        stage.post(SetParameter(name, value))
    stage.run(1)


def options_of(stage, joint) -> JointOptions:
    return stage.scene.model.world.joint_options(joint)


def test_a_click_on_a_joint_shows_the_joint_and_beside_it_the_body():
    stage, joint = hung()
    right_click(stage, TOP)
    shown = stage.scene.inspected()
    assert shown.title == f"Pin {joint}" and shown.parameters == OF_KIND["pin"]
    right_click(stage, (0.0, 2.8))
    assert stage.scene.inspected().title.startswith("Body")
    use(stage, "select")
    click(stage, TOP)
    stage.run(1)
    assert stage.scene.inspected().title == f"Pin {joint}"


def test_its_load_is_the_weight_that_hangs_on_it():
    stage, _ = hung()
    give(stage, gravity=9.81)
    right_click(stage, TOP)
    stage.run(240)
    world, (body,) = stage.scene.model.world, bodies(stage)
    weight = 9.81 / float(world.bodies.inverse_masses[body])
    force = float(stage.scene.inspected().told.split(" N")[0])
    assert force == pytest.approx(weight, rel=0.01)


def test_the_card_says_what_the_joint_has():
    limits = (-0.5, 1.0)
    stage, _ = hung(limits=limits, speed=2.0, most=30.0, hertz=5.0, damping=0.7, break_force=900.0)
    right_click(stage, TOP)
    values = stage.scene.values
    assert values["joint_limited"] is True
    assert [values[name] for name in ("joint_least_turn", "joint_most_turn")] == pytest.approx(
        [math.degrees(end) for end in limits]
    )
    said = [values[f"joint_{name}"] for name in ("speed", "torque", "hertz", "damping", "break")]
    assert said == [2.0, 30.0, 5.0, 0.7, 900.0]


def test_what_is_changed_is_the_joints_own_and_saved_with_the_level():
    stage, joint = hung()
    right_click(stage, TOP)
    give(stage, joint_least_turn=-30.0, joint_most_turn=60.0, joint_limited=True, joint_speed=1.5,
         joint_torque=20.0, joint_hertz=4.0, joint_damping=0.25, joint_break=5000.0)  # fmt: skip
    found = options_of(stage, joint)
    assert found.limits == pytest.approx((math.radians(-30.0), math.radians(60.0)))
    assert (found.speed, found.most, found.hertz, found.damping, found.break_force) == (
        1.5, 20.0, 4.0, 0.25, 5000.0,
    )  # fmt: skip
    (entry,) = saved(stage).scene.save_content().joints
    assert entry.limits[1] - entry.limits[0] == pytest.approx(math.radians(90.0))  # from how they stand now
    assert (entry.speed, entry.most, entry.hertz, entry.damping) == (1.5, 20.0, 4.0, 0.25)
    give(stage, joint_limited=False, joint_torque=1e6, joint_break=1e6)
    found = options_of(stage, joint)
    assert found.limits == (-math.inf, math.inf) and found.most == found.break_force == math.inf


def test_a_motor_on_the_card_turns_the_body():
    stage, _ = hung()
    (body,) = bodies(stage)
    right_click(stage, TOP)
    give(stage, joint_speed=3.0)
    stage.run(120)
    assert float(stage.scene.model.world.bodies.spins[body]) == pytest.approx(3.0, rel=0.02)


def test_what_cannot_be_is_said_and_changes_nothing():
    stage, joint = hung(limits=(-0.5, 1.0))
    right_click(stage, TOP)
    give(stage, joint_least_turn=200.0)
    assert "expected lower, upper" in " ".join(stage.scene.messages())
    assert options_of(stage, joint).limits == pytest.approx((-0.5, 1.0))


def test_without_a_joint_nothing_is_changed_and_it_is_said_why():
    stage, joint = hung()
    before = options_of(stage, joint)
    give(stage, joint_hertz=7.0)
    assert options_of(stage, joint) == before
    assert all(stage.scene.why_idle(name) for name in OF_JOINT)
    right_click(stage, TOP)
    stage.scene.model.world.remove_joint(joint)
    assert stage.scene.inspected() is None


def test_a_joint_that_broke_stays_broken_when_it_is_changed():
    stage, joint = hung(break_force=0.5)
    give(stage, gravity=9.81)
    stage.run(30)
    world = stage.scene.model.world
    assert world.joints.flags[joint] & 8
    world.change_joint(joint, hertz=2.0)
    assert world.joints.flags[joint] & 8


@pytest.mark.parametrize("kind", sorted(OF_KIND))
def test_every_kind_has_a_card_whose_parameters_there_are(kind):
    options = {"hertz": 3.0} if kind == "spring" else {}
    stage, joint = hung(kind, **options)
    shown = card_of(stage.scene.model.world, joint)
    assert shown.title == f"{kind.capitalize()} {joint}" and " N" in shown.told
    assert set(shown.parameters) <= set(Solids.parameters_type.__dict__) | set(stage.scene.values)


@pytest.mark.parametrize("solver", ["soft-step", "sequential-impulses"])
def test_a_joint_bears_what_hangs_on_it_when_that_sleeps_too(solver):
    stage, joint = hung()
    give(stage, solver=solver, gravity=9.81)
    stage.run(400)
    world, (body,) = stage.scene.model.world, bodies(stage)
    weight = 9.81 / float(world.bodies.inverse_masses[body])
    assert world.bodies.flags[body] & ASLEEP
    assert world.joint_load(joint)[0] == pytest.approx(weight, rel=0.01)

"""What is heard of solids: each impact once, by its materials, louder for what is heavier and faster."""

from __future__ import annotations

import pytest

from game.levels import parse_level
from game.scenes.solids.level import SolidContent
from game.scenes.solids.scene import Solids
from game.stage import Stage
from game.ui.sound import KINDS, sample_of
from tests.scenes.listening import heard_in
from tests.scenes.particle_stages import open_level

PAIR = """
scene = "solids"
title = "Two"
about = "One falls on the other."
[content]
floor = {floor}
[[content.bodies]]
shapes = [{{ box = [2.0, 0.5] }}]
position = [{x}, 0.25]
kind = "fixed"
colour = "{below}"
[[content.bodies]]
shapes = [{{ disc = 0.25 }}]
position = [{x}, {top}]
density = {density}
colour = "{above}"
"""


def pair(above, below, height=1.0, density=1.0, x=0.0, floor=-5.0):
    text = PAIR.format(above=above, below=below, top=0.75 + height, density=density, x=x, floor=floor)
    return Stage(Solids, level=parse_level(text, "solids", SolidContent, "pair.toml"))


@pytest.mark.parametrize(
    ("above", "below", "kind"),
    [
        ("steel", "steel", "steel"), ("steel", "stone", "stone"), ("stone", "steel", "stone"),
        ("steel", "wood", "wood"), ("pink", "stone", "wood"),
    ],
)  # fmt: skip
def test_the_softer_of_two_is_heard(above, below, kind):
    heard = heard_in(pair(above, below), [7] * 12)
    assert heard and {name for name, _ in heard} == {kind}


def test_the_ground_thuds():
    stage = pair("steel", "steel", x=0.0)
    stage.scene.model.remove(int(stage.scene.model.movable()[0]))
    stage.scene.model.world.set_velocity(int(stage.scene.model.movable()[0]), (0.0, -4.0))
    assert {name for name, _ in heard_in(stage, [5] * 24)} == {"thud"}


def test_what_is_faster_or_heavier_is_louder_and_what_rests_is_silent():
    def loudest(**how):
        return max(speed for _, speed in heard_in(pair("wood", "wood", **how), [4] * 24))

    assert loudest(height=2.0) > 1.3 * loudest(height=1.0)
    assert loudest(density=8.0) == pytest.approx(2.0 * loudest(density=1.0), rel=0.01)
    stage = pair("wood", "wood")
    heard_in(stage, [4] * 24)
    stage.run(60)
    assert not len(stage.scene.hearing().sounds)


def test_sounds_come_from_where_they_are():
    stages = [pair("wood", "wood", x=x) for x in (-6.0, 6.0)]
    pans = []
    for stage in stages:
        for _ in range(60):
            stage.run(1)
            if stage.scene.hearing().sounds:
                break
        pans.append(stage.scene.hearing().sounds[0].pan)
    assert pans == pytest.approx([-0.75, 0.75])


def test_a_joint_that_breaks_is_heard():
    heard = heard_in(open_level(Solids, "hard-12-cantilever"), [1] * 4)
    assert ("crackle", 3.0) in heard


def test_a_clock_ticks_twice_in_a_period():
    stage = open_level(Solids, "clock")
    stage.run(round(4.0 / stage.dt))
    heard = heard_in(stage, [4] * round(8.0 / (4 * stage.dt)))
    assert {name for name, _ in heard} == {"steel"}
    assert 4 <= len(heard) <= 12


def test_steps_back_take_back_what_was_heard():
    stage = pair("wood", "wood")
    while not stage.scene.hearing().sounds:
        stage.run(1)
    stage.step_back()
    assert not stage.scene.hearing().sounds
    stage.run(1)
    assert len(stage.scene.hearing().sounds) == 1


def test_every_kind_has_its_sound():
    assert {"wood", "stone", "steel", "thud", "crackle"} <= set(KINDS)
    assert abs(sample_of("steel", 3) - 0.0).max() == 1.0
    assert len(sample_of("steel", 2)) > 2 * len(sample_of("stone", 2))

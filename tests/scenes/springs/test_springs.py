"""What the mass-spring scenes C14 and C15 share: building, moving, cutting, levels, replay."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import Level, LevelError, format_level, level_files, parse_level
from game.physics.fields import GROUND
from game.scenes.springs.level import SpringContent
from game.scenes.springs.rigid_links import RigidLinks
from game.scenes.springs.soft_springs import Springs
from game.stage import Action, ParameterError, SetEffect, SetParameter, replay_scene
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release, stage_of

SCENES = (RigidLinks, Springs)
LEVELS = [(scene, path) for scene in SCENES for path in level_files(scene.name)]
both = pytest.mark.parametrize("scene_type", SCENES, ids=lambda scene: scene.name)


def sheet(scene_type, **declared):
    """Two particles and a link, the first of them fixed."""
    return open_level(scene_type, "draw", tool="hand", **declared)


@both
def test_particles_and_links_are_clicked_together(scene_type):
    """C14.1, C15.1: also while it stands still, and saved and read back."""
    stage = sheet(scene_type)
    stage.pause()
    stage.post(SetParameter("tool", "particle"))
    stage.post(SetParameter("mass", 3.0))
    for point in ((-2.0, 2.0), (-1.0, 2.0), (-1.5, 3.0)):
        click(stage, point)
    scene = stage.scene
    assert scene.model.system.count == 5
    assert np.allclose(scene.model.system.inverse_masses[2:], 1 / 3)
    stage.post(SetParameter("tool", "link"))
    click(stage, (-2.0, 2.0))
    click(stage, (-1.0, 2.0))
    drag(stage, (-1.0, 2.0), (-1.5, 3.0), steps=2, run=0)
    assert scene.model.system.links.pairs.tolist()[-2:] == [[2, 3], [3, 4]]
    assert scene.model.system.links.rest[-1] == pytest.approx(math.dist((-1, 2), (-1.5, 3)))
    click(stage, (-2.0, 2.0))
    click(stage, (-1.0, 2.0))
    assert len(scene.model.system.torn) == 3
    assert any("linked already" in words for words in scene.messages())
    text = format_level(Level(scene=scene_type.name, content=scene.save_content()))
    back = parse_level(text, scene_type.name, SpringContent)
    assert len(back.content.particles) == 5
    assert len(back.content.links) == 3
    assert scene_type(back).model.system.links.pairs.tolist() == scene.model.system.links.pairs.tolist()
    stage.resume()
    stage.run(30)
    assert stage.fault is None


@both
def test_inverse_mass_zero_is_fixed_and_masses_are_typed(scene_type):
    """C14.2, C15.2: pinned and freed by a click; the mass of the chosen one by its parameter."""
    stage = sheet(scene_type)
    scene = stage.scene
    stage.run(30)
    assert np.array_equal(scene.model.system.positions[0], (0.0, 3.0))
    stage.post(Action("pin"))
    click(stage, (0.0, 3.0))
    assert scene.model.system.inverse_masses[0] > 0.0
    stage.post(Action("hand"))
    stage.run(10)
    assert scene.model.system.positions[0, 1] < 3.0
    stage.post(Action("hand"))
    click(stage, scene.model.system.positions[1])
    assert scene.hand.chosen == 1
    stage.post(SetParameter("mass", 50.0))
    assert scene.model.system.inverse_masses[1] == pytest.approx(0.02)
    stage.post(SetParameter("fixed", True))
    there = scene.model.system.positions[1].copy()
    stage.run(20)
    assert np.array_equal(scene.model.system.positions[1], there)


@both
def test_the_ground_pushes_up_and_gravity_pulls_down(scene_type):
    """C14.4, .5, C15.4, .5"""
    stage = sheet(scene_type)
    stage.post(Action("pin"))
    click(stage, (0.0, 3.0))
    stage.post(Action("hand"))
    stage.run(120)
    assert stage.scene.model.system.positions[:, 1].min() == 0.0
    stage.post(SetEffect("ground", False))
    stage.run(60)
    assert stage.scene.model.system.positions[:, 1].max() < -3.0
    stage.post(SetParameter("gravity", -10.0))
    stage.run(240)
    assert stage.scene.model.system.positions[:, 1].min() > 0.0


@both
def test_damping_takes_energy(scene_type):
    """C14.7, C15.7: f = -k_d v."""
    kinetic = {}
    for k in (0.0, 3.0):
        stage = sheet(scene_type, damping=k)
        stage.run(50)
        kinetic[k] = readouts(stage)["kinetic"]
    assert kinetic[3.0] < 0.2 * kinetic[0.0]


@both
def test_particles_are_dragged_while_it_runs(scene_type):
    """C14.8, C15.8: the held one is where the pointer is, and is free again."""
    stage = open_level(scene_type, "default")
    stage.run(10)
    scene = stage.scene
    index = 20
    press(stage, scene.model.system.positions[index])
    held = scene.model.system.held
    assert held >= 0
    for i in range(20):
        move(stage, (0.05 * i, 2.0 + 0.05 * i))
        stage.run(1)
        if i > 10:
            assert np.allclose(
                scene.model.system.positions[held], (0.05 * i, 2.0 + 0.05 * i), rtol=0, atol=1e-9
            )
    release(stage, (1.0, 3.0))
    assert scene.model.system.held == -1
    assert scene.model.system.inverse_masses[held] > 0.0
    stage.run(240)
    assert scene.model.system.positions[held, 1] < 2.9
    assert stage.fault is None


@both
@pytest.mark.parametrize("ground", [True, False])
def test_what_is_dragged_stops_at_a_wall_and_goes_on_where_there_is_none(scene_type, ground):
    stage = open_level(scene_type, "default")
    stage.post(SetEffect(GROUND.name, ground))
    stage.run(2)
    model = stage.scene.model
    for side, wall in zip((-1.0, 1.0), model.walls, strict=True):
        press(stage, model.system.positions[20])
        held = model.system.held
        move(stage, (wall + 0.4 * side, 2.0))
        stage.run(60)
        assert model.system.positions[held] == pytest.approx(
            (wall + 0.4 * side * (not ground), 2.0), abs=1e-9
        )
        release(stage, (0.0, 2.0))
        stage.run(1)


@both
def test_cutting_with_the_right_button_and_with_the_tool(scene_type):
    stage = sheet(scene_type)
    drag(stage, (0.7, 3.4), (0.7, 2.6), button=3, run=0)
    assert readouts(stage)["links"] == 0
    stage.run(60)
    assert stage.scene.model.system.positions[1, 1] < 0.5
    assert np.array_equal(stage.scene.model.system.positions[0], (0.0, 3.0))
    again = sheet(scene_type)
    again.post(Action("cut"))
    drag(again, (0.7, 3.4), (0.7, 2.6), run=0)
    assert readouts(again)["torn"] == 1


@both
def test_what_is_chosen_is_deleted_with_its_links(scene_type):
    stage = open_level(scene_type, "default")
    scene = stage.scene
    links = len(scene.model.system.torn)
    click(stage, scene.model.system.positions[10])
    at_it = int(np.any(scene.model.system.links.pairs == scene.hand.chosen, axis=1).sum())
    count = scene.model.system.count
    stage.post(Action("delete"))
    assert stage.scene.model.system.count == count - 1
    assert len(stage.scene.model.system.torn) == links - at_it
    stage.run(30)
    stage.scene.model.system.check()
    alone = sheet(scene_type)
    for _ in range(2):
        click(alone, alone.scene.model.system.positions[0])
        alone.post(Action("delete"))
    assert alone.scene.model.system.count == 1
    assert any("last particle" in words for words in alone.scene.messages())


@both
def test_points_and_lines_are_counted_in_the_legend(scene_type):
    """C14.9, C15.9"""
    stage = open_level(scene_type, "default")
    rows = {words: count for _, words, count in stage.scene.legend()}
    noun = "links" if scene_type is RigidLinks else "springs"
    assert int(rows[noun].replace("\u202f", "").replace("\u2009", "")) == len(stage.scene.model.system.torn)


@pytest.mark.parametrize(("scene_type", "path"), LEVELS, ids=lambda value: getattr(value, "name", value))
def test_every_level_steps_restores_and_steps_again(scene_type, path):
    stage = stage_of(scene_type, path)
    stage.run(12)
    for _ in range(4):
        assert stage.step_back()
    middle = stage.digest()
    stage.run(8)
    again = stage_of(scene_type, path)
    again.run(8)
    assert again.digest() == middle
    again.run(8)
    assert again.digest() == stage.digest()
    assert stage.fault is None
    stage.scene.model.system.check()


@both
def test_a_recorded_session_with_edits_replays_exactly(scene_type):
    stage = open_level(scene_type, "default")
    stage.run(5)
    drag(stage, stage.scene.model.system.positions[9], (0.0, 4.0), steps=6)
    stage.post(SetParameter("tool", "particle"))
    click(stage, (0.0, 4.2))
    stage.post(SetParameter("iterations", 5))
    stage.run(3)
    stage.post(SetParameter("tool", "link"))
    click(stage, stage.scene.model.system.positions[-1])
    click(stage, stage.scene.model.system.positions[3])
    drag(stage, (-3.0, 3.5), (3.0, 0.5), button=3, steps=4)
    stage.post(SetEffect("damping", False))
    stage.run(10)
    twin = replay_scene(stage.recording, scene_type)
    assert twin.digest() == stage.digest()


@both
def test_stepping_back_undoes_edits(scene_type):
    stage = open_level(scene_type, "default")
    stage.run(6)
    before, count = stage.digest(), stage.scene.model.system.count
    stage.post(Action("particle"))
    click(stage, (0.0, 4.3))
    stage.run(4)
    click(stage, (0.5, 4.3))
    stage.run(4)
    assert stage.scene.model.system.count == count + 2
    after = stage.digest()
    while stage.step_number > 6:
        assert stage.step_back()
    assert stage.step_back()
    stage.step()
    stage.step_back()
    while stage.step_number < 14:
        stage.step()
    assert stage.digest() == after
    while stage.step_number > 5:
        stage.step_back()
    stage.post(Action("hand"))
    stage.step()
    assert stage.scene.model.system.count == count
    assert stage.digest() == before


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("[[content.links]]\nends = [0, 1]", "links[0]"),
        (
            "[content]\nparticles = [{ position = [0, 0], inverse_mass = -1.0 }]",
            "content.particles[0].inverse_mass",
        ),
        ("[content]\nparticles = [{ position = [0, nan] }]", "content.particles[0].position[1]"),
        (
            "[content]\nparticles = [{ position = [0, 0] }]\nlinks = [{ ends = [0, 0] }]",
            "links[0]",
        ),
        ("[content]\nparticles = [{ position = [0, 0] }]\nareas = [[0, 0, 0]]", "areas[0]"),
        ('[[content.ropes]]\nstart = [0, 0]\nend = [1, 0]\nlinks = 4\npins = "all"', "ropes[0]"),
        (
            "[[content.cloths]]\ncorner = [0, 0]\ncolumns = 9999\nrows = 2\nspacing = 0.1",
            "content.cloths[0].columns",
        ),
        ("[content]\nfloor = 0.0", "particles"),
        ("[parameters]\niterations = 0", "parameters.iterations"),
        ("[content]\nropse = []", "ropse"),
        ("[content]\nwalls = [2.0, -2.0]\nparticles = [{ position = [0, 0] }]", "walls"),
        ("[content]\nbody_distance = -0.1", "content.body_distance"),
    ],
)
def test_what_is_broken_in_a_level_is_named(text, field):
    with pytest.raises(LevelError) as caught:
        RigidLinks(parse_level(f'scene = "c14"\n{text}\n', "c14", SpringContent))
    assert field in str(caught.value)


def test_a_solver_that_does_not_fit_is_refused_and_the_old_one_goes_on():
    stage = open_level(RigidLinks, "default")
    with pytest.raises(ParameterError, match="fork"):
        stage.post(SetParameter("solver", "direct"))
    assert stage.scene.parameters.solver == "gauss-seidel"
    stage.run(2)
    assert stage.fault is None


@both
def test_the_next_click_is_named(scene_type):
    stage = sheet(scene_type)
    assert stage.scene.hand.next_click() == ""
    assert stage.scene.hints_now() == scene_type.hints
    for tool, words in (("particle", "new particle"), ("link", "one end"), ("pin", "pin"), ("cut", "cut")):
        stage.post(Action(tool))
        assert words in stage.scene.hand.next_click()
        assert words in stage.scene.hints_now()[0].text
    stage.post(Action("link"))
    click(stage, (0.0, 3.0))
    assert "other end" in stage.scene.hand.next_click()


@both
def test_the_next_click_stands_at_the_pointer(scene_type):
    stage = open_level(scene_type, "draw")
    move(stage, (1.0, 2.0), button=0)
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    place, *_ = canvas.drawn["click: a new particle"]
    assert place == (1.0, 2.0)


@both
def test_an_empty_sheet_stands_still_while_one_builds(scene_type):
    stage = open_level(scene_type, "draw")
    click(stage, (-2.0, 2.0))
    before = stage.scene.model.system.positions.copy()
    stage.run(60)
    assert np.array_equal(stage.scene.model.system.positions, before)
    stage.post(Action("hand"))
    stage.run(60)
    assert stage.scene.model.system.positions[2, 1] < 1.0

"""Hard levels say in the picture what is expected and what is measured."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.levels import LevelError, level_files, load_level, parse_level
from game.scenes.fountain.scene import Fountain
from game.scenes.key_frames.scene import KeyFraming
from game.scenes.rigid_body.scene import RigidBodyScene
from game.scenes.skeletons.inverse_kinematics import InverseKinematics
from game.scenes.skeletons.skinning import Skinning
from game.scenes.spheres.scene import SphereCollisions
from game.scenes.springs.rigid_links import RigidLinks
from game.scenes.springs.soft_springs import Springs
from game.stage import Frame, Readout
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.worlds.expectations import Caption, Expectation, captions_now, captions_of, draw_captions
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import open_level

SCENES = (
    Fountain, SphereCollisions, RigidLinks, Springs, KeyFraming, Skinning, InverseKinematics, RigidBodyScene,
)  # fmt: skip
BELOW_THE_EDGE = (Fountain, RigidLinks, Springs)  # of the level's view; the others leave room above it
WITH = {  # what a level is to be given before it does as it should: that is its lesson
    "hard-04-heavy-end": {"solver": "direct"},
    "hard-05-loop": {"model": "xpbd"},
}
EXPECTING = [
    (scene, path.stem)
    for scene in SCENES
    for path in level_files(scene.name)
    if getattr(load_level(path, scene.name, scene.content_type).content, "expected", ())
]
ALWAYS = [name for scene, name in EXPECTING if scene is SphereCollisions]
SETTLED_S = 20.0
SILENT = ("hard-02-on-the-bone", "hard-06-series-and-parallel")  # whose lesson is no single number


def captions(stage):
    return captions_of(expected_of(stage), stage.readouts())


def expected_of(stage):
    """What the stage's level expects."""
    return stage.level.content.expected


def test_words_and_whether_it_is_as_expected():
    entries = (Expectation(readout="kinetic", value=0.0, within=1e-9), Expectation(readout="count", value=3))
    found = captions_of(entries, [Readout("kinetic", 1e-12, "J"), Readout("count", 2)])
    assert found[0] == ("kinetic: expected 0 J, measured 0 J", True)
    assert found[1] == ("count: expected 3, measured 2", False)
    assert not captions_of(entries, [Readout("kinetic", 2.0, "J"), Readout("count", float("nan"))])[1].met


def test_a_bound_is_told_with_what_is_measured():
    entries = [Expectation(readout="sinks", value=0.1, at_most=True)]
    noise = captions_of(entries, [Readout("sinks", -8.38e-17, "m")])
    assert noise[0] == ("sinks: at most 100 mm, measured 0 m", True)
    told = [captions_of(entries, [Readout("sinks", sinks, "m")])[0] for sinks in (0.05, 0.2, -0.2)]
    assert told[0] == ("sinks: at most 100 mm, measured 50.0 mm", True)
    assert [caption.met for caption in told] == [True, False, False]


@pytest.mark.parametrize(("scene_type", "name"), EXPECTING, ids=[f"{s.name}-{n}" for s, n in EXPECTING])
def test_what_a_hard_level_expects_comes_true(scene_type, name):
    stage = open_level(scene_type, name, **WITH.get(name, {}))
    period = getattr(stage.level.content, "repeat", 0.0) or SETTLED_S
    stage.run(round(min(SETTLED_S, period) / stage.dt) - 1)
    assert stage.fault is None
    assert [caption.words for caption in captions(stage) if not caption.met] == []
    assert stage.scene.save_content().expected == expected_of(stage)


@pytest.mark.parametrize("scene_type", SCENES)
def test_hard_levels_say_what_they_expect(scene_type):
    silent = [
        path.stem
        for path in level_files(scene_type.name)
        if path.stem.startswith("hard") and (scene_type, path.stem) not in EXPECTING
    ]
    assert silent == [name for name in SILENT if name in silent]


@pytest.mark.parametrize(("name", "given"), WITH.items())
def test_a_lesson_is_amber_until_it_is_learnt(name, given):
    scene_type = RigidLinks if "solver" in given else Springs
    stage = open_level(scene_type, name)
    stage.run(round(SETTLED_S / stage.dt))
    assert not captions(stage)[0].met


def test_where_a_method_fails_the_caption_says_so():
    stage = open_level(Fountain, "hard-06-fast-and-small", contact="end")
    stage.run(round(5.0 / stage.dt))
    assert captions(stage) == [("impacts: expected 4, measured 0", False)]


@pytest.mark.parametrize("name", ALWAYS)
def test_what_is_expected_of_spheres_is_so_all_the_time(name):
    stage = open_level(SphereCollisions, name)
    for _ in range(20):
        assert [caption.words for caption in captions(stage) if not caption.met] == []
        stage.run(15)


def test_where_a_correction_makes_energy_the_caption_says_how_much():
    stage = open_level(SphereCollisions, "hard-08-deep-overlap", correction="baumgarte")
    stage.run(round(0.5 / stage.dt))
    (caption,) = captions(stage)
    assert not caption.met
    assert caption.words.startswith("total energy: expected 0 J, measured ")
    assert not caption.words.endswith("measured 0 J")


@pytest.mark.parametrize("scene_type", SCENES)
def test_captions_look_the_same_in_every_scene(scene_type):
    """Below each other, in the middle below the upper edge of the level's view."""
    stage = open_level(scene_type, next(name for scene, name in EXPECTING if scene is scene_type))
    stage.run(1)
    frame, canvas = stage.scene.frame(), labels_of(stage)
    view = stage.level.content.view if scene_type in (*BELOW_THE_EDGE, KeyFraming) else frame
    stage.scene.draw(canvas, 1.0)
    found = captions(stage)
    assert found
    for line, (words, met) in enumerate(found):
        style = ("green" if met else "amber", 13, "semibold", "top", (0.0, 14.0 + 20.0 * line))
        assert canvas.drawn[words] == ((0.5 * (view.left + view.right), view.top), *style)


@pytest.mark.parametrize("scene_type", SCENES)
def test_before_a_first_step_nothing_was_measured_and_nothing_is_green(scene_type):
    stage = open_level(scene_type, next(name for scene, name in EXPECTING if scene is scene_type))
    expected = expected_of(stage)

    def shown() -> list[Caption]:
        return captions_now(stage.scene, expected)

    assert [caption.words.split(", ")[-1] for caption in shown()] == ["not measured yet"] * len(expected)
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    assert {canvas.drawn[caption.words][1] for caption in shown()} == {"amber"}
    stage.run(1)
    assert shown() == captions(stage)
    for caption, before in zip(shown(), captions_now(scene_type(level=stage.level), expected), strict=True):
        assert caption.words.split(", measured")[0] == before.words.split(", not")[0]
    assert stage.step_back()
    assert {caption.met for caption in shown()} == {False}
    assert captions_now(stage.scene, ()) == []


def test_two_captions_stand_below_each_other():
    canvas = labels_of(open_level(Fountain, "default"))
    draw_captions(canvas, (0.0, 4.0), [Caption("a", True), Caption("b", False)])
    (_, first, *_, (_, upper)), (_, second, *_, (_, lower)) = canvas.drawn["a"], canvas.drawn["b"]
    assert (first, second) == ("green", "amber") and lower > upper


def test_the_plate_lies_behind_all_the_words_and_beside_them_the_picture_is_seen():
    """Wherever a letter stands there is the plate; it is as wide to the left of its words as to the right."""
    surface = pygame.Surface((400, 200), 0, 32)
    canvas, camera = Canvas(Look(DARK)), Camera()
    camera.fit(Frame(-2.0, -1.0, 2.0, 1.0), surface.get_rect(), 0.0)
    canvas.begin(surface, surface.get_rect(), camera)
    surface.fill("#ff00ff")
    draw_captions(canvas, (0.0, 0.8), [Caption("the longest line of them", True), Caption("short", False)])
    bare = (pygame.surfarray.array3d(surface) == (255, 0, 255)).all(axis=2)
    columns, rows = np.flatnonzero(~bare.all(axis=1)), np.flatnonzero(~bare.all(axis=0))
    assert not bare[columns[0] : columns[-1] + 1, rows[0] : rows[-1] + 1].any()
    wide = canvas.fonts.size("the longest line of them", 13, "semibold")[0]
    assert len(columns) == pytest.approx(wide + 2 * 8, abs=2)
    assert columns[0] + columns[-1] == pytest.approx(399, abs=2)


@pytest.mark.parametrize(
    ("scene_type", "content"), [(Fountain, ""), (RigidLinks, "particles = [{ position = [0, 0] }]")]
)
def test_an_unknown_readout_is_refused(scene_type, content):
    expected = 'expected = [{ readout = "warmth", value = 0 }]'
    text = f'scene = "{scene_type.name}"\n[content]\n{expected}\n{content}\n'
    with pytest.raises(LevelError, match="warmth"):
        scene_type(parse_level(text, scene_type.name, scene_type.content_type))

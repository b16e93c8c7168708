"""Hard levels say in the picture what is expected and what is measured."""

from __future__ import annotations

import pytest

from game.levels import LevelError, level_files, load_level, parse_level
from game.scenes.fountain.scene import Fountain
from game.scenes.shared.expectations import Expectation, captions_of, draw_captions
from game.scenes.springs.rigid_links import RigidLinks
from game.scenes.springs.soft_springs import Springs
from game.stage import Readout
from tests.scenes.particle_stages import open_level

SCENES = (Fountain, RigidLinks, Springs)
EXPECTING = [
    (scene, path.stem)
    for scene in SCENES
    for path in level_files(scene.name)
    if getattr(load_level(path, scene.name, scene.content_type).content, "expected", ())
]
SETTLED_S = 20.0


def captions(stage):
    return captions_of(stage.scene.model.content.expected, stage.readouts())


def test_words_and_whether_it_is_as_expected():
    entries = (Expectation(readout="kinetic", value=0.0, within=1e-9), Expectation(readout="count", value=3))
    found = captions_of(entries, [Readout("kinetic", 1e-12, "J"), Readout("count", 2)])
    assert found[0] == ("kinetic: expected 0 J, measured 0 J", True)
    assert found[1] == ("count: expected 3, measured 2", False)
    assert not captions_of(entries, [Readout("kinetic", 2.0, "J"), Readout("count", float("nan"))])[1].met


@pytest.mark.parametrize(("scene_type", "name"), EXPECTING, ids=[f"{s.name}-{n}" for s, n in EXPECTING])
def test_what_a_hard_level_expects_comes_true(scene_type, name):
    stage = open_level(scene_type, name)
    stage.run(round(SETTLED_S / stage.dt))
    assert stage.fault is None
    assert [caption.words for caption in captions(stage) if not caption.met] == []
    assert stage.scene.save_content().expected == stage.scene.model.content.expected


def test_where_a_method_fails_the_caption_says_so():
    stage = open_level(Fountain, "hard-06-fast-and-small", contact="end")
    stage.run(round(5.0 / stage.dt))
    assert captions(stage) == [("impacts: expected 4, measured 0", False)]


def test_captions_stand_below_each_other_in_the_picture():
    class Labels:
        drawn: list = []

        def label(self, place, words, color, size, weight, anchor, offset):
            self.drawn.append((place, words, color, offset))

    draw_captions(Labels(), (0.0, 4.0), [("a", True), ("b", False)])
    (_, _, first, (_, upper)), (_, _, second, (_, lower)) = Labels.drawn
    assert (first, second) == ("green", "amber") and lower > upper


@pytest.mark.parametrize(
    ("scene_type", "content"), [(Fountain, ""), (RigidLinks, "particles = [{ position = [0, 0] }]")]
)
def test_an_unknown_readout_is_refused(scene_type, content):
    expected = 'expected = [{ readout = "warmth", value = 0 }]'
    text = f'scene = "{scene_type.name}"\n[content]\n{expected}\n{content}\n'
    with pytest.raises(LevelError, match="warmth"):
        scene_type(parse_level(text, scene_type.name, scene_type.content_type))

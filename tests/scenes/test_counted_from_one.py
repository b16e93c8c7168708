"""What a person reads is counted from 1, in every scene: corners, edges, nodes, boxes, spheres, bones."""

from __future__ import annotations

import re

import pytest

from game.levels import level_files
from game.physics.narrowphase import Feature
from game.scenes import CATALOGUE
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import open_level

NUMBERED = ("c02", "c03", "c08", "c09", "c10", "c11", "c13")
LEVELS = ("default", "draw", "coins", "hard-01-parallel", "tree")
FROM_ZERO = re.compile(r"\b(?:vertex|edge|corner|node|bone|box|sphere|ball) 0\b|\b[abAB]0\b|^#0\b|^0$")


def test_a_feature_is_named_from_one_and_keeps_its_index():
    assert str(Feature("vertex", 0)) == "vertex 1" and Feature("edge", 2).index == 2


@pytest.mark.parametrize("name", NUMBERED)
def test_nothing_has_the_number_zero(name: str):
    scene_type = CATALOGUE[name].load()
    for path in level_files(name):
        if path.stem in LEVELS:
            stage = open_level(scene_type, path.stem)
            stage.run(3)
            canvas = labels_of(stage)
            stage.scene.draw(canvas, 1.0)
            assert not [words for words in canvas.drawn if FROM_ZERO.search(words)], path.stem

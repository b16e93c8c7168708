"""Hard cases of the trees say how far outlines are apart and how often they cross, and it is measured."""

from __future__ import annotations

import pytest

from game.app.stagehand.opening import read_level
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage import Stage
from game.worlds.expectations import captions_of

MOVING = {"hard-04-duplicates-clockwise", "hard-07-one-and-two-leaves"}  # the gap is another in every step
HARD = [(name, path) for name in ("c08", "c09") for path in level_files(name) if "hard" in path.stem]


@pytest.mark.parametrize(("name", "path"), HARD, ids=[f"{name}-{path.stem}" for name, path in HARD])
def test_what_a_hard_case_expects_is_measured(name, path):
    scene_type = CATALOGUE[name].load()
    stage = Stage(scene_type, level=read_level(scene_type, path))
    expected = stage.level.content.expected
    assert bool(expected) != (path.stem in MOVING)
    for _ in range(2):
        assert [c.words for c in captions_of(expected, stage.readouts()) if not c.met] == []
        stage.run(5)

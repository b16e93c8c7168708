"""Hard cases of the broad phases say what is expected, it is measured, and they stay hard."""

from __future__ import annotations

import math

import msgspec
import numpy as np
import pytest

from game.app.stagehand.opening import read_level
from game.levels import level_files
from game.scenes import CATALOGUE
from game.scenes.boxes.level import WIDTH
from game.scenes.boxes.view.outside import boxes_outside
from game.stage import Stage
from game.worlds.expectations import captions_of

HARD = [(name, path) for name in ("c05", "c06", "c07") for path in level_files(name) if "hard" in path.stem]


def stage_of(name, path, **parameters):
    scene_type = CATALOGUE[name].load()
    return Stage(scene_type, level=read_level(scene_type, path), parameters=parameters)


@pytest.mark.parametrize(("name", "path"), HARD, ids=[f"{name}-{path.stem}" for name, path in HARD])
def test_what_a_hard_case_expects_is_measured(name, path):
    stage = stage_of(name, path)
    assert stage.level.content.expected
    for _ in range(3):
        assert [
            c.words for c in captions_of(stage.level.content.expected, stage.readouts()) if not c.met
        ] == []
        stage.run(7)


@pytest.mark.parametrize("name", ["c05", "c06", "c07"])
def test_a_pair_that_is_lost_or_made_up_is_counted(name):
    path = next(path for path in level_files(name) if path.stem.startswith("hard-01"))
    model = stage_of(name, path).scene.model
    assert model.missed_pairs() == 0
    found = model.pairs
    model.pairs = found[1:]
    assert model.missed_pairs() == 1
    far = np.array([(0, len(model.boxes) - 1)])
    assert tuple(far[0]) not in set(map(tuple, found.tolist()))
    model.pairs = np.concatenate((found[1:], far))
    assert model.missed_pairs() == 2


def test_a_level_that_expects_what_is_not_measured_is_refused():
    name, path = HARD[0]
    scene_type = CATALOGUE[name].load()
    level = read_level(scene_type, path)
    wrong = msgspec.structs.replace(level.content.expected[0], readout="nothing")
    content = msgspec.structs.replace(level.content, expected=(wrong,))
    with pytest.raises(ValueError, match=r"expected\[0\].readout: no readout 'nothing'"):
        Stage(scene_type, level=msgspec.structs.replace(level, content=content))


def named(name, stem):
    return next(path for path in level_files(name) if path.stem.startswith(stem))


def test_boxes_on_one_line_stay_there_and_go_on_to_swap():
    stage = stage_of("c07", named("c07", "hard-05"), resort=False)
    model = stage.scene.model
    height = model.boxes.lowers[:, 1].copy()
    stage.run(599)
    stray = np.abs(model.boxes.lowers[:, 1] - height).max()
    assert stray <= 1.001 * stage.scene.parameters.speed * stage.dt
    before = []
    for _ in range(10):
        stage.run(1)
        before.append(model.swaps)
    assert min(before) > 0.2 * len(model.boxes) ** 2, "the order on that axis is another one in every step"


@pytest.mark.parametrize(("name", "stem"), [("c05", "hard-10"), ("broad-phase-race", "lattice")])
def test_a_lattice_comes_back_to_its_ties_in_every_second_step(name, stem):
    stage = stage_of(name, named(name, stem))
    model = stage.scene.model
    places, pairs = model.boxes.lowers.copy(), len(model.pairs)
    stage.run(301)
    assert np.abs(model.boxes.lowers - places).max() > 1e-6, "it trembles"
    stage.run(1)
    np.testing.assert_allclose(model.boxes.lowers, places, rtol=0.0, atol=1e-12)
    assert len(model.pairs) >= 0.98 * pairs


def test_what_lies_out_of_the_picture_is_told_by_its_side():
    far = {one.side: one for one in boxes_outside(stage_of("c06", named("c06", "hard-06")).scene.model)}
    assert {side: (one.boxes, one.pairs) for side, one in far.items()} == {(1, -1): (2, 1), (-1, 1): (2, 1)}
    assert far[1, -1].farthest == pytest.approx(math.hypot(1e9 - WIDTH, 1e9), rel=1e-6)
    assert far[1, -1].words == "2 boxes, 1 pair, up to 1.41 Gm away ↘"
    (row,) = boxes_outside(stage_of("c06", named("c06", "hard-05")).scene.model)
    assert row.side == (1, 0) and row.boxes >= 30 and row.farthest == pytest.approx(7936.0 - WIDTH)
    assert boxes_outside(stage_of("c06", named("c06", "hard-02")).scene.model) == [], "without end"
    assert boxes_outside(stage_of("c05", named("c05", "default")).scene.model) == []

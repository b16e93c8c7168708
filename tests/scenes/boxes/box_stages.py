"""What the tests of the broad-phase scenes share: their levels on a stage, and the plainest answer."""

from __future__ import annotations

import numpy as np

from game.levels import level_files, load_level
from game.scenes.boxes.hierarchical_grids import HierarchicalGridScene
from game.scenes.boxes.race import BroadPhaseRace
from game.scenes.boxes.sweep_and_prune import SweepAndPruneScene
from game.scenes.boxes.uniform_grid import UniformGridScene
from game.stage import Pointer, Stage

SCENES = (UniformGridScene, HierarchicalGridScene, SweepAndPruneScene, BroadPhaseRace)
LEVELS = [(scene, path) for scene in SCENES for path in level_files(scene.name)]


def level_id(value) -> str:
    return getattr(value, "name", "") if isinstance(value, type) else value.stem


def stage_of(scene_type, path, **parameters) -> Stage:
    level = load_level(path, scene_type.name, scene_type.content_type)
    return Stage(scene_type, level=level, parameters=parameters)


def open_level(scene_type, name: str, **parameters) -> Stage:
    path = next(path for path in level_files(scene_type.name) if path.stem == name)
    return stage_of(scene_type, path, **parameters)


def readouts(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.readouts()}


def brute_pairs(scene) -> list[list[int]]:
    """All pairs of a scene's boxes by comparing all with all, in slices."""
    ids = np.flatnonzero(scene.model.boxes.alive)
    low, high = (corners[ids] for corners in scene.model.boxes.covered())
    rows = []
    for begin in range(0, len(ids), 500):
        part = slice(begin, begin + 500)
        meet = (low[part, None] <= high[None]).all(axis=2) & (low[None] <= high[part, None]).all(axis=2)
        rows.append(np.argwhere(meet) + np.array([begin, 0]))
    pairs = ids[np.concatenate(rows)]
    return pairs[pairs[:, 0] < pairs[:, 1]].tolist()


def middle_of(stage: Stage, box: int) -> tuple[float, float]:
    """The centre of a box, m."""
    boxes = stage.scene.model.boxes
    x, y = (0.5 * (boxes.lowers[box] + boxes.uppers[box])).tolist()
    return x, y


def new_sentences(stage: Stage) -> list[str]:
    """What sweep and prune says of the last step."""
    model = stage.scene.model
    return model.story[len(model.story) - model.fresh :] if model.fresh else []


def drag(stage: Stage, start, end, button: int = 1, release: bool = True) -> None:
    """Press at one point, move to another, let go."""
    stage.post(Pointer("move", *start))
    stage.post(Pointer("down", *start, button=button))
    stage.post(Pointer("move", *end, button=button))
    if release:
        stage.post(Pointer("up", *end, button=button))


def click(stage: Stage, at, button: int = 1) -> None:
    drag(stage, at, at, button)

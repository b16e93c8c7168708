"""What the tests of the particle and spring scenes share."""

from __future__ import annotations

from game.levels import level_files, load_level
from game.stage import Pointer, Stage


def stage_of(scene_type, path, **parameters) -> Stage:
    level = load_level(path, scene_type.name, scene_type.content_type)
    return Stage(scene_type, level=level, parameters=parameters)


def open_level(scene_type, name: str, **parameters) -> Stage:
    path = next(path for path in level_files(scene_type.name) if path.stem == name)
    return stage_of(scene_type, path, **parameters)


def readouts(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.readouts()}


def press(stage: Stage, at, button: int = 1, shift: bool = False) -> None:
    stage.post(Pointer("down", *map(float, at), button=button, shift=shift))


def move(stage: Stage, to, button: int = 1) -> None:
    stage.post(Pointer("move", *map(float, to), button=button))


def release(stage: Stage, at, button: int = 1) -> None:
    stage.post(Pointer("up", *map(float, at), button=button))


def click(stage: Stage, at, button: int = 1, shift: bool = False) -> None:
    press(stage, at, button, shift)
    release(stage, at, button)


def drag(stage: Stage, start, end, steps: int = 10, button: int = 1, run: int = 1) -> None:
    """Press, move in so many parts with steps of the stage between, let go."""
    press(stage, start, button)
    for i in range(1, steps + 1):
        part = i / steps
        move(stage, [a + part * (b - a) for a, b in zip(start, end, strict=True)], button)
        stage.run(run)
    release(stage, end, button)

"""Stages of carom for its tests."""

from __future__ import annotations

from game.levels import level_files, load_level, parse_level
from game.scenes.carom import layout
from game.scenes.carom.scene import CaromScene
from game.stage import Pointer, Stage


def open_level(name: str = "default", **parameters) -> Stage:
    """A stage of one of the game's levels."""
    path = next(path for path in level_files("carom") if path.stem == name)
    level = load_level(path, "carom", CaromScene.content_type)
    return Stage(CaromScene, level=level, parameters=parameters)


def level_of(content: str, **parameters) -> Stage:
    """A stage of a level given as the text of its content."""
    level = parse_level(f'scene = "carom"\n[content]\n{content}', "carom", CaromScene.content_type)
    return Stage(CaromScene, level=level, parameters=parameters)


def seconds(stage: Stage, s: float) -> Stage:
    """So much simulated time, without a fault."""
    stage.run(round(s / stage.dt))
    assert stage.fault is None, stage.fault
    return stage


def until_aiming(stage: Stage, longest_s: float = 60.0) -> Stage:
    """Until the shot is over."""
    for _ in range(round(longest_s * 4)):
        if stage.scene.course.phase == "aiming":
            return stage
        seconds(stage, 0.25)
    raise AssertionError("the shot does not end")


def press(stage: Stage, x: float, y: float) -> None:
    stage.post(Pointer("move", x, y))
    stage.post(Pointer("down", x, y, button=1))


def click(stage: Stage, x: float, y: float) -> None:
    """Press and let go."""
    press(stage, x, y)
    stage.post(Pointer("up", x, y, button=1))


def click_row(stage: Stage, row: int) -> None:
    """Click on a row of the list, as the window would see it: the map is there, the click is decided upon."""
    stage.listen(at_once=True)
    click(stage, *layout.row_box(row).middle)
    stage.listen(at_once=True)


def drag(stage: Stage, start: tuple[float, float], *way: tuple[float, float], lift: bool = True) -> None:
    """Take hold at a point, move along a way, let go."""
    press(stage, *start)
    for x, y in way:
        stage.post(Pointer("move", x, y, button=1))
    if lift:
        stage.post(Pointer("up", *way[-1], button=1))

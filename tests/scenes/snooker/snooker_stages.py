"""Stages of snooker for its tests."""

from __future__ import annotations

from game.levels import level_files, load_level, parse_level
from game.scenes.snooker.scene import SnookerScene
from game.stage import Pointer, Stage


def open_level(name: str = "default", **parameters) -> Stage:
    """A stage of one of the game's levels."""
    path = next(path for path in level_files("snooker") if path.stem == name)
    level = load_level(path, "snooker", SnookerScene.content_type)
    return Stage(SnookerScene, level=level, parameters=parameters)


def level_of(content: str, **parameters) -> Stage:
    """A stage of a level given as the text of its content."""
    level = parse_level(f'scene = "snooker"\n[content]\n{content}', "snooker", SnookerScene.content_type)
    return Stage(SnookerScene, level=level, parameters=parameters)


def seconds(stage: Stage, s: float) -> Stage:
    """So much simulated time, without a fault."""
    stage.run(round(s / stage.dt))
    assert stage.fault is None, stage.fault
    return stage


def until_aiming(stage: Stage, longest_s: float = 60.0) -> Stage:
    """Until the shot is over."""
    seconds(stage, 0.1)
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
    seconds(stage, 0.02)


def drag(stage: Stage, start: tuple[float, float], *way: tuple[float, float]) -> None:
    """Take hold at a point, move along a way, let go."""
    press(stage, *start)
    for x, y in way:
        stage.post(Pointer("move", x, y, button=1))
    stage.post(Pointer("up", *way[-1], button=1))
    seconds(stage, 0.02)


def press_button(stage: Stage, name: str) -> None:
    """Click one of the buttons at the right; AssertionError if it is not there."""
    from game.scenes.snooker import layout

    names = [row[0] for row in stage.scene.hand.buttons()]
    assert name in names, names
    click(stage, *layout.button_box(names.index(name)).middle)

"""Stages of the billiard game for its tests, and what must hold whatever a hand does to it."""

import math

from game.billiards.game.rules import CUE_BALL
from game.levels import Level, level_files, load_level, parse_level
from game.scenes.billiards import layout
from game.scenes.billiards.scene import Billiards
from game.scenes.billiards.view.standing import Standing, standing_of
from game.stage import Pointer, Stage


def open_level(name: str = "default", **parameters) -> Stage:
    """A stage of one of the game's levels."""
    path = next(path for path in level_files("billiards") if path.stem == name)
    return Stage(
        Billiards, level=load_level(path, "billiards", Billiards.content_type), parameters=parameters
    )


def level_of(content: str, **parameters) -> Stage:
    """A stage of a level given as the text of its content."""
    level: Level = parse_level(
        f'scene = "billiards"\n[content]\n{content}', "billiards", Billiards.content_type
    )
    return Stage(Billiards, level=level, parameters=parameters)


def straight_pot(game: str = "practice") -> Stage:
    """The 3 before a corner pocket, the cue ball behind it on the same line, the 5 far off."""
    return level_of(
        f'game = "{game}"\nballs = [{{ number = 0, position = [0.5, 0.5] }},'
        " { number = 3, position = [0.22, 0.22] }, { number = 5, position = [0.9, 2.2] }]"
    )


AT_THE_CORNER = math.atan2(-1.0, -1.0)  # rad, aim of that pot


def standing(stage: Stage) -> Standing:
    """What the score board says."""
    return standing_of(stage.scene.play, stage.scene.opponents.thinker)


def seconds(stage: Stage, s: float) -> Stage:
    """So much simulated time, without a fault."""
    stage.run(round(s / stage.dt))
    assert stage.fault is None, stage.fault
    return stage


def until_aiming(stage: Stage, longest_s: float = 40.0) -> Stage:
    """Until the shot is over."""
    for _ in range(round(longest_s * 4)):
        if stage.scene.play.phase == "aiming":
            return stage
        seconds(stage, 0.25)
    raise AssertionError("the shot does not end")


def point(stage: Stage, kind: str, x: float, y: float, button: int = 0, **more) -> None:
    """A pointer event."""
    stage.post(Pointer(kind, x, y, button=button, **more))


def aim(stage: Stage, angle: float) -> None:
    """Turn the cue, without fine aiming in the way."""
    x, y = stage.scene.model.frame.cue_ball
    stage.scene.aiming.fine_at = math.nan
    point(stage, "move", x + 0.1 * math.cos(angle), y + 0.1 * math.sin(angle))


def drag(stage: Stage, start: tuple[float, float], end: tuple[float, float], steps: int = 4) -> None:
    """Press, move, let go."""
    point(stage, "move", *start)
    point(stage, "down", *start, button=1)
    for k in range(1, steps + 1):
        share = k / steps
        place = (start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1]))
        point(stage, "move", *place, button=1)
    point(stage, "up", *end, button=1)


def click(stage: Stage, x: float, y: float) -> None:
    """Press and let go where the pointer already is."""
    point(stage, "down", x, y, button=1)
    point(stage, "up", x, y, button=1)


def press(stage: Stage, box: layout.Box) -> None:
    """Press a button of the layout."""
    point(stage, "move", *box.middle)
    point(stage, "down", *box.middle, button=1)
    point(stage, "up", *box.middle, button=1)


def check_balls(stage: Stage) -> None:
    """No ball is lost: rules and cloth agree on which lie on the table, none outside or in another."""
    scene = stage.scene
    assert stage.fault is None, stage.fault
    frame = scene.model.frame
    numbers = [number for number, _, _ in frame.layout.places]
    assert len(set(numbers)) == len(numbers)
    if scene.play.phase in ("set-up", "rolling"):
        return
    assert {n for n in numbers if n != CUE_BALL} == set(frame.game.on_table), scene.play.phase
    if not frame.game.over and not frame.game.options:
        assert CUE_BALL in numbers
    table = frame.table
    radii = frame.layout.balls.radii
    for k, (number, x, y) in enumerate(frame.layout.places):
        assert -0.06 <= x <= table.width + 0.06 and -0.06 <= y <= table.length + 0.06, (number, x, y)
        for other, ox, oy in frame.layout.places[:k]:
            reach = 2.0 * math.sqrt(radii[number] * radii[other])
            assert math.hypot(x - ox, y - oy) > reach - 2e-6, (number, other)

"""A pointer that draws a cue back and pushes it through the ball, for tests of every cue table."""

import math
from typing import Any

from game.stage import Pointer, Stage

BACK = 0.2  # m, that the pointer draws the cue back


def course_of(stage: Stage) -> Any:
    """The course of the game in play."""
    return stage.scene.course


def push(stage: Stage, ball, angle: float, speed: float, every: int = 2, drift: float = 0.0) -> None:
    """Push along ``angle`` (rad) at ``speed`` m/s, a move each ``every`` steps; drift: m aside for each m."""
    ux, uy = math.cos(angle), math.sin(angle)
    held = course_of(stage).push

    def place(along: float, aside: float = 0.0) -> tuple[float, float]:
        reach = 0.25 + along
        return ball[0] + reach * ux - aside * uy, ball[1] + reach * uy + aside * ux

    stage.post(Pointer("move", *place(0.0)))
    stage.post(Pointer("down", *place(0.0), button=1))
    stage.run(2)
    for k in range(1, 11):
        stage.post(Pointer("move", *place(-BACK * k / 10), button=1))
        stage.run(4)
    gone = 0.0
    while held.held and gone < 2.0 * BACK:
        stage.run(every)
        gone += speed * every * stage.dt
        stage.post(Pointer("move", *place(gone - BACK, drift * gone), button=1))
    stage.post(Pointer("up", *place(gone - BACK), button=1))

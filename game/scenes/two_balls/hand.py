"""The hand in the two-ball program: it drags a ball, or the head of its velocity's arrow."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from game.scenes.two_balls.level import HEIGHT, WIDTH
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.two_balls.scene import LectureBalls

NOTHING = -1  # what is dragged: ball 0 or 1, the arrow of one as 2 or 3, or nothing
REACH = 14.0  # px, how near to a ball's arrow head the pointer takes it
ARROW = 4.0  # px of arrow for a pixel per frame
FASTEST = 60.0  # px/frame each way that an arrow can be drawn to


def take_pointer(scene: LectureBalls, event: Pointer) -> None:
    """What the pointer does to the balls."""
    if event.kind == "down" and event.button == 1:
        scene.dragged = what_is_at(scene, event.x, event.y)
    elif event.kind in ("up", "cancel"):
        scene.dragged = NOTHING
    elif event.kind == "move" and scene.dragged != NOTHING:
        ball = scene.balls[scene.dragged % 2]
        if scene.dragged < 2:
            r = ball.radius
            ball.position = (min(max(event.x, r), WIDTH - r), min(max(event.y, r), HEIGHT - r))
        else:
            x, y = ball.position
            ball.velocity = (_limited(event.x - x), _limited(event.y - y))


def _limited(way: float) -> float:
    return min(max(way / ARROW, -FASTEST), FASTEST)


def what_is_at(scene: LectureBalls, x: float, y: float) -> int:
    """The arrow head or the ball at a place, arrows first."""
    for index, ball in enumerate(scene.balls):
        head = (ball.position[0] + ARROW * ball.velocity[0], ball.position[1] + ARROW * ball.velocity[1])
        long = math.dist(head, ball.position) > 0.5 * ball.radius
        if scene.vectors and long and math.dist(head, (x, y)) < REACH:
            return index + 2
    for index, ball in enumerate(scene.balls):
        if math.dist(ball.position, (x, y)) <= ball.radius:
            return index
    return NOTHING

"""The hand in the two-ball program: it drags a ball, or the head of its velocity's arrow."""

from __future__ import annotations

from game.physics.kernels import elementary
from game.scenes.two_balls.level import HEIGHT, WIDTH
from game.scenes.two_balls.model import NOTHING, Grasp, TwoBalls
from game.stage import Part, Pointer

REACH = 14.0  # px, how near to a ball's arrow head the pointer takes it
ARROW = 4.0  # px of arrow for a pixel per frame
FASTEST = 60.0  # px/frame along each axis that an arrow can be drawn to


class TwoBallsHand(Part):
    """What the pointer holds, as a `Grasp`."""

    def __init__(self, model: TwoBalls) -> None:
        self.model = model
        self.grasp = NOTHING

    def take(self, event: Pointer) -> None:
        """What a pointer event does to the balls."""
        if event.kind == "down" and event.button == 1:
            self.grasp = self._what_is_at(event.x, event.y)
        elif event.kind in ("up", "cancel"):
            self.grasp = NOTHING
        elif event.kind == "move" and self.grasp != NOTHING:
            ball = self.model.balls[self.grasp.ball]
            if self.grasp.arrow:
                x, y = ball.position
                ball.velocity = (_limited(event.x - x), _limited(event.y - y))
            else:
                r = ball.radius
                ball.position = (min(max(event.x, r), WIDTH - r), min(max(event.y, r), HEIGHT - r))

    def _what_is_at(self, x: float, y: float) -> Grasp:
        """The arrow head or the ball at a place, arrows first."""
        for index, ball in enumerate(self.model.balls):
            head = (ball.position[0] + ARROW * ball.velocity[0], ball.position[1] + ARROW * ball.velocity[1])
            long = elementary.dist(head, ball.position) > 0.5 * ball.radius
            if self.model.parameters.vectors and long and elementary.dist(head, (x, y)) < REACH:
                return Grasp(index, arrow=True)
        for index, ball in enumerate(self.model.balls):
            if elementary.dist(ball.position, (x, y)) <= ball.radius:
                return Grasp(index)
        return NOTHING


def _limited(length: float) -> float:
    """Velocity, px/frame, of an arrow so long along an axis, px."""
    return min(max(length / ARROW, -FASTEST), FASTEST)

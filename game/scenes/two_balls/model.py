"""The two balls of the program, frame by frame: their collisions, and what is remembered of the last one."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.lecture.ball import Ball
from game.billiards.lecture.ball_collision import Collision
from game.billiards.lecture.state import BALL_COLLISIONS, FRICTION, MINIMUM_SPEED, WALLS
from game.billiards.table import passing
from game.physics.effects import EffectSet
from game.physics.kernels import elementary, linear
from game.scenes.two_balls import record
from game.scenes.two_balls.level import HEIGHT, WIDTH, LectureBallsContent, entry_of
from game.scenes.two_balls.parameters import LectureBallsParameters
from game.stage import Part

NEXT_START_S = 2.5  # s at rest before the balls set off again
BOTH = np.ones(2, dtype=np.bool_)


class LectureBallsState(NamedTuple):
    """positions, velocities (2, 2) px and px/frame; last (36,), the record of the last collision.

    walls (2, 5): each ball's last overshoot, see record.py.
    """

    positions: Floats
    velocities: Floats
    last: Floats
    walls: Floats


class Grasp(NamedTuple):
    """What the hand holds: a ball, or the arrow of its velocity; ball -1 is nothing."""

    ball: int = -1
    arrow: bool = False


NOTHING = Grasp()


class TwoBalls(Part):
    """Both balls in the window; effects: those that are active. ``seed``: of the starts after the first."""

    def __init__(
        self, content: LectureBallsContent, parameters: LectureBallsParameters, effects: EffectSet, seed: int
    ) -> None:
        self.content = content
        self.parameters = parameters
        self.effects = effects
        self.seed = seed
        self.starts = 0
        self.collisions = 0
        self.frames = 0
        self.hold_s = 0.0  # s that the last collision is still held
        self.rest_s = 0.0
        self.momentum_lost = 0.0
        self.energy_lost = 0.0
        self.last = np.zeros(record.WIDTH)
        self.walls = np.zeros((2, 5))
        self.walls[:, record.AGE] = record.LONG_AGO
        self.unseen = 0
        self.passed: tuple[float, ...] = ()  # the frame, and both places, of the last contact not noticed
        self.balls = self._new_balls()

    # -- the balls ----------------------------------------------------------------------------------

    def _new_balls(self) -> list[Ball]:
        """The balls at their start, with walls, friction and minimum speed as the effects have them."""
        chosen = self.parameters
        balls = []
        for entry, radius, mass in zip(
            (self.content.ball_1, self.content.ball_2),
            (chosen.radius_1, chosen.radius_2),
            (1.0, chosen.mass_ratio),
            strict=True,
        ):
            ball = Ball(
                entry.position[0],
                entry.position[1],
                radius,
                mass=mass,
                bounce=chosen.bounce,
                friction=chosen.friction if FRICTION in self.effects else 1.0,
                minimum_speed=chosen.minimum_speed if MINIMUM_SPEED in self.effects else 0.0,
            )
            if WALLS in self.effects:
                ball.set_bounds(0.0, WIDTH, 0.0, HEIGHT)
            ball.velocity = entry.velocity
            balls.append(ball)
        return balls

    def renew_balls(self) -> None:
        """Give the balls the present parameters and effects, where they are."""
        old = self.balls
        self.balls = self._new_balls()
        for ball, before in zip(self.balls, old, strict=True):
            ball.position, ball.velocity = before.position, before.velocity

    def change_effects(self, effects: EffectSet) -> None:
        """Compute these effects from now on."""
        self.effects = effects
        self.renew_balls()

    def state(self) -> LectureBallsState:
        """All that later frames depend on."""
        return LectureBallsState(
            np.array([ball.position for ball in self.balls]),
            np.array([ball.velocity for ball in self.balls]),
            self.last,
            self.walls,
        )

    def restore(self, state: LectureBallsState) -> None:
        """Take over a state."""
        self.renew_balls()
        for ball, position, velocity in zip(
            self.balls, state.positions.tolist(), state.velocities.tolist(), strict=True
        ):
            ball.position, ball.velocity = tuple(position), tuple(velocity)
        self.last[:] = state.last
        self.walls[:] = state.walls

    def content_now(self) -> LectureBallsContent:
        """The level as it stands."""
        first, second = (entry_of(ball.position, ball.velocity) for ball in self.balls)
        return LectureBallsContent(ball_1=first, ball_2=second)

    # -- one frame ----------------------------------------------------------------------------------

    def advance(self, dt: float, grasp: Grasp) -> None:
        """One frame; a ball that is held stays where it is, and a collision that is held stops both."""
        self.walls[:, record.AGE] = np.minimum(self.walls[:, record.AGE] + dt, record.LONG_AGO)
        if self.hold_s > 0.0:
            self.hold_s = max(self.hold_s - dt, 0.0)
            return
        self.frames += 1
        before = [ball.position for ball in self.balls]
        straight = True
        for index, ball in enumerate(self.balls):
            if grasp != (index, False):
                ball.acceleration = self._acceleration_of(ball)
                overshoot = ball.update()
                if overshoot is not None and record.write_overshoot(self.walls[index], ball, overshoot):
                    straight = False
        if BALL_COLLISIONS in self.effects:
            rule, restitution = self.parameters.rule, self.parameters.restitution
            collision = self.balls[0].handle_collision(self.balls[1], rule, restitution)
            if collision is not None:
                self._note_collision(collision)
            elif straight:
                self._note_passing(before)
        resting = all(ball.speed == 0.0 for ball in self.balls)
        self.rest_s = self.rest_s + dt if resting else 0.0
        if self.parameters.again and self.rest_s > NEXT_START_S and grasp == NOTHING:
            self.start_again()

    def _acceleration_of(self, ball: Ball) -> tuple[float, float]:
        """What is added to a velocity in a frame, px/frame²: the acceleration, less what slows down.

        A deceleration ends where the ball stands; it does not turn it round.
        """
        chosen, (vx, vy), speed = self.parameters, ball.velocity, ball.speed
        turn = math.radians(chosen.direction)
        lost = min(chosen.deceleration, speed) / speed if speed > 0.0 else 0.0
        return (
            chosen.acceleration * elementary.cos(turn) - lost * vx,
            chosen.acceleration * elementary.sin(turn) - lost * vy,
        )

    def release(self) -> None:
        """Go on from a collision that is held."""
        self.hold_s = 0.0

    def start_again(self) -> None:
        """Both balls set off from where they are, with other velocities."""
        self.starts += 1
        self.rest_s = self.hold_s = 0.0
        random = np.random.default_rng((self.seed, self.starts))
        for ball in self.balls:
            ball.set_speed_and_angle(
                linear.uniform(random, 8.0, 22.0), linear.uniform(random, -math.pi, math.pi)
            )

    def _note_collision(self, c: Collision) -> None:
        """Keep the record of a collision, and hold the picture if asked to."""
        if c.exchanged:
            self.collisions += 1
            self.momentum_lost += record.momentum_lost((*c.momentum_before, *c.momentum_after))
            self.energy_lost += c.energy_before - c.energy_after
            self.hold_s = self.parameters.hold
        if c.exchanged or self.last[record.OVERLAP] == 0.0:
            record.write_collision(self.last, c)

    def _note_passing(self, before: list[tuple[float, float]]) -> None:
        """Count a contact that came and went between two frames, and keep where it was."""
        now = [ball.position for ball in self.balls]
        radii = np.array([ball.radius for ball in self.balls])
        found = np.zeros((1, passing.COLUMNS))
        if passing.find_passed(np.array(before), np.array(now), radii, BOTH, found):
            self.unseen += 1
            self.passed = (self.frames, *found[0, 2:].tolist())

"""The two-ball program of the lecture, with every step of its collision made visible."""

from __future__ import annotations

import math
from collections import deque
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.lecture.ball import Ball
from game.billiards.lecture.ball_collision import Collision
from game.billiards.lecture.slips import SLIPS
from game.billiards.lecture.state import BALL_COLLISIONS, FRICTION, MINIMUM_SPEED, WALLS
from game.billiards.table import passing
from game.lab.studies.billiards.lecture_table import one_collision_study
from game.levels import Level
from game.scenes.two_balls import LECTURE_BALLS, hand, record, view
from game.scenes.two_balls.figure import draw_exchange
from game.scenes.two_balls.level import HEIGHT, WIDTH, LectureBallsContent, entry_of
from game.scenes.two_balls.parameters import LectureBallsParameters
from game.stage import (
    Equation,
    Frame,
    Hint,
    Pointer,
    Readout,
    SceneAction,
    Strip,
    WarmUp,
)
from game.ui.painters import ball as ball_painter

Array = NDArray[np.float64]

FRAME_RATE = 30.0  # 1/s, of the lecture's main loop
METRES = 0.004  # m to a pixel, where the lecture's window is taken as a table
NEXT_START_S = 2.5  # s at rest before the balls set off again
BOTH = np.ones(2, dtype=np.bool_)


class LectureBallsState(NamedTuple):
    """positions, velocities (2, 2) px and px/frame; last (36,), the record of the last collision.

    walls (2, 5): each ball's last overshoot, see lecture_balls_record.
    """

    positions: Array
    velocities: Array
    last: Array
    walls: Array


class LectureBalls(LectureBallsParameters):
    """Two balls in a window, as the lecture's program has them: pixels, and a velocity added to the
    position in every frame. A ball beyond a wall is put back by its overshoot and turned round. When the
    circles overlap, the program finds the angle of the line of centres, moves both balls by half of the
    overlap, turns the velocities into the frame of the collision, changes the parts along the line, and
    turns them back.

    On the right the last collision is held and these steps are shown one by one. Choose "as printed" to
    run the listing as the slides have it: in two places x and y are not swapped, one assignment exchanges
    what should stay, and the loss is taken from the whole velocities. The strip shows the momentum that
    disappears; with the conserving rule, restitution acts on the normal part alone, and momentum is kept to
    rounding.
    """

    name, task, title = LECTURE_BALLS.names
    study = one_collision_study
    dt = 1.0 / FRAME_RATE
    unit = "px"
    y_up = False
    content_type = LectureBallsContent

    strips = (
        Strip("Momentum", "", ("right", "down")),
        Strip("Energy", "", ("energy",)),
        Strip("Momentum lost", "", ("momentum lost",)),
    )
    hints = (Hint(("Drag",), "move a ball, or its arrow"), Hint(("H",), "go on from a held collision"))
    actions = (
        SceneAction("release", "go on", "H"),
        SceneAction("again", "start again", "R"),
    )
    figure = staticmethod(draw_exchange)
    equations = (
        Equation("Line of centres", r"\alpha = \atan2(y_1 - y_2, x_1 - x_2)", "the lecture"),
        Equation(
            "Into its frame",
            r"p_x = v_x \cos\alpha + v_y \sin\alpha,  p_y = v_y \cos\alpha - v_x \sin\alpha",
            "rotation by −α",
        ),
        Equation("Equal masses, no loss", r"p_{1x}' = p_{2x},  p_{2x}' = p_{1x}", "the lecture"),
        Equation(
            "Any masses, restitution e", r"j = \frac{(1+e)(p_{2x} - p_{1x})}{1/m_1 + 1/m_2}", "Newton 1687"
        ),
        Equation(
            "Back again",
            r"v_x = p_x \cos\alpha - p_y \sin\alpha,  v_y = p_y \cos\alpha + p_x \sin\alpha",
            "rotation by α",
        ),
        Equation("Slip 1 of the listing", r"p_y = v_x \cos\alpha - v_y \sin\alpha", "x, y not swapped"),
        Equation("Slip 2", r"p_{1y}' = p_{2y},  p_{2y}' = p_{1y}", "exchanged, should stay"),
        Equation("Slip 3", r"v_y = p_x \cos\alpha + p_y \sin\alpha", "x, y not swapped"),
    )
    try_this = (
        "Choose as printed and watch the momentum: " + SLIPS[0].effect,
        "Slip 2: " + SLIPS[1].effect,
        "Slip 3: " + SLIPS[2].effect,
        "Drag an arrow's head to aim one ball past the other: the thinner the hit, the less is exchanged.",
        "Make ball 2 a hundred times heavier: the light ball bounces off, the sum of momenta stays.",
    )

    # -- building -----------------------------------------------------------------------------------

    def build(self, level: Level | None) -> None:
        content = level.content if level is not None and level.content is not None else LectureBallsContent()
        self.content: LectureBallsContent = content
        self.starts = 0
        self.collisions = 0
        self.frames = 0
        self.hold_s = 0.0
        self.rest_s = 0.0
        self.momentum_lost = 0.0
        self.energy_lost = 0.0
        self.dragged = hand.NOTHING
        self.told: deque[str] = deque(maxlen=8)
        self.last = np.zeros(record.WIDTH)
        self.walls = np.zeros((2, 5))
        self.walls[:, record.AGE] = record.LONG_AGO
        self.unseen = 0
        self.passed: tuple[float, ...] = ()  # the frame, and both places, of the last contact not noticed
        self.balls = self._new_balls()

    def _new_balls(self) -> list[Ball]:
        """The balls at their start, with walls, friction and minimum speed as the effects have them."""
        balls = []
        for entry, radius, mass in zip(
            (self.content.ball_1, self.content.ball_2),
            (self.radius_1, self.radius_2),
            (1.0, self.mass_ratio),
            strict=True,
        ):
            ball = Ball(
                entry.position[0],
                entry.position[1],
                radius,
                mass=mass,
                bounce=self.bounce,
                friction=self.friction if FRICTION in self.active else 1.0,
                minimum_speed=self.minimum_speed if MINIMUM_SPEED in self.active else 0.0,
            )
            if WALLS in self.active:
                ball.set_bounds(0.0, WIDTH, 0.0, HEIGHT)
            ball.velocity = entry.velocity
            balls.append(ball)
        return balls

    def _renew_balls(self) -> None:
        """Balls with the present settings, where they are."""
        old = self.balls
        self.balls = self._new_balls()
        for ball, before in zip(self.balls, old, strict=True):
            ball.position, ball.velocity = before.position, before.velocity

    def parameter_changed(self, name: str) -> None:
        if name in ("bounce", "friction", "minimum_speed"):
            self._renew_balls()

    def effects_changed(self) -> None:
        self._renew_balls()

    def state(self) -> LectureBallsState:
        return LectureBallsState(
            np.array([ball.position for ball in self.balls]),
            np.array([ball.velocity for ball in self.balls]),
            self.last,
            self.walls,
        )

    def restore(self, state: LectureBallsState) -> None:
        self._renew_balls()
        for ball, position, velocity in zip(
            self.balls, state.positions.tolist(), state.velocities.tolist(), strict=True
        ):
            ball.position, ball.velocity = tuple(position), tuple(velocity)
        self.last[:] = state.last
        self.walls[:] = state.walls

    @classmethod
    def warm_ups(cls) -> list[WarmUp]:
        return [
            WarmUp("two balls", lambda: cls().advance(cls.dt)),
            WarmUp("unseen contacts", passing.warm_up),
            *(WarmUp(*row) for row in ball_painter.WARM_UPS),
        ]

    # -- one frame ----------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        self.walls[:, record.AGE] = np.minimum(self.walls[:, record.AGE] + dt, record.LONG_AGO)
        if self.hold_s > 0.0:
            self.hold_s = max(self.hold_s - dt, 0.0)
            return
        self.frames += 1
        before = [ball.position for ball in self.balls]
        straight = True
        for index, ball in enumerate(self.balls):
            if self.dragged != index:
                overshoot = ball.update()
                if overshoot is not None and record.write_overshoot(self.walls[index], ball, overshoot):
                    straight = False
        if BALL_COLLISIONS in self.active:
            collision = self.balls[0].handle_collision(self.balls[1], self.rule, self.restitution)
            if collision is not None:
                self._note_collision(collision)
            elif straight:
                self._note_passing(before)
        self._start_again(dt)

    def _note_collision(self, c: Collision) -> None:
        """Keep the record of a collision, and hold the picture if asked to."""
        if c.exchanged:
            self.collisions += 1
            self.momentum_lost += record.momentum_lost((*c.momentum_before, *c.momentum_after))
            self.energy_lost += c.energy_before - c.energy_after
            self.hold_s = self.hold
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

    def _start_again(self, dt: float) -> None:
        """After a while at rest both balls set off once more, with other velocities."""
        resting = all(ball.speed == 0.0 for ball in self.balls)
        self.rest_s = self.rest_s + dt if resting else 0.0
        if self.again and self.rest_s > NEXT_START_S and self.dragged < 0:
            self.action("again")

    # -- the hand -----------------------------------------------------------------------------------

    def pointer(self, event: Pointer) -> None:
        hand.take_pointer(self, event)

    def action(self, name: str) -> None:
        if name == "release":
            self.hold_s = 0.0
        elif name == "again":
            self.starts += 1
            self.rest_s = self.hold_s = 0.0
            random = np.random.default_rng((self.seed, self.starts))
            for ball in self.balls:
                ball.set_speed_and_angle(random.uniform(8.0, 22.0), random.uniform(-math.pi, math.pi))

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return view.FRAME

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw(self, canvas, alpha)

    def legend(self) -> tuple[tuple[str, str, str], ...]:
        return ()

    def readouts(self) -> tuple[Readout, ...]:
        speed_unit, momentum_unit, energy_unit, speed, energy = self.measures()
        px = sum(ball.momentum[0] for ball in self.balls)
        py = sum(ball.momentum[1] for ball in self.balls)
        return (
            Readout("collisions", self.collisions),
            Readout("speed of 1", self.balls[0].speed * speed, speed_unit),
            Readout("speed of 2", self.balls[1].speed * speed, speed_unit),
            Readout("energy", sum(ball.energy for ball in self.balls) * energy, energy_unit),
            Readout("right", px * speed, momentum_unit),
            Readout("down", py * speed, momentum_unit),
            Readout("momentum lost", self.momentum_lost * speed, momentum_unit),
            Readout("energy lost", self.energy_lost * energy, energy_unit),
            Readout("passed unseen", self.unseen),
        )

    def measures(self) -> tuple[str, str, str, float, float]:
        """Units of speed, momentum and energy, and the factors that take pixels per frame to them."""
        if self.units == "pixels":
            return "px/frame", "kg px/frame", "kg px²/frame²", 1.0, 1.0
        factor = METRES * FRAME_RATE
        return "m/s", "kg m/s", "J", factor, factor * factor

    def messages(self) -> list[str]:
        told = list(self.told)
        self.told.clear()
        return told

    def save_content(self) -> LectureBallsContent:
        first, second = (entry_of(ball.position, ball.velocity) for ball in self.balls)
        return LectureBallsContent(ball_1=first, ball_2=second)

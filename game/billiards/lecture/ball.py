"""The lecture's ball: it moves, turns round at walls, slows down, and collides with another ball.

Lengths are pixels and times frames, as in the lecture (``update()``), or metres and seconds (``update(dt)``
with dt in s): nothing here depends on which. The ball knows no screen; it hands itself to a painter.

Source: K. Peters, chapter 3 of "Flash MX 2004 Games Most Wanted" (Apress 2004), as taught. Where the printed
listing slips, `slips.SLIPS` says how, and the rule ``as-printed`` computes it so.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Protocol

from game.billiards.lecture.ball_collision import Collision, Parts, in_collision_frame, sum_of
from game.billiards.lecture.contacts import exchange_as_lectured
from game.billiards.lecture.settings import RULES
from game.physics.kernels import elementary


class Bounds(NamedTuple):
    """Walls that limit the motion; `low` is the upper edge of a screen whose y points down."""

    left: float
    right: float
    low: float
    high: float


class Overshoot(NamedTuple):
    """How far a ball was beyond each wall before it was put back; negative inside."""

    left: float
    right: float
    low: float
    high: float


class BallPainter(Protocol):
    """Anything that can draw a ball."""

    def ball(self, position: tuple[float, float], radius: float, colour: Any) -> None:
        """Draw a ball at a position, in the unit of the ball, of a colour that the painter knows."""


class Ball:
    """A round thing that moves. ValueError for numbers that are not finite, or a radius or mass not positive.

    bounce: part of the speed that is left after a wall. friction: factor on the velocity at each update.
    minimum_speed: what is slower stops. acceleration: added to the velocity at each update (times dt).
    """

    def __init__(
        self,
        x: float,
        y: float,
        radius: float,
        colour: Any = "white",
        mass: float = 1.0,
        *,
        bounce: float = 1.0,
        friction: float = 1.0,
        minimum_speed: float = 0.0,
    ) -> None:
        self._x, self._y = _finite("position", x, y)
        self._vx = self._vy = 0.0
        self._ax = self._ay = 0.0
        self._bounds: Bounds | None = None
        self.radius = _in_range("radius", radius, 0.0, math.inf, low_open=True)
        self.mass = _in_range("mass", mass, 0.0, math.inf, low_open=True)
        self.bounce = _in_range("bounce", bounce, 0.0, 1.0)
        self.friction = _in_range("friction", friction, 0.0, 1.0)
        self.minimum_speed = _in_range("minimum_speed", minimum_speed, 0.0, math.inf)
        self.colour = colour

    # -- position, velocity, acceleration

    @property
    def position(self) -> tuple[float, float]:
        """Where the centre is; ValueError for numbers that are not finite, as for all that can be set."""
        return self._x, self._y

    @position.setter
    def position(self, position: tuple[float, float]) -> None:
        self._x, self._y = _finite("position", *position)

    @property
    def velocity(self) -> tuple[float, float]:
        """Components: how far it goes along x and y in one unit of time."""
        return self._vx, self._vy

    @velocity.setter
    def velocity(self, velocity: tuple[float, float]) -> None:
        self._vx, self._vy = _finite("velocity", *velocity)

    @property
    def acceleration(self) -> tuple[float, float]:
        """What is added to the velocity in one unit of time."""
        return self._ax, self._ay

    @acceleration.setter
    def acceleration(self, acceleration: tuple[float, float]) -> None:
        self._ax, self._ay = _finite("acceleration", *acceleration)

    @property
    def speed(self) -> float:
        """Magnitude of the velocity: one number, never negative."""
        return math.sqrt(self._vx * self._vx + self._vy * self._vy)

    @property
    def angle(self) -> float:
        """Direction of the velocity, rad from the x axis; 0 at rest."""
        return elementary.atan2(self._vy, self._vx)

    def set_speed_and_angle(self, speed: float, angle: float) -> None:
        """Velocity by magnitude and direction (rad): components speed cos(angle), speed sin(angle)."""
        speed = _in_range("speed", speed, 0.0, math.inf)
        (angle, _) = _finite("angle", angle, 0.0)
        self.velocity = speed * elementary.cos(angle), speed * elementary.sin(angle)

    @property
    def momentum(self) -> tuple[float, float]:
        """Mass times velocity."""
        return self.mass * self._vx, self.mass * self._vy

    @property
    def energy(self) -> float:
        """Kinetic energy of translation."""
        return 0.5 * self.mass * (self._vx * self._vx + self._vy * self._vy)

    @property
    def bounds(self) -> Bounds | None:
        """The walls, or None if there are none."""
        return self._bounds

    def set_bounds(self, left: float, right: float, low: float, high: float) -> None:
        """Walls at x = left, right and y = low, high. ValueError if the ball does not fit between them."""
        left, right = _finite("bounds", left, right)
        low, high = _finite("bounds", low, high)
        if right - left < 2.0 * self.radius or high - low < 2.0 * self.radius:
            raise ValueError(f"bounds: a ball of radius {self.radius:g} does not fit between the walls")
        self._bounds = Bounds(left, right, low, high)

    # -- one frame

    def update(self, dt: float = 1.0) -> Overshoot | None:
        """One frame, or dt: accelerate, move, turn round at walls, slow down.

        Returns how far the ball was beyond the walls before it was put back; None without bounds.
        """
        dt = _in_range("dt", dt, 0.0, math.inf, low_open=True)
        self._vx += self._ax * dt
        self._vy += self._ay * dt
        self._x += self._vx * dt
        self._y += self._vy * dt
        overshoot = self.collide_with_walls()
        self._vx *= self.friction
        self._vy *= self.friction
        if self.speed < self.minimum_speed:
            self._vx = self._vy = 0.0
        return overshoot

    def collide_with_walls(self) -> Overshoot | None:
        """Put the ball back from walls it overshot; turn round the part of the velocity that led there."""
        if self._bounds is None:
            return None
        left, right, low, high = self._bounds
        overshoot = Overshoot(
            left - (self._x - self.radius),
            (self._x + self.radius) - right,
            low - (self._y - self.radius),
            (self._y + self.radius) - high,
        )
        if overshoot.right > 0.0:
            self._x -= overshoot.right
        elif overshoot.left > 0.0:
            self._x += overshoot.left
        if overshoot.high > 0.0:
            self._y -= overshoot.high
        elif overshoot.low > 0.0:
            self._y += overshoot.low
        # only a ball that still moves outwards is turned round: one that is leaving already would stick
        if (overshoot.right > 0.0 and self._vx > 0.0) or (overshoot.left > 0.0 and self._vx < 0.0):
            self._vx = -self._vx * self.bounce
        if (overshoot.high > 0.0 and self._vy > 0.0) or (overshoot.low > 0.0 and self._vy < 0.0):
            self._vy = -self._vy * self.bounce
        return overshoot

    # -- two balls

    def handle_collision(
        self, other: Ball, rule: str = "conserving", restitution: float = 1.0
    ) -> Collision | None:
        """Separate two balls that overlap and change their velocities; None if they do not overlap.

        rule: `conserving`, restitution on the normal part, any masses: momentum is kept to rounding.
        `scaled`: normal parts exchanged (equal masses), then both whole velocities times `restitution`: of
        the momentum that share is left. `as-printed`: the same by the printed listing, with its SLIPS, also
        where the balls are separating already. Each ball is moved by half of the overlap, whatever it weighs.
        ValueError for another rule, or a restitution that is not 0 to 1.
        """
        if rule not in RULES:
            raise ValueError(f"rule: must be one of {', '.join(RULES)}, got {rule!r}")
        restitution = _in_range("restitution", restitution, 0.0, 1.0)
        dx, dy = self._x - other._x, self._y - other._y
        distance = math.sqrt(dx * dx + dy * dy)
        overlap = self.radius + other.radius - distance
        if not overlap > 0.0:
            return None
        angle = elementary.atan2(dy, dx)
        cosa = dx / distance if distance > 0.0 else 1.0
        sina = dy / distance if distance > 0.0 else 0.0
        places, velocities = (self.position, other.position), (self.velocity, other.velocity)
        momentum, energy = sum_of(self.momentum, other.momentum), self.energy + other.energy
        parts = in_collision_frame(velocities[0], cosa, sina), in_collision_frame(velocities[1], cosa, sina)
        reach = other.radius - 0.5 * overlap
        contact = other._x + reach * cosa, other._y + reach * sina
        self._separate_from(other, overlap, cosa, sina)
        exchanged = rule == "as-printed" or parts[1].normal > parts[0].normal
        if exchanged and rule == "conserving":
            self._exchange_conserving(other, parts, cosa, sina, restitution)
        elif exchanged:
            self._vx, self._vy, other._vx, other._vy = exchange_as_lectured(
                *self.velocity, *other.velocity, cosa, sina, restitution, rule == "as-printed"
            )
        after = in_collision_frame(self.velocity, cosa, sina), in_collision_frame(other.velocity, cosa, sina)
        return Collision(
            rule, distance, overlap, angle, cosa, sina, contact, places, (self.position, other.position),
            velocities, (self.velocity, other.velocity), parts, after, exchanged,
            momentum, sum_of(self.momentum, other.momentum), energy, self.energy + other.energy,
        )  # fmt: skip

    def _separate_from(self, other: Ball, overlap: float, cosa: float, sina: float) -> None:
        """Move each of two balls half of the overlap, along the line of centres."""
        self._x += 0.5 * overlap * cosa
        self._y += 0.5 * overlap * sina
        other._x -= 0.5 * overlap * cosa
        other._y -= 0.5 * overlap * sina

    def _exchange_conserving(
        self, other: Ball, parts: tuple[Parts, Parts], cosa: float, sina: float, restitution: float
    ) -> None:
        """Equal and opposite impulses along the line of centres: (1 + e) v_n / (1/m1 + 1/m2)."""
        approach = parts[1].normal - parts[0].normal
        impulse = (1.0 + restitution) * approach / (1.0 / self.mass + 1.0 / other.mass)
        self._vx += impulse / self.mass * cosa
        self._vy += impulse / self.mass * sina
        other._vx -= impulse / other.mass * cosa
        other._vy -= impulse / other.mass * sina

    # -- picture

    def draw(self, painter: BallPainter) -> None:
        """Hand over what there is to be drawn."""
        painter.ball(self.position, self.radius, self.colour)


def _finite(name: str, first: float, second: float) -> tuple[float, float]:
    """Both as floats; ValueError if one is not a finite number."""
    for value in (first, second):
        if isinstance(value, str | bool) or not math.isfinite(value):
            raise ValueError(f"{name}: must be finite numbers, got {value!r}")
    return float(first), float(second)


def _in_range(name: str, value: float, low: float, high: float, *, low_open: bool = False) -> float:
    """The value as a float; ValueError if it is not a finite number from low to high."""
    good = not isinstance(value, str | bool) and math.isfinite(value) and low <= value <= high
    if not good or (low_open and value == low):
        bound = "above" if low_open else "at least"
        upper = "" if math.isinf(high) else f" and at most {high:g}"
        raise ValueError(f"{name}: must be finite, {bound} {low:g}{upper}, got {value!r}")
    return float(value)

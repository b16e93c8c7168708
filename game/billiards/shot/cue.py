"""The stroke: from cue speed, aim and tip offset to the ball's velocity and spin.

An instant, point-like, elastic impact of the cue, which does not rub off its tip. (Alciatore, technical proof
A.30, The effects of elevation and tip offset on cue ball motion; Leckie and Greenspan 2006.) A tip beside the
centre also pushes the cue's end aside, and the ball the other way: squirt, after Alciatore, technical proof
A.31, with the effective mass of the cue's end.

A raised cue pushes the ball into the slate as well, `Strike.pressed`: cue first, then slate (`flight.slate`),
though the two impacts overlap.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.physics.kernels import elementary

CUE_MASS = 0.567  # kg; 20 ounces
CUE_END_MASS = BALL_MASS / 30.0  # kg; what the end of the cue moves aside, a usual cue


class Strike(NamedTuple):
    """A struck ball: velocity m/s and spin rad/s, three components each, in the table's frame."""

    velocity: tuple[float, float, float]
    spin: tuple[float, float, float]

    def pressed(self, elevation: float) -> tuple[float, float, float]:
        """The velocity with its part into the slate: the ball is pushed along the cue, raised by rad."""
        x, y, _ = self.velocity
        return x, y, -math.sqrt(x * x + y * y) * elementary.tan(elevation)


def strike(
    cue_speed: float,
    azimuth: float,
    elevation: float = 0.0,
    tip_left: float = 0.0,
    tip_up: float = 0.0,
    *,
    ball_mass: float = BALL_MASS,
    ball_radius: float = BALL_RADIUS,
    cue_mass: float = CUE_MASS,
    cue_end_mass: float | None = CUE_END_MASS,
) -> Strike:
    """Velocity and spin of a ball struck by a cue.

    cue_speed m/s. azimuth: direction of the stroke, rad from the x axis. elevation of the cue's butt, rad, 0
    to below pi/2. tip_left, tip_up: where the tip meets the ball, in ball radii from its centre, seen along
    the cue. Masses kg, radius m. cue_end_mass None: no squirt. ValueError names an absurd argument.
    """
    _check(cue_speed, azimuth, elevation, tip_left, tip_up, ball_mass, ball_radius, cue_mass, cue_end_mass)
    cosine, sine = elementary.cos(elevation), elementary.sin(elevation)
    a, b = tip_left, tip_up
    c = math.sqrt(1.0 - a * a - b * b)
    k = 0.4 * ball_radius * ball_radius
    # the tip in the frame of the cue: A to the left, B up, C towards the butt
    A = ball_radius * a
    B = ball_radius * (sine * c + cosine * b)
    C = ball_radius * (cosine * c - sine * b)
    lever = B * cosine - C * sine
    speed = 2.0 * cue_speed / (1.0 + ball_mass / cue_mass + (A * A + lever * lever) / k)
    spin = (speed / k * lever, speed / k * A * sine, -speed / k * A * cosine)
    turn = azimuth + 0.5 * math.pi
    squirt = 0.0
    if cue_end_mass is not None:
        rest = 1.0 - a * a
        squirt = -elementary.atan2(2.5 * a * math.sqrt(rest), 1.0 + ball_mass / cue_end_mass + 2.5 * rest)
    velocity_x, velocity_y = _turned(0.0, -speed * cosine, turn + squirt)
    spin_x, spin_y = _turned(spin[0], spin[1], turn)
    return Strike((velocity_x, velocity_y, 0.0), (spin_x, spin_y, spin[2]))


def speed_ratio(ball_mass: float = BALL_MASS, cue_mass: float = CUE_MASS) -> float:
    """Speed of a ball struck in its centre over that of the cue: what a speed shown for the ball is divided
    by to be that of the cue. Masses kg."""
    return 2.0 / (1.0 + ball_mass / cue_mass)


def _turned(x: float, y: float, angle: float) -> tuple[float, float]:
    cosine, sine = elementary.cos(angle), elementary.sin(angle)
    return cosine * x - sine * y, sine * x + cosine * y


def _check(
    cue_speed: float,
    azimuth: float,
    elevation: float,
    tip_left: float,
    tip_up: float,
    ball_mass: float,
    ball_radius: float,
    cue_mass: float,
    cue_end_mass: float | None,
) -> None:
    """ValueError for what no stroke can be."""
    for name, value in (("azimuth", azimuth), ("tip_left", tip_left), ("tip_up", tip_up)):
        if not math.isfinite(value):
            raise ValueError(f"strike {name}: must be finite, got {value!r}")
    if not (math.isfinite(cue_speed) and 0.0 <= cue_speed <= 1e3):
        raise ValueError(f"strike cue_speed: must be 0 to 1000 m/s, got {cue_speed!r}")
    if not 0.0 <= elevation < 0.5 * math.pi:
        raise ValueError(f"strike elevation: must be 0 to below pi/2, got {elevation!r}")
    if tip_left * tip_left + tip_up * tip_up >= 1.0:
        raise ValueError("strike tip_left, tip_up: the tip misses the ball")
    masses = {"ball_mass": ball_mass, "ball_radius": ball_radius, "cue_mass": cue_mass}
    if cue_end_mass is not None:
        masses["cue_end_mass"] = cue_end_mass
    for name, value in masses.items():
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"strike {name}: must be positive and finite, got {value!r}")

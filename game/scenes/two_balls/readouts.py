"""What the two-ball program measures, in pixels and frames or in SI units."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.scenes.two_balls.level import FRAME_RATE
from game.scenes.two_balls.model import TwoBalls
from game.stage import Readout

METRES = 0.004  # m to a pixel, where the lecture's window is taken as a table


class Measures(NamedTuple):
    """Units of speed, momentum and energy, and the factors that take pixels per frame to them."""

    speed_unit: str
    momentum_unit: str
    energy_unit: str
    speed: float
    energy: float


def measures_in(units: str) -> Measures:
    """Measures for one of the options of the parameter "units"."""
    if units == "pixels":
        return Measures("px/frame", "kg px/frame", "kg px²/frame²", 1.0, 1.0)
    factor = METRES * FRAME_RATE
    return Measures("m/s", "kg m/s", "J", factor, factor * factor)


def velocity_words(model: TwoBalls, index: int) -> str:
    """Speed, direction and components of a ball's velocity, y down: "18.0 px/frame at 56°, (10.0, 15.0)"."""
    ball, measures = model.balls[index], measures_in(model.parameters.units)
    digits = 1 if model.parameters.units == "pixels" else 2
    vx, vy = (fixed(measures.speed * part, digits) for part in ball.velocity)
    angle = fixed(math.degrees(ball.angle), 0)
    return f"{fixed(measures.speed * ball.speed, digits)} {measures.speed_unit} at {angle}°, ({vx}, {vy})"


def fixed(value: float, digits: int) -> str:
    """A number with so many digits after the point, and no sign before a zero."""
    text = f"{value:.{digits}f}"
    return text.replace("-", "" if float(text) == 0.0 else "−")


def readouts_of(model: TwoBalls) -> tuple[Readout, ...]:
    """What is shown and charted."""
    speed_unit, momentum_unit, energy_unit, speed, energy = measures_in(model.parameters.units)
    px = sum(ball.momentum[0] for ball in model.balls)
    py = sum(ball.momentum[1] for ball in model.balls)
    return (
        Readout("collisions", model.collisions),
        Readout("speed of 1", model.balls[0].speed * speed, speed_unit),
        Readout("speed of 2", model.balls[1].speed * speed, speed_unit),
        Readout("direction of 1", math.degrees(model.balls[0].angle), "°"),
        Readout("direction of 2", math.degrees(model.balls[1].angle), "°"),
        Readout("energy", sum(ball.energy for ball in model.balls) * energy, energy_unit),
        Readout("right", px * speed, momentum_unit),
        Readout("down", py * speed, momentum_unit),
        Readout("momentum lost", model.momentum_lost * speed, momentum_unit),
        Readout("energy lost", model.energy_lost * energy, energy_unit),
        Readout("passed unseen", model.unseen),
    )

"""What a swarm is worth: its energy, its highest particle, and how far it is from where it ought to be.

Without quadratic drag the particles of one nozzle and one age lie on a circle, however they were aimed:

    centre   c(t) = x₀ + w (t - r) - g d,   radius   R(t) = v r,   r = (1 - exp(-k t)) / k,  d = (t - r) / k

(from the closed form of the flight with linear drag k and wind w; r = t and d = t²/2 for k = 0). The distance
of a particle from its circle is an error that needs no twin to be measured. The envelope of all circles is a
curve that no particle can pass (Torricelli 1644 for k = 0: the parabola of safety).

Arrays: fields (>= 5, n), x, y, vx, vy, birth; tags (2, n); emitters (m, EMITTER_COLUMNS).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel
from game.physics.kernels import elementary
from game.physics.particles import births
from game.physics.particles.flight import decay_over
from game.physics.particles.forces import Forces


@kernel
def measure_swarm(fields, low, high, gravity, base, since):
    """Kinetic and potential energy (J for 1 kg each, above the height ``base``), and the greatest height (m)
    of those born at ``since`` (s) or later."""
    kinetic = 0.0
    potential = 0.0
    highest = -math.inf
    for i in range(low, high):
        vx = fields[2, i]
        vy = fields[3, i]
        kinetic += 0.5 * (vx * vx + vy * vy)
        potential += gravity * (fields[1, i] - base)
        if fields[4, i] >= since:
            highest = max(highest, fields[1, i])
    return kinetic, potential, highest


@kernel
def circle_at(law, age):
    """Centre relative to the nozzle (m) and radius per speed (s) of the circle on which that age lies."""
    decay = decay_over(law.drag, age)
    x = law.wind_x * (age - decay.reach)
    y = law.wind_y * (age - decay.reach) - law.gravity * decay.drift
    return x, y, decay.reach


@kernel
def measure_deviation(swarm, low, high, stride, emitters, law, now, since, tolerance):
    """Off their circles: every ``stride``-th of a `Swarm` born after ``since`` (s) that has touched nothing.

    Returns (greatest distance from the circle in m, how many are outside by more than ``tolerance`` m, how
    many were looked at).
    """
    fields, tags = swarm
    worst = 0.0
    outside = 0
    looked = 0
    for i in range(low, high, stride):
        e = tags[0, i] // births.IDENTITY_STEP
        if tags[1, i] != 0 or fields[4, i] < since or e >= emitters.shape[0]:
            continue
        x, y, reach = circle_at(law, now - fields[4, i])
        dx = fields[0, i] - emitters[e, births.FROM_X] - x
        dy = fields[1, i] - emitters[e, births.FROM_Y] - y
        off = math.sqrt(dx * dx + dy * dy) - emitters[e, births.SPEED] * reach
        worst = max(worst, abs(off))
        outside += off > tolerance
        looked += 1
    return worst, outside, looked


@kernel
def count_touching(tags, low, high, since):
    """How many touched a stone in a step of number ``since`` or later."""
    count = 0
    for i in range(low, high):
        count += tags[1, i] >= since
    return count


def _drift(law: Forces, age: float) -> float:
    """How fast (m/s) the centre of the circle of an age goes."""
    fade = elementary.exp(-law.drag * age)
    vx = law.wind_x * (1.0 - fade)
    vy = law.wind_y * (1.0 - fade) - law.gravity * circle_at(law, age)[2]
    return math.sqrt(vx * vx + vy * vy)


def envelope(law: Forces, speed: float, life: float, points: int = 100) -> NDArray[np.float64]:
    """The curve (n, 2) m from the nozzle, left to right, that particles of that speed cannot pass.

    Empty where there is none: without a force, or before the circles begin to overlap.
    """
    left, right = [], []
    first, last = 0.0, life  # s: the age from which centres go faster than circles grow
    if _drift(law, life) <= speed * elementary.exp(-law.drag * life):
        return np.zeros((0, 2))
    for _ in range(60):
        middle = 0.5 * (first + last)
        faster = _drift(law, middle) > speed * elementary.exp(-law.drag * middle)
        first, last = (first, middle) if faster else (middle, last)
    # the two sides part like a square root: so many more points at the top
    for part in np.linspace(0.0, 1.0, points).tolist():
        age = last + (life - last) * part * part
        x, y, reach = circle_at(law, age)
        fade = elementary.exp(-law.drag * age)
        vx = law.wind_x * (1.0 - fade)  # how fast the centre goes, and the circle grows
        vy = law.wind_y * (1.0 - fade) - law.gravity * reach
        pace, growth = math.sqrt(vx * vx + vy * vy), speed * fade
        if pace <= growth or pace == 0.0:
            continue
        along, across = -growth / pace, math.sqrt(1.0 - elementary.square(growth / pace))
        ux, uy = vx / pace, vy / pace
        radius = speed * reach
        left.append((x + radius * (along * ux + across * uy), y + radius * (along * uy - across * ux)))
        right.append((x + radius * (along * ux - across * uy), y + radius * (along * uy + across * ux)))
    sides = (left[::-1] + right) if left[-1][0] < right[-1][0] else (right[::-1] + left)
    return np.array(sides)

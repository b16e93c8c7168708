"""The help figure: a front of embers in cloth that is written on, its warmth and what fuel is left."""

from __future__ import annotations

import math

from game.physics.cloth import Fabric
from game.ui.canvas.pen import Pen

LEFT, RIGHT, LOW, HIGH = 34.0, 278.0, 150.0, 46.0
SPAN = 0.2  # m that are shown


def draw_front(pen: Pen) -> None:
    """Both by the closed form without losses; the ignition temperature, and where the front is."""
    fabric = Fabric()
    speed = fabric.front_speed(lossless=True)
    rate, spread = fabric.salted.rate, fabric.diffusivity
    start = (fabric.salted.ignition - fabric.ambient) / fabric.rise
    pen.line(((LEFT, HIGH - 6.0), (LEFT, LOW), (RIGHT, LOW)), "text3", 1.2)

    def at(share: float, high: float) -> tuple[float, float]:
        return LEFT + (RIGHT - LEFT) * share, LOW - (LOW - HIGH) * high

    warm, left = [], []
    fast = rate / speed
    part = -rate / (spread * fast * fast + rate)
    for k in range(81):
        place = SPAN * (k / 80.0 - 0.6)  # m before the front
        if place >= 0.0:
            warm.append(at(k / 80.0, start * math.exp(-speed / spread * place)))
            left.append(at(k / 80.0, 1.0))
        else:
            warm.append(at(k / 80.0, start - part + part * math.exp(fast * place)))
            left.append(at(k / 80.0, math.exp(fast * place)))
    pen.line([at(0.0, start), at(1.0, start)], "text3", 1.2, dash=4.0)
    pen.line(left, "chalk", 2.0)
    pen.line(warm, "vermilion", 2.4)
    pen.arrow(at(0.62, 0.55), at(0.8, 0.55), "amber")
    pen.words(f"{1e3 * speed:.0f} mm/s", at(0.64, 0.66)[0], at(0.64, 0.66)[1], "text2", "left")
    pen.words("warmth", *at(0.02, 0.86), "text2", "left")
    pen.words("fuel left", *at(0.72, 0.9), "text2", "left")
    pen.words("ignition", *at(0.02, start - 0.08), "text3", "left")
    pen.formula(r"c = \sqrt{D r \frac{1 - u_i}{u_i}}", 156.0, 184.0)

"""What small scenes show beside their bodies: velocities, forces, an angle, heights by the law."""

from __future__ import annotations

import math
from collections.abc import Sequence

from game.arrays import Floats, Point
from game.physics.kernels import elementary
from game.physics.oscillators import spring_pull
from game.stage import Scene
from game.ui.canvas.canvas import EXACT_DASH, Canvas

SECONDS, SQUARE_SECONDS = 0.12, 0.04  # of a pendulum's length: m for m/s, m for m/s²
BALL_SECONDS, BALL_SQUARE_SECONDS = 0.08, 0.02  # of a ball's fall, likewise
LAW = "by the law"  # a readout
BOUNCES = 5  # that are counted


def arrow_legend(scene: Scene) -> list[tuple[str, str, str]]:
    """What the arrows are."""
    return [("arrow:text1", "velocity", ""), ("arrow:amber", "force", "")]


def may_be_read(scene: Scene, name: str) -> bool:
    """Whether the level lets a readout of that name be seen."""
    teaching = scene.level.teaching if scene.level is not None else None
    return teaching is None or name not in teaching.hidden_readouts


def mark_swing(canvas: Canvas, scene: Scene, swing: Point, length: float, pull: float) -> None:
    """Angle, velocity, weight and pull of the rod; swing: rad, rad/s; pull: g / l, 1/s². Periods as read."""
    angle, rate = swing
    c, s = elementary.cos(angle), elementary.sin(angle)
    mass, force = (length * s, -length * c), SQUARE_SECONDS * length * length
    canvas.line((0.0, 0.0), (0.0, -0.5 * length), "text3", 1.0, EXACT_DASH)
    canvas.arc((0.0, 0.0), 0.3 * length, -0.5 * math.pi, math.remainder(angle, math.tau) - 0.5 * math.pi)
    canvas.arrow(mass, (SECONDS * length * rate * c, SECONDS * length * rate * s), "text1", "v")
    canvas.arrow(mass, (0.0, -force * pull), "amber", "m g")
    rod = force * (pull * c + rate * rate)
    canvas.arrow(mass, (-rod * s, rod * c), "amber", "F")
    half = 0.5 * math.remainder(angle, math.tau)
    words = canvas.figure("angle", f"{2.0 * math.degrees(half):.1f}°")
    canvas.label(
        (0.42 * length * elementary.sin(half), -0.42 * length * elementary.cos(half)), words, "text1"
    )
    known = {one.name: one.value for one in scene.readouts() if may_be_read(scene, one.name)}
    values = [(before, known.get(name, math.nan)) for before, name in (("", "period"), (LAW, LAW))]
    told = [f"{before} {value:.3f} s".lstrip() for before, value in values if math.isfinite(value)]
    if told:
        words = canvas.figure("period", "Period " + ", ".join(told))
        canvas.label((0.0, 0.35 * length), words, "text1", size=13)


def mark_bounces(canvas: Canvas, height: float, restitution: float) -> None:
    """How high each bounce rises by Newton's law of impact: e² times as high as the one before."""
    level = height
    for n in range(BOUNCES):
        if level > 0.03 * height:
            canvas.line((-0.6 * height, level), (0.6 * height, level), "text3", 1.0, EXACT_DASH)
            canvas.formula((0.66 * height, level), f"e^{2 * n} h" if n else "h", "text2", 14, "left")
        level *= restitution * restitution


def mark_flight(
    canvas: Canvas, middle: Point, above: float, speed: float, scale: tuple[float, float]
) -> None:
    """Height above the ground (m), velocity and weight of a ball about ``middle``.

    scale: weight for its mass m/s², and height of the fall m, by which arrows are drawn.
    """
    (x, y), (weight, height) = middle, scale
    left = x - 0.4 * height
    canvas.line((left, 0.0), (left, above), "text2", 1.2)
    canvas.line((left - 0.04 * height, above), (left + 0.04 * height, above), "text2", 1.2)
    words = canvas.figure("height", f"{above:.2f} m")
    canvas.label((left - 0.02 * height, 0.5 * above), words, "text1", anchor="right")
    apart = canvas.px(7.0)
    velocity = BALL_SECONDS * math.sqrt(height) * speed
    canvas.arrow((x - apart, y), (0.0, velocity), "text1", "v")
    canvas.arrow((x + apart, y), (0.0, -BALL_SQUARE_SECONDS * height * weight), "amber", "m g")


def mark_beads(
    canvas: Canvas, across: Sequence[float], beads: Floats, rates: Floats, stiffness: float
) -> None:
    """Beads with velocities and forces, in the units of one bead between two springs; across: m."""
    square = 2.0 * stiffness  # of its angular frequency, 1/s²
    pulls = spring_pull(stiffness)(beads, None, 0.0)
    for x, y, rate, pull in zip(across, beads.tolist(), rates.tolist(), pulls.tolist(), strict=True):
        canvas.dot((x, y), 5.0, "chalk")
        canvas.arrow((x, y), (0.0, rate / math.sqrt(square)), "text1", width=1.6)
        canvas.arrow((x, y), (0.0, 2.0 * pull / square), "amber", width=1.6)

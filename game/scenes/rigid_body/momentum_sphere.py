"""The sphere of L: the direction of the angular momentum as the body sees it.

A free body's L has one length and, in the body's frame, stays on the curve where its energy is what it is.
Two planes through axis 2 separate the curves about axis 1 from those about axis 3.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.scenes.rigid_body.bodies import A, B
from game.scenes.rigid_body.camera import camera_matrix
from game.scenes.rigid_body.model import RigidModel
from game.ui.canvas.canvas import Canvas

RADIUS_PX, MARGIN_PX, SIDE_PX = 52.0, 26.0, 20.0
LOOK = camera_matrix(-35.0, 24.0) @ np.array(
    ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
)  # 2 right, 3 up
TURNS = np.linspace(0.0, 2.0 * math.pi, 73)


def draw_momentum_sphere(model: RigidModel, canvas: Canvas) -> None:
    """Draw it in the upper right corner: trails of A and B, the separatrix, the ends of the axes."""
    seen = canvas.camera.visible()
    radius = canvas.px(RADIUS_PX)
    top, side = canvas.px(MARGIN_PX + canvas.insets[1] / canvas.k), canvas.px(SIDE_PX)
    center = np.array((seen.right - radius - side, seen.top - radius - top))
    canvas.circle(center, radius, "panel", 0.9, "line2", 1.2)
    for curve in separatrix(model.bodies.all[A].moments):
        _draw_on_sphere(canvas, center, radius, curve, "line2", 1.0)
    for index, color in ((B, "green"), (A, "chalk")):
        if index == A or model.parameters.twin:
            _draw_on_sphere(canvas, center, radius, model.trail_of(index), color, 1.6)
            last = LOOK @ model.trail_of(index)[-1]
            canvas.dot(center + radius * last[:2], 3.6, color, 1.0 if last[2] >= 0.0 else 0.4)
    for k in range(3):
        tip = LOOK[:, k]
        canvas.dot(center + radius * tip[:2], 2.0, "text2")
        canvas.label(center + (radius + canvas.px(9.0)) * _outwards(tip), str(k + 1), "text2", 11)
    below = center - (0.0, radius)
    canvas.label(below, "L in the body", "text3", 11, anchor="top", offset=(0.0, 5.0))


def separatrix(moments: Floats) -> list[Floats]:
    """The two great circles (73, 3) through axis 2, if all three moments differ."""
    i1, i2, i3 = moments.tolist()
    if not 0.0 < i1 < i2 < i3:
        return []
    # l1² (1/I1 - 1/I2) = l3² (1/I2 - 1/I3), where either side may round to nothing
    steep = math.atan2(math.sqrt(1.0 / i1 - 1.0 / i2), math.sqrt(1.0 / i2 - 1.0 / i3))
    c, s = math.cos(steep), math.sin(steep)
    cos, sin = np.cos(TURNS), np.sin(TURNS)
    return [np.column_stack((c * sin, cos, sign * s * sin)) for sign in (1.0, -1.0)]


def _draw_on_sphere(
    canvas: Canvas, center: Floats, radius: float, curve: Floats, color: str, width: float
) -> None:
    """A curve (n, 3) on the unit sphere: strong before, weak behind."""
    seen = curve @ LOOK.T
    flat = center + radius * seen[:, :2]
    for front, strength in ((False, 0.3), (True, 1.0)):
        part = np.where(((seen[:, 2] >= 0.0) == front)[:, None], flat, np.nan)
        canvas.polyline(part, color, width, alpha=strength)


def _outwards(tip: Floats) -> Floats:
    """Where to write beside a point of the sphere: away from its middle, at least a little."""
    length = math.sqrt(float(tip[0] * tip[0] + tip[1] * tip[1]))
    return tip[:2] / length if length > 1e-9 else np.array((0.0, 1.0))

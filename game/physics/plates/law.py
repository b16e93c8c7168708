"""The law of a plate in air: added mass, circulation, drag, and a bend about its middle.

Andersen, Pesavento and Wang (2005, J. Fluid Mech. 541, 65 and 91), in body axes (x along the chord), for the
velocity u through the air. All is divided by the mass pi rho a² of the air that the plate takes along
broadside:

    (I + beta²) u_x' = (I + 1) w u_y - G u_y + (I - beta) g_x - F_x
    (I + 1) u_y' = -(I + beta²) w u_x + G u_x + (I - beta) g_y - F_y
    J w' = -(1 - beta²) u_x u_y - (t_1 + t_2 |w|) w,   J = a² (I (1 + beta²) + (1 - beta²)²/2)/4
    G = (2/pi) (C_R w - C_T u_x u_y/(a |u|)),   F = (A - B (u_x² - u_y²)/u²) |u| u/(pi a)

with I = rho_s b/(rho a), beta = b/a. The lift G is at right angles to u and does no work; drag only takes.

Wind. In a wind w(t) that is the same everywhere the air is at rest in a frame that falls with it, where
gravity is g - w'. So the law holds exactly for u = v - w with that gravity: the air's own acceleration pushes
with (I - beta) less than the added mass takes along. In a wind that varies in space w' is taken along the
plate's path (Maxey and Riley 1983). Along the air's own path (Auton, Hunt and Prud'homme 1988) it differs by
(u grad) w, which is nothing for a gust that is large beside a plate. A jump of the wind from one step to the
next is that law's impulse: what moves with the air changes by (1 + beta)/(I + 1) of it broadside.

Bend (of this program, not of the paper). A leaf's halves are turned up by q each, and give way like a spring.
Each half is dragged by its own inclination and the speed of its own middle,

    U_i = u + s w x r_i + q' dr_i/dq,   s = q²/(q² + q_h²),

and the drag on it pushes, turns and bends through the same lever as made its speed. So its power is -F_i U_i
<= 0 for each half, and a plate with q = q' = 0 is the paper's to the last bit. A bend adds the circulation of
a wing with a kink at half its chord (Glauert 1926: C_L = -4 q at no incidence), scaled as C_T is to thin
wings. Inertia does not change with the bend. HEAVY of the mass lies in the midrib.

Balance (of this program). A plate whose mass lies off its middle by e a is pushed in its middle, by the
velocity there, u + w x r with r = (-e a, 0): it turns by e a times that push, and still no energy comes of
it. With the mass ahead of the middle it glides, which the paper's plate never does: all its equilibria have
u_x u_y = 0.

Columns of `Laws` (COLUMNS, n); the state `STATE` (n,) in SI units, world axes.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary

X, Y, THETA, VX, VY, SPIN, BEND, BEND_RATE = range(8)
STATE = 8
(HALF, MASS_X, MASS_Y, INERTIA, WEIGHT, TURN, GLIDE, DRAG, DRAG_TURN, TORQUE, TORQUE_2, BEND_INERTIA, STIFF,
 DAMP, CURL, OFFSET, MASS, RADIUS, UNIT) = range(19)  # fmt: skip
COLUMNS = 19
HEAVY = 0.3  # of a leaf's mass is in its midrib
HALF_BEND = 0.25  # rad, q_h: from where on the halves are apart
MOST_BEND = 1.35  # rad
AIR_DENSITY = 1.2  # kg/m³
GRAVITY = 9.81  # m/s², of the speed unit


class Plate(NamedTuple):
    """A plate or leaf. half_chord m; inertia I = rho_s b/(rho a); thickness beta = b/a; the others above.

    curl: rad, the bend at rest; bend_hz: frequency at which it bends, 0: rigid; damping: share of critical;
    balance: how far towards its +x end its mass lies off its middle, in half chords.
    """

    half_chord: float = 0.02
    inertia: float = 1.1
    thickness: float = 1.0 / 14.0
    turn: float = math.pi  # C_R
    glide: float = 1.2  # C_T
    drag: float = 1.4  # A
    drag_turn: float = 1.0  # B
    torque: float = 0.2  # mu_1
    torque_2: float = 0.2  # mu_2
    curl: float = 0.0
    bend_hz: float = 0.0
    damping: float = 0.3
    balance: float = 0.0

    @property
    def speed(self) -> float:
        """The unit of speed sqrt((rho_s/rho - 1) g b), m/s."""
        return math.sqrt((self.inertia - self.thickness) * GRAVITY * self.half_chord)

    @property
    def time(self) -> float:
        """The unit of time a/U, s."""
        return self.half_chord / self.speed

    @property
    def broadside(self) -> float:
        """Steady speed of a fall broadside, m/s: U sqrt(pi/(A + B)), where the weight is the drag."""
        return self.speed * math.sqrt(math.pi / (self.drag + self.drag_turn))

    @property
    def edge_on(self) -> float:
        """Steady speed of a fall edge on, m/s: U sqrt(pi/(A - B)); inf where it has no drag."""
        left = self.drag - self.drag_turn
        return self.speed * math.sqrt(math.pi / left) if left > 0.0 else math.inf

    def lift_coefficient(self, incidence: float) -> float:
        """C_L on the chord 2 a at an incidence (rad), without spin: C_T sin 2 alpha."""
        return self.glide * elementary.sin(2.0 * incidence)

    def drag_coefficient(self, incidence: float) -> float:
        """C_D on the chord 2 a at an incidence (rad): A - B cos 2 alpha."""
        return self.drag - self.drag_turn * elementary.cos(2.0 * incidence)


RANGES = {
    "half_chord": (1e-4, 10.0), "inertia": (1e-6, 1e6), "thickness": (0.0, 1.0), "turn": (-20.0, 20.0),
    "glide": (-20.0, 20.0), "drag": (0.0, 20.0), "drag_turn": (-20.0, 20.0), "torque": (0.0, 100.0),
    "torque_2": (0.0, 100.0), "curl": (-1.2, 1.2), "bend_hz": (0.0, 1000.0), "damping": (0.0, 10.0),
    "balance": (-0.8, 0.8),
}  # fmt: skip


def checked_plate(plate: Plate) -> Plate:
    """The plate itself; ValueError, naming the field, for what makes no sense."""
    for name, value in zip(plate._fields, plate, strict=True):
        low, high = RANGES[name]
        if not low <= value <= high:
            raise ValueError(f"{name} = {value!r}: expected {low:g} to {high:g}")
    if not plate.inertia > plate.thickness:
        raise ValueError(
            f"inertia = {plate.inertia!r}: expected more than thickness {plate.thickness:g}, else it floats"
        )
    if plate.drag < abs(plate.drag_turn):
        raise ValueError(f"drag = {plate.drag!r}: expected at least |drag_turn|, so that drag only takes")
    return plate


def law_of(plate: Plate) -> Floats:
    """The column (COLUMNS,) of a checked plate."""
    a, i, beta = plate.half_chord, plate.inertia, plate.thickness
    turning = a * a * (i * (1.0 + beta * beta) + 0.5 * elementary.square(1.0 - beta * beta)) / 4.0
    bending, rate = 0.5 * turning, 2.0 * math.pi * plate.bend_hz
    column = np.zeros(COLUMNS)
    column[HALF], column[MASS_X], column[MASS_Y], column[INERTIA] = a, i + beta * beta, i + 1.0, turning
    column[WEIGHT] = i - beta
    column[TURN], column[GLIDE] = 2.0 / math.pi * plate.turn, 2.0 / math.pi * plate.glide / a
    column[DRAG], column[DRAG_TURN] = plate.drag / (math.pi * a), plate.drag_turn / (math.pi * a)
    column[TORQUE], column[TORQUE_2] = plate.torque * a * plate.speed, plate.torque_2 * a * a
    column[BEND_INERTIA], column[STIFF] = bending, bending * rate * rate
    column[DAMP], column[CURL] = 2.0 * plate.damping * rate * bending, plate.curl
    column[OFFSET] = -plate.balance * a
    column[MASS] = math.pi * AIR_DENSITY * a * a
    column[RADIUS], column[UNIT] = beta * a, plate.speed
    return column


@inner_kernel(forceinline=True)
def sine(q):
    """sin q to 2e-8 for |q| <= MOST_BEND, without a call."""
    p = q * q
    return q * (
        1.0
        - p
        / 6.0
        * (1.0 - p / 20.0 * (1.0 - p / 42.0 * (1.0 - p / 72.0 * (1.0 - p / 110.0 * (1.0 - p / 156.0)))))
    )


@inner_kernel(forceinline=True)
def cosine(q):
    """cos q to 2e-8 for |q| <= MOST_BEND, without a call."""
    p = q * q
    return 1.0 - p / 2.0 * (
        1.0 - p / 12.0 * (1.0 - p / 30.0 * (1.0 - p / 56.0 * (1.0 - p / 90.0 * (1.0 - p / 132.0))))
    )


@inner_kernel(forceinline=True)
def half_drag(ux, uy, tx, ty, drag, drag_turn):
    """Drag (x, y) of half a plate along (tx, ty), against its velocity; nothing at rest."""
    squared = ux * ux + uy * uy
    speed = math.sqrt(squared)
    along = ux * tx + uy * ty
    off = uy * tx - ux * ty
    per = 1.0 / (speed + 1e-300)
    force = 0.5 * (drag * speed - drag_turn * (along * along - off * off) * per)
    return force * ux, force * uy

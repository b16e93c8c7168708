"""How particles move between projections: predicted by Euler or BDF2, and their velocities afterwards.

    Euler   v* = v / (1 + h k_d w) + h g,  p = x + h v*,  project p,  v⁺ = (p - x) / h
            Müller, Heidelberger, Hennix, Ratcliff 2007, algorithm 1
    BDF2    v* = (4 v - v₋ + 2 h (g - k_d w (2 v - v₋))) / 3,  p = (4 x - x₋ + 2 h v*) / 3,  project p,
            v⁺ = (3 p - 4 x + x₋) / (2 h)
            English and Bridson 2008; both halves are needed: with v* of Euler nothing converges

Damping acts on what there was of velocity, not on the pull of gravity, so that it moves no resting point. It
never reverses a motion: BDF2 takes it as Euler does where h k_d w is above STRONG.

Arrays and tuples of them as in `motion`.
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel

SCHEMES = ("euler", "bdf2")
STRONG = 0.2  # damping per substep above which taking it from two velocities could overshoot
EULER, BDF2 = range(2)


@lean_kernel
def predict_euler(now, inverse_mass, aim, h, fall, damping):
    """Where particles would be without constraints; the fixed ones stay."""
    x, y, vx, vy = now
    px, py = aim
    for i in range(x.shape[0]):
        keep = 1.0 / (1.0 + h * damping * inverse_mass[i])
        step = h if inverse_mass[i] > 0.0 else 0.0
        px[i] = x[i] + step * keep * vx[i]
        py[i] = y[i] + step * (keep * vy[i] - h * fall)


@lean_kernel
def predict_bdf2(now, before, inverse_mass, fresh, aim, h, fall, damping):
    """The same from two steps; from one where the step before does not count."""
    x, y, vx, vy = now
    ox, oy, ux, uy = before
    px, py = aim
    for i in range(x.shape[0]):
        step = h if inverse_mass[i] > 0.0 else 0.0
        drag = h * damping * inverse_mass[i]
        keep = 1.0 / (1.0 + drag)
        history = 1.0 / (3.0 + 2.0 * drag) if drag > STRONG else 1.0 / 3.0
        lag = 0.0 if drag > STRONG else 2.0 * drag / 3.0
        qx = history * (4.0 * vx[i] - ux[i]) - lag * (2.0 * vx[i] - ux[i])
        qy = history * (4.0 * vy[i] - uy[i]) - lag * (2.0 * vy[i] - uy[i]) - 2.0 / 3.0 * h * fall
        bx = x[i] + (x[i] - ox[i] + 2.0 * step * qx) / 3.0
        by = y[i] + (y[i] - oy[i] + 2.0 * step * qy) / 3.0
        ex = x[i] + step * keep * vx[i]
        ey = y[i] + step * (keep * vy[i] - h * fall)
        px[i] = ex if fresh[i] > 0.0 else bx
        py[i] = ey if fresh[i] > 0.0 else by


@lean_kernel
def settle_euler(now, aim, h):
    """Take over projected positions and the velocities that they mean."""
    x, y, vx, vy = now
    px, py = aim
    for i in range(x.shape[0]):
        vx[i] = (px[i] - x[i]) / h
        vy[i] = (py[i] - y[i]) / h
        x[i] = px[i]
        y[i] = py[i]


@lean_kernel
def settle_bdf2(now, before, fresh, aim, h):
    """The same by the backward difference over two steps; the step before is kept."""
    x, y, vx, vy = now
    ox, oy, ux, uy = before
    px, py = aim
    for i in range(x.shape[0]):
        ax = (px[i] - x[i]) / h
        ay = (py[i] - y[i]) / h
        bx = (3.0 * px[i] - 4.0 * x[i] + ox[i]) / (2.0 * h)
        by = (3.0 * py[i] - 4.0 * y[i] + oy[i]) / (2.0 * h)
        ux[i] = vx[i]
        uy[i] = vy[i]
        ox[i] = x[i]
        oy[i] = y[i]
        vx[i] = ax if fresh[i] > 0.0 else bx
        vy[i] = ay if fresh[i] > 0.0 else by
        x[i] = px[i]
        y[i] = py[i]
        fresh[i] = 0.0

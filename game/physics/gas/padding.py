"""Copies with ghosts around: what is carried in a step, with the explicit part of the step added.

The time-centred step carries u + (1 - q) dt (f - grad p + nu laplace u), all of the step before (theta scheme
along the gas's way; Temperton and Staniforth 1987 for the form), so the projection has only q of it to do.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.grid.layout import PAD


@kernel
def pad_u(u, f, p, part, slope, before, padded):
    """padded = u + part f - slope (p - p to the left) inside; u is kept in before. p is padded by one."""
    rows, columns = u.shape
    for j in range(rows):
        goal, now, old, force, high = padded[j + PAD, PAD:], u[j], before[j], f[j], p[j + 1]
        for i in range(columns):
            goal[i] = now[i] + part * force[i] - slope * (high[i + 1] - high[i])
            old[i] = now[i]


@kernel
def pad_v(v, f, p, part, slope, before, padded):
    """The same for v, with the pressure below."""
    rows, columns = v.shape
    for j in range(rows):
        goal, now, old, force = padded[j + PAD, PAD:], v[j], before[j], f[j]
        low, high = p[j, 1:], p[j + 1, 1:]
        for i in range(columns):
            goal[i] = now[i] + part * force[i] - slope * (high[i] - low[i])
            old[i] = now[i]


@kernel
def pad_field(field, padded):
    """A plain copy inside."""
    for j in range(field.shape[0]):
        goal, source = padded[j + PAD, PAD:], field[j]
        for i in range(field.shape[1]):
            goal[i] = source[i]


@kernel
def pad_scalars(scalars, rates, dt, padded):
    """padded = scalars + dt rates inside, all (ny, nx, fields)."""
    ny, width = scalars.shape[0], scalars.shape[1] * scalars.shape[2]
    now, change, goals = scalars.reshape(-1), rates.reshape(-1), padded.reshape(-1)
    stride, before = padded.shape[1] * padded.shape[2], PAD * padded.shape[2]
    for j in range(ny):
        start, first = j * width, (j + PAD) * stride + before
        source, rate = now[start : start + width], change[start : start + width]
        goal = goals[first : first + width]
        for i in range(source.size):
            goal[i] = source[i] + dt * rate[i]


@kernel
def extend(padded, layer, most):
    """Give closed faces, from the open ones outward, the mean of their neighbours in the layer before.

    layer (rows, columns) int64: 0 open, 1 beside an open face, 2 beside those, ...
    """
    rows, columns = layer.shape
    for depth in range(1, most + 1):
        for j in range(rows):
            for i in range(columns):
                if layer[j, i] != depth:
                    continue
                total, count = 0.0, 0
                if i > 0 and layer[j, i - 1] < depth:
                    total += padded[j + PAD, i + PAD - 1]
                    count += 1
                if i < columns - 1 and layer[j, i + 1] < depth:
                    total += padded[j + PAD, i + PAD + 1]
                    count += 1
                if j > 0 and layer[j - 1, i] < depth:
                    total += padded[j + PAD - 1, i + PAD]
                    count += 1
                if j < rows - 1 and layer[j + 1, i] < depth:
                    total += padded[j + PAD + 1, i + PAD]
                    count += 1
                if count > 0:
                    padded[j + PAD, i + PAD] = total / count

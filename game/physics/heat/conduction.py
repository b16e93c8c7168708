"""Conduction on a grid of square cells: C dT/dt = div(k grad T), in the form of fluxes through faces.

Arrays: temperature, capacity C (ny, nx), K and J/(m³ K); face conductances across x gx (ny, nx + 1) and
across y gy (ny + 1, nx), W/(m³ K): k / cell², k the harmonic mean of both cells, so that the flux is the same
on both sides of a jump of any size (Patankar 1980, 4.2-3). At an edge that is held at a temperature it is 2 k
/ cell², at an insulated one 0. held (8,): temperatures of the left, right, lower and upper edge, K, and four
zeros.

Explicit Euler is stable up to dt = cell² C / 4 k. Crank and Nicolson (1947) solve (C - dt/2 A) T' = (C + dt/2
A) T by conjugate gradients, as does backward Euler with the whole of A on the left. What is left of the
residual becomes a flux like any other, so no heat is lost by an unfinished solution. Peaceman and Rachford
(1955) go half a step implicitly along rows and half along columns; each is a set of tridiagonal systems.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel

LEFT, RIGHT, LOWER, UPPER = range(4)


@lean_kernel
def join_cells(conductivity, cell, is_held, gx, gy):
    """Write face conductances from conductivities (ny, nx) W/(m K); is_held (4,): whether an edge is."""
    ny, nx = conductivity.shape
    part = 1.0 / (cell * cell)
    for j in range(ny):
        gx[j, 0] = 2.0 * conductivity[j, 0] * part * is_held[LEFT]
        gx[j, nx] = 2.0 * conductivity[j, nx - 1] * part * is_held[RIGHT]
        for i in range(1, nx):
            a, b = conductivity[j, i - 1], conductivity[j, i]
            gx[j, i] = part * (2.0 * a * b / (a + b) if a + b > 0.0 else 0.0)
    for i in range(nx):
        gy[0, i] = 2.0 * conductivity[0, i] * part * is_held[LOWER]
        gy[ny, i] = 2.0 * conductivity[ny - 1, i] * part * is_held[UPPER]
        for j in range(1, ny):
            a, b = conductivity[j - 1, i], conductivity[j, i]
            gy[j, i] = part * (2.0 * a * b / (a + b) if a + b > 0.0 else 0.0)


@inner_kernel
def _across(t, gx, held, j, i):
    """Heat that comes into a cell through its faces across x, W/m³."""
    nx, here = t.shape[1], t[j, i]
    left = t[j, i - 1] if i > 0 else held[LEFT]
    right = t[j, i + 1] if i < nx - 1 else held[RIGHT]
    return gx[j, i] * (left - here) + gx[j, i + 1] * (right - here)


@inner_kernel
def _along(t, gy, held, j, i):
    """Heat that comes into a cell through its faces across y, W/m³."""
    ny, here = t.shape[0], t[j, i]
    below = t[j - 1, i] if j > 0 else held[LOWER]
    above = t[j + 1, i] if j < ny - 1 else held[UPPER]
    return gy[j, i] * (below - here) + gy[j + 1, i] * (above - here)


@inner_kernel
def through_edges(t, gx, gy, held, part_x, part_y):
    """Heat that comes in through all edges, W/m³ of a cell, those across x and across y with a weight
    each.
    """
    ny, nx = t.shape
    total = 0.0
    for j in range(ny):
        total += part_x * gx[j, 0] * (held[LEFT] - t[j, 0])
        total += part_x * gx[j, nx] * (held[RIGHT] - t[j, nx - 1])
    for i in range(nx):
        total += part_y * gy[0, i] * (held[LOWER] - t[0, i])
        total += part_y * gy[ny, i] * (held[UPPER] - t[ny - 1, i])
    return total


@lean_kernel
def flow_into(t, gx, gy, held, flow):
    """Write what flows into each cell, W/m³, and give what comes in through edges, W/m³ of a cell."""
    ny, nx = t.shape
    for j in range(ny):
        for i in range(nx):
            flow[j, i] = _across(t, gx, held, j, i) + _along(t, gy, held, j, i)
    return through_edges(t, gx, gy, held, 1.0, 1.0)


@lean_kernel
def explicit_step(t, capacity, gx, gy, held, dt, flow):
    """Euler's explicit step; gives what came in through edges, J/m³ of a cell."""
    came = flow_into(t, gx, gy, held, flow)
    for j in range(t.shape[0]):
        for i in range(t.shape[1]):
            t[j, i] += dt * flow[j, i] / capacity[j, i]
    return dt * came


@inner_kernel
def _eliminate(diagonal, right, upper, n):
    """Thomas' algorithm's way back, after the way there; the solution is left in ``right``."""
    right[n - 1] /= diagonal[n - 1]
    for k in range(n - 2, -1, -1):
        right[k] = (right[k] - upper[k] * right[k + 1]) / diagonal[k]


@lean_kernel
def alternating_step(t, capacity, gx, gy, held, dt, middle, work):
    """Peaceman and Rachford's step; work (3, longest side); gives what came in through edges, J/m³ of a
    cell.
    """
    ny, nx = t.shape
    h = 0.5 * dt
    diagonal, right, upper = work[0], work[1], work[2]
    came = h * through_edges(t, gx, gy, held, 0.0, 1.0)
    for j in range(ny):
        for i in range(nx):
            diagonal[i] = capacity[j, i] + h * (gx[j, i] + gx[j, i + 1])
            right[i] = capacity[j, i] * t[j, i] + h * _along(t, gy, held, j, i)
            upper[i] = -h * gx[j, i + 1]
        right[0] += h * gx[j, 0] * held[LEFT]
        right[nx - 1] += h * gx[j, nx] * held[RIGHT]
        for i in range(1, nx):
            part = -h * gx[j, i] / diagonal[i - 1]
            diagonal[i] -= part * upper[i - 1]
            right[i] -= part * right[i - 1]
        _eliminate(diagonal, right, upper, nx)
        for i in range(nx):
            middle[j, i] = right[i]
    came += dt * through_edges(middle, gx, gy, held, 1.0, 0.0)
    for i in range(nx):
        for j in range(ny):
            diagonal[j] = capacity[j, i] + h * (gy[j, i] + gy[j + 1, i])
            right[j] = capacity[j, i] * middle[j, i] + h * _across(middle, gx, held, j, i)
            upper[j] = -h * gy[j + 1, i]
        right[0] += h * gy[0, i] * held[LOWER]
        right[ny - 1] += h * gy[ny, i] * held[UPPER]
        for j in range(1, ny):
            part = -h * gy[j, i] / diagonal[j - 1]
            diagonal[j] -= part * upper[j - 1]
            right[j] -= part * right[j - 1]
        _eliminate(diagonal, right, upper, ny)
        for j in range(ny):
            t[j, i] = right[j]
    return came + h * through_edges(t, gx, gy, held, 0.0, 1.0)


@inner_kernel
def _apply(v, capacity, gx, gy, none, h, out):
    """(C - h A) v with edges at 0; gives v times that."""
    total = 0.0
    for j in range(v.shape[0]):
        for i in range(v.shape[1]):
            inflow = _across(v, gx, none, j, i) + _along(v, gy, none, j, i)
            out[j, i] = capacity[j, i] * v[j, i] - h * inflow
            total += v[j, i] * out[j, i]
    return total


@lean_kernel
def implicit_step(t, capacity, gx, gy, held, dt, theta, most, work):
    """A step with a share theta of the new temperature: 1/2 Crank-Nicolson, 1 backward Euler.

    most: iterations; work (4, ny, nx). Gives what came in through edges, J/m³ of a cell, and the iterations
    made. The solution is sought as the change of temperature; then the fluxes at (1 - theta) T + theta T'
    make the step.
    """
    ny, nx = t.shape
    change, residual, way, image, none = work[0], work[1], work[2], work[3], held[4:]
    h = theta * dt
    start, square = 0.0, 0.0
    for j in range(ny):
        for i in range(nx):
            inflow = dt * (_across(t, gx, held, j, i) + _along(t, gy, held, j, i))
            share = capacity[j, i] + h * (gx[j, i] + gx[j, i + 1] + gy[j, i] + gy[j + 1, i])
            change[j, i], residual[j, i] = 0.0, inflow
            way[j, i] = inflow / share
            square += inflow * way[j, i]
            start += inflow * inflow
    count, left = 0, start
    while count < most and left > 1e-24 * start and square > 0.0:
        step = square / _apply(way, capacity, gx, gy, none, h, image)
        before, square, left = square, 0.0, 0.0
        for j in range(ny):
            for i in range(nx):
                change[j, i] += step * way[j, i]
                residual[j, i] -= step * image[j, i]
                share = capacity[j, i] + h * (gx[j, i] + gx[j, i + 1] + gy[j, i] + gy[j + 1, i])
                image[j, i] = residual[j, i] / share
                square += residual[j, i] * image[j, i]
                left += residual[j, i] * residual[j, i]
        for j in range(ny):
            for i in range(nx):
                way[j, i] = image[j, i] + square / before * way[j, i]
        count += 1
    for j in range(ny):
        for i in range(nx):
            change[j, i] = t[j, i] + theta * change[j, i]
    came = flow_into(change, gx, gy, held, image)
    for j in range(ny):
        for i in range(nx):
            t[j, i] += dt * image[j, i] / capacity[j, i]
    return dt * came, count

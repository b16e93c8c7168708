"""The book of momentum of a box of gas around a solid: what goes in less what is kept is the force on it.

Over a rectangle of whole cells that no solid cuts: momentum and its moment that the gas holds. Also what
leaves through the four sides by flow, pressure and viscosity, at the middles of faces and at nodes (second
order). Force on the solid = -(what leaves) - (change of what is held).
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, kernel

LEFT, RIGHT, LOW, HIGH = range(4)


@inner_kernel
def _node(u, v, j, i, h):
    """u, v and du/dy + dv/dx at the node (j, i)."""
    speed_u = 0.5 * (u[j - 1, i] + u[j, i])
    speed_v = 0.5 * (v[j, i - 1] + v[j, i])
    return speed_u, speed_v, ((u[j, i] - u[j - 1, i]) + (v[j, i] - v[j, i - 1])) / h


@kernel
def outflow(p, u, v, box, numbers, out):
    """Write what leaves the box (3,): momentum along x, y, and its moment, over the density, a second.

    p: padded by one; box (4,): first and last column and row of nodes that bound it; numbers (4,): cell m,
    viscosity m²/s, x and y m of the grid's corner from the point of the moment.
    """
    h, nu = numbers[0], numbers[1]
    out[0] = out[1] = out[2] = 0.0
    for side in range(2):
        i, sign = box[LEFT + side], 2.0 * side - 1.0
        x = numbers[2] + i * h
        for j in range(box[LOW], box[HIGH]):
            y = numbers[3] + (j + 0.5) * h
            normal = 0.5 * (p[j + 1, i] + p[j + 1, i + 1]) - nu * (u[j, i + 1] - u[j, i - 1]) / h
            leaves = sign * h * (u[j, i] * u[j, i] + normal)
            out[0] += leaves
            out[2] -= y * leaves
        for j in range(box[LOW], box[HIGH] + 1):
            weight = 0.5 if j == box[LOW] or j == box[HIGH] else 1.0
            speed_u, speed_v, shear = _node(u, v, j, i, h)
            leaves = sign * weight * h * (speed_u * speed_v - nu * shear)
            out[1] += leaves
            out[2] += x * leaves
    for side in range(2):
        j, sign = box[LOW + side], 2.0 * side - 1.0
        y = numbers[3] + j * h
        for i in range(box[LEFT], box[RIGHT]):
            x = numbers[2] + (i + 0.5) * h
            normal = 0.5 * (p[j, i + 1] + p[j + 1, i + 1]) - nu * (v[j + 1, i] - v[j - 1, i]) / h
            leaves = sign * h * (v[j, i] * v[j, i] + normal)
            out[1] += leaves
            out[2] += x * leaves
        for i in range(box[LEFT], box[RIGHT] + 1):
            weight = 0.5 if i == box[LEFT] or i == box[RIGHT] else 1.0
            speed_u, speed_v, shear = _node(u, v, j, i, h)
            leaves = sign * weight * h * (speed_u * speed_v - nu * shear)
            out[0] += leaves
            out[2] -= y * leaves


@kernel
def held(u, v, ax, ay, box, numbers, out):
    """Write the momentum in the box (3,) along x, y, and its moment, over the density; as `outflow`."""
    h = numbers[0]
    out[0] = out[1] = out[2] = 0.0
    for j in range(box[LOW], box[HIGH]):
        y = numbers[3] + (j + 0.5) * h
        for i in range(box[LEFT], box[RIGHT] + 1):
            weight = 0.5 if i == box[LEFT] or i == box[RIGHT] else 1.0
            part = weight * h * h * ax[j, i] * u[j, i]
            out[0] += part
            out[2] -= y * part
    for j in range(box[LOW], box[HIGH] + 1):
        weight = 0.5 if j == box[LOW] or j == box[HIGH] else 1.0
        for i in range(box[LEFT], box[RIGHT]):
            x = numbers[2] + (i + 0.5) * h
            part = weight * h * h * ay[j, i] * v[j, i]
            out[1] += part
            out[2] += x * part

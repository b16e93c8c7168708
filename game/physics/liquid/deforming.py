"""A smooth deformation of place and time that carries points onto others: matching, and least squares.

It lies on a lattice. Neighbours are held together by springs, so it goes on where there are no points.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel

TURNS, ERROR = 60, 1e-5  # of the conjugate gradients


@inner_kernel
def corner(at, length, count):
    """Node before a place along an axis and the share to the next; places outside count to the end."""
    at = min(max(at, 0.0), length)
    node = min(math.floor(at), max(count - 2, 0))
    return node, at - node


@lean_kernel
def match(points, normals, others, other_normals, turned, found):
    """For each point (n, 3) the other that is nearest in place, time and normal."""
    weight = turned * turned
    for i in range(len(points)):
        best, least = -1, math.inf
        for j in range(len(others)):
            a, b, c = points[i, 0] - others[j, 0], points[i, 1] - others[j, 1], points[i, 2] - others[j, 2]
            square = a * a + b * b + c * c
            if square < least:
                u = normals[i, 0] - other_normals[j, 0]
                v = normals[i, 1] - other_normals[j, 1]
                w = normals[i, 2] - other_normals[j, 2]
                square += 0.5 * weight * (u * u + v * v + w * w)
                if square < least:
                    best, least = j, square
        found[i] = best


@lean_kernel
def place_samples(points, scale, shape, nodes, shares):
    """Eight nodes of the lattice around each point (n, 3), and their shares; scale: nodes a metre."""
    for i in range(len(points)):
        t, a = corner(points[i, 0] * scale[0], shape[0] - 1.0, shape[0])
        y, b = corner(points[i, 1] * scale[1], shape[1] - 1.0, shape[1])
        x, c = corner(points[i, 2] * scale[2], shape[2] - 1.0, shape[2])
        for m in range(8):
            p, q, r = m & 1, m >> 1 & 1, m >> 2
            nodes[i, m] = (min(t + p, shape[0] - 1) * shape[1] + min(y + q, shape[1] - 1)) * shape[2] + min(
                x + r, shape[2] - 1
            )
            shares[i, m] = (a if p else 1.0 - a) * (b if q else 1.0 - b) * (c if r else 1.0 - c)


@lean_kernel
def shift_of(shift, nodes, shares, found):
    """The deformation (n, 3) at samples."""
    for i in range(len(nodes)):
        for k in range(3):
            total = 0.0
            for m in range(8):
                total += shares[i, m] * shift[nodes[i, m], k]
            found[i, k] = total


@inner_kernel
def _apply(value, out, samples, shape, stiff):
    """Σ shares² of samples, and the stiffness between neighbours of the lattice, times a value (nodes,)."""
    nodes, shares, weights = samples
    out[:] = 0.0
    for i in range(len(nodes)):
        total = 0.0
        for m in range(8):
            total += shares[i, m] * value[nodes[i, m]]
        total *= weights[i]
        for m in range(8):
            out[nodes[i, m]] += shares[i, m] * total
    strides = (shape[1] * shape[2], shape[2], 1)
    for a in range(shape[0]):
        for b in range(shape[1]):
            for c in range(shape[2]):
                here = a * strides[0] + b * strides[1] + c
                for axis in range(3):
                    if (a, b, c)[axis] + 1 < shape[axis]:
                        beyond = here + strides[axis]
                        pull = stiff * (value[here] - value[beyond])
                        out[here] += pull
                        out[beyond] -= pull


@lean_kernel
def deform(samples, goals, shape, stiff, shift, spare):
    """Least squares for the deformation (nodes, 3) by conjugate gradients; spare: (4, nodes).

    samples: nodes, shares (n, 8), weights (n,); goals: (n, 3) m that samples should go.
    """
    nodes, shares, weights = samples
    rest, way, changed = spare[0], spare[1], spare[2]
    for k in range(3):
        value = spare[3]
        for j in range(len(value)):
            value[j] = shift[j, k]
        _apply(value, rest, samples, shape, stiff)
        for j in range(len(rest)):
            rest[j] = -rest[j]
        for i in range(len(nodes)):
            for m in range(8):
                rest[nodes[i, m]] += shares[i, m] * weights[i] * goals[i, k]
        now = 0.0
        for j in range(len(rest)):
            way[j] = rest[j]
            now += rest[j] * rest[j]
        least = ERROR * ERROR * now
        for _ in range(TURNS):
            if now <= least:
                break
            _apply(way, changed, samples, shape, stiff)
            along = 0.0
            for j in range(len(way)):
                along += way[j] * changed[j]
            if along <= 0.0:
                break
            far = now / along
            before, now = now, 0.0
            for j in range(len(way)):
                value[j] += far * way[j]
                rest[j] -= far * changed[j]
                now += rest[j] * rest[j]
            for j in range(len(way)):
                way[j] = rest[j] + now / before * way[j]
        for j in range(len(value)):
            shift[j, k] = value[j]

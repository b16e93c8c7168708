"""Curves as chains of straight lines that are nowhere farther from them than a tolerance.

Evenly: n lines a piece with n = ceil(sqrt(3/4 max(|P0 - 2 P1 + P2|, |P1 - 2 P2 + P3|) / tolerance)) (Wang
1984), which looks at the sharpest bend alone, and at the pace as well as at the shape. Adaptively: a piece is
halved until it is flat, by one of two bounds. With both inner control points beside the chord, the curve is
no farther from it than 3/4 of the farther of them. And it differs from an even pace along the chord by u (1 -
u) ((1 - u) a + u b) with a = 3 P1 - 2 P0 - P3 and b = 3 P2 - P0 - 2 P3. So it differs by no more than the
longer of these, by components, over 4 (Fischer 2000, "Piecewise linear approximation of Bezier curves").

Arrays: controls (n, 4, d) m, the pieces of a curve; out (k, d) m and parameters (k,) of the chain.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import kernel

DEEPEST = 16  # halvings of a piece, 65 536 lines
MOST_LINES = 1 << DEEPEST


def even_count(controls: Floats, tolerance: float) -> int:
    """Lines for one piece (4, d) by Wang's bound, at least 1 and at most 65 536."""
    bend = controls[2:] - 2.0 * controls[1:-1] + controls[:-2]
    sharpest = math.sqrt(float((bend * bend).sum(axis=1).max()))
    return min(max(1, math.ceil(min(math.sqrt(0.75 * sharpest / tolerance), 1e9))), MOST_LINES)


@kernel(_nrt=False)
def is_flat(q, tolerance):
    """Is a piece, controls q (4, d), within the tolerance of its chord?"""
    uneven = square = first = second = 0.0
    for j in range(q.shape[1]):
        a = 3.0 * q[1, j] - 2.0 * q[0, j] - q[3, j]
        b = 3.0 * q[2, j] - q[0, j] - 2.0 * q[3, j]
        uneven += max(a * a, b * b)
        chord = q[3, j] - q[0, j]
        square += chord * chord
        first += (q[1, j] - q[0, j]) * chord
        second += (q[2, j] - q[0, j]) * chord
    if uneven <= 16.0 * tolerance * tolerance:
        return True
    if square == 0.0 or min(first, second) < 0.0 or max(first, second) > square:
        return False
    first_off = second_off = 0.0
    for j in range(q.shape[1]):
        chord = q[3, j] - q[0, j]
        a = q[1, j] - q[0, j] - first / square * chord
        b = q[2, j] - q[0, j] - second / square * chord
        first_off += a * a
        second_off += b * b
    return 9.0 * max(first_off, second_off) <= 16.0 * tolerance * tolerance


@kernel(_nrt=False)
def halve(stack, depth):
    """Split the piece stack[depth] (4, d): its second half stays, its first half becomes stack[depth + 1]."""
    for j in range(stack.shape[2]):
        p0, p1, p2, p3 = stack[depth, 0, j], stack[depth, 1, j], stack[depth, 2, j], stack[depth, 3, j]
        a, b, c = 0.5 * (p0 + p1), 0.5 * (p1 + p2), 0.5 * (p2 + p3)
        d, e = 0.5 * (a + b), 0.5 * (b + c)
        middle = 0.5 * (d + e)
        stack[depth + 1, 0, j], stack[depth + 1, 1, j] = p0, a
        stack[depth + 1, 2, j], stack[depth + 1, 3, j] = d, middle
        stack[depth, 0, j], stack[depth, 1, j], stack[depth, 2, j] = middle, e, c


@kernel(_nrt=False)
def meets(controls, i):
    """Does piece i begin where the one before ends?"""
    for j in range(controls.shape[2]):  # noqa: SIM110  a kernel has no generators
        if controls[i, 0, j] != controls[i - 1, 3, j]:
            return False
    return True


@kernel(_nrt=False)
def flatten_piece(controls, i, tolerance, stack, ends, out, parameters, count):
    """Append the ends of the lines of piece i; returns the new count, which may be beyond the capacity.

    stack: (DEEPEST + 2, 4, d) and ends: (DEEPEST + 2,) to work in. What has no space is counted, not written.
    """
    for k in range(4):
        for j in range(controls.shape[2]):
            stack[0, k, j] = controls[i, k, j]
    ends[0] = 1.0
    begin = 0.0
    depth = 0
    while depth >= 0:
        width = ends[depth] - begin
        if width * MOST_LINES > 1.0 and not is_flat(stack[depth], tolerance):
            halve(stack, depth)
            ends[depth + 1] = begin + 0.5 * width
            depth += 1
            continue
        if count < out.shape[0]:
            for j in range(controls.shape[2]):
                out[count, j] = stack[depth, 3, j]
            parameters[count] = i + ends[depth]
        count += 1
        begin = ends[depth]
        depth -= 1
    return count


@kernel(_nrt=False)
def flatten_pieces(controls, tolerance, stack, ends, out, parameters):
    """Write points (k, d) and parameters (k,) of the chain; returns k, which may be beyond the capacity."""
    for j in range(controls.shape[2]):
        out[0, j] = controls[0, 0, j]
    parameters[0] = 0.0
    count = 1
    for i in range(controls.shape[0]):
        if i > 0 and not meets(controls, i):
            if count < out.shape[0]:
                for j in range(controls.shape[2]):
                    out[count, j] = controls[i, 0, j]
                parameters[count] = i
            count += 1
        count = flatten_piece(controls, i, tolerance, stack, ends, out, parameters, count)
    return count


def flatten_adaptively(controls: Floats, tolerance: float) -> tuple[Floats, Floats]:
    """Points (k, d) of a chain within ``tolerance`` of the pieces (n, 4, d), and their parameters (k,)."""
    n, _, d = controls.shape
    stack, ends = np.empty((DEEPEST + 2, 4, d)), np.empty(DEEPEST + 2)
    room = 64 * n
    while True:
        out, parameters = np.empty((room, d)), np.empty(room)
        count = flatten_pieces(controls, tolerance, stack, ends, out, parameters)
        if count <= room:
            return out[:count].copy(), parameters[:count].copy()
        room = count


def even_parameters(controls: Floats, tolerance: float) -> Floats:
    """Parameters (k,) of a chain with Wang's number of lines for each piece (n, 4, d)."""
    counts = [even_count(piece, tolerance) for piece in controls]
    return np.concatenate([[0.0], *(i + np.arange(1, n + 1) / n for i, n in enumerate(counts))])

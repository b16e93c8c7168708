"""Viscosity: its explicit part, and the implicit one by Chebyshev's iteration.

Each component of the velocity is a padded field of faces. `gain` (as padded) is 0 for closed faces along
which the gas slips, which then drag nothing, else 1; `free` (rows, columns) is 0 for faces whose velocity is
given.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel
from game.physics.grid.borders import NO_SLIP
from game.physics.grid.ghosts import fill_velocity_ghosts
from game.physics.grid.layout import PAD
from game.physics.kernels import elementary

EXACT = 1e-5  # of what viscosity does in a step, left over by the iteration
MOST_TURNS = 400
SMOOTH, STICKY = 8.0, 7.0 + math.sqrt(19.0 / 3.0)  # bounds of -h² laplace; where parabolas end at walls


@kernel
def add_laplacian(padded, gain, part, out):
    """out (rows, columns) += part times the five-point Laplacian times h² of a padded field."""
    rows, columns = out.shape
    for j in range(rows):
        goal, row, low, high = (
            out[j],
            padded[j + PAD, 1:],
            padded[j + PAD - 1, PAD:],
            padded[j + PAD + 1, PAD:],
        )
        own, down, up = gain[j + PAD, 1:], gain[j + PAD - 1, PAD:], gain[j + PAD + 1, PAD:]
        for i in range(columns):
            here = row[i + 1]
            total = own[i] * (row[i] - here) + own[i + 2] * (row[i + 2] - here)
            goal[i] += part * (total + (down[i] * (low[i] - here) + up[i] * (high[i] - here)))


def steepest(kinds: NDArray[np.int64]) -> float:
    """Bound of the eigenvalues of -h² laplace for the kinds of the sides (4,).

    Behind a wall that the gas sticks to a ghost is a parabola's, so that cell's row is (4, -4/3), the others'
    (-1, 2, -1). Between two such walls the largest eigenvalue falls with the count of rows. It begins at
    that of four rows, the fewest of a grid: (7 + sqrt(19 / 3)) / 2 in each direction.
    """
    return STICKY if bool(np.any(kinds == NO_SLIP)) else SMOOTH


def turns_for(strength: float, steep: float) -> int:
    """Turns of the iteration for nu dt / h² = strength, by its condition, 1 + steep strength (Saad 2003)."""
    root = math.sqrt(1.0 + steep * strength)
    rate = (root - 1.0) / (root + 1.0)
    return min(MOST_TURNS, max(1, math.ceil(elementary.log(0.5 * EXACT) / elementary.log(max(rate, 1e-12)))))


@kernel
def _turn(x, goal, way, right, gain, free, strength, memory, step):
    """way = memory way + step (right - A x); goal = x + way, A x = x - strength laplacian."""
    rows, columns = right.shape
    for j in range(rows):
        row, low, high = x[j + PAD, 1:], x[j + PAD - 1, PAD:], x[j + PAD + 1, PAD:]
        own, down, up = gain[j + PAD, 1:], gain[j + PAD - 1, PAD:], gain[j + PAD + 1, PAD:]
        to, d, b, moves = goal[j + PAD, PAD:], way[j], right[j], free[j]
        for i in range(columns):
            here = row[i + 1]
            total = own[i] * (row[i] - here) + own[i + 2] * (row[i + 2] - here)
            total += down[i] * (low[i] - here) + up[i] * (high[i] - here)
            d[i] = moves[i] * (memory * d[i] + step * (b[i] - here + strength * total))
            to[i] = here + d[i]


@kernel
def diffuse_velocity(field, x, other, way, gain, free, axis, edges, numbers):
    """Solve (1 - strength h² laplace) field = field for free faces. numbers: (strength, turns, `steepest`).

    x, other: two padded arrays to work in; way (rows, columns) to work in. Chebyshev's iteration (Saad 2003,
    algorithm 12.1) on the spectrum from 1 to 1 + steepest strength.
    """
    strength, turns = numbers[0], int(numbers[1])
    rows, columns = field.shape
    half = 0.5 * numbers[2] * strength
    middle = 1.0 + half
    ratio = middle / half
    rho = 1.0 / ratio
    for j in range(rows):
        for i in range(columns):
            x[j + PAD, i + PAD] = field[j, i]
            way[j, i] = 0.0
    for turn in range(turns):
        fill_velocity_ghosts(x, axis, edges)
        if turn == 0:
            memory, step = 0.0, 1.0 / middle
        else:
            new = 1.0 / (2.0 * ratio - rho)
            memory, step = new * rho, 2.0 * new / half
            rho = new
        _turn(x, other, way, field, gain, free, strength, memory, step)
        x, other = other, x
    for j in range(rows):
        for i in range(columns):
            field[j, i] = x[j + PAD, i + PAD]

"""Downhill from many strokes at once: the simplex method of Nelder and Mead 1965, in one kernel.

A shot is no smooth function of its stroke: a contact more or less is a jump. The method asks for values only,
so a jump costs it a step and no more.
"""

from __future__ import annotations

from game.billiards.fitting.errors import STROKE_COLUMNS, track_error
from game.billiards.laws.lean import inner_kernel, lean_kernel

COST = STROKE_COLUMNS  # column of the simplex after those of the stroke
VERTICES = STROKE_COLUMNS + 1
CENTROID, TRIAL, SECOND_TRIAL = VERTICES, VERTICES + 1, VERTICES + 2  # rows after the vertices
ENOUGH = 1e-7  # relative spread of the costs at which the simplex has arrived


@inner_kernel
def _rank(simplex):
    """Rows of the best, the second worst and the worst vertex."""
    best = 0
    worst = 0
    for v in range(1, VERTICES):
        if simplex[v, COST] < simplex[best, COST]:
            best = v
        if simplex[v, COST] >= simplex[worst, COST]:
            worst = v
    second = best
    for v in range(VERTICES):
        if v != worst and simplex[v, COST] >= simplex[second, COST]:
            second = v
    return best, second, worst


@inner_kernel
def _try(target, scratch, ground, goal, sums, worst, share, row):
    """Put the point centroid + share (worst - centroid) into a row; its cost."""
    simplex = scratch.simplex
    for p in range(STROKE_COLUMNS):
        simplex[row, p] = simplex[CENTROID, p] + share * (simplex[worst, p] - simplex[CENTROID, p])
    simplex[row, COST] = track_error(target, scratch, ground, simplex[row], goal, sums)
    return simplex[row, COST]


@inner_kernel(inline="always")
def _replace(simplex, row, by):
    for p in range(COST + 1):
        simplex[row, p] = simplex[by, p]


@inner_kernel
def _shrink(target, scratch, ground, goal, sums, best):
    """Halve the simplex towards its best vertex."""
    simplex = scratch.simplex
    for v in range(VERTICES):
        if v != best:
            for p in range(STROKE_COLUMNS):
                simplex[v, p] = 0.5 * (simplex[v, p] + simplex[best, p])
            simplex[v, COST] = track_error(target, scratch, ground, simplex[v], goal, sums)


@inner_kernel
def _turn(target, scratch, ground, goal, sums, order):
    """One turn of the method. Returns how many strokes it played."""
    best, second, worst = order
    simplex = scratch.simplex
    for p in range(STROKE_COLUMNS):
        total = 0.0
        for v in range(VERTICES):
            if v != worst:
                total += simplex[v, p]
        simplex[CENTROID, p] = total / STROKE_COLUMNS
    reflected = _try(target, scratch, ground, goal, sums, worst, -1.0, TRIAL)
    if reflected < simplex[best, COST]:
        expanded = _try(target, scratch, ground, goal, sums, worst, -2.0, SECOND_TRIAL)
        _replace(simplex, worst, SECOND_TRIAL if expanded < reflected else TRIAL)
        return 2
    if reflected < simplex[second, COST]:
        _replace(simplex, worst, TRIAL)
        return 1
    share = -0.5 if reflected < simplex[worst, COST] else 0.5
    contracted = _try(target, scratch, ground, goal, sums, worst, share, SECOND_TRIAL)
    if contracted < min(reflected, simplex[worst, COST]):
        _replace(simplex, worst, SECOND_TRIAL)
        return 2
    _shrink(target, scratch, ground, goal, sums, best)
    return 2 + STROKE_COLUMNS


@lean_kernel
def descend(target, scratch, ground, strokes, goal, scales, evaluations, sums, costs):
    """Go downhill from each of the strokes (k, 5), in place. scales (5,): the first simplex. evaluations: at
    most about so many shots for each. sums (k, n, 3), costs (k,): as `errors.errors_of` at the end."""
    simplex = scratch.simplex
    for k in range(strokes.shape[0]):
        for v in range(VERTICES):
            for p in range(STROKE_COLUMNS):
                simplex[v, p] = strokes[k, p]
            if v > 0:
                simplex[v, v - 1] += scales[v - 1]
            simplex[v, COST] = track_error(target, scratch, ground, simplex[v], goal, sums[k])
        used = VERTICES
        order = _rank(simplex)
        while used < evaluations:
            used += _turn(target, scratch, ground, goal, sums[k], order)
            order = _rank(simplex)
            best, _, worst = order
            if simplex[worst, COST] - simplex[best, COST] <= ENOUGH * simplex[best, COST]:
                used = evaluations
        best, _, _ = order
        for p in range(STROKE_COLUMNS):
            strokes[k, p] = simplex[best, p]
        costs[k] = track_error(target, scratch, ground, strokes[k], goal, sums[k])

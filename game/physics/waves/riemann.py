"""Sweeps of shallow water along a row of cells: MUSCL-Hancock, HLL waves, a bed that keeps still water.

In a row, h is the depth (m), q the discharge along it, t the one across it (m²/s), z the bed (m):

    h_t + q_x = 0,    q_t + (q u + g h²/2)_x = -g h z_x,    t_t + (q v)_x = 0

Depth, level h + z and velocities go linearly through a cell, with van Leer's (1977) limiter, and half a step
on before the faces meet (Hancock, in van Leer 1984). At a face the bed is the higher one of its two sides,
and depths are reckoned from there (Audusse, Bouchut, Bristeau, Klein & Perthame 2004): water at rest stays
at rest but for the rounding of its level, since all that acts are differences of levels.

Two waves (Harten, Lax & van Leer 1983) give the flux, with Einfeldt's (1988) speeds and those of a dry bed.
What goes across is carried by the side that the water comes from: the contact wave of HLLC (Toro, Spruce &
Speares 1994). A cell gives away no more than it has.

No level goes through the cells of a film that runs down steep ground. There the bed does, half way between
neighbours (Kurganov & Petrova 2007), so that each cell passes on what it has; none keeps water that falls on
and on. Speeds at both faces of a cell share its momentum (Bouchut 2004). What is left when nearly all has
gone is slowed down, as Kurganov & Petrova reckon speeds of films.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, kernel
from game.physics.kernels import elementary
from game.physics.kernels.lanes import LANES, any_of, choose, larger, load, root, smaller, store, zeros

DRY, FILM = 1e-9, 1e-5  # m; thinner water does not move; is slowed down where it gets thinner still
TINY = 1e-30  # m/s, what two waves of nothing are apart
GHOSTS = 2
# what is beyond the first and the last cell of a row
WALL, OPEN, PERIODIC, FLOW, LEVEL = range(5)
# rows of ``row``: what a sweep reads and writes, cells with ghosts
DEPTH, ALONG, ACROSS, BED = range(4)
ROWS = 4
# rows of ``work``: level and speeds in the cells; half a step on, at their left and their right faces
SURFACE, SPEED, DRIFT, LEFT_H, LEFT_E, LEFT_U, LEFT_V, RIGHT_H, RIGHT_E, RIGHT_U, RIGHT_V = range(11)
# what goes through the left face of a cell: water, momentum over each side's own pressure, discharge across
MASS, PUSH_LEFT, PUSH_RIGHT, CARRIED = range(11, 15)
WORKS = 15


def padded(count: int) -> int:
    """Columns of ``row`` and ``work`` for so many cells: with ghosts, and whole lanes past them."""
    return count + 2 * GHOSTS + 2 * LANES


@inner_kernel
def _limited(middle, back, ahead):
    """Half the difference over a cell: monotonized central (van Leer 1977), 0 at an extreme."""
    back, ahead = middle - back, ahead - middle
    least = smaller(
        smaller(larger(back, -back), larger(ahead, -ahead)), 0.25 * larger(back + ahead, -back - ahead)
    )
    return choose(back * ahead > 0.0, choose(back > 0.0, least, -least), 0.0)


@inner_kernel
def _fill_end(row, ghost, mirror, edge, end, value, gravity):
    """Write one ghost: as ``mirror`` or ``edge``, a cell inside, tells, by what is at that end."""
    source = mirror if end <= PERIODIC and end != OPEN else edge
    for field in range(ROWS):
        row[field, ghost] = row[field, source]
    if end == WALL:
        row[ALONG, ghost] = -row[ALONG, source]
    elif end == FLOW:  # a dry bed is met at the critical depth
        critical = elementary.cbrt(value * value / gravity) if gravity > 0.0 else 0.0
        row[DEPTH, ghost] = max(row[DEPTH, source], critical)
        row[ALONG, ghost] = value
        row[ACROSS, ghost] = 0.0
    elif end == LEVEL:
        depth, h = max(value - row[BED, source], 0.0), row[DEPTH, source]
        part = depth / h if h > DRY else 0.0
        row[DEPTH, ghost] = depth
        row[ALONG, ghost] *= part
        row[ACROSS, ghost] *= part


@kernel
def fill_ghosts(row, count, kinds, values, gravity):
    """Write the ghosts at both ends of ``row`` (ROWS, padded); kinds: (2,) WALL to LEVEL.

    values: (2,) the discharge (m²/s, along the row) of a FLOW, the height (m) of a LEVEL.
    """
    first, last = GHOSTS, GHOSTS + count - 1
    for k in range(GHOSTS):
        near, far = first + min(k, count - 1), last - min(k, count - 1)
        around = kinds[0] == PERIODIC
        _fill_end(row, first - 1 - k, far if around else near, first, kinds[0], values[0], gravity)
        _fill_end(row, last + 1 + k, near if around else far, last, kinds[1], values[1], gravity)


@kernel
def fastest(depth, along, across, gravity, work):
    """The largest speed of a wave, |u| + sqrt(g h) of either direction, m/s. Fields (ny, nx), without gaps.

    work: (LANES,) at least, written.
    """
    size, found = depth.size, zeros()
    for i in range(0, size - LANES + 1, LANES):
        h, q, t = load(depth, i), load(along, i), load(across, i)
        speed = larger(larger(q, -q), larger(t, -t)) / larger(h, DRY) + root(gravity * h)
        found = larger(found, choose(h > DRY, speed, 0.0))
    store(work, 0, found)
    most = 0.0
    for k in range(LANES):
        most = max(most, work[k])
    for i in range(size - size % LANES, size):
        h = depth.flat[i]
        if h > DRY:
            most = max(most, max(abs(along.flat[i]), abs(across.flat[i])) / h + math.sqrt(gravity * h))
    return most


@inner_kernel
def _slope(array, at, wet):
    """Half the difference over the cells ``at`` of an array, counted through it; 0 where not ``wet``."""
    return choose(wet, _limited(load(array, at), load(array, at - 1), load(array, at + 1)), 0.0)


@inner_kernel
def _is_film(row, work, width, i):
    """Where water is above the level of a neighbour with its bed: it runs down, and is part of no lake."""
    bed, low = load(row, BED * width + i), load(work, SURFACE * width + i - 1)
    low = smaller(low, load(work, SURFACE * width + i + 1))
    return choose(low < bed, load(row, DEPTH * width + i), 0.0) > DRY


@inner_kernel
def _bed_beside(row, work, width, i, other):
    """Of a film, at its face with the cells ``other``: half way, and not below a lower level there."""
    bed, level = load(row, BED * width + i), load(work, SURFACE * width + other)
    middle = 0.5 * (bed + load(row, BED * width + other))
    return choose(level < bed, larger(middle, level), middle)


@inner_kernel
def _half_step(row, work, width, count, share, gravity, second):
    """Depth, level, speeds at both faces of cells, half a step on (Toro 2001, 14.4); share: dt / (2 dx)."""
    for i in range(0, count + 4, LANES):
        h = load(row, DEPTH * width + i)
        part = 1.0 / larger(h, DRY)
        store(work, SURFACE * width + i, h + load(row, BED * width + i))
        store(work, SPEED * width + i, part * load(row, ALONG * width + i))
        store(work, DRIFT * width + i, part * load(row, ACROSS * width + i))
    least = DRY if second else math.inf
    for i in range(1, count + 3, LANES):
        h, u = load(row, DEPTH * width + i), load(work, SPEED * width + i)
        wet = h > least
        dh, de = _slope(row, DEPTH * width + i, wet), _slope(work, SURFACE * width + i, wet)
        du, dv = _slope(work, SPEED * width + i, wet), _slope(work, DRIFT * width + i, wet)
        poured = smaller(2.0 * share * (h * du + u * dh), h - larger(dh, -dh))
        h, e = h - poured, load(work, SURFACE * width + i) - poured
        left, right = e - de, e + de
        film = _is_film(row, work, width, i)
        if any_of(film):
            back, ahead = _bed_beside(row, work, width, i, i - 1), _bed_beside(row, work, width, i, i + 1)
            left, right = choose(film, back + h - dh, left), choose(film, ahead + h + dh, right)
            de = 0.5 * (right - left)
        v = load(work, DRIFT * width + i) - 2.0 * share * u * dv
        u = u - 2.0 * share * (u * du + gravity * de)
        part = 1.0 / larger(h, DRY)
        before, after = part * (h + dh), part * (h - dh)
        store(work, LEFT_H * width + i, h - dh)
        store(work, LEFT_E * width + i, left)
        store(work, LEFT_U * width + i, u - before * du)
        store(work, LEFT_V * width + i, v - before * dv)
        store(work, RIGHT_H * width + i, h + dh)
        store(work, RIGHT_E * width + i, right)
        store(work, RIGHT_U * width + i, u + after * du)
        store(work, RIGHT_V * width + i, v + after * dv)


@inner_kernel
def _meet(work, width, i, gravity):
    """What goes through the left faces of the cells from i on."""
    el, er = load(work, RIGHT_E * width + i - 1), load(work, LEFT_E * width + i)
    bed = larger(el - load(work, RIGHT_H * width + i - 1), er - load(work, LEFT_H * width + i))
    hl, hr = larger(el - bed, 0.0), larger(er - bed, 0.0)
    ul, ur = load(work, RIGHT_U * width + i - 1), load(work, LEFT_U * width + i)
    cl, cr = root(gravity * hl), root(gravity * hr)
    middle, wave = 0.5 * (ul + ur) + cl - cr, larger(0.5 * (cl + cr) + 0.25 * (ul - ur), 0.0)
    slow = choose(hr > DRY, smaller(ul - cl, middle - wave), ul - cl)
    fast = choose(hl > DRY, larger(ur + cr, middle + wave), ur + cr)
    slow = smaller(choose(hl > DRY, slow, ur - 2.0 * cr), 0.0)
    fast = larger(choose(hr > DRY, fast, ul + 2.0 * cl), 0.0)
    ql, qr = hl * ul, hr * ur
    jump = qr * ur - ql * ul + 0.5 * gravity * (hr - hl) * (hr + hl)
    part = 1.0 / larger(fast - slow, TINY)
    mass = ql + slow * part * (fast * (hr - hl) - (qr - ql))
    drift = choose(mass > 0.0, load(work, RIGHT_V * width + i - 1), load(work, LEFT_V * width + i))
    store(work, MASS * width + i, mass)
    store(work, PUSH_LEFT * width + i, ql * ul + slow * part * (fast * (qr - ql) - jump))
    store(work, PUSH_RIGHT * width + i, qr * ur + fast * part * (slow * (qr - ql) - jump))
    store(work, CARRIED * width + i, mass * drift)


@inner_kernel
def _spare(row, work, i, ratio):
    """Let cell i give away no more than it has; ratio: dt / dx."""
    out = max(work[MASS, i + 1], 0.0) - min(work[MASS, i], 0.0)
    if ratio * out > row[DEPTH, i]:
        part = row[DEPTH, i] / (ratio * out)
        for face in range(i, i + 2):
            leaves = work[MASS, face] > 0.0 if face > i else work[MASS, face] < 0.0
            if leaves:
                pushed = (1.0 - part) * work[MASS, face] * row[ALONG, i] / max(row[DEPTH, i], DRY)
                work[MASS, face] *= part
                work[CARRIED, face] *= part
                work[PUSH_LEFT, face] -= pushed
                work[PUSH_RIGHT, face] -= pushed


@kernel
def sweep_row(row, work, count, ratio, gravity, second):
    """Go on by dt along a row: ``row`` (ROWS, padded) with its ghosts filled; ratio: dt / dx.

    work: (WORKS, padded), written. second: linear in a cell, or constant (Godunov 1959).
    """
    width = row.shape[1]
    _half_step(row, work, width, count, 0.5 * ratio, gravity, second)
    for i in range(2, count + 3, LANES):
        _meet(work, width, i, gravity)
    for i in range(2, count + 2, LANES):
        ahead, here = load(work, MASS * width + i + 1), load(work, MASS * width + i)
        if any_of(ratio * (larger(ahead, 0.0) - smaller(here, 0.0)) > load(row, DEPTH * width + i)):
            for k in range(i, min(i + LANES, count + 2)):
                _spare(row, work, k, ratio)
    for i in range(2, count + 2, LANES):
        mean = load(work, LEFT_H * width + i) + load(work, RIGHT_H * width + i)
        fall = 0.5 * gravity * mean * (load(work, RIGHT_E * width + i) - load(work, LEFT_E * width + i))
        poured = load(work, MASS * width + i + 1) - load(work, MASS * width + i)
        pushed = load(work, PUSH_LEFT * width + i + 1) - load(work, PUSH_RIGHT * width + i)
        carried = load(work, CARRIED * width + i + 1) - load(work, CARRIED * width + i)
        depth = larger(load(row, DEPTH * width + i) - ratio * poured, 0.0)
        square, least = depth * depth, choose(depth < load(row, DEPTH * width + i), FILM * FILM, DRY * DRY)
        kept = choose(depth > DRY, square / larger(square, least), 0.0)
        store(row, DEPTH * width + i, depth)
        store(row, ALONG * width + i, kept * (load(row, ALONG * width + i) - ratio * (pushed + fall)))
        store(row, ACROSS * width + i, kept * (load(row, ACROSS * width + i) - ratio * carried))

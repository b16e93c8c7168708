"""Area constraints: a closed outline keeps the area that it encloses; a triangle is the smallest outline.

    C = A - A_rest,  A = ½ Σ p_i × p_{i+1},  ∂A/∂p_i = ½ (y_{i+1} - y_{i-1}, x_{i-1} - x_{i+1})

Müller and others 2007, section 4.4 (volume in three dimensions), with compliance as Macklin and others 2016.

Arrays: x, y (n,) m; inverse_mass (n,) 1/kg; corners: indices of an outline, in order; rows (AREA_ROWS, k).
"""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.constraints.links import PBD_EVEN, XPBD
from game.physics.kernels import elementary

# rows of the outlines' numbers: area at rest (m²), stiffness (0 to 1), compliance (m³/N), λ, 1 if whole
AREA, STIFFNESS, COMPLIANCE, MULTIPLIER, INTACT = range(5)
AREA_ROWS = 5


@lean_kernel
def outline_area(x, y, corners):
    """Signed area (m²) of a closed outline, counter-clockwise positive; (x, y) of a corner is the origin."""
    total = 0.0
    count = corners.shape[0]
    ox = x[corners[0]]
    oy = y[corners[0]]
    for i in range(1, count - 1):
        p = corners[i]
        q = corners[i + 1]
        total += (x[p] - ox) * (y[q] - oy) - (x[q] - ox) * (y[p] - oy)
    return 0.5 * total


@lean_kernel
def measure_areas(x, y, corners, starts, areas):
    """Write the signed areas (k,) m² of outlines; corners, starts (k + 1,): see `sweep_areas`."""
    for j in range(areas.shape[0]):
        areas[j] = outline_area(x, y, corners[starts[j] : starts[j + 1]])


@lean_kernel
def project_outline(x, y, inverse_mass, corners, correction):
    """Move the corners along the gradient of the area by ``correction`` (kg, as λ); x, y are written."""
    count = corners.shape[0]
    first = corners[0]
    start_x = x[first]
    start_y = y[first]
    before_x = x[corners[count - 1]]
    before_y = y[corners[count - 1]]
    for i in range(count):
        p = corners[i]
        here_x = x[p]
        here_y = y[p]
        after_x = start_x if i == count - 1 else x[corners[i + 1]]
        after_y = start_y if i == count - 1 else y[corners[i + 1]]
        x[p] += inverse_mass[p] * correction * 0.5 * (after_y - before_y)
        y[p] += inverse_mass[p] * correction * 0.5 * (before_x - after_x)
        before_x = here_x
        before_y = here_y


@lean_kernel
def gradient_weight(x, y, inverse_mass, corners):
    """Σ w_i |∂A/∂p_i|² of an outline."""
    total = 0.0
    count = corners.shape[0]
    for i in range(count):
        p = corners[i - 1] if i else corners[count - 1]
        q = corners[i + 1] if i + 1 < count else corners[0]
        dx = x[q] - x[p]
        dy = y[q] - y[p]
        total += inverse_mass[corners[i]] * 0.25 * (dx * dx + dy * dy)
    return total


@lean_kernel
def sweep_areas(model, x, y, inverse_mass, corners, starts, rows, sweeps, step):
    """One sweep over all outlines in turn; x, y (n,) m and the multipliers are written.

    corners: indices of all outlines one after the other; starts (k + 1,): where each begins. step: s, by
    which compliance counts as α / step².
    """
    for j in range(starts.shape[0] - 1):
        if rows[INTACT, j] == 0.0:
            continue
        outline = corners[starts[j] : starts[j + 1]]
        weight = gradient_weight(x, y, inverse_mass, outline)
        if weight <= 0.0:
            continue
        excess = outline_area(x, y, outline) - rows[AREA, j]
        if model == XPBD:
            soft = rows[COMPLIANCE, j] / (step * step)
            correction = -(excess + soft * rows[MULTIPLIER, j]) / (weight + soft)
            rows[MULTIPLIER, j] += correction
        else:
            k = rows[STIFFNESS, j]
            if model == PBD_EVEN:
                k = 1.0 - elementary.pow(1.0 - k, 1.0 / sweeps)
            correction = -k * excess / weight
        project_outline(x, y, inverse_mass, outline, correction)

"""Distance constraints: each link is put back to its length, or part of the way, in turn (Gauss-Seidel).

    C = |p_b - p_a| - L = 0        Δp_a = w_a s n,   Δp_b = -w_b s n,   n = (p_b - p_a) / |p_b - p_a|

    position based    s = k C / (w_a + w_b)                     Müller and others 2007, eq. 10, 11
    with k'           k' = 1 - (1 - k)^(1/n), n sweeps          the same, section 3.3
    with compliance   s = (C - α̃ λ) / (w_a + w_b + α̃),  λ += s,  α̃ = α / h²   Macklin and others 2016, eq. 18

(λ is minus the paper's: the tension of the link times h².) A link whose ends coincide has no direction and is
left alone. So is one with both ends fixed or one that is torn.

Arrays: x, y (n,) m, and w (n,) 1/kg; links (m, 2); rows (LINK_ROWS, m), of which a sweep gets the part that
belongs to its run: rest, weight, softness, multiplier.
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.kernels import elementary

TINY = 1e-12  # m, length below which a link has no direction
PBD, PBD_EVEN, XPBD = range(3)
MODELS = ("pbd", "pbd-even", "xpbd")

# rows of the links' numbers: length at rest (m), correction per excess and inverse mass (kg), α̃ (1/kg), and
# the multiplier λ (kg m) of this substep
REST, WEIGHT, SOFTNESS, MULTIPLIER = range(4)
LINK_ROWS = 4


@lean_kernel
def prepare_links(w, net, stiffness, compliance, model, sweeps, relaxation, step):
    """Write WEIGHT and SOFTNESS for substeps whose compliance counts as α / step².

    w (n,) 1/kg, 0 is fixed; net: a `motion.Network`; stiffness (0 to 1) and compliance (m/N) in the order
    given. relaxation: 1, or up to 2 for over-relaxation.
    """
    links, order, torn, rows = net.links, net.order, net.torn, net.link_rows
    for e in range(links.shape[0]):
        mobility = w[links[e, 0]] + w[links[e, 1]]
        place = order[e]
        rows[SOFTNESS, e] = 0.0
        rows[WEIGHT, e] = 0.0
        if mobility == 0.0 or torn[place]:
            continue
        if model == XPBD:
            rows[SOFTNESS, e] = compliance[place] / (step * step)
            rows[WEIGHT, e] = relaxation / (mobility + rows[SOFTNESS, e])
        else:
            k = stiffness[place]
            if model == PBD_EVEN:
                k = 1.0 - elementary.pow(1.0 - k, 1.0 / sweeps)
            rows[WEIGHT, e] = relaxation * k / mobility


@lean_kernel
def sweep_together(x, y, w, a, b, size, rest, weight):
    """One run, no particle twice: ends a, a + 1, ... and b, b + 1, ...; compiled to do several at once."""
    xa = x[a : a + size]
    ya = y[a : a + size]
    wa = w[a : a + size]
    xb = x[b : b + size]
    yb = y[b : b + size]
    wb = w[b : b + size]
    for i in range(size):
        dx = xb[i] - xa[i]
        dy = yb[i] - ya[i]
        length = math.sqrt(dx * dx + dy * dy)
        pull = weight[i] * (1.0 - rest[i] / length) if length > TINY else 0.0
        xa[i] += wa[i] * pull * dx
        ya[i] += wa[i] * pull * dy
        xb[i] -= wb[i] * pull * dx
        yb[i] -= wb[i] * pull * dy


@lean_kernel
def sweep_in_turn(x, y, w, links, rest, weight):
    """Links one after the other."""
    for e in range(links.shape[0]):
        a = links[e, 0]
        b = links[e, 1]
        dx = x[b] - x[a]
        dy = y[b] - y[a]
        length = math.sqrt(dx * dx + dy * dy)
        if length > TINY:
            pull = weight[e] * (1.0 - rest[e] / length)
            x[a] += w[a] * pull * dx
            y[a] += w[a] * pull * dy
            x[b] -= w[b] * pull * dx
            y[b] -= w[b] * pull * dy


@lean_kernel
def sweep_soft_together(x, y, w, a, b, size, goal, weight):
    """One run with compliance; the multiplier is brought along. goal: rest, softness, multiplier."""
    rest, softness, multiplier = goal
    xa = x[a : a + size]
    ya = y[a : a + size]
    wa = w[a : a + size]
    xb = x[b : b + size]
    yb = y[b : b + size]
    wb = w[b : b + size]
    for i in range(size):
        dx = xb[i] - xa[i]
        dy = yb[i] - ya[i]
        length = math.sqrt(dx * dx + dy * dy)
        wished = rest[i] + softness[i] * multiplier[i]
        pull = weight[i] * (1.0 - wished / length) if length > TINY else 0.0
        multiplier[i] += pull * length
        xa[i] += wa[i] * pull * dx
        ya[i] += wa[i] * pull * dy
        xb[i] -= wb[i] * pull * dx
        yb[i] -= wb[i] * pull * dy


@lean_kernel
def sweep_soft_in_turn(x, y, w, links, rest, weight, softness, multiplier):
    """Links with compliance, one after the other."""
    for e in range(links.shape[0]):
        a = links[e, 0]
        b = links[e, 1]
        dx = x[b] - x[a]
        dy = y[b] - y[a]
        length = math.sqrt(dx * dx + dy * dy)
        if length > TINY:
            goal = rest[e] + softness[e] * multiplier[e]
            pull = weight[e] * (1.0 - goal / length)
            multiplier[e] += pull * length
            x[a] += w[a] * pull * dx
            y[a] += w[a] * pull * dy
            x[b] -= w[b] * pull * dx
            y[b] -= w[b] * pull * dy


@lean_kernel
def sweep_links(model, x, y, w, links, runs, rows):
    """One sweep over all links, run by run. x, y (n,) m and the multipliers are written; w (n,) 1/kg."""
    for r in range(runs.shape[0]):
        first = runs[r, 0]
        size = runs[r, 1]
        last = first + size
        rest = rows[REST][first:last]
        weight = rows[WEIGHT][first:last]
        if model == XPBD:
            softness = rows[SOFTNESS][first:last]
            multiplier = rows[MULTIPLIER][first:last]
            if runs[r, 2]:
                a = links[first, 0]
                b = links[first, 1]
                sweep_soft_together(x, y, w, a, b, size, (rest, softness, multiplier), weight)
            else:
                sweep_soft_in_turn(x, y, w, links[first:last], rest, weight, softness, multiplier)
        elif runs[r, 2]:
            sweep_together(x, y, w, links[first, 0], links[first, 1], size, rest, weight)
        else:
            sweep_in_turn(x, y, w, links[first:last], rest, weight)

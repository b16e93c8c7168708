"""Springs between near particles, which yield: slime (Clavet, Beaudoin and Poulin 2005, section 5).

Each pair that comes near gets a spring of the length that it has. A spring that is stretched or pressed by
more than a share of its length flows: its length follows. One that is longer than the support is gone.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel

SLOTS = 24  # springs that a particle keeps with others of higher number
NO_SPRING = -1


@inner_kernel
def slot_with(partner, a, b):
    """Where particle a keeps its spring with b, or where one could be kept; -1 if all are taken."""
    free = -1
    for s in range(SLOTS):
        if partner[a, s] == b:
            return s
        if partner[a, s] == NO_SPRING and free < 0:
            free = s
    return free


@lean_kernel
def pull_springs(pairs, order, body, place, table, rules):
    """Let springs yield and pull places (n, 2) m. Returns how many there are.

    table: (partner (n, SLOTS), length (n, SLOTS) m, seen (n, SLOTS)); rules: (stiffness 1/s², share that is
    borne, rate 1/s at which they flow, spacing, support m, dt, yields).
    """
    partner, length, seen = table
    stiffness, borne, flow, fresh, support, dt, springy = rules
    count = 0
    for i in range(len(order)):
        for s in range(SLOTS):
            seen[i, s] = 0
    for i in range(len(order)):
        for k in range(pairs.start[i], pairs.start[i + 1]):
            j = pairs.other[k]
            if body.light[i] == 0.0 or body.light[j] == 0.0:
                continue
            if not (springy[order[i]] and springy[order[j]]):
                continue
            a, b = min(order[i], order[j]), max(order[i], order[j])
            s = slot_with(partner, a, b)
            if s < 0:
                continue
            gap = pairs.gap[k]
            if partner[a, s] == NO_SPRING:
                if gap > fresh:
                    continue
                partner[a, s], length[a, s] = b, gap
            rest = length[a, s]
            if gap > rest * (1.0 + borne):
                rest += dt * flow * (gap - rest * (1.0 + borne))
            elif gap < rest * (1.0 - borne):
                rest -= dt * flow * (rest * (1.0 - borne) - gap)
            if rest > support:
                partner[a, s] = NO_SPRING
                continue
            length[a, s], seen[a, s] = rest, 1
            count += 1
            both = body.light[i] + body.light[j]
            way = dt * dt * stiffness * (1.0 - rest / support) * (rest - gap)
            way = min(max(way, -0.25 * support), 0.25 * support)
            for c in range(2):
                place[i, c] += way * body.light[i] / both * pairs.unit[k, c]
                place[j, c] -= way * body.light[j] / both * pairs.unit[k, c]
    for i in range(len(order)):
        for s in range(SLOTS):
            if seen[i, s] == 0:
                partner[i, s] = NO_SPRING
    return count

"""Links that break: those that are too long, and one by one."""

from __future__ import annotations

from game.compiler.decorator import lean_kernel
from game.physics.constraints.areas import INTACT
from game.physics.constraints.links import REST, WEIGHT


@lean_kernel
def tear(x, y, net, limit):
    """Break links longer than (1 + limit) times their length at rest; how many broke.

    Outlines with a broken link for an edge do not keep their area any more.
    """
    broken = 0
    for e in range(net.links.shape[0]):
        place = net.order[e]
        a = net.links[e, 0]
        b = net.links[e, 1]
        dx = x[b] - x[a]
        dy = y[b] - y[a]
        most = (1.0 + limit) * net.link_rows[REST, e]
        if net.torn[place] or dx * dx + dy * dy <= most * most:
            continue
        break_link(net, e)
        broken += 1
    return broken


@lean_kernel
def break_link(net, e):
    """Let link e (in the order of solving) hold no more."""
    net.torn[net.order[e]] = 1
    net.link_rows[WEIGHT, e] = 0.0
    a = net.links[e, 0]
    b = net.links[e, 1]
    for j in range(net.corner_starts.shape[0] - 1):
        first = net.corner_starts[j]
        last = net.corner_starts[j + 1]
        for i in range(first, last):
            p = net.corners[i]
            q = net.corners[i + 1] if i + 1 < last else net.corners[first]
            if (p == a and q == b) or (p == b and q == a):
                net.area_rows[INTACT, j] = 0.0

"""All links of a chain at once: one linear solve in place of many sweeps.

For a chain the matrix of the constraint forces, J M⁻¹ Jᵀ + α̃, couples a link to its two neighbours only. So
a solve costs about as much as two sweeps (Thomas algorithm). Heavy ends or long chains make it no slower. One
solve is a Newton step for the lengths. With masses that differ by more than 10^4 it wants substeps of a
millisecond while the chain is thrown about. Compare Deul, Kugelstadt, Weiler, Bender 2018, "Direct
position-based solver for stiff rods".

Arrays: x, y (n,) m; inverse_mass (n,) 1/kg; net: a `motion.Network`.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel
from game.physics.constraints import links as li

DIAGONAL, OFF, RIGHT, NORMAL_X, NORMAL_Y = range(5)
WORK_ROWS = 5
SINGULAR = (
    1e-12  # part of a diagonal below which a pivot is zero: a taut chain between pins pulls for nothing
)


@lean_kernel
def solve_chain(model, x, y, inverse_mass, nodes, chain_links, net):
    """Project the links between consecutive ``nodes``; x, y and the multipliers are written.

    chain_links: index of each link in the order of solving.
    """
    torn, order, rows, work = net.torn, net.order, net.link_rows, net.work
    count = chain_links.shape[0]
    for i in range(count):
        e = chain_links[i]
        a = nodes[i]
        b = nodes[i + 1]
        dx = x[b] - x[a]
        dy = y[b] - y[a]
        length = math.sqrt(dx * dx + dy * dy)
        whole = length > li.TINY and not torn[order[e]]
        work[NORMAL_X, i] = dx / length if whole else 0.0
        work[NORMAL_Y, i] = dy / length if whole else 0.0
        soft = rows[li.SOFTNESS, e] if model == li.XPBD else 0.0
        work[DIAGONAL, i] = inverse_mass[a] + inverse_mass[b] + soft if whole else 1.0
        work[RIGHT, i] = length - rows[li.REST, e] - soft * rows[li.MULTIPLIER, e] if whole else 0.0
        work[OFF, i] = 0.0
        if i > 0:
            cosine = work[NORMAL_X, i - 1] * work[NORMAL_X, i] + work[NORMAL_Y, i - 1] * work[NORMAL_Y, i]
            work[OFF, i] = -inverse_mass[a] * cosine
    for i in range(1, count):
        factor = work[OFF, i] / work[DIAGONAL, i - 1] if work[DIAGONAL, i - 1] > 0.0 else 0.0
        full = work[DIAGONAL, i]
        work[DIAGONAL, i] -= factor * work[OFF, i]
        work[RIGHT, i] -= factor * work[RIGHT, i - 1]
        if work[DIAGONAL, i] <= SINGULAR * full:
            work[DIAGONAL, i] = 0.0
    above = 0.0
    for k in range(count):
        i = count - 1 - k
        over = work[RIGHT, i]
        if i + 1 < count:
            over -= work[OFF, i + 1] * above
        above = over / work[DIAGONAL, i] if work[DIAGONAL, i] > 0.0 else 0.0
        work[RIGHT, i] = above
    for i in range(count):
        pull_x = work[RIGHT, i] * work[NORMAL_X, i]
        pull_y = work[RIGHT, i] * work[NORMAL_Y, i]
        a = nodes[i]
        b = nodes[i + 1]
        x[a] += inverse_mass[a] * pull_x
        y[a] += inverse_mass[a] * pull_y
        x[b] -= inverse_mass[b] * pull_x
        y[b] -= inverse_mass[b] * pull_y
        rows[li.MULTIPLIER, chain_links[i]] += work[RIGHT, i]


@lean_kernel
def solve_chains(model, x, y, inverse_mass, net):
    """`solve_chain` for each chain. A chain of c links takes c + 1 of ``nodes`` and c of ``chain_links``."""
    nodes, node_starts, chain_links = net.nodes, net.node_starts, net.chain_links
    for j in range(node_starts.shape[0] - 1):
        first = node_starts[j]
        last = node_starts[j + 1]
        some = chain_links[first - j : last - j - 1]
        solve_chain(model, x, y, inverse_mass, nodes[first:last], some, net)


def find_chains(
    links: NDArray[np.int64], count: int
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Chains that the links (m, 2) form: nodes, where each chain's nodes start, and their links.

    ValueError if the links fork or close a ring, naming the particle.
    """
    at: list[list[tuple[int, int]]] = [[] for _ in range(count)]
    for e, (a, b) in enumerate(links.tolist()):
        at[a].append((e, b))
        at[b].append((e, a))
        for node in (a, b):
            if len(at[node]) > 2:
                raise ValueError(f"links: fork at particle {node}; the direct solver wants chains")
    nodes: list[int] = []
    starts = [0]
    chain_links: list[int] = []
    seen = np.zeros(len(links), dtype=bool)
    for end in range(count):
        if len(at[end]) != 1 or seen[at[end][0][0]]:
            continue
        node = end
        nodes.append(node)
        while True:
            onward = [(e, other) for e, other in at[node] if not seen[e]]
            if not onward:
                break
            e, node = onward[0]
            seen[e] = True
            chain_links.append(e)
            nodes.append(node)
        starts.append(len(nodes))
    if not np.all(seen):
        ring = int(links[int(np.argmin(seen)), 0])
        raise ValueError(f"links: ring through particle {ring}; the direct solver wants chains with ends")
    return (
        np.array(nodes, dtype=np.int64),
        np.array(starts, dtype=np.int64),
        np.array(chain_links, dtype=np.int64),
    )

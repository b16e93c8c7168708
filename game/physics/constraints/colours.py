"""The order in which links are solved: colours, and runs that lie side by side in memory.

Links of one colour share no particle, so they may be solved in any order or all at once (Fratarcangeli and
Pellacini 2015, "Scalable partitioning for parallel position based dynamics"; greedy colouring). A run is a
stretch of links of one colour whose first ends follow each other in memory and whose second ends do too: such
runs are what a processor does four or eight at a time. Which links make runs is a matter of how particles
are numbered; see `shapes.cloth`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel

ORDERS = ("coloured", "natural", "reversed")
MAX_COLOURS = 62  # links beyond these go one by one: a hub of more links than that has no parallelism
SHORTEST_RUN = 8  # below it the start of a run costs more than it saves
START, LENGTH, TOGETHER = range(3)  # columns of a run


@kernel
def colour_links(links, used, colours):
    """Write to ``colours`` (m,) a colour that is free at both ends; MAX_COLOURS if there is none.

    It is that of the link before, so that neighbours make runs, or else the least one. links: (m, 2). used:
    (n,) int64, all 0; bit c is set where colour c is taken.
    """
    colour = 0
    for e in range(links.shape[0]):
        taken = used[links[e, 0]] | used[links[e, 1]]
        if colour == MAX_COLOURS or taken >> colour & 1:
            colour = 0
            while colour < MAX_COLOURS and taken >> colour & 1:
                colour += 1
        colours[e] = colour
        if colour < MAX_COLOURS:
            used[links[e, 0]] |= 1 << colour
            used[links[e, 1]] |= 1 << colour


def arrange_links(
    links: NDArray[np.int64], count: int, order: str
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The order of solving, (m,) indices into links, and the runs (r, 3): start, length, whether together.

    links: (m, 2) with each pair ascending. count: of particles. order: of ORDERS. Links that are not in a run
    that is solved together are solved one after the other. ValueError for an order that there is not.
    """
    if order not in ORDERS:
        raise ValueError(f"order = {order!r}: expected one of {', '.join(ORDERS)}")
    m = len(links)
    if order != "coloured":
        places = np.arange(m) if order == "natural" else np.arange(m)[::-1].copy()
        return places, np.array([[0, m, 0]], dtype=np.int64).reshape(-1, 3)[: 1 if m else 0]
    colours = np.zeros(m, dtype=np.int64)
    colour_links(links, np.zeros(count, dtype=np.int64), colours)
    places = np.lexsort((links[:, 1], links[:, 0], colours))
    return places, find_runs(links[places], colours[places])


def find_runs(links: NDArray[np.int64], colours: NDArray[np.int64]) -> NDArray[np.int64]:
    """Runs (r, 3) of links sorted by colour and ends; short ones are joined to be solved one by one."""
    m = len(links)
    if m == 0:
        return np.zeros((0, 3), dtype=np.int64)
    follows = np.all(links[1:] == links[:-1] + 1, axis=1) & (colours[1:] == colours[:-1])
    follows &= colours[1:] < MAX_COLOURS
    starts = np.concatenate([[0], np.flatnonzero(~follows) + 1])
    lengths = np.diff(np.concatenate([starts, [m]]))
    # neighbours in a run such as (0, 1), (1, 2) share a particle only if they differ in colour; ends that
    # follow each other could still overlap over a distance: the first ends of a run must not reach the second
    gaps = links[starts, 1] - links[starts, 0]
    together = (lengths >= SHORTEST_RUN) & (gaps >= lengths)
    runs: list[list[int]] = []
    for start, length, whole in zip(starts.tolist(), lengths.tolist(), together.tolist(), strict=True):
        if not whole and runs and not runs[-1][TOGETHER]:
            runs[-1][LENGTH] += length
        else:
            runs.append([start, length, int(whole)])
    return np.array(runs, dtype=np.int64)

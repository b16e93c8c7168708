"""Links and outlines as they were given, made into what a step runs over: in order, and in its own arrays."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Longs
from game.physics.constraints.bodies import bodies_of
from game.physics.constraints.chains import WORK_ROWS, find_chains
from game.physics.constraints.colours import arrange_links
from game.physics.constraints.graph import Links, Outlines
from game.physics.constraints.links import LINK_ROWS, REST
from game.physics.constraints.motion import Network

PADDING = 40  # numbers between the rows, so that equal indices do not fall on one set of a cache
NOBODY = -1


def network_of(
    count: int, links: Links, outlines: Outlines, contacts: Links, torn: Longs, order: str, direct: bool
) -> Network:
    """The constraints of ``count`` particles in the order (of ORDERS) in which links are solved.

    torn: (m,) in the order given, shared. direct: chains are found, to be solved at once. Weights of links,
    pins and reaches are still to be prepared. ValueError for an order that there is not, or links that are no
    chains.
    """
    places, runs = arrange_links(links.pairs, count, order)
    pairs = np.ascontiguousarray(links.pairs[places])
    rows = np.zeros((LINK_ROWS, len(places) + PADDING))
    rows[REST, : len(places)] = links.rest[places]
    nodes = some = np.zeros(0, dtype=np.int64)
    starts = np.zeros(1, dtype=np.int64)
    if direct:
        nodes, starts, some = find_chains(pairs, count)
    members, body_starts = bodies_of(count, links.pairs, outlines.corners, outlines.starts)
    longest = int(np.max(np.diff(starts), initial=1))
    return Network(
        pairs, runs, rows, places, torn, outlines.corners, outlines.starts, outlines.rows,
        np.full(count, NOBODY, dtype=np.int64), np.full(count, math.inf), nodes, starts, some,
        np.zeros((WORK_ROWS, longest)), contacts.pairs, contacts.rest, members, body_starts,
        np.zeros((4, len(body_starts) - 1)),
    )  # fmt: skip

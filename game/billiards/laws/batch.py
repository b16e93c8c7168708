"""What goes into the exact table's kernel and what comes out of it: a batch of shots, and a log.

All are tuples of plain arrays, so that a kernel takes few arguments and a whole batch is one call.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.laws.joint import BALL_COLUMNS, CONTACT_COLUMNS, JointScratch
from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import END_ROWS, FLOAT_ROWS, FORCE_ROWS, INTEGER_ROWS, PAIR_PLANES

Array = NDArray[np.float64]


class Workspace(NamedTuple):
    """Arrays for one shot of n balls, kept and used again; `view_workspace` cuts it up."""

    floats: Array
    integers: NDArray[np.int64]


def workspace(n: int) -> Workspace:
    """A workspace for shots of n balls."""
    m = max(1, n * (n - 1) // 2)
    balls = FLOAT_ROWS + PAIR_PLANES * n + 2 + BALL_COLUMNS
    floats = n * balls + m * (FORCE_ROWS + 2 + CONTACT_COLUMNS)
    return Workspace(np.zeros(floats), np.zeros(n * INTEGER_ROWS + m * END_ROWS, np.int64))


class Batch(NamedTuple):
    """m shots of n balls each, as the kernel reads them.

    balls (m, n, 11), constants (m, 22), a row of physics each: see `state`. elements (e, 7): rows of all
    tables in use, of each the cushions, then the jaws, then the pockets. ranges (m, 4): where those of each
    shot's table start, and end.
    """

    balls: Array
    constants: Array
    elements: Array
    ranges: NDArray[np.int64]


class Log(NamedTuple):
    """What the kernel writes; events and segments of all shots one after another, in order of time.

    events (e, 4): time (s), type, ball, ball or element (-1: none). segments (s, 12): see `state`; with no
    rows at all, none are written. ends (m, 6): start and end of each shot's events, and of its segments; how
    it ended (see `state`); time of its last event, or `until` (s). final (m, n, 11): balls as they come in,
    but in the table's frame, as are segments.
    """

    events: Array
    segments: Array
    ends: Array
    final: Array


class Elements(NamedTuple):
    """What balls meet: cushions (c, 7), jaws (j, 7), pockets (p, 7), as in `state`."""

    cushions: Array
    jaws: Array
    pockets: Array


class Cluster(NamedTuple):
    """Contacts of one moment: ends (2, m), forces (7, m), normals (m, 2); velocities (n, 2) and scratch."""

    ends: NDArray[np.int64]
    forces: Array
    normals: Array
    velocities: Array
    scratch: JointScratch


class Arrays(NamedTuple):
    """Views into a `Workspace`: state (rows, n), modes (rows, n), pairs (planes, n, n), see `state`."""

    state: Array
    modes: NDArray[np.int64]
    pairs: Array
    cluster: Cluster


@inner_kernel(inline="always")
def view_workspace(floats, integers, n):
    """The `Arrays` of a `Workspace` for n balls."""
    m = max(1, n * (n - 1) // 2)
    a = FLOAT_ROWS * n
    b = a + PAIR_PLANES * n * n
    c = b + FORCE_ROWS * m
    d = c + 2 * m
    e = d + 2 * n
    f = e + CONTACT_COLUMNS * m
    scratch = JointScratch(
        floats[e:f].reshape((m, CONTACT_COLUMNS)),
        floats[f : f + BALL_COLUMNS * n].reshape((n, BALL_COLUMNS)),
    )
    cluster = Cluster(
        integers[INTEGER_ROWS * n : INTEGER_ROWS * n + END_ROWS * m].reshape((END_ROWS, m)),
        floats[b:c].reshape((FORCE_ROWS, m)),
        floats[c:d].reshape((m, 2)),
        floats[d:e].reshape((n, 2)),
        scratch,
    )
    return Arrays(
        floats[:a].reshape((FLOAT_ROWS, n)),
        integers[: INTEGER_ROWS * n].reshape((INTEGER_ROWS, n)),
        floats[a:b].reshape((PAIR_PLANES, n, n)),
        cluster,
    )

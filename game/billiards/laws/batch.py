"""What goes into the exact table's kernel and what comes out of it: a batch of shots, and a log.

All are tuples of plain arrays, so that a kernel takes few arguments and a whole batch is one call.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.joint import BALL_COLUMNS, CONTACT_COLUMNS, JointScratch
from game.billiards.laws.lean import inner_kernel


class Workspace(NamedTuple):
    """Arrays for one shot of n balls, kept and used again; `view_workspace` cuts it up."""

    floats: Floats
    integers: NDArray[np.int64]


def workspace(n: int) -> Workspace:
    """A workspace for shots of n balls."""
    m = max(1, n * (n - 1) // 2)
    balls = s.FLOAT_ROWS + s.PAIR_PLANES * n + 2 + BALL_COLUMNS
    floats = n * balls + m * (s.FORCE_ROWS + 2 + CONTACT_COLUMNS)
    return Workspace(np.zeros(floats), np.zeros(n * s.INTEGER_ROWS + m * s.END_ROWS, np.int64))


class Batch(NamedTuple):
    """m shots of n balls each, as the kernel reads them.

    balls (m, n, 11), constants (m, 22), a row of physics each: see `state`. elements (e, 7): rows of all
    tables in use, of each the cushions, then the jaws, then the pockets. ranges (m, 4): where those of each
    shot's table start, and end.
    """

    balls: Floats
    constants: Floats
    elements: Floats
    ranges: NDArray[np.int64]


class Log(NamedTuple):
    """What the kernel writes; events and segments of all shots one after another, in order of time.

    events (e, 4): time (s), type, ball, ball or element (-1: none). segments (s, 12): see `state`; with no
    rows at all, none are written. ends (m, 6): start and end of each shot's events, and of its segments; how
    it ended (see `state`); time of its last event, or `until` (s). final (m, n, 11): balls as they come in,
    but in the table's frame, as are segments.
    """

    events: Floats
    segments: Floats
    ends: Floats
    final: Floats


class Elements(NamedTuple):
    """What balls meet: cushions (c, 7), jaws (j, 7), pockets (p, 7), as in `state`."""

    cushions: Floats
    jaws: Floats
    pockets: Floats


class Cluster(NamedTuple):
    """Contacts of one moment: ends (2, m), forces (7, m), normals (m, 2); velocities (n, 2) and scratch."""

    ends: NDArray[np.int64]
    forces: Floats
    normals: Floats
    velocities: Floats
    scratch: JointScratch


class Arrays(NamedTuple):
    """Views into a `Workspace`: state (rows, n), modes (rows, n), pairs (planes, n, n), see `state`."""

    state: Floats
    modes: NDArray[np.int64]
    pairs: Floats
    cluster: Cluster


@inner_kernel(inline="always")
def view_workspace(floats, integers, n):
    """The `Arrays` of a `Workspace` for n balls."""
    m = max(1, n * (n - 1) // 2)
    a = s.FLOAT_ROWS * n
    b = a + s.PAIR_PLANES * n * n
    c = b + s.FORCE_ROWS * m
    d = c + 2 * m
    e = d + 2 * n
    f = e + CONTACT_COLUMNS * m
    scratch = JointScratch(
        floats[e:f].reshape((m, CONTACT_COLUMNS)),
        floats[f : f + BALL_COLUMNS * n].reshape((n, BALL_COLUMNS)),
    )
    cluster = Cluster(
        integers[s.INTEGER_ROWS * n : s.INTEGER_ROWS * n + s.END_ROWS * m].reshape((s.END_ROWS, m)),
        floats[b:c].reshape((s.FORCE_ROWS, m)),
        floats[c:d].reshape((m, 2)),
        floats[d:e].reshape((n, 2)),
        scratch,
    )
    return Arrays(
        floats[:a].reshape((s.FLOAT_ROWS, n)),
        integers[: s.INTEGER_ROWS * n].reshape((s.INTEGER_ROWS, n)),
        floats[a:b].reshape((s.PAIR_PLANES, n, n)),
        cluster,
    )

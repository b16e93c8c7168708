"""Two trees against each other: which of their leaves overlap, which segments meet.

A pair of volumes that are apart ends its branch. Of a pair that overlaps the larger volume is opened. Where
two leaves overlap their segments are tested, exactly. The pairs are written down in the order in which they
come. That is a record to walk through, from which the next query can begin: where shapes have moved little,
the pairs at which a branch ended (the front) end it again, so those that were opened need no test. A pair
whose two parts were apart is asked again after a while, and if it is apart the front draws back. (Gottschalk,
Lin and Manocha 1996; fronts: Klosowski and others 1998, Li and Chen 1998.)
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.compiler.decorator import lean_kernel
from game.physics.bounds.building import BEGIN, CHILD, END, Nodes
from game.physics.bounds.overlap import gap_of_volumes
from game.physics.bounds.segments import segments_meet

APART, OPENED, MET = 0, 1, 2  # verdicts: separated; the larger one opened; two leaves that overlap
ROW_A, ROW_B, VERDICT, AGE, TESTED = 0, 1, 2, 3, 4  # columns of rows
PATIENCE = 1  # queries before an opened pair whose parts were apart is tested again
VOLUMES_TESTED, SEGMENTS_TESTED, LEAVES_MET, CROSSINGS, ROWS = 0, 1, 2, 3, 4  # places in counts
DONE, MORE_ROWS, MORE_CROSSINGS = 0, 1, 2


class Written(NamedTuple):
    """What a query writes."""

    rows: Any  # (n, 5) pairs of nodes
    gaps: Any  # (n, 3) gap and axis of each pair that was tested
    crossings: Any  # (c, 2)
    counts: Any  # (5,)


@lean_kernel(inline="always")
def test_leaves(first, a, second, b, place, written, found, scratch):
    """Test all segments of two leaves; pairs that meet are listed in ``crossings``. Returns their number.

    What does not fit into ``crossings`` is only counted.
    """
    la, ends_a, order_a = first.links, first.ends, first.order
    lb, ends_b, order_b = second.links, second.ends, second.order
    crossings, counts = written.crossings, written.counts
    c, s, x, y = place[0], place[1], place[2], place[3]
    for k in range(lb[b, BEGIN], lb[b, END]):
        j = order_b[k]
        cx, cy = c * ends_b[j, 0] - s * ends_b[j, 1] + x, s * ends_b[j, 0] + c * ends_b[j, 1] + y
        dx, dy = c * ends_b[j, 2] - s * ends_b[j, 3] + x, s * ends_b[j, 2] + c * ends_b[j, 3] + y
        for m in range(la[a, BEGIN], la[a, END]):
            i = order_a[m]
            counts[SEGMENTS_TESTED] += 1
            if segments_meet(ends_a[i, 0], ends_a[i, 1], ends_a[i, 2], ends_a[i, 3], cx, cy, dx, dy, scratch):
                if found < len(crossings):
                    crossings[found, 0], crossings[found, 1] = i, j
                found += 1
    return found


@lean_kernel
def traverse(first, second, place, slack, exact, patience, old, written, scratch):
    """All pairs of a query, in the order of a walk that goes deep first; returns DONE or what has no place.

    first, second: `Nodes` of the trees; written: `Written`; both as plain tuples. place (4,): cosine, sine,
    x, y of the second one's frame in the first one's. slack: m, a gap up to this is rounding. exact: whether
    segments are tested. old (k, 5): rows of the last query, or one row 0, 0, MET to begin afresh. scratch:
    stack (d, 2) and numbers (16,), overwritten.
    """
    first, second, written = Nodes(*first), Nodes(*second), Written(*written)
    kind, va, la, sizes_a = first.kind, first.volumes, first.links, first.sizes
    vb, lb, sizes_b = second.volumes, second.links, second.sizes
    rows, gaps, crossings, counts = written
    stack, numbers = scratch
    n = k = top = 0
    found = np.int64(0)
    for i in range(len(counts)):
        counts[i] = 0
    while top > 0 or k < len(old):
        if n >= len(rows):
            return MORE_ROWS
        if found > 4 * len(crossings):  # to count on would cost the product of both polylines at worst
            counts[CROSSINGS] = found
            return MORE_CROSSINGS
        again = False  # a pair that was opened last time
        if top > 0:
            top -= 1
            a, b = stack[top, 0], stack[top, 1]
        else:
            a, b = np.int64(old[k, ROW_A]), np.int64(old[k, ROW_B])
            if old[k, VERDICT] == OPENED:
                again = True
                both_apart = old[k + 1, VERDICT] == APART and old[k + 2, VERDICT] == APART
                if not (both_apart and old[k, AGE] >= patience):
                    rows[n, ROW_A], rows[n, ROW_B], rows[n, VERDICT] = a, b, OPENED
                    rows[n, AGE], rows[n, TESTED] = old[k, AGE] + 1, 0
                    gaps[n, 0], gaps[n, 1], gaps[n, 2] = 0.0, 0.0, 0.0
                    n += 1
                    k += 1
                    continue
            else:
                k += 1
        gap, nx, ny = gap_of_volumes(kind, va, a, vb, b, place)
        counts[VOLUMES_TESTED] += 1
        verdict = OPENED
        if gap > slack:
            verdict = APART
            k += 3 if again else 0
        elif again:
            k += 1
        elif la[a, CHILD] < 0 and lb[b, CHILD] < 0:
            verdict = MET
            counts[LEAVES_MET] += 1
            if exact:
                found = test_leaves(first, a, second, b, place, written, found, numbers)
        else:
            open_a = lb[b, CHILD] < 0 or (la[a, CHILD] >= 0 and sizes_a[a] >= sizes_b[b])
            for side in range(1, -1, -1):
                stack[top, 0] = la[a, CHILD] + side if open_a else a
                stack[top, 1] = b if open_a else lb[b, CHILD] + side
                top += 1
        rows[n, ROW_A], rows[n, ROW_B], rows[n, VERDICT], rows[n, AGE], rows[n, TESTED] = a, b, verdict, 0, 1
        gaps[n, 0], gaps[n, 1], gaps[n, 2] = gap, nx, ny
        n += 1
    counts[CROSSINGS], counts[ROWS] = found, n
    return MORE_CROSSINGS if found > len(crossings) else DONE

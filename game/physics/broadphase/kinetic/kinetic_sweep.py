"""A kinetic sweep over velocity-aligned discrete oriented polytopes (Coming and Staadt 2004, 2006, 2008).

A box in motion gets a bound of what it covers in the steps to come: its extents along x and y, and one slab
more, of k / 2 fixed directions the one most nearly across its motion. That slab is the thin one: it cuts off
the corners that a box about a slanting path would have. A queue tells when each bound is used up. Only boxes
whose bound is, or that did not move as foreseen, are bounded and swept anew. Between these events a pair of
bounds that overlap stays a candidate, and candidates alone are tested.

The authors ask when two things meet within a frame. Here, as in all broad phases of this folder, the answer
is which boxes overlap at the end of a step. So bounds may reach over many steps.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.physics.broadphase.boxes import BroadPhase
from game.physics.broadphase.kinetic import bounds as b
from game.physics.broadphase.kinetic.bounds import (
    Bounds,
    begin_bounds,
    find_events,
    forget_bounds,
    write_extents,
)
from game.physics.broadphase.kinetic.sweep import Order, keep_candidates, merge_order, sweep_all, sweep_events
from game.physics.broadphase.naive import scan_boxes
from game.physics.broadphase.ordering import LOW_HALF
from game.physics.broadphase.validation import grown
from game.physics.kernels import elementwise

MANY = 0.3  # share of the boxes from which on all get new bounds: one sweep finds each pair once then
GROWTH_OF_BOUNDS = 1.0  # of a box's size, by which its motion may lengthen its bound
PAD_OF_BOUNDS = 0.1  # of a box's size, by which a side may be elsewhere than foreseen
SLABS = (4, 8, 16)  # sides k of the polytopes: pairs of opposite ones on k / 2 directions


def directions_of(slabs: int) -> NDArray[np.float64]:
    """(k / 2, 2) unit vectors, evenly spread over half a turn: x first. ValueError unless k is 4, 8 or 16."""
    if slabs not in SLABS:
        raise ValueError(f"slabs = {slabs!r}: expected one of {', '.join(map(str, SLABS))}")
    angles = np.arange(slabs // 2) * (2.0 * np.pi / slabs)
    return np.stack([elementwise.cos(angles), elementwise.sin(angles)], axis=1)


class KineticSweep(BroadPhase):
    """Bounds of k sides over boxes in motion, and the candidates among them.

    ``slabs``: k. ``growth``, ``pad``: shares of a box's size, by which motion may lengthen a bound, and by
    which a side may deviate from its path. ``events``: bounds that began in the last step; ``candidates``: of
    that step. A step is an answer after something has changed.
    """

    def __init__(self, slabs: int = 8, growth: float = GROWTH_OF_BOUNDS, pad: float = PAD_OF_BOUNDS):
        super().__init__()
        for name, share in (("growth", growth), ("pad", pad)):
            if not 0.0 <= share < np.inf:
                raise ValueError(f"{name} = {share!r}: expected a finite number of at least 0")
        self.slabs = slabs
        slanting = [number for number in range(slabs // 2) if number % (slabs // 4)]
        self._directions = directions_of(slabs)[slanting]
        self.events = self.candidates = self.renewals = 0
        self._step = 0
        self._ordered = 0  # boxes in the order
        self._scales = np.zeros(b.SCALES)
        self._scales[b.GROWTH], self._scales[b.PAD] = growth, pad
        self._scales[b.HEIGHT] = self._scales[b.STRIPS] = 1.0
        self._bounds = _new_bounds(self.capacity)
        self._listed: Longs = np.empty(self.capacity, np.int64)
        self._order, self._merged = _new_order(self.capacity), _new_order(self.capacity)
        self._near: Longs = np.empty(self.capacity + 1, np.int64)
        self._kept: Longs = np.empty(64, np.int64)
        self._spare: Longs = np.empty(64, np.int64)

    # -- what it shows ------------------------------------------------------------------------------

    @property
    def false_pairs(self) -> int:
        """Candidates of the last step that do not overlap."""
        return self.candidates - (0 if self._found is None else len(self._found))

    def candidate_pairs(self) -> Longs:
        """The candidates of the last step, (m, 2), sorted as pairs are."""
        keys = self._kept[: self.candidates]
        return np.stack([keys >> 32, keys & LOW_HALF], axis=1)

    def coming_events(self) -> NDArray[np.int64]:
        """(RING,) how many bounds are used up in the next step, the one after it, and so on."""
        ends = self._bounds.begun[self.ids(), 1]
        ahead = ends[ends < b.NEVER] - self._step - 1
        return np.bincount(ahead[ahead >= 0], minlength=b.RING)[: b.RING]

    def polygon(self, box: int) -> NDArray[np.float64]:
        """(m, 2) corners of a box's bound, counterclockwise; empty where it has none yet or is infinite.

        ValueError if there is no box of that id.
        """
        self._known(box)
        if self._bounds.marks[box, b.STATE] == b.UNKNOWN or not np.isfinite(self._bounds.spans[box]).all():
            return np.empty((0, 2))
        directions = [(1.0, 0.0), (0.0, 1.0)]
        if self._bounds.aligned[box] != b.NOBODY:
            directions.append(tuple(self._directions[self._bounds.aligned[box]].tolist()))
        normals = np.array(directions)
        extents = np.empty((1, len(normals), 2))
        write_extents(self._bounds, np.array([box]), normals, extents)
        x0, y0, x1, y1 = self._bounds.spans[box].tolist()
        corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        for normal, (low, high) in zip(normals[2:], extents[0, 2:], strict=True):
            corners = _cut(_cut(corners, normal, float(high)), -normal, -float(low))
        return np.array(corners).reshape(-1, 2)

    # -- what every broad phase does ----------------------------------------------------------------

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        old, new = self._bounds, _new_bounds(capacity)
        for name in Bounds._fields:
            getattr(new, name)[: len(getattr(old, name))] = getattr(old, name)
        self._bounds = new
        self._listed, self._merged = np.empty(capacity, np.int64), _new_order(capacity)
        self._near = np.empty(capacity + 1, np.int64)
        order = self._order
        ends = np.stack([grown(row, capacity) for row in order.ends])
        self._order = order._replace(ids=grown(order.ids, capacity), ends=ends)

    def _removed(self, box: int) -> None:
        self._removed_many(np.array([box]))

    def _removed_many(self, ids: Longs) -> None:
        forget_bounds(self._bounds, ids)

    def _find_pairs(self) -> Longs:
        self._step += 1
        bounds = self._bounds
        count = find_events(bounds, self.boxes, self.alive, self.top, self._step, self._listed)
        if count > MANY * len(self):
            come, tests = self._renew_all()
        elif count or self._ordered != len(self):
            come, tests = self._renew(self._listed[:count])
        else:
            come, tests = np.empty((0, 2), np.int64), 0
        self.events = count
        return self._test(come, tests)

    def _renew(self, events: Longs) -> tuple[Longs, int]:
        """New bounds for some boxes, and their candidates."""
        self._begin(events, False)
        while True:
            found, tests = sweep_events(
                self._bounds,
                self._order,
                events,
                self._scales,
                self._directions,
                self._sorter.keys,
                self._near,
            )
            if found >= 0:
                return self._sorter.sorted(found, self.top), tests
            self._sorter.grow(2 * len(self))

    def _renew_all(self) -> tuple[Longs, int]:
        """New bounds for all boxes, swept along the axis on which they are spread more."""
        ids = self.ids()
        self.renewals += 1
        self._lay_out(self.boxes[ids])
        marks = self._bounds.marks
        marks[ids, b.WHY] = np.where(marks[ids, b.WHY] == b.HELD, b.NEW, marks[ids, b.WHY])
        self._begin(ids, True)
        while True:
            found, tests = sweep_all(
                self._bounds,
                self._order,
                self._scales,
                self._directions,
                self._sorter.keys,
                self._near,
            )
            if found >= 0:
                return self._sorter.sorted(found, self.top), tests
            self._sorter.grow(4 * len(self))

    def _lay_out(self, held: Floats) -> None:
        """Choose the axis of the sweep, the typical size and the strips, for boxes (n, 4) m."""
        scales = self._scales
        sizes = held[:, 2:] - held[:, :2]
        finite = (np.abs(held) < 1e100).all(axis=1)
        if not finite.any():
            return
        scales[b.TYPICAL] = float(sizes[finite].mean())
        lowest = held[finite, :2]
        spread = lowest.std(axis=0)
        axis = int(spread[1] > spread[0])
        least, greatest = float(lowest[:, 1 - axis].min()), float(lowest[:, 1 - axis].max())
        most = min((greatest - least) / max(2.0 * scales[b.TYPICAL], 1e-300), 0.25 * math.sqrt(len(held)))
        scales[b.AXIS], scales[b.ORIGIN], scales[b.STRIPS] = (
            axis,
            least,
            max(min(int(most), b.MOST_STRIPS), 1),
        )
        scales[b.HEIGHT] = max((greatest - least) / scales[b.STRIPS], 1e-300)

    def _begin(self, ids: Longs, everything: bool) -> None:
        """Begin bounds, and put them in their places in the order."""
        bounds, scales = self._bounds, self._scales
        scales[b.STAGGER] = float(everything)
        begin_bounds(bounds, self.boxes, self._step, ids, self._directions, scales)
        axis = int(scales[b.AXIS])
        by_end = ids[np.argsort(bounds.spans[ids, axis], kind="stable")]
        placed = by_end[np.argsort(bounds.lanes[by_end], kind="stable")]
        if everything:
            self._order.begins[:] = 0
        self._ordered = merge_order(bounds, self._order, placed, axis, int(scales[b.STRIPS]), self._merged)
        self._order, self._merged = self._merged, self._order

    def _test(self, come: Longs, tests: int) -> Longs:
        """Test all candidates; ``come``: the new ones, sorted."""
        most = self.candidates + len(come)
        self._sorter.check(most)
        if most > len(self._spare):
            self._spare = np.empty(2 * most, np.int64)
        pairs = np.empty((most + 1, 2), np.int64)
        kept, found = keep_candidates(
            self._bounds.marks, self.boxes, self._kept, self.candidates, come, self._spare, pairs
        )
        self._kept, self._spare = self._spare, self._kept
        self.candidates = kept
        self.tests = tests + kept
        return pairs[:found]

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Longs:
        found = scan_boxes(self.boxes, self.alive, self.top, x0, y0, x1, y1, self._listed)
        return self._listed[:found].copy()

    def memory(self) -> int:
        """Bytes in the arrays of bounds, order, candidates, boxes and pairs."""
        parts = (self._bounds, self._order, self._merged)
        return super().memory() + sum(array.nbytes for part in parts for array in part)

    def check(self) -> None:
        """Check store, order and queue; and, after an answer, bounds and candidates."""
        super().check()
        bounds = self._bounds
        queued = 0
        for bucket, head in enumerate(bounds.heads.tolist()):
            before = b.NOBODY
            while head >= 0:
                assert self.alive[head] and bounds.begun[head, 1] % b.RING == bucket, "events are in place"
                assert bounds.links[head, 1] == before, "lists go both ways"
                before, head = head, int(bounds.links[head, 0])
                queued += 1
        ids = self.ids()
        assert queued == int((bounds.begun[ids, 1] != b.NEVER).sum()), "what is to end is in the queue"
        if self._found is None:
            return
        assert sorted(self._order.ids[: self._ordered].tolist()) == ids.tolist(), "all are in order"
        axis, begins = int(self._scales[b.AXIS]), self._order.begins
        for lane in range(b.LEVELS * int(self._scales[b.STRIPS])):
            inside = self._order.ids[begins[lane] : begins[lane + 1]]
            assert (bounds.lanes[inside] == lane).all(), "bounds stand in their lanes"
            assert (np.diff(bounds.spans[inside, axis]) >= 0.0).all(), "each lane is sorted"
        held, spans = self.boxes[ids], bounds.spans[ids]
        assert (spans[:, :2] <= held[:, :2]).all() and (held[:, 2:] <= spans[:, 2:]).all(), "boxes lie within"
        keys = self._kept[: self.candidates]
        assert (np.diff(keys) > 0).all(), "candidates are sorted, and each is there once"


def _new_bounds(capacity: int) -> Bounds:
    """Bounds of no boxes."""
    begun = np.zeros((capacity, 2), np.int64)
    begun[:, 1] = b.NEVER
    marks = np.zeros((capacity, 3), np.uint8)
    marks[:, b.WHY], marks[:, b.STATE] = b.NEW, b.UNKNOWN
    return Bounds(
        np.zeros((capacity, 4)), np.zeros((capacity, 4)), np.zeros((capacity, 4)), np.zeros((capacity, 4)),
        np.zeros((capacity, 2)), begun, np.full((capacity, 2), b.NOBODY, np.int32),
        np.full(b.RING, b.NOBODY, np.int32), marks, np.zeros(capacity, np.uint16),
        np.full(capacity, b.NOBODY, np.int8),
    )  # fmt: skip


def _new_order(capacity: int) -> Order:
    """An order of no boxes."""
    lanes = b.LEVELS * b.MOST_STRIPS
    return Order(
        np.empty(capacity, np.int64), np.zeros((4, capacity)), np.zeros(lanes + 1, np.int64),
        np.zeros(lanes), np.zeros(b.LEVELS),
    )  # fmt: skip


def _cut(
    corners: list[tuple[float, float]], normal: NDArray[np.float64], most: float
) -> list[tuple[float, float]]:
    """The part of a convex polygon where normal . x <= most (Sutherland and Hodgman 1974)."""
    kept = []
    for i, (x, y) in enumerate(corners):
        u, v = corners[i - 1]
        here, there = normal[0] * x + normal[1] * y - most, normal[0] * u + normal[1] * v - most
        if (here > 0.0) != (there > 0.0):
            part = there / (there - here)
            kept.append((float(u + part * (x - u)), float(v + part * (y - v))))
        if here <= 0.0:
            kept.append((x, y))
    return kept

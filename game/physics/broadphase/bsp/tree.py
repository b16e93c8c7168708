"""The semi-adjusting BSP tree of Luque, Comba and Freitas (2005), in the plane.

The tree is kept from step to step. A box that stays between the cuts about it costs a comparison; one that
crosses a cut is put in anew. Leaves are split and merged as they fill and empty. A part that leans is cut
anew once it has cost more than that would (see adjusting). The authors leave to the user by what measure a
part leans and when it pays; ours are the constants there.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Longs
from game.physics.broadphase.boxes import BroadPhase
from game.physics.broadphase.bsp import nodes as n
from game.physics.broadphase.bsp.adjusting import adjust
from game.physics.broadphase.bsp.nodes import Tree, put_boxes, put_in_order, take_boxes
from game.physics.broadphase.bsp.search import find_in_box, find_pairs
from game.physics.broadphase.validation import grown

PRICE = 2.0  # of cutting a part anew, for each reference and level, in references that are too many
ORDERED_EVERY = 0.1  # changes for each box after which references are put in order again


class TreeWork(NamedTuple):
    """What the tree has done since it was made."""

    repairs: int  # boxes put in anew
    merges: int
    moved: int  # boxes in parts that were cut anew


class BspTree(BroadPhase):
    """Cuts parallel to the axes; each leaf refers to the boxes that reach into it.

    ``price``: of cutting a part anew, in references that are too many, for each reference and level. With 0 a
    part is cut anew as soon as it leans, with inf it never is. ValueError unless it is 0 or more.
    """

    def __init__(self, price: float = PRICE) -> None:
        super().__init__()
        if not price >= 0.0:
            raise ValueError(f"price = {price!r}: expected 0 or more")
        self._price = float(price)
        self._tree = Tree(
            np.zeros((64, 8), np.int32), np.zeros((64, 2)), np.zeros((64, 5), np.int32),
            np.full(self.capacity, n.NOBODY, np.int32), np.zeros((self.capacity, 8)),
            np.zeros(self.capacity, np.int64), np.zeros(n.NUMBERS, np.int64),
        )  # fmt: skip
        numbers = self._tree.numbers
        numbers[n.FREE_NODE] = numbers[n.FREE_REF] = n.NOBODY
        numbers[n.NODES] = 1  # the root, an empty leaf
        self._tree.nodes[0, [n.AXIS, n.LEFT, n.RIGHT, n.HEAD]] = n.LEAF, n.NOBODY, n.NOBODY, n.NOBODY
        self._stack = np.zeros((3, n.DEEPEST), np.int64)
        self._parts = np.zeros((n.DEEPEST, 4))
        self._ids: NDArray[np.int64] = np.empty(self.capacity, np.int64)
        self._near = np.empty((4, self.capacity))
        self._changed = False  # since it was adjusted
        self._ordered_at = 0  # changes that had been made when references were last put in order

    # -- what it has done ---------------------------------------------------------------------------

    @property
    def work(self) -> TreeWork:
        """What has been done so far."""
        numbers = self._tree.numbers
        return TreeWork(*(int(numbers[k]) for k in (n.REPAIRS, n.MERGES, n.MOVED)))

    def leaves(self) -> NDArray[np.float64]:
        """(k, 5) lower and upper corners of the parts of all leaves, infinite at the rim, and their boxes."""
        nodes, cuts = self._tree.nodes, self._tree.cuts
        rows: list[tuple[float, ...]] = []
        pending: list[tuple[int, tuple[float, ...]]] = [(0, (-np.inf, -np.inf, np.inf, np.inf))]
        while pending:
            node, part = pending.pop()
            axis = int(nodes[node, n.AXIS])
            if axis == n.LEAF:
                rows.append((*part, float(nodes[node, n.COUNT])))
                continue
            cut = float(cuts[node, n.CUT])
            pending.append((int(nodes[node, n.LEFT]), (*part[: axis + 2], cut, *part[axis + 3 :])))
            pending.append((int(nodes[node, n.RIGHT]), (*part[:axis], cut, *part[axis + 1 :])))
        return np.array(rows)

    # -- what every broad phase does ----------------------------------------------------------------

    def _grow(self, capacity: int) -> None:
        super()._grow(capacity)
        tree = self._tree
        self._tree = tree._replace(
            first=grown(tree.first, capacity, n.NOBODY), safe=grown(tree.safe, capacity),
            stamps=grown(tree.stamps, capacity),
        )  # fmt: skip
        self._ids, self._near = np.empty(capacity, np.int64), np.empty((4, capacity))

    def _room(self) -> None:
        """Double nodes and references, where the old ones are used up."""
        tree = self._tree
        self._tree = tree._replace(
            nodes=grown(tree.nodes, 2 * len(tree.nodes)), cuts=grown(tree.cuts, 2 * len(tree.cuts)),
            refs=grown(tree.refs, 2 * len(tree.refs)),
        )  # fmt: skip

    def _put(self, ids: Longs, moved: bool) -> None:
        done = 0
        while (
            done := put_boxes(self._tree, self.boxes, ids, done, self._stack[0], moved)
        ) < len(ids):  # fmt: skip
            self._room()
        self._changed = True

    def _added(self, box: int) -> None:
        self._put(np.array([box]), False)

    def _added_many(self, ids: Longs) -> None:
        self._put(ids, False)

    def _removed(self, box: int) -> None:
        self._removed_many(np.array([box]))

    def _removed_many(self, ids: Longs) -> None:
        take_boxes(self._tree, ids)
        self._changed = True

    def _moved(self, box: int, x0: float, y0: float, x1: float, y1: float) -> None:
        super()._moved(box, x0, y0, x1, y1)
        self._put(np.array([box]), True)

    def _moved_many(self, ids: Longs) -> None:
        self._put(ids, True)

    def _adjust(self) -> None:
        """Bring the tree into shape, if anything has changed."""
        if not self._changed:
            return
        scratch = self._near.reshape(-1)
        while not adjust(self._tree, self.boxes, self._stack, scratch, self._ids, self._price):
            self._room()
        self._changed = False
        done = int(self._tree.numbers[[n.REPAIRS, n.SPLITS, n.MOVED]].sum())
        if done - self._ordered_at > ORDERED_EVERY * len(self):
            self._order()
            self._ordered_at = done

    def _order(self) -> None:
        """Let the references of each leaf lie side by side, as they did not after many changes."""
        refs = np.zeros_like(self._tree.refs)
        put_in_order(self._tree, refs, self._stack[0])
        self._tree = self._tree._replace(refs=refs)

    def _find_pairs(self) -> Longs:
        self._adjust()
        while (
            found := find_pairs(
                self._tree, self.boxes, self._sorter.keys, self._stack[0], self._parts, self._ids, self._near
            )
        ) < 0:
            self._sorter.grow(4 * len(self))
        self.tests = int(self._tree.numbers[n.TESTS])
        return self._sorter.sorted(found, self.top)

    def _find_in_box(self, x0: float, y0: float, x1: float, y1: float) -> Longs:
        wanted = np.array((x0, y0, x1, y1))
        found = find_in_box(self._tree, self.boxes, wanted, self._stack[0], self._ids)
        return np.sort(self._ids[:found])

    def memory(self) -> int:
        """Bytes in the arrays of tree, boxes and pairs."""
        return super().memory() + sum(array.nbytes for array in self._tree)

    def check(self) -> None:
        """Check store, lists, and that each leaf refers to just the boxes that reach into it."""
        super().check()
        nodes, refs = self._tree.nodes, self._tree.refs
        ids = self.ids()
        held = self.boxes[ids]
        seen = 0
        pending: list[tuple[int, tuple[float, ...]]] = [(0, (-np.inf, -np.inf, np.inf, np.inf))]
        while pending:
            node, part = pending.pop()
            axis = int(nodes[node, n.AXIS])
            assert axis != n.FREE, "no node in the tree is free"
            if axis != n.LEAF:
                cut = float(self._tree.cuts[node, n.CUT])
                assert part[axis] <= cut <= part[axis + 2], "a cut lies within the part that it cuts"
                pending.append((int(nodes[node, n.LEFT]), (*part[: axis + 2], cut, *part[axis + 3 :])))
                pending.append((int(nodes[node, n.RIGHT]), (*part[:axis], cut, *part[axis + 1 :])))
                continue
            listed = []
            ref = int(nodes[node, n.HEAD])
            while ref >= 0:
                assert refs[ref, n.OWNER] == node, "a reference knows its leaf"
                listed.append(int(refs[ref, n.BOX]))
                ref = int(refs[ref, n.NEXT])
            assert len(listed) == nodes[node, n.COUNT], "as many boxes are listed in a leaf as counted"
            x0, y0, x1, y1 = part
            inside = (held[:, 0] < x1) & (held[:, 2] >= x0) & (held[:, 1] < y1) & (held[:, 3] >= y0)
            assert sorted(listed) == ids[inside].tolist(), "a leaf refers to the boxes that reach into it"
            seen += len(listed)
        assert seen <= self._tree.numbers[n.REFS], "no more references are in use than were made"

"""Snapshots for stepping back: a full state now and then, within a budget of bytes.

What lies between two snapshots is made again by restoring the earlier one and stepping, with the events that
acted since. The budget holds for the copies of states. The newest snapshot is kept even if it alone is
larger, so that a scene can always return to a state that was good.
"""

from __future__ import annotations

from bisect import bisect_right
from typing import Any, NamedTuple

from game.stage.states.memory import Memory
from game.stage.states.state import state_bytes

INTERVAL = 30  # steps between snapshots of a small state: a step back costs at most so many steps
BYTES_PER_STEP = 16_384  # what copying may take for each step, on average, when states are large
DENSE_SHARE = 0.125  # of the budget: single steps kept while walking back
OVERHEAD = 600  # bytes of a snapshot beside its state


class Snapshot(NamedTuple):
    """What is needed to go on from a step as if nothing had happened since."""

    step: int
    dt: float  # s
    time_base_s: float
    time_base_step: int
    events: int  # how many events had acted before
    values: dict[str, Any]
    active: Any
    state: Any
    memory: Memory

    @property
    def bytes(self) -> int:
        """What it takes, about."""
        return OVERHEAD + 100 * len(self.values) + state_bytes(self.state) + self.memory.bytes


class SnapshotRing:
    """Snapshots in the order of their steps, the oldest given up first.

    ``budget``: bytes for all of them, at least 0 (else ValueError); `bytes` never exceeds it unless a single
    one does.
    """

    def __init__(self, budget: int):
        if isinstance(budget, bool) or not isinstance(budget, int) or budget < 0:
            raise ValueError(f"snapshot_bytes = {budget!r}: expected a whole number of bytes, 0 or more")
        self.budget = budget
        self._rare = _Shelf(budget - int(budget * DENSE_SHARE))
        self._dense = _Shelf(int(budget * DENSE_SHARE))

    @property
    def bytes(self) -> int:
        """What all snapshots take together."""
        return self._rare.bytes + self._dense.bytes

    @property
    def first_step(self) -> int:
        """The earliest step that can be returned to."""
        return self._rare.items[0].step

    @property
    def last_step(self) -> int:
        """The latest step with a snapshot, not counting those made on the way back."""
        return self._rare.items[-1].step

    @property
    def first_event(self) -> int:
        """Events before this number are needed no more for stepping back."""
        return self._rare.items[0].events

    def __len__(self) -> int:
        return len(self._rare.items)

    def interval(self, snapshot: Snapshot) -> int:
        """Steps to wait until the next snapshot after this one."""
        return max(INTERVAL, -(-snapshot.bytes // BYTES_PER_STEP))

    def add(self, snapshot: Snapshot) -> None:
        """Keep a snapshot of a step that was reached for the first time."""
        self._rare.put(snapshot, keep_newest=True)

    def dense_room(self, snapshot: Snapshot) -> int:
        """How many snapshots as heavy as this one may be kept on the way back."""
        return self._dense.budget // snapshot.bytes

    def add_dense(self, snapshot: Snapshot) -> None:
        """Keep a snapshot made on the way back: the next step back will want it."""
        self._dense.put(snapshot, keep_newest=False)

    def before(self, step: int) -> Snapshot:
        """The latest snapshot of a step not after that one; LookupError if it is out of reach."""
        found = [shelf.before(step) for shelf in (self._rare, self._dense)]
        candidates = [snapshot for snapshot in found if snapshot is not None]
        if not candidates:
            raise LookupError(f"step {step} is out of reach")
        return max(candidates, key=lambda snapshot: snapshot.step)

    def forget_dense_after(self, step: int) -> None:
        """Drop what walking back has passed."""
        self._dense.cut(step)

    def forget_after(self, step: int) -> None:
        """Drop snapshots of later steps: their future will not come."""
        self._rare.cut(step)
        self._dense.cut(step)


class _Shelf:
    """Snapshots sorted by step, with a running count of their bytes."""

    def __init__(self, budget: int):
        self.budget = budget
        self.bytes = 0
        self.items: list[Snapshot] = []

    def put(self, snapshot: Snapshot, keep_newest: bool) -> None:
        """Keep a snapshot, unless there is one of its step; drop the oldest while there are too many."""
        index = bisect_right(self.items, snapshot.step, key=lambda item: item.step)
        if index and self.items[index - 1].step == snapshot.step:
            return
        weight = snapshot.bytes
        if weight > self.budget and not keep_newest:
            return
        self.items.insert(index, snapshot)
        self.bytes += weight
        while self.bytes > self.budget and len(self.items) > 1:
            self.bytes -= self.items.pop(0).bytes

    def before(self, step: int) -> Snapshot | None:
        """The last one of that step or before it."""
        index = bisect_right(self.items, step, key=lambda item: item.step)
        return self.items[index - 1] if index else None

    def cut(self, step: int) -> None:
        """Drop those of later steps."""
        while self.items and self.items[-1].step > step:
            self.bytes -= self.items.pop().bytes

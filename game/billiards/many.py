"""Many shots at once, for searching: over threads, each in the kernel without the interpreter's lock.

What comes of a shot does not depend on how many threads there are, nor on the other shots.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from game.arrays import Floats
from game.billiards.laws import state as s
from game.billiards.laws.batch import Batch, Log
from game.billiards.shot.shot import Shot, batch_of
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import (
    MAX_EVENTS,
    check_status,
    log_for,
    play_into,
    simulate_exact,
)

CHUNK = 256  # shots a thread takes at a time
EVENTS_A_SHOT = 40  # first guess of the capacity of a log


class Trajectories(Sequence[Trajectory]):
    """Played shots, in the order given: events and ends. Paths are not kept: a `Trajectory` is played again,
    to the same bits, when it is asked for.

    rows: events of each shot as numbers, see `Trajectory`. ends: balls of each shot at its end, (n, 11) as in
    `state`, in the table's frame. end_times (m,) s.
    """

    def __init__(
        self,
        shots: Sequence[Shot],
        rows: list[Floats],
        ends: list[Floats],
        end_times: Floats,
        options: dict[str, Any],
    ) -> None:
        """options: how to play a shot again."""
        self._shots = shots
        self.rows = rows
        self.ends = ends
        self.end_times = end_times
        self._options = options

    def __len__(self) -> int:
        return len(self._shots)

    def __getitem__(self, i):
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(len(self)))]
        return simulate_exact(self._shots[i], **self._options)


def simulate_many(
    shots: Sequence[Shot], threads: int | None = None, until: float = math.inf, max_events: int = MAX_EVENTS
) -> Trajectories:
    """Play shots from event to event. threads: at most so many; None: as many as there are processors.

    SimulationError if a shot has more than `max_events` events. ValueError if threads is below 1.
    """
    if threads is not None and threads < 1:
        raise ValueError(f"simulate_many threads: must be at least 1, got {threads!r}")
    groups: dict[tuple[int, bool], list[int]] = {}
    for i, shot in enumerate(shots):
        groups.setdefault((len(shot.balls), shot.flies), []).append(i)
    chunks = [group[k : k + CHUNK] for group in groups.values() for k in range(0, len(group), CHUNK)]
    batches = [batch_of([shots[i] for i in chunk]) for chunk in chunks]
    workers = min(threads or os.cpu_count() or 1, len(chunks))
    if workers <= 1:
        played = [play_batch(batch, until, max_events) for batch in batches]
    else:
        with ThreadPoolExecutor(workers) as pool:
            played = list(pool.map(lambda batch: play_batch(batch, until, max_events), batches))
    rows: list[Floats] = [np.empty((0, 4))] * len(shots)
    ends: list[Floats] = [np.empty((0, 11))] * len(shots)
    end_times = np.empty(len(shots))
    for chunk, parts in zip(chunks, played, strict=True):
        places = iter(chunk)
        for log, first, end in parts:
            for row in range(first, end):
                i = next(places)
                rows[i] = log.events[int(log.ends[row, s.EVENTS_START]) : int(log.ends[row, s.EVENTS_END])]
                ends[i] = log.final[row]
                end_times[i] = log.ends[row, s.END_TIME]
    return Trajectories(shots, rows, ends, end_times, {"until": until, "max_events": max_events})


def play_batch(batch: Batch, until: float, max_events: int) -> list[tuple[Log, int, int]]:
    """Play a batch into as many logs as it takes: (log, first row, end of rows) each."""
    shots, n, columns = batch.balls.shape
    flies = columns > s.IN_COLUMNS
    parts = []
    first = 0
    capacity = max(1024, 2 * n * n, EVENTS_A_SHOT * shots)
    while first < shots:
        log = log_for(shots, n, capacity, paths=False, flies=flies)
        end = play_into(log, batch, first, until, max_events)
        if end == first:
            capacity *= 4
            continue
        for row in first + np.flatnonzero(log.ends[first:end, s.STATUS] != s.FINISHED):
            check_status(log.ends[row], max_events)
        parts.append((log, first, end))
        first = end
    return parts

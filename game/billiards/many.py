"""Many shots at once, for searching: over threads, each in the kernel without the interpreter's lock.

What comes of a shot does not depend on how many threads there are, nor on the other shots.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from game.billiards.exact import Batch, Log, play_shots
from game.billiards.shot import Shot, batch_of
from game.billiards.simulation import MAX_EVENTS, check_status, cut_from_log, log_for, room_for
from game.billiards.trajectory import Trajectory

Array = NDArray[np.float64]

CHUNK = 256  # shots a thread takes at a time
EVENTS_A_SHOT = 40  # first guess of the room in a log


class Trajectories(Sequence[Trajectory]):
    """Played shots, in the order given. A `Trajectory` is cut out when it is asked for."""

    def __init__(self, shots: Sequence[Shot], logs: list[Log], places: NDArray[np.int64]) -> None:
        """places (m, 2): log and row of each shot."""
        self._shots = shots
        self._logs = logs
        self._places = places

    def __len__(self) -> int:
        return len(self._shots)

    def __getitem__(self, i):
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(len(self)))]
        log, row = (int(v) for v in self._places[i])
        return cut_from_log(self._shots[i], self._logs[log], row)

    def __iter__(self) -> Iterator[Trajectory]:
        return (self[i] for i in range(len(self)))

    @property
    def end_times(self) -> Array:
        """Time of each shot's end (m,), s."""
        return np.array([self._logs[log].end_times[row] for log, row in self._places])

    def ends(self) -> list[Array]:
        """The balls of each shot at its end, (n, 11) as in `state`, about the table's middle."""
        return [self._logs[log].final[row] for log, row in self._places]


def simulate_many(
    shots: Sequence[Shot], threads: int | None = None, until: float = math.inf, max_events: int = MAX_EVENTS
) -> Trajectories:
    """Play shots from event to event. threads: at most so many; None: as many as there are processors.

    SimulationError if a shot has more than `max_events` events. ValueError if threads is below 1.
    """
    if threads is not None and threads < 1:
        raise ValueError(f"simulate_many threads: must be at least 1, got {threads!r}")
    groups: dict[int, list[int]] = {}
    for i, shot in enumerate(shots):
        groups.setdefault(len(shot.balls), []).append(i)
    chunks = [group[k : k + CHUNK] for group in groups.values() for k in range(0, len(group), CHUNK)]
    batches = [batch_of([shots[i] for i in chunk]) for chunk in chunks]
    workers = min(threads or os.cpu_count() or 1, len(chunks))
    if workers <= 1:
        played = [play_batch(batch, until, max_events) for batch in batches]
    else:
        with ThreadPoolExecutor(workers) as pool:
            played = list(pool.map(lambda batch: play_batch(batch, until, max_events), batches))
    logs: list[Log] = []
    places = np.empty((len(shots), 2), np.int64)
    for chunk, parts in zip(chunks, played, strict=True):
        row = 0
        for log, start, end in parts:
            for place in range(start, end):
                places[chunk[row]] = len(logs), place
                row += 1
            logs.append(log)
    return Trajectories(shots, logs, places)


def play_batch(batch: Batch, until: float, max_events: int) -> list[tuple[Log, int, int]]:
    """Play a batch into as many logs as it takes: (log, first row, end of rows) each."""
    shots, n = batch.balls.shape[:2]
    parts = []
    first = 0
    capacity = max(1024, 2 * n * n, EVENTS_A_SHOT * shots)
    while first < shots:
        log = log_for(shots, n, capacity)
        end = int(play_shots(room_for(n), batch, log, first, until, max_events))
        if end == first:
            capacity *= 4
            continue
        for row in range(first, end):
            check_status(int(log.status[row]), float(log.end_times[row]), max_events)
        parts.append((log, first, end))
        first = end
    return parts

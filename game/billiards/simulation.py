"""Play a shot: buffers, errors and results of the exact table, and the way in to all models."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from game.arrays import Floats
from game.billiards.exact.play import play_shots
from game.billiards.flight.play import play_flying_shots
from game.billiards.laws import state as s
from game.billiards.laws.batch import Batch, Log, Workspace, workspace
from game.billiards.lecture.shot import simulate_lecture
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot.shot_file import load_shot
from game.billiards.shot.trajectory import Trajectory
from game.billiards.stepped.play import simulate_stepped
from game.billiards.table.table import Table

MAX_EVENTS = 20_000  # of one shot; breaks have about 150
FIRST_CAPACITY = 1024  # events in a log

_own = threading.local()


class SimulationError(RuntimeError):
    """A shot that did not come to an end, or lost its numbers."""


def workspace_for(n: int) -> Workspace:
    """This thread's workspace for n balls."""
    workspaces = _own.__dict__.setdefault("workspaces", {})
    if n not in workspaces:
        workspaces[n] = workspace(n)
    return workspaces[n]


def log_for(shots: int, n: int, capacity: int, paths: bool = True, flies: bool = False) -> Log:
    """An empty log for so many shots and events; without `paths`, none for segments. flies: of balls that
    leave the slate."""
    return Log(
        np.empty((capacity, 4)),
        np.empty(
            (
                2 * capacity + shots * n if paths else 0,
                s.FLIGHT_SEGMENT_COLUMNS if flies else s.SEGMENT_COLUMNS,
            )
        ),
        np.empty((shots, 6)),
        np.empty((shots, n, s.FLIGHT_IN_COLUMNS if flies else s.IN_COLUMNS)),
    )


def play_into(log: Log, batch: Batch, first: int, until: float, max_events: int) -> int:
    """Play a batch from shot `first` on until the log is full; the number of the first that was not played.

    The entry to the two kernels: balls (m, n, 13) may leave the slate, balls (m, n, 11) do not.
    """
    work = workspace_for(batch.balls.shape[1])
    if batch.balls.shape[2] > s.IN_COLUMNS:
        return int(play_flying_shots(work, batch, log, first, until, max_events))
    return int(play_shots(*work, *batch, *log, first, until, max_events))


def _log_of_one(n: int, capacity: int, flies: bool) -> Log:
    """This thread's log for single shots of n balls."""
    logs = _own.__dict__.setdefault("flight_logs" if flies else "logs", {})
    if n not in logs or len(logs[n].events) < capacity:
        logs[n] = log_for(1, n, capacity, flies=flies)
    return logs[n]


def check_status(ends: Floats, max_events: int) -> None:
    """SimulationError if a shot did not finish. ends (6,): its row of the log."""
    if int(ends[s.STATUS]) == s.EVENT_LIMIT:
        raise SimulationError(
            f"more than {max_events} events by {ends[s.END_TIME]:.6g} s; the shot was given up"
        )
    if int(ends[s.STATUS]) == s.NOT_FINITE:
        raise SimulationError("a number of the shot's end state is not finite")


def simulate_exact(shot: Shot, until: float = math.inf, max_events: int = MAX_EVENTS) -> Trajectory:
    """Play a shot from event to event, at most to the time `until` (s).

    SimulationError if there are more than `max_events` events.
    """
    n = len(shot.balls)
    capacity = max(FIRST_CAPACITY, 4 * n * n)
    log = _log_of_one(n, capacity, shot.flies)
    while play_into(log, shot.batch, 0, until, max_events) == 0:
        log = _log_of_one(n, 4 * len(log.events), shot.flies)
    check_status(log.ends[0], max_events)
    return cut_from_log(shot, log, 0)


def warm_up_flights() -> None:
    """Compile what plays balls in the air."""
    simulate_exact(make_shot(Table.pool(), [(0.6, 0.6)]).struck(0, (0.0, 1.0, -1.0)))


def cut_from_log(shot: Shot, log: Log, number: int) -> Trajectory:
    """The trajectory of one shot of a log, in arrays of its own."""
    ends = log.ends[number].tolist()
    return Trajectory(
        shot,
        log.events[int(ends[s.EVENTS_START]) : int(ends[s.EVENTS_END])].copy(),
        log.segments[int(ends[s.SEGMENTS_START]) : int(ends[s.SEGMENTS_END])].copy(),
        log.final[number].copy(),
        ends[s.END_TIME],
    )


def simulate(shot: Shot, model: str = "exact", **options: Any) -> Trajectory:
    """Play a shot under one of the MODELS: "exact", from event to event; "stepped"; "lecture".

    options: those of the model (`simulate_exact`, `simulate_stepped`, `simulate_lecture`). ValueError for an
    unknown model.
    """
    if model not in MODELS:
        raise ValueError(f"model: must be one of {', '.join(MODELS)}, got {model!r}")
    return MODELS[model](shot, **options)


MODELS: dict[str, Callable[..., Trajectory]] = {
    "exact": simulate_exact,
    "stepped": simulate_stepped,
    "lecture": simulate_lecture,
}


def run_shot_file(path: str | Path, model: str = "exact") -> dict[str, Any]:
    """Play a shot file: events (type, time, ids), final (id to [x, y] or "pocketed"), end_time, digest.

    ShotError names what is missing or wrong in the file.
    """
    trajectory = simulate(load_shot(path), model)
    return {
        "model": model,
        "events": [{"type": e.type, "time": e.time, "ids": list(e.ids)} for e in trajectory.events],
        "final": {name: p if isinstance(p, str) else list(p) for name, p in trajectory.final.items()},
        "end_time": trajectory.end_time,
        "digest": trajectory.digest,
    }

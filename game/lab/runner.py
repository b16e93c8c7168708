"""Measuring: one point, or all points of a study.

CPU time is that of the calling thread, the least of several repeats after a warm-up, so that a study can run
behind a window. Asserting on it is no use; on errors and counters it is, for they are the same everywhere.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable

from game.lab.study import Row, Setting, Study, StudyTable

REPEATS = 7  # after a warm-up that also compiles
MOST_REPEATS = 200
Progress = Callable[[int, int, str, float], None]


class StoppedError(Exception):
    """A measurement was stopped before it was done."""


def measure(
    study: Study,
    setting: Setting,
    stop: Callable[[], bool] | None = None,
    repeats: int = REPEATS,
    seconds: float = 0.0,
) -> Row:
    """Error, counter and least CPU time of one setting. StoppedError if `stop` says so between repeats.

    What takes little time is repeated further, until so many seconds are spent: that quietens the noise.
    """
    if repeats < 1:
        raise ValueError(f"repeats: must be at least 1, got {repeats!r}")
    trial = study.trial(setting)
    trial.reset()
    trial.run()
    outcome = trial.outcome()
    least, spent, made = math.inf, 0.0, 0
    while made < repeats or (spent < seconds and made < MOST_REPEATS):
        if stop is not None and stop():
            raise StoppedError(study.name)
        trial.reset()
        begin = time.thread_time()
        trial.run()
        took = time.thread_time() - begin
        least, spent, made = min(least, took), spent + took, made + 1
    failure = outcome.failure
    if not failure and not math.isfinite(outcome.error):
        failure = "not a finite number"
    return Row(
        setting.method,
        float(setting.knob),
        float(outcome.error),
        least / trial.simulated_s,
        int(outcome.counter),
        failure,
        dict(setting.others),
        dict(setting.scene),
    )


def measure_present(
    study: Study,
    parameters: dict[str, object],
    repeats: int = REPEATS,
    seconds: float = 0.0,
    stop: Callable[[], bool] | None = None,
) -> Row | None:
    """The point at which a scene with these parameters, effects and standing is; None if it has no place.

    `Study.place` says why it has none. stop, StoppedError: see `measure`.
    """
    setting, _ = study.place(parameters)
    return None if setting is None else measure(study, setting, stop, repeats, seconds)


def run_study(
    study: Study,
    progress: Progress | None = None,
    stop: Callable[[], bool] | None = None,
    table: StudyTable | None = None,
    repeats: int = REPEATS,
    seconds: float = 0.0,
) -> StudyTable:
    """Measure all settings of a study; rows (method, knob, error, cpu_s, ...).

    progress(done, total, label, seconds_left) is called before each point and at the end (seconds_left nan
    while nothing is known). stop() true ends the run. The table holds what was measured, and handed back as
    `table` it is gone on with. ValueError if it is one of another study. Rows are added one by one, and in
    the end stand in the order of the settings. repeats, seconds: see `measure`.
    """
    table = StudyTable(study) if table is None else table
    if table.study is not study:
        raise ValueError(f"table: belongs to the study {table.study.name!r}, not to {study.name!r}")
    settings = list(study.settings())
    have = {row.key: row for row in table.rows}
    missing = [setting for setting in settings if setting.key not in have]
    ahead = sum(setting.weight for setting in missing)
    behind = 0.0
    begin = time.perf_counter()
    for setting in missing:
        if progress is not None:
            spent = time.perf_counter() - begin
            left = spent / behind * (ahead - behind) if behind > 0.0 else math.nan
            label = study.method(setting.method).label
            progress(len(have), len(settings), label, left)
        try:
            row = measure(study, setting, stop, repeats, seconds)
        except StoppedError:
            break
        have[setting.key] = row
        table.rows.append(row)  # another thread that draws the table sees it grow
        behind += setting.weight
    table.rows = [have[setting.key] for setting in settings if setting.key in have]
    table.complete = len(table.rows) == len(settings)
    if progress is not None:
        progress(len(table.rows), len(settings), "done" if table.complete else "stopped", 0.0)
    return table

"""A study that runs behind the window, and what the accuracy page shows of it."""

from __future__ import annotations

import math
import threading
from collections.abc import Mapping
from typing import Any

from game.lab import Row, Study, StudyTable, cost_to_reach, fit_order, measure_present, run_study
from game.ui.accuracy_data import AccuracyData, Progress, TableRow, sentence_for
from game.ui.numerals import format_si
from game.ui.plot_data import PlotPoint, PlotSeries, Present
from game.ui.theme import SERIES

TARGETS = tuple(10.0**power for power in (-3, -4, -2, -5, -6, -1, -7, -8, -9))  # the most useful first


class StudyRun:
    """Measures in a thread; ``table`` fills while it runs and may be gone on with later."""

    def __init__(self, study: Study, parameters: Mapping[str, Any], table: StudyTable | None = None):
        self.study = study
        self.table = table if table is not None else StudyTable(study)
        self.present: Row | None = None
        self.progress = Progress(
            len(self.table), max(len(study.settings()), 1), "the present setting", running=True
        )
        self.error = ""
        self._parameters = dict(parameters)
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._work, name=f"study {study.name}", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Stop after the present repeat."""
        self._stop.set()

    def wait(self, seconds: float | None = None) -> None:
        """Wait for the end, for tests."""
        self._thread.join(seconds)

    def _work(self) -> None:
        try:
            if self.study.present is not None:
                self.present = measure_present(self.study, self._parameters)
            run_study(self.study, self._report, self._stop.is_set, self.table)
        except Exception as error:  # a study's own code; the page says so and the scene goes on
            self.error = " ".join(str(error).split()) or type(error).__name__
        self.progress = self.progress._replace(done=len(self.table), running=False)

    def _report(self, done: int, total: int, label: str, left_s: float) -> None:
        self.progress = Progress(done, total, label, left_s, running=True)


def accuracy_data(run: StudyRun, title: str) -> AccuracyData:
    """What has been measured so far, as the page draws it."""
    study, rows = run.study, list(run.table.rows)
    table = StudyTable(study, rows)
    series = tuple(_series(study, table, i) for i in range(len(study.methods)))
    target = _target(study, table)
    lines = tuple(
        TableRow(method.label, one.order, math.nan if method.order is None else method.order,
                 cost_to_reach(table.of(method.name), target, study.envelope))
        for method, one in zip(study.methods, series, strict=True)
    )  # fmt: skip
    words = format_si(target, study.error_unit, 1) if math.isfinite(target) else ""
    notes = [run.error] if run.error else []
    notes += [study.expectation] if study.expectation else []
    return AccuracyData(
        title=title,
        subtitle=f"{study.error[:1].upper()}{study.error[1:]}; reference: {study.reference.rstrip('.')}.",
        error_unit=study.error_unit,
        series=series,
        rows=lines,
        present=_present(run.present, series, study),
        target=target,
        sentence=sentence_for(lines, words),
        notes=(*notes, "Click a point to set the scene to it."),
    )


def _series(study: Study, table: StudyTable, i: int) -> PlotSeries:
    """The runs of the i-th method in order of cost."""
    method, look = study.methods[i], SERIES[i % len(SERIES)]
    points = tuple(
        _point(study, row) for row in sorted(table.of(method.name, failed=None), key=lambda row: row.cpu_s)
    )
    order = fit_order(table.of(method.name), study.floor, study.envelope, study.order_over)
    return PlotSeries(method.label, points, order, look.color, look.marker)


def _point(study: Study, row: Row) -> PlotPoint:
    words = f"{study.knob.label} {format_si(row.knob, study.knob.unit)}"
    if row.failure:
        words += f", {row.failure}"
    return PlotPoint(row.cpu_s, row.error, diverged=row.failed, parameters=row.scene, words=words)


def _target(study: Study, table: StudyTable) -> float:
    """The round error that most methods reach; nan if none reaches any."""

    def reached(target: float) -> int:
        costs = (cost_to_reach(table.of(method.name), target, study.envelope) for method in study.methods)
        return sum(math.isfinite(cost) for cost in costs)

    best = max(TARGETS, key=reached)
    return best if reached(best) else math.nan


def _present(row: Row | None, series: tuple[PlotSeries, ...], study: Study) -> Present | None:
    """The scene's own setting, with the series that passes nearest to it."""
    if row is None or not (row.error > 0.0 and row.cpu_s > 0.0):
        return None

    def distance(one: PlotSeries) -> float:
        usable = (p for p in one.points if p.error > 0.0 and p.cpu_s > 0.0 and not p.diverged)
        return min((_apart(p, row) for p in usable), default=math.inf)

    nearest = min(range(len(series)), key=lambda i: distance(series[i]), default=0)
    words = f"{study.knob.label} {format_si(row.knob, study.knob.unit)}"
    return Present(nearest, PlotPoint(row.cpu_s, row.error, row.failed), words)


def _apart(point: PlotPoint, row: Row) -> float:
    """How far apart in the plot, in decades squared."""
    across, along = math.log10(point.cpu_s / row.cpu_s), math.log10(point.error / row.error)
    return across * across + along * along

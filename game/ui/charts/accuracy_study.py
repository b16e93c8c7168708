"""A study's table as the accuracy overlay shows it: series, orders, costs of a round error, a sentence.

Where a study has very many points of a method, its line runs along the upper envelope. The points lie about
it as a cloud. Runs still to come are placed by straight lines through those there are, in logarithms.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from game.lab import (
    ACCURACY,
    Knob,
    Row,
    Setting,
    Study,
    StudyTable,
    cost_to_reach,
    fitted,
    slope_of,
    upper_envelope,
)
from game.ui.charts.accuracy_data import AccuracyData, TableRow, sentence_for
from game.ui.charts.plot_data import PlotAxes, PlotPoint, PlotSeries, Present
from game.ui.look.numerals import format_number, format_si
from game.ui.look.theme import SERIES

MANY = 24  # points of a method that can be told apart
ENVELOPE = 16  # points of the line when there are more
FEWEST = 3  # points for an estimate of those to come


def study_data(
    table: StudyTable, scene_title: str, present: Row | None = None, trouble: str = "", place: str = ""
) -> AccuracyData:
    """What the overlay shows of a table, whole or in the making.

    ``present``: the scene's own point; ``place``: what it is measured on, or why there is none. ``trouble``:
    what went wrong in the study, if anything.
    """
    study = table.study
    target = round_error(table)
    settings = list(study.settings())
    used = {setting.method for setting in settings}
    shown = [method for method in study.methods if method.name in used]
    series = tuple(_series(table, method.name, i, settings) for i, method in enumerate(shown))
    rows = tuple(
        TableRow(
            _sentence_case(method.label),
            slope_of(study, method, fitted(table, method.name)),
            method.order if method.order is not None else math.nan,
            _cost(table, method.name, target),
        )
        for method in shown
    )
    return AccuracyData(
        scene_title, _subtitle(study), _axes(study), series, rows,
        _present(study, present, series, [method.name for method in shown]), target,
        _sentence(study, rows, target), _notes(study, series, trouble, place),
        "least" if study.axes.up == "cpu" else "", study.slope_name,
        floor=study.floor if study.axes.up == "error" else 0.0,
    )  # fmt: skip


def _subtitle(study: Study) -> str:
    if study.axes == ACCURACY:
        return f"{_sentence_case(study.error)}; reference: {study.reference}"
    up, across = study.up_words()[0], study.across_words()[0]
    return f"{_sentence_case(up)}, against {across}. {_sentence_case(study.reference)}"


def _axes(study: Study) -> PlotAxes:
    words, unit = study.across_words()
    heading = "CPU time" if study.axes.up == "cpu" else "Error"
    if study.axes.up == "error" and study.axes.across == "knob":
        heading = _sentence_case(study.error).split()[0]
    return PlotAxes(_sentence_case(words), unit, heading, study.up_words()[1])


def _cost(table: StudyTable, method: str, target: float) -> float:
    """What the round error costs, or, where cost is what is shown, the least cost there is."""
    rows = table.of(method)
    if table.study.axes.up == "cpu":
        return min((row.cpu_s for row in rows), default=math.nan)
    if table.study.axes.across == "knob" or math.isnan(target):
        return math.nan
    return cost_to_reach(rows, target, table.study.envelope)


def round_error(table: StudyTable) -> float:
    """The smallest power of ten that as many methods as possible come to stay below; nan if none does."""
    study = table.study
    if study.axes != ACCURACY:
        return math.nan
    errors = [row.error for row in table if not row.failed and row.error > study.floor]
    if not errors:
        return math.nan
    by_method = [_decisive(study, table.of(method.name)) for method in study.methods]
    best, found = 1, math.nan
    for power in range(math.floor(math.log10(max(errors))), math.floor(math.log10(min(errors))) - 1, -1):
        costs = (cost_to_reach(rows, 10.0**power) for rows in by_method)
        reached = sum(math.isfinite(cost) for cost in costs)
        if reached >= best:
            best, found = reached, 10.0**power
    return found


def _decisive(study: Study, rows: list[Row]) -> list[Row]:
    """The rows that decide what an error costs, found once for all errors."""
    return upper_envelope(rows, over="counter") if study.envelope else rows


@lru_cache(maxsize=8192)
def setting_words(parameter: Knob, value: float, others: tuple[tuple[str, float], ...] = ()) -> str:
    """A point in words: its parameter with unit, and what else tells it apart."""
    number = format_si(value, parameter.unit) if parameter.unit else _plain(value)
    return ", ".join([f"{parameter.label} {number}", *(f"{name} {_plain(x)}" for name, x in others)])


def _plain(value: float) -> str:
    """A count as it is, else a number of a few digits."""
    return str(int(value)) if abs(value) < 1e5 and float(value).is_integer() else format_number(value)


def _point(study: Study, row: Row) -> PlotPoint:
    words = setting_words(study.knob, row.knob, tuple(row.others.items()))
    if row.failed:
        words = f"{words}: {row.failure}"
    mark = study.mark(row) if study.mark is not None and not row.failed else ""
    return PlotPoint(study.across(row), study.up(row), row.failed, False, row.scene, words, mark)


def _series(table: StudyTable, method: str, i: int, settings: Sequence[Setting]) -> PlotSeries:
    """The runs of one method, a line through them or through their envelope, and those still to come."""
    study = table.study
    rows = _in_turn(study, table.of(method))
    failed = [_point(study, row) for row in table.of(method, failed=True)]
    order = slope_of(study, study.method(method), fitted(table, method))
    cloud: list[PlotPoint] = []
    chosen = rows
    if len(rows) > MANY and study.axes.up == "error":
        chosen = _in_turn(study, upper_envelope(fitted(table, method), ENVELOPE, study.order_over))
        kept = {id(row) for row in chosen}
        cloud = [_point(study, row) for row in rows if id(row) not in kept]
    have = {row.key for row in table.of(method, failed=None)}
    missing = [setting for setting in settings if setting.method == method and setting.key not in have]
    coming = _estimates(study, rows, missing)
    style = SERIES[i % len(SERIES)]
    points = (*failed, *(_point(study, row) for row in chosen), *coming)
    told = study.method(method)
    color = told.color or style.color
    return PlotSeries(_sentence_case(told.label), points, order, color, style.marker, tuple(cloud))


def _in_turn(study: Study, rows: Sequence[Row]) -> list[Row]:
    """Rows in the order in which they are joined, from the left: that of the parameter, for cost is noisy."""
    found = sorted(rows, key=lambda row: row.knob)
    return found[::-1] if found and study.across(found[0]) > study.across(found[-1]) else found


def _estimates(study: Study, rows: Sequence[Row], missing: Sequence[Setting]) -> list[PlotPoint]:
    """Where the runs of a method that are still to come may lie; none without enough points."""
    if study.axes != ACCURACY:
        return []
    good = [row for row in rows if row.error > study.floor and row.cpu_s > 0.0 and row.knob > 0.0]
    if not missing or len(missing) > MANY or len({row.knob for row in good}) < FEWEST:
        return []
    declared = np.log([row.knob for row in good])
    error, cost = (np.polyfit(declared, np.log(values), 1) for values in
                   ([row.error for row in good], [row.cpu_s for row in good]))  # fmt: skip
    last = max(row.cpu_s for row in good)
    found = []
    for setting in missing:
        point = _estimate(study, setting, error, cost)
        if point.x > last:
            found.append(point)
    return sorted(found, key=lambda point: point.x)


def _estimate(study: Study, setting: Setting, error: np.ndarray, cost: np.ndarray) -> PlotPoint:
    at = math.log(setting.knob)
    words = setting_words(study.knob, setting.knob, tuple(setting.others.items()))
    return PlotPoint(
        math.exp(float(np.polyval(cost, at))), math.exp(float(np.polyval(error, at))), False, True,
        setting.scene, words,
    )  # fmt: skip


def _present(
    study: Study, row: Row | None, series: Sequence[PlotSeries], names: Sequence[str]
) -> Present | None:
    """The point measured for the scene, with its method if it is one of the study's.

    Where the study has a problem of its own it is no place of the scene, but one of its settings.
    """
    if row is None:
        return None
    point, words = _point(study, row), setting_words(study.knob, row.knob)
    head = "your settings" if study.workload.own is None else "you are here"
    if row.method not in names:
        return Present(-1, point, words, head)
    index = names.index(row.method)
    return Present(index, point, f"{series[index].name}, {words}", head)


def _sentence(study: Study, rows: Sequence[TableRow], target: float) -> str:
    """The comparison of costs if there is one, else what the study is about to show."""
    words = (
        format_si(target, study.error_unit, 1)
        if study.error_unit
        else f"an error of {format_number(target, 1)}"
    )
    labels = {_sentence_case(method.label): method.label for method in study.methods}
    inside = [row._replace(name=labels.get(row.name, row.name)) for row in rows]
    if study.axes != ACCURACY or study.lesson or math.isnan(target):
        return study.expectation
    return sentence_for(inside, words) or study.expectation


def _notes(study: Study, series: Sequence[PlotSeries], trouble: str, place: str) -> tuple[str, ...]:
    notes = [words for words in (trouble, place) if words]
    if study.envelope:
        notes.append("Orders are fitted to the upper envelope.")
    of_errors = study.axes.up == "error"
    if of_errors and any(0.0 <= point.y <= study.floor for one in series for point in one.points):
        notes.append("Points on the lower edge err by rounding only.")
    if any(point.pending for one in series for point in one.points):
        notes.append("Hollow: still to be measured.")
    notes.append("Click a point to set the scene to it.")
    return tuple(notes)


def _sentence_case(label: str) -> str:
    """With a capital, but for a symbol of one letter."""
    return label[:1].upper() + label[1:] if label[1:2].isalpha() or label[:2] == "a " else label

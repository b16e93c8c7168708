"""A study's table on disk: CSV, Markdown, PNG."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Any

from game.lab.analysis import TARGETS, summarise, upper_envelope, usable
from game.lab.study import ACCURACY, Row, Study, StudyTable

# colours that colour-blind people can tell apart, each with a shape of its own (Okabe and Ito 2008)
FEW = 24  # points that are drawn singly; of more the upper envelope
SERIES = (
    ("#0072B2", "o"),
    ("#D55E00", "s"),
    ("#009E73", "^"),
    ("#CC79A7", "D"),
    ("#E69F00", "v"),
    ("#56B4E9", "P"),
    ("#000000", "X"),
)


class PlotsMissingError(RuntimeError):
    """Pictures need matplotlib, which is not installed."""


def write_csv(table: StudyTable, path: Path) -> Path:
    """All rows, one a line; further knobs and scene parameters in columns of their own."""
    others = sorted({name for row in table for name in row.others})
    scene = sorted({name for row in table for name in row.scene})
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        fixed = ["method", table.study.knob.name, "error", "cpu_s", "counter", "failure"]
        writer.writerow([*fixed, *others, *(f"scene.{name}" for name in scene)])
        for row in table:
            values = [row.method, repr(row.knob), repr(row.error), repr(row.cpu_s), row.counter, row.failure]
            values += [row.others.get(name, "") for name in others]
            writer.writerow([*values, *(row.scene.get(name, "") for name in scene)])
    return path


def write_markdown(table: StudyTable, path: Path, picture: str = "") -> Path:
    """What was measured, in words and one table."""
    study = table.study
    lines = [f"# {study.title}", ""]
    if picture:
        lines += [f"![{study.title}]({picture})", ""]
    lines += [
        f"Error: {study.error}" + (f" ({study.error_unit})" if study.error_unit else "") + ".",
        f"Knob: {study.knob.label}" + (f" ({study.knob.unit})" if study.knob.unit else "") + ".",
        f"Counter: {study.counter}.",
        f"Reference: {study.reference}",
        "Cost: CPU seconds of one thread for each simulated second, least of several repeats.",
        "",
    ]
    if study.expectation:
        lines += [study.expectation, ""]
    if not table.complete:
        lines += ["The run was stopped before all points were measured.", ""]
    targets = TARGETS if study.axes == ACCURACY else ()
    cheapest = ["least cost", f"at {study.knob.label}"] if study.axes.up == "cpu" else []
    heads = [
        "method",
        study.slope_name,
        "expected",
        *(f"cost of {target:g}" for target in targets),
        *cheapest,
        "points",
        "failed",
        "out of order",
    ]
    lines += ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads)]
    for line in summarise(table):
        expected = "" if line.expected is None else f"{line.expected:g}"
        cells = [line.label, _number(line.order), expected, *map(_number, line.costs[: len(targets)])]
        if cheapest:
            least = min(table.of(line.method), key=lambda row: row.cpu_s, default=None)
            cells += ["", ""] if least is None else [_number(least.cpu_s), _number(least.knob)]
        cells += [str(line.points), str(line.failed), str(line.out_of_order)]
        lines.append("| " + " | ".join(cells) + " |")
    lines += _failures(table)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def write_png(table: StudyTable, path: Path) -> Path:
    """The picture of a study by its axes, logarithmic; failed points crossed out.

    PlotsMissingError without matplotlib.
    """
    figure_class, canvas_class = _matplotlib()
    figure = figure_class(figsize=(9.0, 6.0), dpi=120, layout="constrained")
    canvas_class(figure)
    axes = figure.add_subplot()
    study = table.study
    positive = [study.up(row) for row in table if not row.failed and study.up(row) > 0.0]
    lowest = min(positive, default=1e-3) / 3.0
    for (colour, shape), line in zip(_series(len(study.methods)), summarise(table), strict=True):
        rows = sorted(table.of(line.method), key=study.across)
        order = "" if math.isnan(line.order) else f"  ({study.slope_name} {line.order:.2f})"
        _plot(axes, study, rows, lowest, color=colour, marker=shape, label=line.label + order)
        failed = [row for row in table.of(line.method, failed=True) if row.cpu_s > 0.0]
        if failed:
            heights = [study.up(row) for row in failed]
            heights = [y if math.isfinite(y) and y > 0.0 else lowest for y in heights]
            axes.plot(
                [study.across(row) for row in failed], heights, "x", color=colour,
                markersize=9 if len(failed) <= FEW else 5, alpha=1.0 if len(failed) <= FEW else 0.35,
            )  # fmt: skip
    if table.rows:
        axes.set_xscale("log")
        axes.set_yscale("log")
    axes.set_xlabel(_with_unit(*study.across_words()))
    axes.set_ylabel(_with_unit(*study.up_words()))
    axes.set_title(study.title + ("   x: failed" if any(row.failed for row in table) else ""))
    axes.grid(True, which="major", color="#dddddd")
    axes.legend()
    figure.savefig(path)
    return path


def write_report(table: StudyTable, folder: Path) -> list[Path]:
    """CSV, PNG and Markdown, named after the study; returns the files.

    PlotsMissingError without matplotlib, after the others are written.
    """
    folder.mkdir(parents=True, exist_ok=True)
    name = table.study.name
    written = [write_csv(table, folder / f"{name}.csv")]
    try:
        written.append(write_png(table, folder / f"{name}.png"))
    except PlotsMissingError:
        write_markdown(table, folder / f"{name}.md")
        raise
    written.append(write_markdown(table, folder / f"{name}.md", f"{name}.png"))
    return written


def _failures(table: StudyTable) -> list[str]:
    """One line for each method and way of failing, with the range of the knob where it happened."""
    knob = table.study.knob
    found: dict[tuple[str, str], list[float]] = {}
    for row in table:
        if row.failed:
            found.setdefault((row.method, row.failure), []).append(row.knob)
    if not found:
        return []
    lines = ["", "Failed:", ""]
    for (method, failure), places in found.items():
        between = f"{min(places):.3g} to {max(places):.3g}" if len(places) > 1 else f"{places[0]:.3g}"
        label = table.study.method(method).label
        lines.append(
            f"- {label}: {failure} ({len(places)} points, {knob.label} {between} {knob.unit})".replace(
                " )", ")"
            )
        )
    return lines


def _with_unit(words: str, unit: str) -> str:
    return f"{words} ({unit})" if unit else words


def _plot(axes: Any, study: Study, rows: list[Row], lowest: float, **style: Any) -> None:
    """Points, joined; of many the upper envelope is joined, as their errors rise and fall like saw teeth.

    Errors of zero lie on the lower edge.
    """
    if study.axes.up == "error" and len(usable(rows, 0.0)) > FEW:
        faint = {**style, "label": None, "alpha": 0.22}
        places = [study.across(row) for row in rows]
        axes.plot(places, [max(study.up(row), lowest) for row in rows], ls="", ms=3.0, **faint)
        rows = sorted(upper_envelope(usable(rows, 0.0)), key=study.across)
    places = [study.across(row) for row in rows]
    heights = [max(study.up(row), lowest) for row in rows]
    axes.plot(places, heights, linestyle="-", markersize=5.0, linewidth=1.4, **style)


def _series(count: int) -> list[tuple[str, str]]:
    return [SERIES[i % len(SERIES)] for i in range(count)]


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.3g}"


def _matplotlib() -> tuple[Any, Any]:
    """Figure and canvas classes; drawn without a screen."""
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        raise PlotsMissingError("pictures need matplotlib: pip install 'carom[plots]'") from None
    return Figure, FigureCanvasAgg

"""A study's table on disk: CSV, Markdown, and its picture."""

from __future__ import annotations

import csv
import math
from io import StringIO
from pathlib import Path

from game.files import save_text
from game.lab.analysis import TARGETS, summarise
from game.lab.picture import PlotsMissingError, write_png
from game.lab.study import ACCURACY, StudyTable


def write_csv(table: StudyTable, path: Path) -> Path:
    """All rows, one a line; further knobs and scene parameters in columns of their own."""
    others = sorted({name for row in table for name in row.others})
    scene = sorted({name for row in table for name in row.scene})
    file = StringIO(newline="")
    writer = csv.writer(file)
    fixed = ["method", table.study.knob.name, "error", "cpu_s", "counter", "failure"]
    writer.writerow([*fixed, *others, *(f"scene.{name}" for name in scene)])
    for row in table:
        values = [row.method, repr(row.knob), repr(row.error), repr(row.cpu_s), row.counter, row.failure]
        values += [row.others.get(name, "") for name in others]
        writer.writerow([*values, *(row.scene.get(name, "") for name in scene)])
    save_text(path, file.getvalue())
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
        f"Cost: {study.cost}, s, of one thread, least of several repeats.",
        "",
    ]
    if study.expectation:
        lines += [study.expectation, ""]
    if not table.complete:
        lines += ["The run was stopped before all points were measured.", ""]
    buys_accuracy = study.axes == ACCURACY  # else what costs more may well be more of what is counted
    targets = TARGETS if buys_accuracy else ()
    cheapest = ["least cost", f"at {study.knob.label}"] if study.axes.up == "cpu" else []
    heads = [
        "method",
        study.slope_name,
        "expected",
        *(f"cost of {target:g}" for target in targets),
        *cheapest,
        "points",
        "failed",
        *(["out of order"] if buys_accuracy else []),
    ]
    lines += ["| " + " | ".join(heads) + " |", "|" + " --- |" * len(heads)]
    for line in summarise(table):
        expected = "" if line.expected is None else f"{line.expected:g}"
        cells = [line.label, _number(line.order), expected, *map(_number, line.costs[: len(targets)])]
        if cheapest:
            least = min(table.of(line.method), key=lambda row: row.cpu_s, default=None)
            cells += ["", ""] if least is None else [_number(least.cpu_s), _number(least.knob)]
        cells += [str(line.points), str(line.failed)] + ([str(line.out_of_order)] if buys_accuracy else [])
        lines.append("| " + " | ".join(cells) + " |")
    failed = failure_lines(table)
    if failed:
        lines += ["", "Failed:", "", *(f"- {line}" for line in failed)]
    save_text(path, "\n".join(lines) + "\n")
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


def failure_lines(table: StudyTable) -> list[str]:
    """One line for each method and way of failing, with the range of the knob where it happened."""
    knob = table.study.knob
    found: dict[tuple[str, str], list[float]] = {}
    for row in table:
        if row.failed:
            found.setdefault((row.method, row.failure), []).append(row.knob)
    lines = []
    for (method, failure), places in found.items():
        many = len(places) > 1
        between = f"{min(places):.3g} to {max(places):.3g}" if many else f"{places[0]:.3g}"
        count = f"{len(places)} points" if many else "1 point"
        where = f"{knob.label} {between} {knob.unit}".rstrip()
        lines.append(f"{table.study.method(method).label}: {failure} ({count}, {where})")
    return lines


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.3g}"

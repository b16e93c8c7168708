"""The page of the accuracy report: HTML that needs nothing but the pictures beside it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from game.app.report.machine import about, about_words
from game.app.report.prices import Price, Prices
from game.files import save_text
from game.lab import ACCURACY, Study, StudyTable, summarise
from game.lab.analysis import TARGETS
from game.lab.report import failure_lines
from game.ui.look.numerals import format_number, format_si

if TYPE_CHECKING:
    from game.stage import Scene

BELOW, ABOVE = -0.15, 0.25  # what a fitted order may be off
NOISE = 0.02  # of a step, at least
STYLE = """
body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#1d252b}
h1,h2,h3{line-height:1.2}h2{border-top:1px solid #ccc;padding-top:1.2rem;margin-top:2.4rem}
table{border-collapse:collapse;margin:.6rem 0}td,th{padding:.2rem .7rem;text-align:right}
td:first-child,th:first-child,.words td,.words th{text-align:left}summary{cursor:pointer}
tr+tr td{border-top:1px solid #e4e4e4}
img{max-width:100%}.bad{color:#b23a00}.quiet{color:#66707a}nav a{margin-right:1rem}
@media(prefers-color-scheme:dark){body{background:#11181d;color:#e8e6df}
img{filter:invert(.88) hue-rotate(180deg)}
tr+tr td{border-color:#2c363d}h2{border-color:#2c363d}a{color:#6db8ff}}
"""


class SceneReport(NamedTuple):
    """What was measured of one scene: its tables, the folder of their pictures, and the effects' prices."""

    scene_type: type[Scene]
    tables: tuple[StudyTable, ...]
    folder: str
    prices: Prices | None


def write_page(reports: Sequence[SceneReport], path: Path) -> Path:
    """Write the page of these scenes; OSError if it cannot be written."""
    parts = [
        "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content='width=device-width'>",
        f"<title>Carom: what accuracy costs</title><style>{STYLE}</style>",
        "<h1>What accuracy costs</h1><p>Cost is CPU time of one thread, the least of several repeats, for "
        "one simulated second unless an axis says otherwise. Slopes are least-squares fits beyond the last "
        "point at which a method failed; such points are crosses in the pictures.</p>",
        f"<p class=quiet>{escape(about_words(about()))}</p><nav>",
        *(f"<a href='#{r.scene_type.name}'>{escape(r.scene_type.title)}</a>" for r in reports),
        "</nav>",
        *_orders(reports),
    ]
    for report in reports:
        parts += _scene(report)
    save_text(path, "\n".join(parts) + "\n")
    return path


def _scene(report: SceneReport) -> list[str]:
    scene_type = report.scene_type
    heading = f"{scene_type.task} {scene_type.title}".strip()
    parts = [f"<h2 id='{scene_type.name}'>{escape(heading)}</h2>"]
    for table in report.tables:
        parts += _study(table, report.folder)
    if report.prices is not None:
        parts += _prices(report.prices)
    return parts


def _study(table: StudyTable, folder: str) -> list[str]:
    """Picture, words, and a row for each method."""
    study = table.study
    targets = TARGETS if study.axes == ACCURACY else ()
    heads = ["method", study.slope_name, "expected", *(f"cost of {_error(study, t)}" for t in targets)]
    heads += ["points", "failed"]
    picture = f"{folder}/{study.name}.png" if folder else f"{study.name}.png"
    parts = [
        f"<h3>{escape(study.title)}</h3>",
        f"<p><a href='{picture}'><img src='{picture}' alt='{escape(study.title)}' loading=lazy></a></p>",
        f"<p>{escape(study.expectation)} <span class=quiet>Error: {escape(study.error)}. Reference: "
        f"{escape(study.reference)}</span></p>",
        "<table><tr>" + "".join(f"<th>{escape(head)}</th>" for head in heads) + "</tr>",
    ]
    for line in summarise(table):
        expected = "" if line.expected is None else f"{line.expected:g}"
        costs = [format_si(cost, "s") if math.isfinite(cost) else "–" for cost in line.costs[: len(targets)]]
        cells = [escape(line.label), _slope(line.order), expected, *costs, str(line.points)]
        failed = f"<td class=bad>{line.failed}</td>" if line.failed else "<td>0</td>"
        parts.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + failed + "</tr>")
    parts.append("</table>")
    failures = failure_lines(table)
    if failures:
        parts.append("<p>Failed: " + "; ".join(escape(line) for line in failures) + ".</p>")
    if not table.complete:
        parts.append("<p class=bad>Stopped before all points were measured.</p>")
    return parts


def _prices(prices: Prices) -> list[str]:
    """A row for each effect: with it, off, not declared; how it is without any."""
    heads = ("effect", "with it", "switched off", "not declared", "price")
    parts = [
        "<h3>What every effect costs</h3>",
        f"<p>CPU time of {prices.work}: {_cost(prices.step_s)} as the scene opens, {_cost(prices.bare_s)} "
        "with no effect. What is switched off is compiled away, so that it costs the same as what was never "
        "declared: the two differ by the noise of measuring.</p>",
        "<table><tr>" + "".join(f"<th>{head}</th>" for head in heads) + "</tr>",
    ]
    for price in prices.effects:
        cells = (price.label, *map(_cost, (price.with_s, price.without_s, price.undeclared_s)))
        row = "".join(f"<td>{escape(cell)}</td>" for cell in cells)
        parts.append(f"<tr>{row}<td>{_price(price)}</td></tr>")
    return [*parts, "</table>"]


def _price(price: Price) -> str:
    """What an effect adds; nothing if that is within the noise."""
    noise = max(abs(price.undeclared_s - price.without_s), NOISE * price.without_s)
    if abs(price.cost_s) <= noise:
        return "<span class=quiet>none to be seen</span>"
    return _cost(price.cost_s)


def _orders(reports: Sequence[SceneReport]) -> list[str]:
    """All slopes that something is expected of, in one table that is folded away."""
    rows, inside = [], 0
    for report in reports:
        for table in report.tables:
            for line in summarise(table):
                if line.expected is None or not math.isfinite(line.order):
                    continue
                right = BELOW <= line.order - line.expected <= ABOVE
                inside += right
                cells = (report.scene_type.title, table.study.short, line.label)
                row = "".join(f"<td>{escape(cell)}</td>" for cell in cells)
                bad = "" if right else " class=bad"
                rows.append(f"<tr>{row}<td{bad}>{_slope(line.order)}</td><td>{line.expected:g}</td></tr>")
    if not rows:
        return []
    heads = "".join(f"<th>{head}</th>" for head in ("scene", "study", "method", "fitted", "expected"))
    words = f"{inside} of {len(rows)} fitted orders lie within −0.15 and +0.25 of the expected one"
    return [
        f"<details><summary>{words}</summary><table class=words><tr>{heads}</tr>",
        *rows,
        "</table></details>",
    ]


def _cost(seconds: float) -> str:
    return format_si(seconds, "s") if math.isfinite(seconds) else "–"


def _error(study: Study, target: float) -> str:
    """A round error in the study's unit."""
    return format_si(target, study.error_unit) if study.error_unit == "m" else f"{target:g}"


def _slope(value: float) -> str:
    return format_number(round(value, 2)) if math.isfinite(value) else "–"

"""The page of the accuracy report: HTML that needs nothing but the pictures beside it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from game.app.report.prices import Prices
from game.lab import ACCURACY, StudyTable, summarise
from game.lab.analysis import TARGETS
from game.ui.numerals import format_number, format_si

if TYPE_CHECKING:
    from game.stage import Scene

STYLE = """
body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#1d252b}
h1,h2,h3{line-height:1.2}h2{border-top:1px solid #ccc;padding-top:1.2rem;margin-top:2.4rem}
table{border-collapse:collapse;margin:.6rem 0}td,th{padding:.2rem .7rem;text-align:right}
td:first-child,th:first-child{text-align:left}tr+tr td{border-top:1px solid #e4e4e4}
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
        "point at which a method failed; such points are crosses in the pictures.</p><nav>",
        *(
            f"<a href='#{r.scene_type.name}'>{escape(r.scene_type.task or r.scene_type.title)}</a>"
            for r in reports
        ),
        "</nav>",
    ]
    for report in reports:
        parts += _scene(report)
    path.write_text("\n".join(parts) + "\n", encoding="utf-8")
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
    heads = ["method", study.slope_name, "expected", *(f"cost of {target:g}" for target in targets)]
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
    if not table.complete:
        parts.append("<p class=bad>Stopped before all points were measured.</p>")
    return parts


def _prices(prices: Prices) -> list[str]:
    """A row for each effect; how a step is without any."""
    parts = [
        "<h3>What every effect costs</h3>",
        f"<p>A step takes {_cost(prices.step_s)} as the scene opens, {_cost(prices.bare_s)} with no effect. "
        "What a scene does not declare is not in its compiled step, and costs nothing.</p>",
        "<table><tr><th>effect</th><th>a step with it costs more by</th></tr>",
    ]
    parts += [f"<tr><td>{escape(p.label)}</td><td>{_cost(p.cost_s)}</td></tr>" for p in prices.effects]
    return [*parts, "</table>"]


def _cost(seconds: float) -> str:
    return format_si(seconds, "s") if math.isfinite(seconds) else "–"


def _slope(value: float) -> str:
    return format_number(round(value, 2)) if math.isfinite(value) else "–"

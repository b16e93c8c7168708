"""A study's table as a picture: PNG by matplotlib, the methods beside the plot and never on it."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from game.folders import data_folder
from game.lab.analysis import fitted, slope_of, upper_envelope, usable
from game.lab.study import Row, Study, StudyTable
from game.physics.kernels import elementary

# colours that colour-blind people can tell apart, each with a shape of its own (Okabe and Ito 2008)
SERIES = (
    ("#0072B2", "o"),
    ("#D55E00", "s"),
    ("#009E73", "^"),
    ("#CC79A7", "D"),
    ("#E69F00", "v"),
    ("#56B4E9", "P"),
    ("#444444", "X"),
)
FEW = 24  # points that are drawn singly; of more the upper envelope
INK, QUIET, GRID = "#1d252b", "#66707a", "#e3e6e8"
SIZE, DPI = (10.0, 5.4), 112  # inches, dots an inch
BEYOND = 30.0  # times the largest error: there stand the failures that are worse
APART = 0.05  # of an axis: marks at its foot need so much room
SHORT = 2.2  # decades: on an axis of fewer, marks stand at 1, 2 and 5


class PlotsMissingError(RuntimeError):
    """Pictures need matplotlib, which is not installed."""


def write_png(table: StudyTable, path: Path) -> Path:
    """The picture of a study by its axes, logarithmic; failed points are crosses.

    PlotsMissingError without matplotlib.
    """
    figure_class, canvas_class, context = _matplotlib()
    with context(_style()):
        figure = figure_class(figsize=SIZE, dpi=DPI, layout="constrained")
        canvas_class(figure)
        axes = figure.add_subplot()
        study = table.study
        foot = _foot_of(table)
        for i, method in enumerate(study.methods):
            colour, shape = SERIES[i % len(SERIES)]
            rows = table.of(method.name)
            if rows or table.of(method.name, failed=True):
                _draw_method(axes, table, method.name, foot, colour, shape)
        _dress(axes, table, foot)
        figure.savefig(path)
    return path


# -- points ---------------------------------------------------------------------------------------------


class Foot(NamedTuple):
    """The lowest height of a picture, where errors stand that are rounding or zero, and its name.

    top: where failures stand that are beyond all measure.
    """

    height: float
    word: str
    top: float = math.inf


NO_FOOT = Foot(0.0, "")


def _foot_of(table: StudyTable) -> Foot:
    study = table.study
    floor = study.floor if study.axes.up == "error" else 0.0
    heights = [study.up(row) for row in table]
    above = min((y for y in heights if math.isfinite(y) and y > floor), default=1e-3)
    below = [y for y in heights if y <= floor]
    highest = max((study.up(row) for row in table if not row.failed), default=0.0)
    if highest <= floor:  # only failures stand above the foot
        highest = max((y for y in heights if math.isfinite(y)), default=0.0) or 1.0
    top = BEYOND * highest
    return Foot(above / 3.0 if below else 0.0, "rounding" if any(below) else "none", top)


def _draw_method(axes: Any, table: StudyTable, name: str, foot: Foot, colour: str, shape: str) -> None:
    """Points, joined; of many the upper envelope is joined, as their errors rise and fall like saw teeth."""
    study = table.study
    rows = sorted(table.of(name), key=_by_knob)
    failed = [row for row in table.of(name, failed=True) if study.across(row) > 0.0]
    joined = rows
    if study.axes.up == "error" and len(rows) > FEW:
        joined = sorted(upper_envelope(usable(fitted(table, name), 0.0), over=study.order_over), key=_by_knob)
        axes.plot(*_places(study, rows, foot), shape, color=colour, markersize=3.0, alpha=0.25, mew=0.0)
    if failed:
        many = len(failed) > FEW
        axes.plot(
            *_places(study, failed, foot), "x", color=colour,
            markersize=4.0 if many else 7.0, alpha=0.35 if many else 0.9, mew=1.0 if many else 1.6,
        )  # fmt: skip
    axes.plot(
        *_places(study, joined, foot), color=colour, marker=shape, label=_label(table, name, failed),
        linewidth=1.6, markersize=6.0, markeredgecolor="white", markeredgewidth=0.6,
    )  # fmt: skip


def _places(study: Study, rows: list[Row], foot: Foot) -> tuple[list[float], list[float]]:
    """Where rows stand, between foot and top; what is not finite at the top."""
    heights = [study.up(row) for row in rows]
    heights = [min(y, foot.top) if not math.isnan(y) else foot.top for y in heights]
    return [study.across(row) for row in rows], [max(y, foot.height) for y in heights]


def _by_knob(row: Row) -> float:
    """The order in which points are joined: that of the settings, for cost is noisy."""
    return row.knob


def _label(table: StudyTable, name: str, failed: list[Row]) -> str:
    """The method, and beneath it the slope fitted and the one expected."""
    study, method = table.study, table.study.method(name)
    slope = slope_of(study, method, fitted(table, name))
    words = [_capital(method.label)]
    if method.order is not None and math.isfinite(slope):
        words.append(f"{study.slope_name} {slope:.2f} of {method.order:g}")
    if failed:
        words.append(f"× failed at {len(failed)} of {len(table.of(name, failed=None))}")
    return "\n".join(words)


# -- axes -----------------------------------------------------------------------------------------------


def _dress(axes: Any, table: StudyTable, foot: Foot) -> None:
    """Title, scales, words and the list of methods."""
    study = table.study
    rows = [row for row in table if study.across(row) > 0.0]
    if rows:
        axes.set_xscale("log")
        axes.set_yscale("log")
        _mark(axes.xaxis, axes.get_xlim(), study.across_words()[1])
        _mark(axes.yaxis, axes.get_ylim(), study.up_words()[1], foot)
        axes.legend(
            loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, frameon=False,
            labelspacing=0.9, handlelength=1.8,
        )  # fmt: skip
    up, across = (_with_unit(*words) for words in (study.up_words(), study.across_words()))
    axes.set_title(study.title, loc="left", pad=30.0, fontsize=14.0, fontweight="semibold", color=INK)
    axes.text(0.0, 1.025, _capital(up), transform=axes.transAxes, ha="left", color=QUIET, fontsize=10.5)
    axes.set_xlabel(_capital(across), loc="right", color=QUIET, fontsize=10.5)
    axes.grid(True, which="major", color=GRID, linewidth=0.8)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def _mark(axis: Any, limits: tuple[float, float], unit: str, foot: Foot = NO_FOOT) -> None:
    """Marks at powers of ten, or at 1, 2 and 5 where there are few; and one at the foot."""
    from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

    decades = elementary.log10(limits[1] / limits[0])
    first, last = math.floor(elementary.log10(limits[0])), math.ceil(elementary.log10(limits[1]))
    every = max(1, math.ceil(decades / 9.0))
    parts = (1.0, 2.0, 5.0) if decades < SHORT else (1.0,)
    marks = [
        part * elementary.pow(10.0, k) for k in range(first, last + 1) if k % every == 0 for part in parts
    ]
    lowest = max(limits[0], foot.height * elementary.pow(10.0, APART * decades))
    words = {mark: in_words(mark, unit, lowest >= PLAIN) for mark in marks if lowest <= mark <= limits[1]}
    if foot.height:
        words[foot.height] = foot.word
    axis.set_major_locator(FixedLocator(sorted(words)))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: words.get(value, "")))


PREFIXES = ((1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"), (1e-15, "f"), (1e-18, "a"))
PLAIN = 1e-3  # numbers from here on need no power of ten
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def in_words(value: float, unit: str, plain: bool = True) -> str:
    """A round number: with a prefix for seconds and metres, else plain or as a power of ten."""
    if unit in ("s", "m") and value < 1e3:
        for factor, prefix in PREFIXES:
            if value >= 0.9999 * factor:
                return f"{value / factor:g}\u202f{prefix}{unit}"
    if (plain or value >= 1.0) and PLAIN <= value < 1e5:
        return f"{value:,g}".replace(",", "\u202f")
    power = math.floor(elementary.log10(value) + 1e-9)
    front = round(value / elementary.pow(10.0, power))
    return ("" if front == 1 else f"{front}·") + f"10{str(power).translate(RAISED)}"


def _with_unit(words: str, unit: str) -> str:
    """With the unit, unless the marks have it."""
    return f"{words}, {unit}" if unit not in ("", "s", "m") else words


def _capital(words: str) -> str:
    """With a capital, but for a symbol of one letter."""
    return words[:1].upper() + words[1:] if words[1:2].isalpha() or words[:2] == "a " else words


# -- matplotlib -----------------------------------------------------------------------------------------


def _matplotlib() -> tuple[Any, Any, Any]:
    """Figure and canvas classes, drawn without a screen, and the context of a style."""
    try:
        from matplotlib import rc_context
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        raise PlotsMissingError("pictures need matplotlib: pip install 'carom[plots]'") from None
    return Figure, FigureCanvasAgg, rc_context


def _style() -> dict[str, Any]:
    return {
        "font.family": _own_font(),
        "font.size": 10.5,
        "axes.edgecolor": "#b8bfc4",
        "axes.labelcolor": QUIET,
        "text.color": INK,
        "xtick.color": "#b8bfc4",
        "ytick.color": "#b8bfc4",
        "xtick.labelcolor": QUIET,
        "ytick.labelcolor": QUIET,
        "axes.unicode_minus": True,
    }


@cache
def _own_font() -> str:
    """The family of the program's own fonts, made known to matplotlib; its usual one if they are missing."""
    from matplotlib import font_manager

    try:
        for weight in ("Regular", "Medium", "SemiBold", "Bold"):
            font_manager.fontManager.addfont(data_folder("assets") / "fonts" / f"CaromSans-{weight}.otf")
    except OSError:
        return "DejaVu Sans"
    return "Carom Sans"

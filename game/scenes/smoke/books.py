"""The books of the last step of smoke: forces on the gas, and its heat; as readouts, and as a page."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.physics.combustion.burning import RADIATED, RELEASED
from game.physics.gas import ledger
from game.physics.gas.ledger import Book
from game.scenes.smoke.model import TALL, WARM, SmokeModel
from game.stage import Readout
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_number

AIR, CAPACITY = 1.2, 1212.0  # kg/m³, J/(m³ K)
MOMENTUM = (
    ("lift", ledger.FORCES),
    ("solids", ledger.SOLIDS),
    ("sides", ledger.SIDES),
    ("viscosity", ledger.DRAG),
    ("held at sides", ledger.HELD),
    ("flows in", ledger.THROUGH),
    ("carrying", ledger.CARRYING),
)
HEAT = ("given", "radiated", "through sides", "spread in", "carrying")
LEAST = 1e-4  # of the largest number of a page: less is drawn as nothing
LINE, FIRST, COLUMN, NAMES = 17.0, 15.0, 62.0, 92.0  # design px


class Page(NamedTuple):
    """Rows (name, numbers), and what they come to: the change, and what they leave open of it."""

    rows: list[tuple[str, tuple[float, ...]]]
    change: tuple[float, ...]
    left: float


def _book(model: SmokeModel, of_momentum: bool) -> Book | None:
    if model.gas is None or model.gas.ledger is None:
        return None
    return model.gas.ledger.momentum if of_momentum else model.gas.ledger.fields


def momentum_page(model: SmokeModel) -> Page:
    """N/m on the gas in the last step, along and up; NaN without books."""
    book = _book(model, True)
    if book is None:
        nothing = (math.nan, math.nan)
        return Page([(name, nothing) for name, _ in MOMENTUM], nothing, math.nan)
    scale = AIR / model.parameters.step_length
    rows = [(name, tuple((scale * book.rows[row]).tolist())) for name, row in MOMENTUM]
    return Page(rows, tuple((scale * book.change).tolist()), scale * float(abs(book.open).max()))


def heat_page(model: SmokeModel) -> Page:
    """W/m into the gas since the step before: by fire, sources and hand, and in the step; NaN without.

    Each row is measured by itself. What is left open is the change less all of them.
    """
    book = _book(model, False)
    if book is None:
        return Page([(name, (math.nan,)) for name in HEAT], (math.nan,), math.nan)
    scale = CAPACITY / model.parameters.step_length
    volume = model.cell * model.cell
    fire, light = (volume * float(model.flames.sums[row]) / model.parameters.step_length
                   for row in (RELEASED, RADIATED))  # fmt: skip
    numbers = (
        scale * model.given + fire, -light, *(scale * float(book.rows[row, WARM])
                                   for row in (ledger.CARRIED_THROUGH, ledger.SPREAD_THROUGH, ledger.SCHEME)),
    )  # fmt: skip
    rows: list[tuple[str, tuple[float, ...]]] = [
        (name, (number,)) for name, number in zip(HEAT, numbers, strict=True)
    ]
    change = scale * float(book.between[WARM] + book.change[WARM])
    return Page(rows, (change,), abs(change - math.fsum(numbers)))


def momentum_readouts(model: SmokeModel) -> list[Readout]:
    """Each row along and up, the change, and what is left open of it: rounding."""
    page, found = momentum_page(model), []
    for name, (along, up) in [*page.rows, ("change of momentum", page.change)]:
        found += [Readout(f"{name}, along", along, "N/m"), Readout(f"{name}, up", up, "N/m")]
    return [*found, Readout("momentum left open", page.left, "N/m")]


def heat_readouts(model: SmokeModel) -> list[Readout]:
    """Each row, the change, and what is left open of it: rounding."""
    page = heat_page(model)
    found = [Readout(f"heat, {name}", numbers[0], "W/m") for name, numbers in page.rows]
    return [
        *found,
        Readout("heat, change", page.change[0], "W/m"),
        Readout("heat left open", page.left, "W/m"),
    ]


def draw_books(canvas: Canvas, model: SmokeModel) -> None:
    """Both pages in the upper left corner of the box; numbers change four times a second."""
    pages = (
        ("Momentum, N/m: along, up", momentum_page(model)), ("Heat from 0 K, W/m", heat_page(model))
    )  # fmt: skip
    down = FIRST
    for title, page in pages:
        _line(canvas, down, title, (), "text2")
        least = LEAST * max(abs(number) for _, numbers in page.rows for number in numbers)
        for name, numbers in page.rows:
            down += LINE
            numbers = tuple(0.0 if abs(number) < least else number for number in numbers)
            _line(
                canvas,
                down,
                name,
                numbers,
                "amber" if name == "carrying" and any(numbers) else "text1",
                title,
            )
        down += LINE
        _line(canvas, down, "change", page.change, "green", title)
        down += LINE
        _line(canvas, down, "left open", (0.0 if page.left < 1e-9 * least else page.left,), "text2", title)
        down += 1.6 * LINE


def _line(
    canvas: Canvas, down: float, name: str, numbers: tuple[float, ...], color: str, of: str = ""
) -> None:
    """A name, and right of it its numbers, each ending at its own column."""
    corner = (0.0, TALL)
    canvas.label(corner, name, color, 12, "medium", "left", (12.0, down))
    for k, number in enumerate(numbers):
        text = canvas.figure((of, name, k), _number(number))
        canvas.label(corner, text, color, 12, "semibold", "right", (12.0 + NAMES + (k + 1) * COLUMN, down))


def _number(value: float) -> str:
    if not math.isfinite(value):
        return "\N{EN DASH}"
    return format_number(value) if value else "0"

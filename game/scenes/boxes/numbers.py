"""Numbers of the broad-phase scenes as they are written."""

from __future__ import annotations

import math

from game.ui.look.numerals import quantity


def grouped(number: float) -> str:
    """A whole number in groups of three."""
    return f"{round(number):,}".replace(",", "\u202f")


def short(number: float) -> str:
    """A count with an SI prefix from ten thousand on."""
    for size, prefix in ((1e9, "G"), (1e6, "M"), (1e4, "k")):
        if number >= size:
            return f"{number / min(size, 1e3 if prefix == 'k' else size):.3g} {prefix}"
    return grouped(number)


def seconds_text(seconds: float) -> str:
    """A time with its unit, or a dash where there is none."""
    return " ".join(quantity(seconds, "s")) if math.isfinite(seconds) else "–"


def bytes_text(count: float) -> str:
    """An amount of memory with its unit."""
    return " ".join(quantity(float(count), "B"))


def log_share(seconds: float, least: float = 1e-6, most: float = 1.0) -> float:
    """Where a time lies between two others on a logarithmic bar; 0 where there is none."""
    if not seconds > 0.0 or not math.isfinite(seconds):
        return 0.0
    return min(max(math.log(seconds / least) / math.log(most / least), 0.02), 1.0)

"""Numbers as a caption gives them: at most three digits, prefixes of the SI, a true minus."""

from __future__ import annotations

import math

DIGITS = 3
LEAST = 0.9995  # is 1 in so many digits
MINUS, NARROW, NOTHING = "\u2212", "\u202f", "\u2013"  # a minus, a space between thousands, not measured
_PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
# Units that take a prefix. Kelvin, %, kg and degrees do not in plain speech, nor does an acceleration.
_SCALED = frozenset(("m", "s", "J", "W", "N", "Hz", "Pa", "V", "m/s", "W/m", "J/m", "N/m"))
_WHOLE = ("", "1")  # units of what is counted


def number_words(value: float, unit: str = "", form: str = "") -> str:
    """A value with its unit, or by ``form`` (such as ".1f") the number alone; a dash if it is not finite."""
    if not math.isfinite(value):
        return NOTHING
    if form:
        return _signed(format(value, form))
    prefix = ""
    if unit in _SCALED and value:
        factor, prefix = _prefix(value)
        value /= factor
    counted = unit in _WHOLE and float(value).is_integer()
    return f"{_signed(_digits(value, counted))} {prefix}{unit}".strip()


def _prefix(value: float) -> tuple[float, str]:
    """The largest prefix that leaves at least 1 before the point, as rounded to the digits that are said."""
    return next((row for row in _PREFIXES if abs(value) >= LEAST * row[0]), _PREFIXES[-1])


def _digits(value: float, counted: bool) -> str:
    """What is counted is said as it is; what is measured has three digits."""
    if value == 0.0:
        return "0"
    if not counted:
        value = float(f"{value:.{DIGITS - 1}e}")
        if abs(value) < 1000.0:
            return f"{value:.{DIGITS}g}"
    return f"{value:,.0f}".replace(",", NARROW)


def _signed(words: str) -> str:
    """With a true minus; none before a zero."""
    bare = words.removeprefix("-")
    sign = MINUS if bare != words and bare.strip("0.") else ""
    return sign + bare.replace("e-", "e" + MINUS)

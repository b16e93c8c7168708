"""Numbers as people read them: groups of three, a true minus, SI prefixes in place of exponents."""

from __future__ import annotations

import math
from numbers import Integral
from typing import NamedTuple

NARROW_SPACE = "\u202f"
MINUS = "\u2212"
NOTHING = "–"  # shown where there is no value
_PREFIXES = (
    (1e9, "G"),
    (1e6, "M"),
    (1e3, "k"),
    (1.0, ""),
    (1e-3, "m"),
    (1e-6, "µ"),
    (1e-9, "n"),
    (1e-12, "p"),
)
SMALLEST = 1e-13  # rounding; a prefix that few know, or noughts after the point, would say less
_PREFIXED = frozenset({"m", "s", "g", "N", "J", "W", "Hz", "Pa", "B", "V", "A"})
_RAISED = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
_SUPERSCRIPT = str.maketrans("-0123456789", _RAISED)


class Quantity(NamedTuple):
    """A number and its unit as they are shown: the unit stands after it in a quieter colour."""

    number: str
    unit: str


def format_number(value: float, digits: int = 3) -> str:
    """A number for people: ``digits`` significant digits, narrow groups of three, a true minus.

    Whole numbers and the whole part of a fraction are never rounded; beyond a billion or below 10^-4 a
    power of ten is written. Not a number shows as a dash, infinity as its sign.
    """
    if isinstance(value, Integral):
        return _group(str(abs(int(value))), value < 0)
    value = float(value)
    if math.isnan(value):
        return NOTHING
    if math.isinf(value):
        return "∞" if value > 0 else MINUS + "∞"
    if value == 0.0:
        return "0"
    size = abs(value)
    if size >= 1e9 or size < 1e-4:
        mantissa, exponent = f"{size:.{digits - 1}e}".split("e")
        power = str(int(exponent)).translate(_SUPERSCRIPT)
        return (MINUS if value < 0 else "") + f"{mantissa}{NARROW_SPACE}×{NARROW_SPACE}10{power}"
    rounded = float(f"{size:.{digits - 1}e}")  # 9.996 has one place fewer than 9.994
    places = max(0, digits - 1 - math.floor(math.log10(rounded)))
    return _group(f"{size:.{places}f}", value < 0)


def quantity(value: float, unit: str, digits: int = 3) -> Quantity:
    """Number and unit with an SI prefix in place of an exponent: 0.0000184 s is 18.4 µs.

    Only plain units and rates of them take a prefix ("m", "m/s", "N s"); squares, angles, "1/s" and per cent
    do not. Less than a kilogram counts from the gram; megagrams are no unit of daily life. Below a tenth of a
    pico there is no prefix but a power of ten. A count (an integer without unit) is shown whole.
    """
    if isinstance(value, Integral) and not unit:
        return Quantity(format_number(value), unit)
    value = float(value)
    if unit.startswith("kg") and unit[2:3] in ("", "/", " ", "·"):
        if abs(value) >= 1.0 or value == 0.0:
            return Quantity(format_number(value, digits), unit)
        value, unit = value * 1e3, unit[1:]
    symbol = unit.replace("·", "/").replace(" ", "/").split("/")[0]
    size = abs(value)
    if symbol not in _PREFIXED or size == 0.0 or not math.isfinite(size):
        return Quantity(format_number(value, digits), unit)
    rounded = float(f"{size:.{digits - 1}e}")
    if rounded < SMALLEST:
        return Quantity(format_number(value, digits), unit)
    factor, prefix = next((row for row in _PREFIXES if rounded >= row[0] * (1.0 - 1e-12)), _PREFIXES[-1])
    return Quantity(format_number(value / factor, digits), prefix + unit)


def format_si(value: float, unit: str, digits: int = 3) -> str:
    """``quantity`` as one text: "18.4 µs"; angles and empty units stand close, but never at an exponent."""
    number, shown = quantity(value, unit, digits)
    close = shown == "" or (shown == "°" and number[-1] not in _RAISED)
    return number + shown if close else f"{number} {shown}"


def _group(text: str, negative: bool) -> str:
    """Digits in groups of three from the point to the left; no sign before a zero."""
    whole, point, fraction = text.partition(".")
    grouped = f"{int(whole):,}".replace(",", NARROW_SPACE) if len(whole) < 4000 else whole
    negative = negative and any(c not in "0." for c in text)
    return (MINUS if negative else "") + grouped + point + fraction

"""Values for knobs: within their limits, at them, beyond them, and what is no value at all."""

from __future__ import annotations

import math
from random import Random
from typing import Any

from game.stage.parameters import Choice, Knob, Param, Toggle

NOT_VALUES: tuple[Any, ...] = (math.nan, math.inf, -math.inf, None, "", "1", "true", b"", 10**400, (), 1e308)


def any_value(hand: Random, knob: Knob[Any]) -> Any:
    """A value that the knob may take or must refuse: half of them are good."""
    if hand.random() < 0.15:
        return hand.choice(NOT_VALUES)
    if isinstance(knob, Param):
        return _any_number(hand, knob)
    if isinstance(knob, Choice):
        return hand.choice((*knob.options, "no such option"))
    if isinstance(knob, Toggle):
        return hand.choice((True, False, 0))
    return knob.default


def _any_number(hand: Random, knob: Param) -> float:
    low, high = knob.minimum, knob.maximum
    kind = hand.randrange(6)
    if kind == 0:
        return hand.choice((low, high))
    if kind == 1:
        return hand.choice((math.nextafter(low, -math.inf), math.nextafter(high, math.inf), -1e300, 1e300))
    if kind == 2:
        return hand.choice((0.0, -0.0, 5e-324, knob.default))
    decades = hand.uniform(math.log(low), math.log(high)) if knob.log else 0.0
    value = math.exp(decades) if knob.log else hand.uniform(low, high)
    return float(round(value)) if knob.whole else value

"""Values for parameters: within their limits, at them, beyond them, and what is no value at all."""

from __future__ import annotations

import math
from random import Random
from typing import Any

from game.stage.parameters import Choice, Param, Parameter, Toggle

NOT_VALUES: tuple[Any, ...] = (math.nan, math.inf, -math.inf, None, "", "1", "true", b"", 10**400, (), 1e308)


def any_value(hand: Random, parameter: Parameter[Any]) -> Any:
    """A value that the parameter may take or must refuse: half of them are good."""
    if hand.random() < 0.15:
        return hand.choice(NOT_VALUES)
    if isinstance(parameter, Param):
        return _any_number(hand, parameter)
    if isinstance(parameter, Choice):
        return hand.choice((*parameter.options, "no such option"))
    if isinstance(parameter, Toggle):
        return hand.choice((True, False, 0))
    return parameter.default


def _any_number(hand: Random, parameter: Param) -> float:
    low, high = parameter.minimum, parameter.maximum
    kind = hand.randrange(6)
    if kind == 0:
        return hand.choice((low, high))
    if kind == 1:
        return hand.choice((math.nextafter(low, -math.inf), math.nextafter(high, math.inf), -1e300, 1e300))
    if kind == 2:
        return hand.choice((0.0, -0.0, 5e-324, parameter.default))
    decades = hand.uniform(math.log(low), math.log(high)) if parameter.log else 0.0
    value = math.exp(decades) if parameter.log else hand.uniform(low, high)
    return float(round(value)) if parameter.whole else value

"""Settings of the lecture's table: what may be chosen, the defaults, and the one check.

The same NamedTuple goes from the scene's parameters, a study or a shot to the kernels. Choices have words
outside (the names of options, as in RULES) and their places in the list inside (CONSERVING, ...).
`lecture_settings` turns words into places, and refuses what is out of range.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.compiler.decorator import kernel

RULES = ("conserving", "scaled", "as-printed")  # what a collision does to two velocities
CONSERVING, SCALED, AS_PRINTED = range(3)
ORDERS = ("joint", "pairwise")  # contacts of one substep together, or pair after pair by index
JOINT, PAIRWISE = range(2)
PROPAGATIONS = ("impacts", "at-once")  # joint order: resting contacts wait for their impact, or join at once
IMPACTS, AT_ONCE = range(2)
REPOSITIONINGS = ("exact", "mirror", "clamp")  # where a ball that overshot a wall is put
EXACT, MIRROR, CLAMP = range(3)
FRICTION_LAWS = ("consistent", "per-frame")  # factor^(60 dt), or the factor each step however long
CONSISTENT, PER_FRAME = range(2)

FRAME_RATE = 60.0  # 1/s; the frame rate that a friction factor is meant for
AUTOMATIC = 0  # substeps: as many as keep a ball from moving over half a radius in one
MAX_SUBSTEPS = 1_000  # automatic ones; above 860 m/s (at 60 steps a second) pool balls may tunnel again
MAX_PASSES = 1_000
MAX_SPEED = 1e6  # m/s


class LectureSettings(NamedTuple):
    """Settings of the lecture's table; make them with `lecture_settings`, which checks them.

    bounce: speed kept at a wall, 0 to 1 (the lecture's bounce factor; above 1 energy would grow for ever).
    restitution: of two balls, 0 to 1; the rules `scaled` and `as-printed` multiply whole velocities by it.
    friction: factor per frame at 60 frames/s, 0 to 1. minimum_speed: m/s. substeps: 0 is automatic.
    passes: rounds of separating balls that overlap (one by the rule as-printed). walls_again: push balls back
    from the walls after balls have pushed them (False, as in the lecture, lets a pressed ball sink in).
    """

    bounce: float = 0.8
    restitution: float = 0.95
    friction: float = 0.992
    minimum_speed: float = 0.02
    substeps: int = AUTOMATIC
    passes: int = 4
    rule: int = CONSERVING
    order: int = JOINT
    propagation: int = IMPACTS
    repositioning: int = EXACT
    friction_law: int = CONSISTENT
    walls_again: bool = True


DEFAULTS = LectureSettings()
_CHOICES = {
    "rule": RULES,
    "order": ORDERS,
    "propagation": PROPAGATIONS,
    "repositioning": REPOSITIONINGS,
    "friction_law": FRICTION_LAWS,
}


def lecture_settings(base: LectureSettings = DEFAULTS, /, **changes: Any) -> LectureSettings:
    """Settings like ``base``, some changed: numbers by name, choices by the words of their options.

    ValueError names a setting that there is not, or one that is out of range.
    """
    unknown = sorted(changes.keys() - set(LectureSettings._fields))
    if unknown:
        raise ValueError(f"{unknown[0]}: no such setting; there are {', '.join(LectureSettings._fields)}")
    settings = base._replace(**{name: _checked(name, value) for name, value in changes.items()})
    if settings.order == JOINT and settings.rule != CONSERVING:
        raise ValueError(
            f"order: joint solves only the rule conserving, not {RULES[settings.rule]!r}; use pairwise"
        )
    return settings


def _checked(name: str, value: Any) -> Any:
    """A setting as the kernels have it."""
    if name in _CHOICES:
        if value not in _CHOICES[name]:
            raise ValueError(f"{name}: must be one of {', '.join(_CHOICES[name])}, got {value!r}")
        return _CHOICES[name].index(value)
    if name == "walls_again":
        if not isinstance(value, bool | np.bool_):
            raise ValueError(f"{name}: must be true or false, got {value!r}")
        return bool(value)
    if name in ("substeps", "passes"):
        low, high = (0, MAX_SUBSTEPS) if name == "substeps" else (1, MAX_PASSES)
        if isinstance(value, bool) or not (isinstance(value, int | np.integer) and low <= value <= high):
            raise ValueError(f"{name}: must be a whole number from {low} to {high}, got {value!r}")
        return int(value)
    most = MAX_SPEED if name == "minimum_speed" else 1.0
    if isinstance(value, bool) or not (isinstance(value, int | float) and 0.0 <= value <= most):
        raise ValueError(f"{name}: must be a number from 0 to {most:g}, got {value!r}")
    return float(value)


@kernel
def read_settings(numbers):
    """The settings from an array (12,) of them: it takes a quarter of the time of handing over the tuple."""
    return LectureSettings(
        numbers[0],
        numbers[1],
        numbers[2],
        numbers[3],
        int(numbers[4]),
        int(numbers[5]),
        int(numbers[6]),
        int(numbers[7]),
        int(numbers[8]),
        int(numbers[9]),
        int(numbers[10]),
        numbers[11] != 0.0,
    )

"""Settings of the lecture's table, each declared once: default, range or options, unit, what it does.

The same NamedTuple goes from the scene's parameters, a study or a shot to the kernels. Choices have words
outside (the names of options, as in RULES) and their places in the list inside (CONSERVING, ...). The scene
makes its controls of the declarations, and these check what comes in there; `lecture_settings` checks what a
program says.
"""

from __future__ import annotations

from typing import Annotated, Any, NamedTuple

from game.compiler.decorator import kernel
from game.settings import Number, Option, changed

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

    The lecture's bounce factor above 1 would let energy grow for ever. The rules `scaled` and `as-printed`
    multiply whole velocities by the restitution, and take one pass. walls_again, False as in the lecture,
    lets a pressed ball sink into a wall.
    """

    bounce: Annotated[float, Number(0.0, 1.0, "speed kept at a cushion")] = 0.8
    restitution: Annotated[float, Number(0.0, 1.0, "normal speed kept when two balls collide")] = 0.95
    friction: Annotated[float, Number(0.0, 1.0, "speed kept from frame to frame, at 60 frames a second")] = (
        0.992
    )
    minimum_speed: Annotated[float, Number(0.0, MAX_SPEED, "what is slower stops", "m/s")] = 0.02
    substeps: Annotated[
        int,
        Number(
            0, MAX_SUBSTEPS,
            "parts of a step; 0: as many as keep a ball from moving over half its radius in one", whole=True,
        ),
    ] = AUTOMATIC  # fmt: skip
    passes: Annotated[int, Number(1, MAX_PASSES, "rounds of moving overlapping balls apart", whole=True)] = 4
    rule: Annotated[
        int,
        Option(RULES, "restitution on the normal part; both velocities scaled; the printed listing"),
    ] = CONSERVING
    order: Annotated[
        int,
        Option(ORDERS, "contacts of one moment solved together, or one pair after the other by number"),
    ] = JOINT
    propagation: Annotated[int, Option(PROPAGATIONS, "resting contacts wait for an impact, or join")] = (
        IMPACTS
    )
    repositioning: Annotated[
        int,
        Option(
            REPOSITIONINGS,
            "where a ball is put that overshot: where it would be, mirrored, or at the wall",
        ),
    ] = EXACT
    friction_law: Annotated[
        int,
        Option(
            FRICTION_LAWS,
            "the same slowing at any step length, or the factor once each step as printed",
        ),
    ] = CONSISTENT
    walls_again: Annotated[
        bool, Option(help="push balls back from the walls after balls have pushed them")
    ] = True


DEFAULTS = LectureSettings()


def lecture_settings(base: LectureSettings = DEFAULTS, /, **changes: Any) -> LectureSettings:
    """Settings like ``base``, some changed: numbers by name, choices by the words of their options.

    ValueError names a setting that there is not, or one that is out of range.
    """
    settings = changed(base, changes)
    if settings.order == JOINT and settings.rule != CONSERVING:
        raise ValueError(
            f"order: joint solves only the rule conserving, not {RULES[settings.rule]!r}; use pairwise"
        )
    return settings


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

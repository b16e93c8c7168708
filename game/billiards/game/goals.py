"""Goals of trick shots and drills: what a stroke must bring about, as data, and whether it did."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Annotated

import msgspec

from game.billiards.game.rules import CUE_BALL, ShotSummary, listed, named

LARGEST = 21  # the black at snooker; at pool the 15
Ball = Annotated[int, msgspec.Meta(ge=0, le=LARGEST)]
Naming = Callable[[int], str]  # a ball in words
Count = Annotated[int, msgspec.Meta(ge=0, le=15)]
Metres = Annotated[float, msgspec.Meta(ge=-1.0, le=10.0)]

COUNTS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


class Pot(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A ball goes down: pocket (its row, None: any), by way of at least so many other balls and cushions."""

    ball: Ball
    pocket: Annotated[int, msgspec.Meta(ge=0, le=5)] | None = None
    by_way_of: Count = 0
    cushions: Count = 0


class Zone(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A ball comes to rest with its centre within `radius` m of (x, y) m."""

    ball: Ball
    x: Metres
    y: Metres
    radius: Annotated[float, msgspec.Meta(gt=0.0, le=3.0)]


class Goal(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """What one stroke must bring about; everything that is said must come true.

    pots: balls that go down. down: at least so many numbered balls go down. cue_touches: balls the cue ball
    touches, in this order. cushions_first: cushions the cue ball touches before any ball. direct: it
    touches none before its first ball. cushions_between: cushions it touches before the last ball of
    `cue_touches`. untouched: balls that nothing touches. zones: where balls come to rest. scratch: the cue
    ball must go down, which else it must not.
    """

    pots: tuple[Pot, ...] = ()
    down: Count = 0
    cue_touches: tuple[Ball, ...] = ()
    cushions_first: Count = 0
    direct: bool = False
    cushions_between: Count = 0
    untouched: tuple[Ball, ...] = ()
    zones: tuple[Zone, ...] = ()
    scratch: bool = False


def balls_of(goal: Goal) -> frozenset[int]:
    """Numbers of the balls that a goal speaks of."""
    potted, resting = (one.ball for one in goal.pots), (one.ball for one in goal.zones)
    return frozenset((*potted, *resting, *goal.cue_touches, *goal.untouched))


def stars_of(goals: Sequence[Goal], shot: ShotSummary) -> int:
    """Stars of a stroke: none if the first goal is missed, one more for each further goal, in their order."""
    return next((stars for stars, goal in enumerate(goals) if missed(goal, shot)), len(goals))


def missed(goal: Goal, shot: ShotSummary, name: Naming = named) -> tuple[str, ...]:
    """What a stroke did not bring about, each in words; empty if the goal is met. name: how balls are
    called.
    """
    lacking = []
    if shot.cue_pocketed != goal.scratch:
        lacking.append("The cue ball went down." if shot.cue_pocketed else "The cue ball did not go down.")
    lacking += [f"The {name(ball)} left the table." for ball in shot.off_table]
    lacking += [text for pot in goal.pots if (text := _pot_missed(pot, shot, name))]
    if len(shot.pocketed) < goal.down:
        lacking.append(f"{len(shot.pocketed)} of {goal.down} balls went down.")
    lacking += _path_missed(goal, shot, name)
    lacking += [f"The {name(ball)} was touched." for ball in goal.untouched if ball in shot.touched]
    lacking += [text for zone in goal.zones if (text := _zone_missed(zone, shot, name))]
    return tuple(lacking)


def _pot_missed(pot: Pot, shot: ShotSummary, name: Naming) -> str:
    """Why a ball does not count as potted; empty if it does."""
    fallen, ball = shot.pocketing(pot.ball), name(pot.ball)
    if fallen is None:
        return f"The {ball} did not go down."
    if pot.pocket is not None and fallen.pocket != pot.pocket:
        return f"The {ball} went into another pocket."
    if pot.by_way_of and len(fallen.chain) - 2 < pot.by_way_of:
        return f"The {ball} went down without enough balls in between."
    if fallen.cushions < pot.cushions:
        return f"The {ball} touched {fallen.cushions} of {pot.cushions} cushions."
    return ""


def _path_missed(goal: Goal, shot: ShotSummary, name: Naming) -> list[str]:
    """What is wrong with the path of the cue ball."""
    lacking = []
    before = 0
    for kind, _ in shot.cue_path:
        if kind == "ball":
            break
        before += 1
    if goal.cushions_first and (before < goal.cushions_first or not shot.first):
        lacking.append(f"The cue ball touched {before} of {goal.cushions_first} cushions before a ball.")
    if goal.direct and before:
        lacking.append("The cue ball touched a cushion before any ball.")
    awaited = list(goal.cue_touches)
    between = 0
    for kind, number in shot.cue_path:
        if not awaited:
            break
        if kind == "cushion":
            between += 1
        elif number == awaited[0]:
            del awaited[0]
    if awaited:
        lacking.append(f"The cue ball did not touch the {name(awaited[0])}.")
    elif between < goal.cushions_between:
        lacking.append(f"The cue ball touched {between} of {goal.cushions_between} cushions on its path.")
    return lacking


def _zone_missed(zone: Zone, shot: ShotSummary, name: Naming) -> str:
    """Why a ball is not where it should be; empty if it is."""
    for ball, x, y in shot.rest:
        if ball == zone.ball:
            dx, dy = x - zone.x, y - zone.y
            far = math.sqrt(dx * dx + dy * dy)
            if far <= zone.radius:
                return ""
            return f"The {name(ball)} stopped {100.0 * (far - zone.radius):.0f} cm outside of its ring."
    return f"The {name(zone.ball)} is not on the table."


def described(goal: Goal, pockets: tuple[str, ...] = ()) -> tuple[str, ...]:
    """The goal in words, a line for each part. pockets: their names by row."""
    lines = []
    for pot in goal.pots:
        line = f"Pot the {pot.ball}"
        if pot.pocket is not None:
            line += f", {pockets[pot.pocket]} pocket" if pockets else f" in pocket {pot.pocket}"
        if pot.by_way_of:
            line += f", by way of {_counted(pot.by_way_of, 'other ball')}"
        if pot.cushions:
            line += f", off {_counted(pot.cushions, 'cushion')}"
        lines.append(line + ".")
    if goal.down:
        lines.append(f"{_counted(goal.down, 'ball').capitalize()} go{'es' * (goal.down == 1)} down.")
    if goal.cue_touches:
        balls = [f"the {ball}" for ball in goal.cue_touches]
        touched = ["no cushion", *balls] if goal.direct else balls
        lines.append(f"The {named(CUE_BALL)} touches {', then '.join(touched)}.")
    elif goal.direct:
        lines.append(f"The {named(CUE_BALL)} touches no cushion before any ball.")
    if goal.cushions_first:
        count = _counted(goal.cushions_first, "cushion")
        lines.append(f"The {named(CUE_BALL)} touches {count} before any ball.")
    if goal.cushions_between:
        lines.append(f"It touches {_counted(goal.cushions_between, 'cushion')} before the last of them.")
    if goal.untouched:
        lines.append(f"Nothing touches {listed(goal.untouched)}.")
    lines += [f"The {named(zone.ball)} stops in its ring." for zone in goal.zones]
    if goal.scratch:
        lines.append(f"The {named(CUE_BALL)} goes down too.")
    return tuple(lines)


def _counted(count: int, noun: str) -> str:
    """A count in words."""
    return f"{COUNTS[count] if count < len(COUNTS) else count} {noun}{'s' * (count != 1)}"

"""A stroke of snooker as the referee sees it: what was on, what was hit, which fouls it had and what they
cost.

Numbers are those of the WPBSA's Official Rules of the Games of Snooker and Billiards (2019).
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.game.rules import CUE_BALL, Foul, ShotSummary
from game.billiards.game.snooker.sight import Discs, Places
from game.billiards.table.snooker import COLOUR_NAMES, RED_NUMBERS, name_of, touching, value_of

LEAST, MOST = 4, 7  # points of a foul (3.10)


class Seen(NamedTuple):
    """What the referee saw besides the summary.

    places: of all balls before the stroke, m by number; empty: not seen. curves: the curved cushions. near:
    how near the cue ball came to a ball on before it met any, gap in m. pushed: the tip was still at the
    cue ball when that met another (2.19).
    """

    places: Places = {}
    curves: Discs = ()
    near: float = math.inf
    pushed: bool = False


class Target(NamedTuple):
    """What a stroke is played for: balls that must be hit first, those that score, its value in points.

    free: the free ball, if one was nominated (2.13). nominated: the striker has said what is on.
    """

    first: tuple[int, ...]
    score: tuple[int, ...]
    value: int
    free: int | None = None
    nominated: bool = True


class Penalty(NamedTuple):
    """A foul and its points before the least of four (3.10)."""

    foul: Foul
    points: int


def hits_touching(target: Target, seen: Seen) -> bool:
    """True if the cue ball lay at a ball on, which it then has hit without moving it (3.8(c))."""
    return any(ball in target.first for ball in touching(seen.places))


def fails_to_hit(target: Target, shot: ShotSummary, seen: Seen) -> bool:
    """True if no ball on was hit first."""
    return not hits_touching(target, seen) and not any(ball in target.first for ball in shot.first)


def penalties(target: Target, shot: ShotSummary, seen: Seen) -> list[Penalty]:
    """Every foul of a stroke that its own course shows, with its points (3.10)."""
    found = []
    if shot.cue_pocketed:
        found.append(Penalty(Foul("in-off", "The cue ball went down."), target.value))
    for ball in shot.off_table:
        value = target.value if ball == CUE_BALL else max(target.value, value_of(ball))
        found.append(Penalty(Foul("off the table", f"The {name_of(ball)} left the table."), value))
    found += contact_penalties(target, shot, seen)
    for ball in shot.balls_down:
        if ball not in target.score:
            words = f"The {name_of(ball)} went down, which was not on."
            found.append(Penalty(Foul("wrong pot", words), max(target.value, value_of(ball))))
    if not target.nominated and found:
        found.append(Penalty(Foul("no nomination", "No colour had been nominated."), MOST))
    return found


def contact_penalties(target: Target, shot: ShotSummary, seen: Seen) -> list[Penalty]:
    """What is wrong with the first contact of a stroke: a push stroke, no ball, or the wrong one."""
    return _push(target, shot, seen) + _first_contact(target, shot, seen)


def _push(target: Target, shot: ShotSummary, seen: Seen) -> list[Penalty]:
    """2.19, 3.8(b): a ball that the cue ball touches must not be played into."""
    into = [ball for ball in shot.first if ball in touching(seen.places)]
    if not into and not (seen.pushed and shot.first):
        return []
    concerned = max(value_of(ball) for ball in into or shot.first)
    words = (
        f"The cue ball was played into the {name_of(into[0])} it touched: a push stroke." if into
        else "The tip was still at the cue ball when that met another: a push stroke."
    )  # fmt: skip
    return [Penalty(Foul("push stroke", words), max(target.value, concerned))]


def _first_contact(target: Target, shot: ShotSummary, seen: Seen) -> list[Penalty]:
    """3.10(a)(vi), (b)(ii), (c): no ball hit, the wrong one first, or two at once."""
    if hits_touching(target, seen):
        return []
    if not shot.first:
        return [Penalty(Foul("no contact", "The cue ball touched no ball."), target.value)]
    wrong = [ball for ball in shot.first if ball not in target.first]
    if target.free is not None and target.free in shot.first:  # 3.6: free ball and ball on at once
        wrong = [ball for ball in wrong if ball not in target.score]
    if not wrong:
        return []
    value = max(target.value, *(value_of(ball) for ball in wrong))
    if len(wrong) < len(shot.first):
        words = f"The {name_of(wrong[0])} was hit together with the {name_of(target.first[0])}."
        return [Penalty(Foul("two at once", words), value)]
    words = f"The {name_of(wrong[0])} was hit first, not {on_words(target)}."
    return [Penalty(Foul("wrong ball", words), value)]


def on_words(target: Target) -> str:
    """What is on, in words."""
    if target.free is not None:
        return f"the free ball, the {name_of(target.free)}"
    if set(target.first) <= set(RED_NUMBERS):
        return "a red"
    return f"the {name_of(target.first[0])}" if len(target.first) == 1 else "a colour"


def cost(found: list[Penalty]) -> int:
    """Points of the worst of the fouls: four at least, seven at most (3.10, 3.11(d))."""
    return min(max([LEAST, *(one.points for one in found)]), MOST)


def scored_points(target: Target, shot: ShotSummary) -> tuple[int, tuple[int, ...]]:
    """Points of a stroke without a foul, and the balls that brought them (3.3(e), 3.12(d) to (f))."""
    down = tuple(ball for ball in shot.balls_down if ball in target.score)
    reds = tuple(ball for ball in down if ball not in COLOUR_NAMES)
    if target.free is not None and target.value > 1:  # beside a colour that is on, a free ball counts nothing
        own = tuple(ball for ball in down if ball != target.free)
        return (target.value, own or down) if down else (0, ())
    if target.value == 1:
        return len(reds) + (target.free in down and target.free not in reds), down
    return (target.value, down) if down else (0, ())

"""Routes and strokes in words: what a cue ball touches in order, and how to play it."""

from __future__ import annotations

import math

from game.billiards.game.arrangement import Stroke
from game.billiards.map.carom import Group, Position
from game.billiards.map.routes import BALL_DIGIT, touches
from game.billiards.map.tolerance import Tolerance
from game.billiards.table.carom import BALL_NAMES, BALL_RADIUS
from game.physics.kernels import elementary

RAILS = ("left", "right", "lower", "upper")
FULLNESS = ((0.92, "full"), (0.68, "three quarters full"), (0.42, "half full"), (0.18, "a quarter full"))
SPEEDS = ((1.0, "very softly"), (2.0, "softly"), (3.2, "at medium speed"), (4.5, "hard"))
LEAST_TIP = 0.08  # ball radii; nearer to the middle it is none


def ball_names(cue: int) -> tuple[str, str, str]:
    """Names of the balls by row when ball `cue` is played."""
    return BALL_NAMES[cue], BALL_NAMES[1 - cue], BALL_NAMES[2]


def route_words(code: int, cue: int) -> str:
    """A route: "red, long, short, long, yellow"."""
    names = ball_names(cue)
    return ", ".join(
        names[digit - BALL_DIGIT] if digit > BALL_DIGIT else "long" if digit <= 2 else "short"
        for digit in touches(code)
    )


def rails_words(code: int) -> str:
    """The rails of a route by their places: "upper, left, right"; to tell apart two that sound alike."""
    return ", ".join(RAILS[digit - 1] for digit in touches(code) if digit <= BALL_DIGIT)


def hit_words(position: Position, group: Group) -> str:
    """How the first ball is hit: "the red ball half full on its left side"; "a long cushion first" else."""
    digits = touches(group.code)
    if not digits or digits[0] <= BALL_DIGIT:
        return f"the {RAILS[digits[0] - 1]} cushion first" if digits else "nothing"
    row = digits[0] - BALL_DIGIT
    places = position.places[position.order]
    dx, dy = (places[row] - places[0]).tolist()
    aim = group.stroke.azimuth
    aside = (dy * elementary.cos(aim) - dx * elementary.sin(aim)) / (2.0 * BALL_RADIUS)
    full = 1.0 - min(abs(aside), 1.0)
    words = next((words for least, words in FULLNESS if full >= least), "thinly")
    name = f"the {ball_names(position.cue)[row]} ball {words}"
    return name if full >= FULLNESS[0][0] else f"{name} on its {'right' if aside > 0.0 else 'left'}"


def tip_words(stroke: Stroke, brief: bool = False) -> str:
    """Where the tip meets the ball: "above the centre, with some left side", or "above, some left side"."""
    up, left = stroke.tip_up, stroke.tip_left
    words = [] if abs(up) < LEAST_TIP else ["above the centre" if up > 0.0 else "below the centre"]
    if abs(left) >= LEAST_TIP:
        much = "much" if abs(left) > 0.35 else "some"
        words.append(f"with {much} {'left' if left > 0.0 else 'right'} side")
    if brief and len(words) == 2:
        words = [words[0].removesuffix(" the centre"), words[1].removeprefix("with ")]
    return ", ".join(words) or "in the centre"


def explain(position: Position, group: Group, tolerance: Tolerance | None = None) -> tuple[str, ...]:
    """A choice in sentences: how to play it, how sure it is, what else there is to say of it."""
    stroke = group.stroke
    pace = next((words for most, words in SPEEDS if stroke.cue_speed <= most), "very hard")
    said = [
        f"Play {hit_words(position, group)}, {pace} ({stroke.cue_speed:.1f} m/s), {tip_words(stroke)}.",
        f"The cue ball goes {route_words(group.code, position.cue)}.",
        f"It scores {round(100.0 * group.chance)} times in 100.",
    ]
    if group.chance - group.meant > 0.05:
        said.append(f"{round(100.0 * (group.chance - group.meant))} of these go another way.")
    if group.kisses:
        said.append("There is a kiss: the balls meet once more than they need to.")
    if tolerance is not None:
        aim = math.degrees(min(tolerance.aim))
        said.append(f"The aim may be off by {aim:.2f} degrees, the speed by {min(tolerance.speed):.2f} m/s.")
    return tuple(said)

"""What is said in words: directions, strokes, fouls to come, and the line below the table."""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.game.arrangement import Stroke
from game.billiards.game.games import Drill, RunDrill
from game.billiards.game.goals import described
from game.billiards.game.rules import CUE_BALL, Call, Game, contact_fouls, listed
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards.play import AIMING, ROLLING, STRIKING, Play
from game.scenes.billiards.stroke.calling import call_for
from game.scenes.billiards.stroke.motion import power_of
from game.scenes.shared.tables.lessons.lesson import NEXT_LESSON


def aim_words(azimuth: float) -> str:
    """A direction (rad from x) in degrees of the picture: 0 to the right, against the clock."""
    degrees = math.degrees(math.remainder(0.5 * math.pi - azimuth, 2.0 * math.pi))
    return f"{-degrees if degrees else 0.0:.2f}°".replace("-", "\u2212")


def stroke_words(stroke: Stroke, radius: float = BALL_RADIUS) -> tuple[str, ...]:
    """How a stroke is set, in lines: power, and where the tip strikes; aim, and how far the cue is raised.

    Nothing is left out that the instruments show as other than 0. radius of the cue ball, m.
    """
    offsets = [
        f"{1000.0 * abs(value) * radius:.1f} mm {more if value > 0.0 else less}"
        for value, more, less in ((stroke.tip_up, "above", "below"), (stroke.tip_left, "left", "right"))
        if 1000.0 * abs(value) * radius >= 0.05
    ]
    power = f"{power_of(stroke.cue_speed):.1f} m/s, {' and '.join(offsets) or 'in the middle'}"
    degrees = math.degrees(stroke.elevation)
    raised = f", cue raised by {degrees:.0f}°" if degrees >= 0.5 else ""
    return power, f"aim {aim_words(stroke.azimuth)}{raised}"


def foul_of(game: Game, call: Call, first: int | None, short: bool) -> str:
    """Why the first contact of a stroke is a foul, empty if it is none. first: the ball that the cue ball
    meets; short: it lies behind the line, which the cue ball has not crossed.
    """
    allowed = game.legal_first()
    if first is None or call.push_out:
        return ""
    kinds = [foul.kind for foul in contact_fouls(game, (first,), short, allowed)]
    if not kinds:
        return ""
    if kinds == ["behind the line"]:
        return "foul: behind the line"
    return f"foul: {listed(allowed)} first" if len(allowed) == 1 else f"foul: not the {first}"


PULLS, PUSHES = "pull the cue back and let go", "draw the cue back and push it through"


class Line(NamedTuple):
    """The line below the table: what follows or is to be done, and why; foul: it says a foul."""

    lead: str
    more: str = ""
    foul: bool = False


def line_of(play: Play, hint: Stroke | None) -> Line:
    """The line below the table. hint: a solution that is shown."""
    frame = play.model.frame
    game = frame.game
    if play.phase in (STRIKING, ROLLING):
        return Line(_announced(play))
    if hint is not None and play.phase == AIMING:
        return Line(f"Hint: {', '.join(stroke_words(hint, float(frame.layout.balls.radii[CUE_BALL])))}.")
    if frame.words:
        lead, *rest = frame.words if len(game.players) == 1 else (frame.words[-1], *frame.words[:-1])
        if isinstance(game, Drill) and game.best and play.model.content.lesson:
            rest = [*rest, NEXT_LESSON]
        return Line(lead, " ".join((*_call_due(play), *rest)), frame.foul)
    if isinstance(game, Drill):
        lead, *rest = described(game.goal, layout.POCKETS)
        if lesson := play.model.content.lesson:
            lead, rest = lesson, []
        return Line(lead, " ".join(rest))
    if isinstance(game, RunDrill):
        return Line(run_words(game), "The cue ball is in hand: drag it." if game.in_hand else "")
    if play.phase != AIMING or not play.person_plays:
        return Line("")
    how = PUSHES if play.push.chosen else PULLS
    return Line(_what_to_do(game, how), " ".join(_call_due(play)))


def run_words(game: RunDrill) -> str:
    """What a drill of many strokes asks for."""
    order = "in order" if game.ordered else "in any order"
    where = f" into the {layout.pocket_words(game.pocket)}" if game.pocket is not None else ""
    off = ", and touch no cushion with the cue ball" if game.off_cushions else ""
    return f"Pot all {game.count} {order}{where} without a miss{off}."


def _what_to_do(game: Game, how: str) -> str:
    """What a person at turn can do. how: in words, a stroke is made."""
    alone = len(game.players) == 1
    if game.in_hand:
        where = " behind the line" if game.in_hand == "behind the line" else ""
        who = "The cue ball is" if alone else f"{game.shooter} has the cue ball"
        return f"{who} in hand: drag it{where}, then {how}."
    return f"Aim, {how}." if alone else f"{game.shooter} plays: aim, {how}."


def _call_due(play: Play) -> tuple[str, ...]:
    """What is called for the stroke that is aimed, or that a call is needed; empty where none is."""
    frame = play.model.frame
    if not play.may_aim or not frame.game.needs_call():
        return ()
    words = call_words(call_for(frame, play.aiming.call, play.aiming.stroke))
    return (words or "A call is needed: aim at a ball, or click a ball and a pocket.",)


def call_words(call: Call) -> str:
    """What is called, in words; empty if that is not enough to score."""
    if call.safety:
        return "A safety."
    if call.push_out:
        return "A push-out."
    if call.ball is None or call.pocket is None:
        return ""
    return f"Called: the {call.ball} into the {layout.pocket_words(call.pocket)}."


def _announced(play: Play) -> str:
    """What was called before the stroke, in words."""
    last = play.model.frame.last
    call = play.aiming.call if play.phase == STRIKING or last is None else last.call
    if not (call.safety or call.push_out or play.model.frame.game.needs_call()):
        return ""
    return call_words(call)

"""What is said in words: directions, strokes, fouls to come, and the line below the table."""

from __future__ import annotations

import math

from game.billiards.game.arrangement import Stroke
from game.billiards.game.games import Drill
from game.billiards.game.goals import described
from game.billiards.game.rules import Call, Game, listed
from game.scenes.billiards import layout
from game.scenes.billiards.play import AIMING, ROLLING, STRIKING, Play
from game.scenes.billiards.stroke.motion import power_of


def aim_words(azimuth: float) -> str:
    """A direction (rad from x) in degrees of the picture: 0 to the right, against the clock."""
    degrees = math.degrees(math.remainder(0.5 * math.pi - azimuth, 2.0 * math.pi))
    return f"{-degrees if degrees else 0.0:.2f}°".replace("-", "\u2212")


def stroke_words(stroke: Stroke) -> tuple[str, ...]:
    """How a stroke is set, in lines: power, and where the tip strikes; aim, and how far the cue is raised.

    Nothing is left out that the instruments show as other than 0.
    """
    offsets = [
        f"{abs(value):.2f} R {more if value > 0.0 else less}"
        for value, more, less in ((stroke.tip_up, "above", "below"), (stroke.tip_left, "left", "right"))
        if abs(value) >= 0.005
    ]
    power = f"{power_of(stroke.cue_speed):.1f} m/s, {' and '.join(offsets) or 'in the middle'}"
    degrees = math.degrees(stroke.elevation)
    raised = f", cue raised by {degrees:.0f}°" if degrees >= 0.5 else ""
    return power, f"aim {aim_words(stroke.azimuth)}{raised}"


def foul_of(game: Game, call: Call, first: int | None) -> str:
    """Why a stroke is a foul whose cue ball meets that ball first, empty if it is none."""
    allowed = game.legal_first()
    if first is None or first in allowed or call.push_out:
        return ""
    return f"foul: {listed(allowed)} first" if len(allowed) == 1 else f"foul: not the {first}"


def line_of(play: Play, hint: Stroke | None) -> tuple[str, bool]:
    """The line below the table, and whether it says a foul. hint: a solution that is shown."""
    frame = play.model.frame
    game = frame.game
    if play.phase in (STRIKING, ROLLING):
        return _announced(play), False
    if hint is not None and play.phase == AIMING:
        return f"Hint: {', '.join(stroke_words(hint))}.", False
    if frame.words:
        return " ".join(frame.words), frame.foul
    if isinstance(game, Drill):
        return " ".join(described(game.goal, layout.POCKETS)), False
    if play.phase != AIMING or play.plays_itself or not play.person_plays:
        return "", False
    alone = len(game.players) == 1
    if game.in_hand:
        where = " behind the line" if game.in_hand == "behind the line" else ""
        who = "The cue ball is" if alone else f"{game.shooter} has the cue ball"
        return f"{who} in hand: drag it{where}, then pull the cue back and let go.", False
    return "Aim, pull the cue back and let go." if alone else f"{game.shooter} plays.", False


def _announced(play: Play) -> str:
    """What was called before the stroke, in words."""
    last = play.model.frame.last
    call = play.aiming.call if play.phase == STRIKING or last is None else last.call
    if call.safety:
        return "A safety."
    if call.push_out:
        return "A push-out."
    if call.ball is None or call.pocket is None or not play.model.frame.game.needs_call():
        return ""
    return f"Called: the {call.ball} into the {layout.pocket_words(call.pocket)}."

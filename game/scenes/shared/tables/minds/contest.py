"""How a match between a person and a computer player stands, for the person's career."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from game.billiards.game.arrangement import Stroke
from game.billiards.game.register import REGISTER
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.shared.tables.choices import PERSON, ahead
from game.stage.records.contested import Contested, HandMeasured, StrokeMeasured

if TYPE_CHECKING:
    from game.billiards.map.stroke_facts import Measured


def contest_of(course: Any) -> Contested | None:
    """The match that is played at a table; None if it is none of a person against a computer player.

    course: of any cue game, with model, parameters and grades.
    """
    game, name = course.model.frame.game, str(course.model.content.game)
    entry = REGISTER.get(name)
    if entry is None or len(game.players) != 2 or course.plays_itself:
        return None
    if course.grade_of(0) != PERSON or course.grade_of(1) == PERSON:
        return None
    start = int(course.parameters.head_start)
    if entry.family == "carom":
        over, won = game.over, (int(game.winner == 0), int(game.winner == 1))
    else:
        over = bool(course.match_over)
        given = ahead(start)
        won = (game.won[0] - given[0], game.won[1] - given[1])
    best = getattr(game, "high", None) or getattr(game, "high_runs", None) or (0, 0)
    return Contested(
        name, game.players[0], course.grade_of(1), start, (max(won[0], 0), max(won[1], 0)), over,
        over and game.winner == 0, int(best[0]), int(course.model.frame.strokes),
        hand_of(course.own_strokes) if over else None,
    )  # fmt: skip


def hand_of(pairs: Sequence[tuple[Stroke, Stroke]]) -> HandMeasured | None:
    """The noise of a person's strokes, (meant, made) each; None for too few, or a hand that is steady."""
    from game.billiards.map.hand import noise_of

    strayed = [pair for pair in pairs if pair[0] != pair[1]]
    noise = noise_of(strayed, BALL_RADIUS)  # of the tip, which is not asked for here
    return None if noise is None else HandMeasured(noise.azimuth, noise.speed, len(strayed))


def stroke_of(course: Any) -> StrokeMeasured | None:
    """What was measured of the last stroke, if the person of a contest has played it."""
    frame, played = course.model.frame, course.model.played
    last = frame.last
    if contest_of(course) is None or last is None or played is None or last.frame.game.turn != 0:
        return None
    pair = course.aimed_and_done
    meant = pair[0] if pair is not None and pair[1] == last.stroke else last.stroke
    found = _measured(last, played, meant)
    return None if found is None else StrokeMeasured(*found, float(last.stroke.cue_speed))


def _measured(last: Any, played: Any, meant: Stroke) -> Measured | None:
    """A stroke in figures. last: with the frame before it."""
    from game.billiards.map.stroke_facts import measured, measured_point
    from game.billiards.players.carom import position_of

    if hasattr(last, "call"):
        return measured(last.frame, played, meant)
    return None if last.safety else measured_point(position_of(last.frame), played, meant)

"""The coach's card beside a table: what was played and what was there, why it missed, what is left."""

from __future__ import annotations

import math

from game.billiards.map.causes import AIM, PACE, SPIN, Cause
from game.billiards.map.hand import FEWEST
from game.scenes.shared.tables.beside.coach import Coach, Told, Way
from game.scenes.shared.tables.beside.column import Column
from game.scenes.shared.tables.beside.rows import Row, draw_ground, draw_rows
from game.scenes.shared.tables.through.measured import hand_words, stroke_words
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look

MOST_CAUSES = 3


def ask_row(coach: Coach) -> Row:
    """How the coach is asked."""
    return Row("?", f"Ask before the stroke: {coach.speech.key}", "the score then says: coached")


def draw_coach(canvas: Canvas, look: Look, column: Column, coach: Coach) -> None:
    """The card."""
    told = coach.told()
    draw_ground(canvas, look, column, "Coach", _under(coach, told))
    below = ahead_rows(coach)
    free = column.rows - len(below)
    if told is not None:
        draw_rows(canvas, look, column, told_rows(coach, told, free)[:free])
    draw_rows(canvas, look, column, below, free)


def _under(coach: Coach, told: Told | None) -> str:
    """The line below the heading."""
    if coach.course.model.frame.last is None:
        return "Play a stroke: here stands afterwards what there was, and why it missed."
    if told is None:
        return "The stroke is looked at …" if coach.active else "The balls roll."
    return f"Chances are of this hand: {coach.hand_words}."


def told_rows(coach: Coach, told: Told, free: int = 100) -> list[Row]:
    """What there is to say of the last stroke. free: rows for it; causes give way first, the hand is last."""
    for most in range(MOST_CAUSES, 0, -1):
        rows = _rows_with(coach, told, most)
        if len(rows) <= free:
            break
    return [*rows, *_hand_rows(coach)]


def _rows_with(coach: Coach, told: Told, most: int) -> list[Row]:
    """The same with so many causes at most, without the hand."""
    speech = coach.speech
    rows = [Row("", f"{told.shooter}'s stroke", head=True), _tried(coach, told)]
    if told.best is not None and not told.surest:
        rows += [Row("", "What was there", head=True), way_row(told.best)]
    if told.tried is not None and not told.made:
        why = "Why it was a foul" if told.foul else "Why it missed"
        why += ": the hand" if told.strayed else ""
        nothing = Row("–", "more than one thing", speech.nothing_right)
        causes = [cause_row(coach, one) for one in told.causes[:most]] or [nothing]
        rows += [Row("", why, head=True), *causes]
    if not told.over:
        whose = "for the next" if told.shooter == told.next_shooter else f"for {told.next_shooter}"
        rows += [Row("", f"What is left {whose}", head=True), left_row(coach, told.left)]
    return rows


def _hand_rows(coach: Coach) -> list[Row]:
    """How the last stroke of the hand strayed, and its noise as far as it is known."""
    own = coach.course.own_strokes
    if not own:
        return []
    meant, made = own[-1]
    measured = hand_words(own, coach.radius) or f"measured from {FEWEST} strokes on"
    said = stroke_words(meant, made, coach.course.push.ball_per_cue)
    return [Row("", "Your hand", head=True), Row("±", said, measured)]


def _tried(coach: Coach, told: Told) -> Row:
    """What was tried."""
    speech, tried = coach.speech, told.tried
    if tried is None and told.aimed:
        return Row("0 %", told.aimed, speech.in_vain, share=0.0)
    if tried is None:
        return Row("–", *speech.untried)
    result = speech.made if told.made else f"{speech.made}, with a foul" if told.foul else "missed"
    if told.surest:
        result += "; it was the surest there was"
    return Row(_percent(tried.chance), tried.words, result, lit=True, share=tried.chance)


def way_row(way: Way) -> Row:
    """A stroke that there is or was."""
    return Row(_percent(way.chance), way.words, way.stroke, share=way.chance)


def left_row(coach: Coach, way: Way | None) -> Row:
    """How good the surest stroke is that is left; which it is, the coach says only if asked."""
    if way is None:
        return Row("–", *coach.speech.none)
    return Row(_percent(way.chance), coach.speech.best, "which one: ask", share=way.chance)


def cause_row(coach: Coach, cause: Cause) -> Row:
    """What, put right alone, would have done it."""
    words = fault_words(cause, coach.radius, coach.course.push.ball_per_cue)
    return Row("✓", words, coach.speech.right)


def fault_words(cause: Cause, radius: float, ball_per_cue: float) -> str:
    """What was wrong: the other way than the change that puts it right. radius of the ball, m."""
    size = abs(cause.change)
    if cause.name == AIM:
        return f"aim {math.degrees(size):.2f}° too far {'right' if cause.change > 0.0 else 'left'}"
    if cause.name == PACE:
        return f"{size * ball_per_cue:.1f} m/s too {'soft' if cause.change > 0.0 else 'hard'}"
    if cause.name == SPIN:
        low, high = ("low", "high") if cause.up else ("far right", "far left")
        return f"tip {1000.0 * size * radius:.1f} mm too {low if cause.change > 0.0 else high}"
    return "throw: the balls' friction took it off"


def ahead_rows(coach: Coach) -> list[Row]:
    """The stroke that is aimed, if the coach was asked; else how to ask."""
    if not coach.course.may_aim:
        return []
    if not coach.asked:
        return [ask_row(coach)]
    known, way = coach.advice()
    if not known:
        row = Row("…", "the position is looked at")
    else:
        nothing = Row("–", coach.speech.none[0], "play safe")
        row = nothing if way is None else way_row(way)._replace(lit=True)
    return [Row("", "The stroke to come", head=True), row]


def _percent(chance: float) -> str:
    return f"{100.0 * chance:.0f} %"

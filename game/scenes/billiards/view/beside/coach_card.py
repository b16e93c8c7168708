"""The coach's card beside the table: what was played and what was there, why it missed, what is left."""

from __future__ import annotations

import math

from game.billiards.map.hand import FEWEST
from game.billiards.map.pool import Pot
from game.billiards.map.review import AIM, PACE, SPIN, Cause, Review
from game.billiards.map.words import tip_words
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards.practice.coach import Coach, Told
from game.scenes.billiards.practice.columns import ROWS
from game.scenes.billiards.stroke.motion import power_of
from game.scenes.billiards.view.beside.rows import Row, draw_ground, draw_rows
from game.scenes.shared.tables.through.measured import hand_words, stroke_words
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look

MOST_CAUSES = 3
ASK = Row("?", "Ask before the stroke: Q", "the score then says: coached")
NO_CAUSE = Row("–", "more than one thing", "nothing put right alone pots it")
SURE = 0.02  # by which a chance is not worse than another one


def draw_coach(canvas: Canvas, look: Look, coach: Coach) -> None:
    """The card."""
    told = coach.told()
    draw_ground(canvas, look, "Coach", _under(coach, told))
    rows = told_rows(coach, told) if told is not None else []
    draw_rows(canvas, look, rows)
    below = ahead_rows(coach)
    draw_rows(canvas, look, below, ROWS - len(below))


def _under(coach: Coach, told: Told | None) -> str:
    """The line below the heading."""
    if coach.play.model.frame.last is None:
        return "Play a stroke: here stands afterwards what there was, and why it missed."
    if told is None:
        return "The stroke is looked at …" if coach.active else "The balls roll."
    return f"Chances are of this hand: {coach.hand.words}."


def told_rows(coach: Coach, told: Told) -> list[Row]:
    """What there is to say of the last stroke."""
    found = told.review
    rows = [Row("", f"{told.shooter}'s stroke", head=True), _tried(found)]
    if found.best is not None and not _is_best(found):
        rows += [Row("", "What was there", head=True), pot_row(found.best)]
    if found.pocket is not None and not found.made:
        why = "Why it was a foul" if found.foul else "Why it missed"
        why += ": the hand" if found.strayed else ""
        causes = [cause_row(one) for one in found.causes[:MOST_CAUSES]] or [NO_CAUSE]
        rows += [Row("", why, head=True), *causes]
    if not told.over:
        whose = "for the next" if told.shooter == told.next_shooter else f"for {told.next_shooter}"
        rows += [Row("", f"What is left {whose}", head=True), left_row(told.left)]
    return [*rows, *_hand_rows(coach)]


def _hand_rows(coach: Coach) -> list[Row]:
    """How the last stroke of the hand strayed, and its noise as far as it is known."""
    play = coach.play
    if not play.own:
        return []
    meant, made = play.own[-1]
    measured = hand_words(play.own, BALL_RADIUS) or f"measured from {FEWEST} strokes on"
    said = stroke_words(meant, made, play.push.ball_per_cue)
    return [Row("", "Your hand", head=True), Row("±", said, measured)]


def _is_best(found: Review) -> bool:
    """True if the pot that was tried was the surest, or as good."""
    best = found.best
    same = best is not None and (best.ball, best.pocket) == (found.ball, found.pocket)
    return best is not None and (same or found.chance >= best.chance - SURE)


def _tried(found: Review) -> Row:
    """The pot that was tried."""
    if found.ball is None:
        return Row("–", "no pot was tried", "a safety, or by a cushion first")
    if found.pocket is None:
        return Row("0 %", f"the {found.ball}", "on this line it goes into no pocket", share=0.0)
    result = "it went down" if found.made else "it went down, with a foul" if found.foul else "missed"
    if found.best is not None and _is_best(found):
        result += "; it was the surest there was"
    words = f"the {found.ball}, {layout.POCKETS[found.pocket]}"
    return Row(_percent(found.chance), words, result, lit=True, share=found.chance)


def pot_row(pot: Pot) -> Row:
    """A pot that there is or was, with its stroke."""
    stroke = f"{power_of(pot.stroke.cue_speed):.1f} m/s, {tip_words(pot.stroke, brief=True)}"
    return Row(
        _percent(pot.chance), f"the {pot.ball}, {layout.POCKETS[pot.pocket]}", stroke, share=pot.chance
    )


def left_row(pot: Pot | None) -> Row:
    """How good the best pot is that is left; which it is, the coach says only if asked."""
    if pot is None:
        return Row("–", "no pot in sight", "a safety, or a kick")
    return Row(_percent(pot.chance), "the chance of the best pot", "which one: ask", share=pot.chance)


def cause_row(cause: Cause) -> Row:
    """What, put right alone, would have potted."""
    return Row("✓", fault_words(cause), "put right alone, it falls")


def fault_words(cause: Cause) -> str:
    """What was wrong: the other way than the change that puts it right."""
    size = abs(cause.change)
    if cause.name == AIM:
        return f"aim {math.degrees(size):.2f}° too far {'right' if cause.change > 0.0 else 'left'}"
    if cause.name == PACE:
        return f"{power_of(size):.1f} m/s too {'soft' if cause.change > 0.0 else 'hard'}"
    if cause.name == SPIN:
        low, high = ("low", "high") if cause.up else ("far right", "far left")
        return f"tip {1000.0 * size * BALL_RADIUS:.1f} mm too {low if cause.change > 0.0 else high}"
    return "throw: the balls' friction took it off"


def ahead_rows(coach: Coach) -> list[Row]:
    """The stroke that is aimed, if the coach was asked; else how to ask."""
    if not coach.play.may_aim:
        return []
    if not coach.asked:
        return [ASK]
    known, pot = coach.advice()
    if not known:
        row = Row("…", "the position is looked at")
    else:
        row = pot_row(pot)._replace(lit=True) if pot is not None else Row("–", "no pot in sight", "play safe")
    return [Row("", "The stroke to come", head=True), row]


def _percent(chance: float) -> str:
    return f"{100.0 * chance:.0f} %"

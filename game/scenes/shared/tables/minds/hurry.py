"""How fast a computer player's strokes are shown where a person waits for its turn: the person chooses."""

from __future__ import annotations

import math
from typing import Any

from game.scenes.shared.tables.choices import PERSON
from game.stage import Choice
from game.stage.declarations import StartLine

AS_PLAYED, FAST, TO_THE_END = OPTIONS = ("as-played", "fast", "to-the-end")
LABELS = ("As they are", "3 times as fast", "To the end")
TIMES = {AS_PLAYED: 1.0, FAST: 3.0, TO_THE_END: math.inf}


def their_strokes() -> Choice:
    """How fast strokes of a computer player are shown to a person."""
    return Choice(
        AS_PLAYED, OPTIONS, labels=LABELS, group="Game", label="Their strokes",
        help="how fast a computer player's are shown while you wait; one that ends the game is not hurried",
    )  # fmt: skip


THEIR_STROKES_LINE = StartLine(
    "their_strokes", "Their strokes", "how fast you see them", tuple(zip(OPTIONS, LABELS, strict=True)),
    AS_PLAYED, idle=("second_player", PERSON), instead="hand_over",
)  # fmt: skip


def times(course: Any) -> float:
    """How many times as fast as time the stroke that rolls is shown; infinity: only its end.

    course: of any cue game. A person's stroke is not hurried, nor are strokes of computer players
    among themselves.
    """
    if course.person_plays or course.plays_itself or course.plays_alone:
        return 1.0
    return TIMES[course.parameters.their_strokes]


def hurried(course: Any, pace: float, decides: bool) -> float:
    """The pace of a stroke that rolls. pace: without hurry; decides: it ends the game."""
    return pace if decides else pace * times(course)


def patience(course: Any, longest_s: float) -> float:
    """How long a computer player may walk round the table, s, where it takes longest_s without hurry."""
    return longest_s / times(course)

"""A match of a cup at a table: after it comes the next round, never a match beside the cup."""

from __future__ import annotations

from typing import Annotated, Any

import msgspec

from game.scenes.shared.tables.minds.contest import contest_of

FINAL = "Final"  # the last round, as of `career.bracket.ROUNDS`
NEXT_ROUND, THE_CUP = "Next round", "The cup"
SPARED = "race "  # of how a match is won: the two cards leave little room between them
Round = Annotated[str, msgspec.Meta(max_length=20)]  # of a level's content; empty: no match of a cup


def with_round(words: str, course: Any) -> str:
    """How a match is won, in words; in a match of a cup its round comes first, and less is said."""
    played = course.model.content.cup
    return f"{played}, {words.rpartition(SPARED)[2]}" if played else words


def after_match(course: Any) -> str:
    """What comes after a match of a cup that has ended, for a button; empty if none has ended.

    course: of any cue game, whose content says of which round the match is.
    """
    if not course.model.content.cup:
        return ""
    seen = contest_of(course)
    if seen is None or not seen.over:
        return ""
    return NEXT_ROUND if seen.victory and course.model.content.cup != FINAL else THE_CUP


def won_with(course: Any, otherwise: str) -> str:
    """What a game that has ended wins: the cup, or one of its rounds; else what is given."""
    played = str(course.model.content.cup)
    if not after_match(course):
        return otherwise
    return "cup" if played == FINAL else played.lower()


def goes_on(course: Any) -> bool:
    """True after a match of a cup: its tournament is asked for, and nothing is racked here."""
    if not after_match(course):
        return False
    course.rounds += 1
    return True

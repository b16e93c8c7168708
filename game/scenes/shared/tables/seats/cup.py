"""A match of a cup at a table: after it comes the next round, never a match beside the cup."""

from __future__ import annotations

from typing import Annotated, Any

import msgspec

from game.scenes.shared.tables.minds.contest import contest_of

FINAL = "Final"  # the last round, as of `career.bracket.ROUNDS`
NEXT_ROUND, THE_CUP = "Next round", "The cup"
Round = Annotated[str, msgspec.Meta(max_length=20)]  # of a level's content; empty: no match of a cup


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


def goes_on(course: Any) -> bool:
    """True after a match of a cup: its tournament is asked for, and nothing is racked here."""
    if not after_match(course):
        return False
    course.rounds += 1
    return True

"""What a level of the beat says: the beat, and a layout that meets it, if one is known."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.billiards.rhythm.candidates import STROKE
from game.billiards.rhythm.search import MOST_BEATS, check_beats
from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

MOST_NUMBERS = STROKE + 2 * MOST_BEATS
Number = Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)]


class BeatContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. beats: s, the first is the stroke; layout: of a stroke and where the balls lie.

    layout: speed m/s, azimuth rad, tip left and up in ball radii, then x and y (m) of each ball, the cue ball
    first; empty: it is searched for. expected: of readouts.
    """

    beats: Annotated[tuple[Number, ...], msgspec.Meta(max_length=MOST_BEATS)] = ()
    layout: Annotated[tuple[Number, ...], msgspec.Meta(max_length=MOST_NUMBERS)] = ()
    expected: Expectations = ()


def check_content(content: BeatContent) -> None:
    """ValueError for beats that make no sense, or another number of balls than of beats."""
    if content.beats:
        check_beats(content.beats)
    numbers = STROKE + 2 * len(content.beats)
    if content.layout and len(content.layout) != numbers:
        raise ValueError(f"layout: expected {numbers} numbers for {len(content.beats)} beats")


DEFAULT = BeatContent(beats=(0.0, 0.5, 1.0, 1.25, 1.5, 2.0))

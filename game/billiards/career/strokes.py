"""What is counted of a person's strokes for ever: pots by distance and cut, position, breaks, opponents."""

from __future__ import annotations

import csv
import io
import itertools
import math
from collections.abc import Sequence
from typing import Annotated, NamedTuple

import msgspec

Number = Annotated[float, msgspec.Meta(ge=0.0, le=1e4)]
Word = Annotated[str, msgspec.Meta(max_length=40)]
POT, BREAK = "pot", "break"
DISTANCES = (0.0, 0.4, 0.8, 1.2, 1.6, 2.4, 4.0)  # m; edges of the classes
CUTS = (0.0, 15.0, 30.0, 45.0, 60.0, 90.0)  # degrees


class StrokeFact(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One stroke of a person in a match.

    kind: POT for one at a ball, BREAK. distance: of the cue ball to its contact, m. cut: degrees. made: the
    ball went down. chance: of the pot by the map's geometry for a hand of usual noise. stray: how far
    from where it was meant to the cue ball came to rest, m; None if the hand did as it was meant. speed: of
    the cue, m/s.
    """

    when: Word
    game: Word
    opponent: Word
    kind: Word
    distance: Number
    cut: Number
    made: bool
    chance: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
    stray: Number | None
    speed: Number


class Share(NamedTuple):
    """A class of pots: its middle, how many pots, the share made, and the mean of the map's chances."""

    middle: float
    pots: int
    made: float
    expected: float


def shares(facts: Sequence[StrokeFact], edges: Sequence[float], by_cut: bool) -> list[Share]:
    """Pots in classes of distance (m), or of cut (degrees); classes without pots are left out."""
    found = []
    for low, high in itertools.pairwise(edges):
        some = [
            one for one in facts
            if one.kind == POT and low <= (one.cut if by_cut else one.distance) < high
        ]  # fmt: skip
        if some:
            made = sum(one.made for one in some) / len(some)
            expected = sum(one.chance for one in some) / len(some)
            found.append(Share(0.5 * (low + high), len(some), made, expected))
    return found


class Summary(NamedTuple):
    """Pots tried and made, what the map expected of them; mean position error m; mean break speed m/s."""

    pots: int
    made: int
    expected: float
    stray: float
    break_speed: float


def summary_of(facts: Sequence[StrokeFact]) -> Summary:
    """All strokes in a line; NaN for what has not been measured."""
    pots = [one for one in facts if one.kind == POT]
    strays = [one.stray for one in facts if one.stray is not None]
    breaks = [one.speed for one in facts if one.kind == BREAK]
    return Summary(
        len(pots), sum(one.made for one in pots), sum(one.chance for one in pots),
        sum(strays) / len(strays) if strays else math.nan,
        sum(breaks) / len(breaks) if breaks else math.nan,
    )  # fmt: skip


def by_opponent(facts: Sequence[StrokeFact]) -> dict[str, Summary]:
    """The summary against each opponent, by name."""
    names = sorted({one.opponent for one in facts})
    return {name: summary_of([one for one in facts if one.opponent == name]) for name in names}


def csv_of(facts: Sequence[StrokeFact]) -> str:
    """All strokes as a table of text, a head first; SI units, cut in degrees."""
    out = io.StringIO()
    rows = csv.writer(out, lineterminator="\n")
    rows.writerow(
        ["when", "game", "opponent", "kind", "distance_m", "cut_deg", "made", "chance", "position_error_m",
         "cue_speed_m_s"]
    )  # fmt: skip
    for one in facts:
        stray = "" if one.stray is None else f"{one.stray:.4f}"
        rows.writerow(
            [one.when, one.game, one.opponent, one.kind, f"{one.distance:.4f}", f"{one.cut:.2f}",
             int(one.made), f"{one.chance:.4f}", stray, f"{one.speed:.3f}"]
        )  # fmt: skip
    return out.getvalue()

"""What is counted of a person's strokes for ever: pots and points by their difficulty, position, breaks."""

from __future__ import annotations

import csv
import io
import itertools
import math
from collections.abc import Sequence
from typing import Annotated, NamedTuple

import msgspec

from game.billiards.game.kinds import BREAK, POINT, POT

Number = Annotated[float, msgspec.Meta(ge=0.0, le=1e4)]
Word = Annotated[str, msgspec.Meta(max_length=40)]
DISTANCES = (0.0, 0.4, 0.8, 1.2, 1.6, 2.4, 4.0)  # m; edges of the classes
CUTS = (0.0, 15.0, 30.0, 45.0, 60.0, 90.0)  # degrees
CHANCES = (0.0, 0.1, 0.2, 0.35, 0.5, 0.7, 1.01)  # of a point, for a hand of usual noise
WAYS = (0.0, 1.0, 2.0, 3.0, 5.0)  # cushions before the first ball


class StrokeFact(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One stroke of a person in a match.

    kind: POT for one at a ball, BREAK, POINT for one of carom. distance: of the cue ball to its contact, m.
    cut: degrees. made: the ball went down, or the point was made. chance: of that for a hand of usual noise,
    of a pot by the map's geometry. stray: how far from where it was meant to the cue ball came to rest, m;
    None if the hand did as it was meant. speed: of the cue, m/s. cushions: before the first ball.
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
    cushions: Annotated[int, msgspec.Meta(ge=0, le=100)] = 0


class Share(NamedTuple):
    """A class of strokes: its middle, how many, the share made, and the mean of their chances."""

    middle: float
    pots: int
    made: float
    expected: float


def shares(
    facts: Sequence[StrokeFact], edges: Sequence[float], by: str = "distance", kind: str = POT
) -> list[Share]:
    """Strokes of a kind in classes by one of their figures; classes without any are left out.

    by: "distance" m, "cut" degrees, "chance", or "cushions".
    """
    found = []
    for low, high in itertools.pairwise(edges):
        some = [one for one in facts if one.kind == kind and low <= float(getattr(one, by)) < high]
        if some:
            made = sum(one.made for one in some) / len(some)
            expected = sum(one.chance for one in some) / len(some)
            found.append(Share(0.5 * (low + high), len(some), made, expected))
    return found


class Summary(NamedTuple):
    """Pots tried and made, what the map expected of them; mean position error m; mean break speed m/s.

    points, points_made, points_expected: the same of strokes of carom.
    """

    pots: int
    made: int
    expected: float
    stray: float
    break_speed: float
    points: int = 0
    points_made: int = 0
    points_expected: float = 0.0


def summary_of(facts: Sequence[StrokeFact]) -> Summary:
    """All strokes in a line; NaN for what has not been measured."""
    pots, points = ([one for one in facts if one.kind == kind] for kind in (POT, POINT))
    strays = [one.stray for one in facts if one.stray is not None]
    breaks = [one.speed for one in facts if one.kind == BREAK]
    return Summary(
        len(pots), sum(one.made for one in pots), sum(one.chance for one in pots),
        sum(strays) / len(strays) if strays else math.nan,
        sum(breaks) / len(breaks) if breaks else math.nan,
        len(points), sum(one.made for one in points), sum(one.chance for one in points),
    )  # fmt: skip


def summary_words(name: str, found: Summary) -> str:
    """A summary in a line."""
    parts = []
    if found.pots or not found.points:
        parts.append(f"{found.made} of {found.pots} pots, {found.expected:.1f} expected by the map")
    if found.points:
        parts.append(
            f"{found.points_made} of {found.points} points, {found.points_expected:.1f} expected by the map"
        )
    if math.isfinite(found.stray):
        parts.append(f"position {1000.0 * found.stray:.0f} mm off")
    if math.isfinite(found.break_speed):
        parts.append(f"break {found.break_speed:.1f} m/s")
    return f"{name}: {'; '.join(parts)}"


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
         "cue_speed_m_s", "cushions_first"]
    )  # fmt: skip
    for one in facts:
        stray = "" if one.stray is None else f"{one.stray:.4f}"
        rows.writerow(
            [one.when, one.game, one.opponent, one.kind, f"{one.distance:.4f}", f"{one.cut:.2f}",
             int(one.made), f"{one.chance:.4f}", stray, f"{one.speed:.3f}",
             one.cushions]
        )  # fmt: skip
    return out.getvalue()

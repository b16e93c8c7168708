"""Which strokes of a match decided it: those that won its last racks, and the highest run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol, TypeVar

from game.billiards.game.log import MOST_LOGGED, START, Log, Logged

LAST_RACKS = 3  # whose winning strokes count
MOST_OF_RUN = 8  # strokes of the highest run, its last ones


class Scoring(Protocol):
    """A stroke as it counted. rack: from 1 on; scored: balls, or points, that it brought its player; winner:
    name of who has won the rack by it, else empty.
    """

    @property
    def number(self) -> int: ...
    @property
    def rack(self) -> int: ...
    @property
    def shooter(self) -> str: ...
    @property
    def scored(self) -> int: ...
    @property
    def winner(self) -> str: ...


S = TypeVar("S", bound=Scoring)


class Marked(NamedTuple):
    """A stroke of a game that keeps no log: as of `Scoring`. struck: with the frame before; end_s: how long
    its balls rolled, s.
    """

    number: int
    rack: int
    shooter: str
    scored: int
    winner: str
    struck: Any
    end_s: float


def with_marked(line: tuple[Marked, ...], struck: Any, played: Any) -> tuple[Marked, ...]:
    """The strokes of a match with one more that has been played to its end, counted in its game's points."""
    before, after = struck.frame.game, played.frame.game
    rack = 1 if not line else line[-1].rack + bool(line[-1].winner)
    winner = after.players[after.winner] if after.over and after.winner is not None else ""
    stroke = Marked(
        line[-1].number + 1 if line else 1, rack, before.players[before.turn],
        max(after.points[before.turn] - before.points[before.turn], 0), winner, struck,
        float(played.trajectory.end_time),
    )  # fmt: skip
    return (*line, stroke)[-MOST_LOGGED:]


def taken_back(line: tuple[Marked, ...], strokes: int) -> tuple[Marked, ...]:
    """Without those that were played after so many ``strokes`` of the frame in play."""
    return tuple(one for one in line if one.struck.frame.strokes < strokes)


def line_of(log: Log) -> list[Logged]:
    """The strokes that led to the frame in play, the oldest first; what was taken back is left out."""
    found: list[Logged] = []
    at = log.at
    while at != START and (entry := log.find(at)) is not None:
        found.append(entry)
        at = entry.after
    return found[::-1]


def highest_run(line: Sequence[S]) -> list[S]:
    """The strokes by which a player has scored most one after the other; of equal runs the first."""
    best: list[S] = []
    run: list[S] = []
    for entry in line:
        goes_on = bool(run) and run[-1].rack == entry.rack and run[-1].shooter == entry.shooter
        run = ([*run, entry] if goes_on else [entry]) if entry.scored else []
        if sum(one.scored for one in run) > sum(one.scored for one in best):
            best = run
    return best


def deciding_of(line: Sequence[S]) -> tuple[S, ...]:
    """The strokes that decided a match, as they were played; none before anything is scored."""
    winning = [entry for entry in line if entry.winner][-LAST_RACKS:]
    run = highest_run(line)[-MOST_OF_RUN:]
    numbers = {entry.number for entry in (*winning, *run)}
    return tuple(entry for entry in line if entry.number in numbers)


def deciding_strokes(log: Log) -> tuple[Logged, ...]:
    """The same of the line in play of a log."""
    return deciding_of(line_of(log))

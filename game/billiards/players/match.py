"""A combination match that plays itself: fifteen rounds, in each one ball goes down by way of another.

Fifteen numbered balls of different radius and mass, two cues that take turns. The last ball has no other to
be potted by and is potted directly. Each round is written down as a shot file, and what counts is that file
played again: so a reader of the record finds exactly what took place.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from game.billiards.game.arrangement import Arrangement, BallSet, Stroke, after_shot, racked
from game.billiards.game.games.combination import SHORTEST_CHAIN, CombinationMatch
from game.billiards.game.rules import CUE_BALL, Pocketing
from game.billiards.game.summary import summarize
from game.billiards.players.match_search import Option, is_clean, options_for
from game.billiards.search.breaking import apex_of
from game.billiards.search.finding import processors, thread_pool
from game.billiards.search.strokes import Board, Noise
from game.billiards.search.view import View
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import Shot
from game.billiards.shot.shot_file import parse_shot
from game.billiards.shot.shot_writing import shot_data
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import simulate
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import POCKET_NAMES, Table
from game.physics.kernels import elementary, linear

PLAYERS = ("Blue cue", "Red cue")
LARGEST_CHANGE = 0.06  # share by which a radius differs from the usual one at most
DENSITY_CHANGE = 0.12  # and a density
BREAKS = 512  # strokes tried at a time for the first round
MOST_BREAKS = 64  # times that many
KEPT = 8  # options of a round that are kept, to go back to
EYE = Noise(azimuth=math.radians(0.03))  # how finely geometry is judged, for a hand that does not shake


class MatchError(RuntimeError):
    """A match that came to no end: no stroke was found."""


class Round(NamedTuple):
    """One round: who plays, the stroke, what fell how, and the shot and its paths.

    number: from 1. player: 0 or 1. fallen: the ball, its pocket and its chain. shot: the state just after the
    cue has left the cue ball. seconds: what the search took.
    """

    number: int
    player: int
    stroke: Stroke
    fallen: Pocketing
    shot: Shot
    trajectory: Trajectory
    seconds: float


class Match(NamedTuple):
    """A whole match: its seed, its balls, all rounds."""

    seed: int
    balls: BallSet
    rounds: tuple[Round, ...]

    @property
    def playing_time(self) -> float:
        """Sum of all rounds' times, s."""
        return sum(one.trajectory.end_time for one in self.rounds)


def unlike_balls(seed: int) -> BallSet:
    """Balls of different radius and mass: up to 6 % and some 30 % from the usual; the cue ball is usual."""
    rng = np.random.default_rng([seed, 1])
    scale = linear.uniform(rng, 1.0 - LARGEST_CHANGE, 1.0 + LARGEST_CHANGE, 16)
    density = linear.uniform(rng, 1.0 - DENSITY_CHANGE, 1.0 + DENSITY_CHANGE, 16)
    scale[CUE_BALL] = density[CUE_BALL] = 1.0
    return BallSet(BALL_RADIUS * scale, BALL_MASS * density * (scale * scale * scale))


def play_match(
    seed: int,
    table: Table | None = None,
    physics: Physics = Physics(),  # noqa: B008  (immutable)
    balls: BallSet | None = None,
    threads: int | None = None,
    progress: Callable[[Round], None] | None = None,
) -> Match:
    """Play a match; equal seeds give equal matches. progress: hears of each round, which may be taken back.

    balls: left out, `unlike_balls`. MatchError if no stroke is found, even after going back.
    """
    table = Table.pool() if table is None else table
    balls = unlike_balls(seed) if balls is None else balls
    finder = _Finder(seed, table, physics, processors() if threads is None else threads)
    layout = racked(table, balls=balls, seed=seed)
    stack: list[tuple[Arrangement, Iterator[Option], float]] = [(layout, finder.options(layout, 1), 0.0)]
    rounds: list[Round] = []
    while stack:
        layout, options, spent = stack[-1]
        started = time.perf_counter()
        played = next(filter(None, (finder.play(layout, option, len(stack)) for option in options)), None)
        spent += time.perf_counter() - started
        if played is None:
            stack.pop()
            del rounds[max(len(stack) - 1, 0) :]
            continue
        stack[-1] = (layout, options, spent)
        rounds = [*rounds[: len(stack) - 1], played._replace(seconds=spent)]
        if progress is not None:
            progress(rounds[-1])
        layout = after_shot(layout, summarize(played.trajectory))
        if layout.numbers == (CUE_BALL,):
            return Match(seed, balls, tuple(rounds))
        stack.append((layout, finder.options(layout, len(stack) + 1), 0.0))
    raise MatchError(f"match {seed}: no stroke was found")


class _Finder:
    """Finds and plays the rounds of one match."""

    def __init__(self, seed: int, table: Table, physics: Physics, threads: int) -> None:
        self.seed = seed
        self.table = table
        self.physics = physics
        self.pool = thread_pool(threads)

    def options(self, layout: Arrangement, number: int) -> Iterator[Option]:
        """Strokes for a round, the best first; searched when the first is asked for."""
        if number == 1:
            yield from self._breaks(layout)
            return
        chain = SHORTEST_CHAIN if len(layout.numbers) > 2 else 0
        kinds = ("combination",) if chain else ("direct", "bank", "kick")
        view = View(Board(layout, self.table, self.physics), EYE)
        yield from options_for(view, chain, kinds, KEPT, self.pool)

    def _breaks(self, layout: Arrangement) -> Iterator[Option]:
        """Breaks that pot one ball."""
        rng = np.random.default_rng([self.seed, 2])
        x, y = apex_of(layout, self.table)
        cue_ball = layout.place_of(CUE_BALL)
        assert cue_ball is not None
        board = Board(layout, self.table, self.physics)
        azimuth = elementary.atan2(y - cue_ball[1], x - cue_ball[0])
        for _ in range(MOST_BREAKS):
            strokes = np.zeros((BREAKS, 5))
            strokes[:, 0] = linear.uniform(rng, 4.0, 6.0, BREAKS)
            strokes[:, 1] = azimuth + linear.uniform(rng, -0.03, 0.03, BREAKS)
            strokes[:, 4] = linear.uniform(rng, -0.1, 0.15, BREAKS)
            outcomes = board.play(strokes, self.pool)
            for row in np.flatnonzero(is_clean(outcomes, SHORTEST_CHAIN, once=False)).tolist():
                yield Option(Stroke(*strokes[row].tolist()), 1.0)

    def play(self, layout: Arrangement, option: Option, number: int) -> Round | None:
        """The round that an option makes, played from its shot file; None if it does not count there."""
        shot = parse_shot(shot_data(_named(layout.shot(self.table, self.physics, option.stroke))))
        trajectory = simulate(shot)
        fallen = what_counts(trajectory, len(layout.numbers) - 1)
        if fallen is None:
            return None
        return Round(number, (number - 1) % 2, option.stroke, fallen, shot, trajectory, 0.0)


def _named(shot: Shot) -> Shot:
    """The shot with its pockets named, if they are those of a pool table."""
    if len(shot.pocket_ids) != len(POCKET_NAMES):
        return shot
    return replace(shot, pocket_ids=tuple(name.replace(" ", "-") for name in POCKET_NAMES))


def what_counts(trajectory: Trajectory, numbered: int) -> Pocketing | None:
    """The one ball that went down as a round wants it; None if the round does not count.

    numbered: how many numbered balls lay on the table. Judged by the rules of the combination match.
    """
    summary = summarize(trajectory)
    on_table = tuple(sorted({n for n, _, _ in summary.rest if n != CUE_BALL} | set(summary.balls_down)))
    game = CombinationMatch(on_table=on_table, opening=False, in_hand="")
    verdict = game.judge(summary)
    if len(on_table) != numbered or len(summary.pocketed) != 1 or not verdict.legal or not verdict.scored:
        return None
    return summary.pocketed[0]


def match_data(match: Match, title: str = "") -> dict[str, Any]:
    """The match as plain values for JSON: each round with stroke, chain, ball, pocket and shot."""
    return {
        "format": "match",
        "version": 1,
        "title": title,
        "seed": match.seed,
        "players": list(PLAYERS),
        "rounds": [_round_data(one) for one in match.rounds],
    }


def _round_data(one: Round) -> dict[str, Any]:
    """One round. `chain`, `ball` and `pocket` are ids of the shot."""
    return {
        "round": one.number,
        "player": PLAYERS[one.player],
        "cue": one.player,
        "stroke": one.stroke._asdict(),
        "chain": [str(number) for number in one.fallen.chain],
        "ball": str(one.fallen.ball),
        "pocket": one.shot.pocket_ids[one.fallen.pocket],
        "duration": one.trajectory.end_time,
        "shot": shot_data(one.shot),
    }


def check_match_data(data: dict[str, Any]) -> None:
    """Play every round of a match again from its own data; ValueError names the first that does not hold."""
    rounds = data["rounds"]
    before: set[str] | None = None
    for k, one in enumerate(rounds):
        shot = parse_shot(one["shot"])
        numbered = {name for name in shot.ids if name != str(CUE_BALL)}
        if before is not None and numbered != before:
            raise ValueError(f"rounds[{k}].shot: has not the balls that the round before left")
        fallen = what_counts(simulate(shot), len(numbered))
        if fallen is None:
            raise ValueError(f"rounds[{k}].shot: no ball goes down as the round says")
        said = (one["ball"], one["pocket"], one["chain"])
        if said != (str(fallen.ball), shot.pocket_ids[fallen.pocket], [str(n) for n in fallen.chain]):
            raise ValueError(f"rounds[{k}]: ball, pocket and chain are not those of the shot")
        before = numbered - {str(fallen.ball)}
    if before:
        raise ValueError(f"rounds: {len(before)} balls are left on the table")

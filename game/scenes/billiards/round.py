"""A round of the billiard table as one immutable value, and what a stroke, a choice or a hand makes of it.

Nothing here knows a screen or the time. Going back is keeping the round before.
"""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import msgspec
import numpy as np

from game.billiards.game.arrangement import (
    Arrangement,
    BallSet,
    Stroke,
    after_shot,
    is_free,
    nearest_free,
)
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL, Call, Game, ShotSummary, Verdict
from game.billiards.game.summary import summarize
from game.billiards.shot.cue import strike as struck_ball
from game.billiards.shot.shot import Physics, Shot, ShotError
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import SimulationError, simulate
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table

LONGEST_S = 60.0  # s; without cloth a shot would never end
MOST_KEPT = 60  # rounds that can be gone back to

Places = tuple[tuple[int, float, float], ...]  # ball, x, y m; ascending


class Conditions(NamedTuple):
    """Under which a stroke is played: measures of balls, cloth and cushions, with pockets or without."""

    radii: tuple[float, ...]
    masses: tuple[float, ...]
    physics: Physics
    pockets: bool = True

    @property
    def balls(self) -> BallSet:
        """The set of balls."""
        return BallSet(np.array(self.radii), np.array(self.masses))

    @property
    def table(self) -> Table:
        """The pool table, or the same bed with unbroken rails."""
        return _tables()[0 if self.pockets else 1]


@lru_cache(maxsize=1)
def _tables() -> tuple[Table, Table]:
    pool = Table.pool()
    return pool, Table.bare(pool.width, pool.length, pool.cushion_height)


class Struck(msgspec.Struct, frozen=True):
    """A stroke, and all that it was played from."""

    game: Game
    places: Places
    conditions: Conditions
    stroke: Stroke
    call: Call = Call()


class Round(msgspec.Struct, frozen=True, kw_only=True):
    """Between two strokes, or in the midst of one.

    places: where the balls lie, or lay before the stroke that is being played. last: the stroke that is being
    played, or was last. words: what the last verdict said; foul: it had a foul. strokes: so many were played.
    earlier: the round before the last stroke.
    """

    game: Game
    places: Places
    conditions: Conditions
    last: Struck | None = None
    call: Call = Call()
    words: tuple[str, ...] = ()
    foul: bool = False
    strokes: int = 0
    earlier: Round | None = None

    @property
    def lie(self) -> Arrangement:
        """The balls as they lie."""
        return lie_from(self.places, self.conditions.balls)

    @property
    def frame(self) -> Frame:
        """Game, balls and table as the rules and the search know them."""
        return Frame(self.game, self.lie, self.conditions.table, self.conditions.physics)

    @property
    def white(self) -> tuple[float, float] | None:
        """Where the white ball lies, m."""
        return next(((x, y) for number, x, y in self.places if number == CUE_BALL), None)

    @property
    def playable(self) -> bool:
        """True if a stroke may be played now."""
        return not self.game.over and not self.game.options and self.white is not None


class Played(NamedTuple):
    """A stroke with its paths, its summary and its verdict; after: the round that follows."""

    trajectory: Trajectory
    summary: ShotSummary
    verdict: Verdict
    after: Round


def lie_from(places: Places, balls: BallSet) -> Arrangement:
    """An arrangement from places."""
    positions = np.array([(x, y) for _, x, y in places], dtype=np.float64).reshape(-1, 2)
    return Arrangement(tuple(number for number, _, _ in places), positions, balls)


def places_from(lie: Arrangement) -> Places:
    """Places from an arrangement."""
    return tuple(
        (number, float(x), float(y))
        for number, (x, y) in zip(lie.numbers, lie.positions.tolist(), strict=True)
    )


def begin(frame: Frame, conditions: Conditions) -> Round:
    """The first round; a white ball that is missing is put down where it may be."""
    start = Round(game=frame.game, places=places_from(frame.lie), conditions=conditions)
    return with_white(start)


def with_white(round_: Round) -> Round:
    """The same with the white ball put on the head spot or near it, if it is in hand and not on the table."""
    if round_.white is not None or not round_.game.in_hand:
        return round_
    table = round_.conditions.table
    lie = round_.lie
    x, y = nearest_free(
        lie, table, CUE_BALL, 0.5 * table.width, HEAD_SPOT * table.length, round_.game.in_hand
    )
    return msgspec.structs.replace(round_, places=places_from(lie.with_ball(CUE_BALL, (x, y))))


def white_moved(round_: Round, x: float, y: float) -> Round:
    """The white ball put at (x, y) m, or as near to it as it may lie. ValueError if it is not in hand."""
    hand = round_.game.in_hand
    if not hand:
        raise ValueError("white ball: it is not in hand")
    lie, table = round_.lie, round_.conditions.table
    if not is_free(lie, table, CUE_BALL, x, y, hand):
        x, y = nearest_free(lie, table, CUE_BALL, x, y, hand)
    return msgspec.structs.replace(round_, places=places_from(lie.with_ball(CUE_BALL, (x, y))))


def strike(round_: Round, stroke: Stroke, call: Call) -> Round:
    """The round in the midst of a stroke. ValueError if none may be played."""
    round_.game.check_playable()
    if round_.white is None:
        raise ValueError("white ball: it must be put down first")
    struck = Struck(round_.game, round_.places, round_.conditions, stroke, call)
    return msgspec.structs.replace(
        round_, last=struck, strokes=round_.strokes + 1, earlier=shortened(round_), words=(), foul=False
    )


def shortened(round_: Round, most: int = MOST_KEPT) -> Round:
    """The round with at most so many before it."""
    chain: list[Round] = []
    at: Round | None = round_
    while at is not None and len(chain) < most + 1:
        chain.append(at)
        at = at.earlier
    if at is None:
        return round_
    kept: Round | None = None
    for link in reversed(chain[:most]):
        kept = msgspec.structs.replace(link, earlier=kept)
    assert kept is not None
    return kept


@lru_cache(maxsize=4)
def resting_shot(places: Places, conditions: Conditions) -> Shot:
    """The balls at rest, checked and ready for many strokes. ShotError if they overlap."""
    return lie_from(places, conditions.balls).shot(conditions.table, conditions.physics)


def trajectory_of(struck: Struck) -> Trajectory:
    """The paths of a stroke. ValueError if it cannot be played."""
    try:
        shot = resting_shot(struck.places, struck.conditions)
        conditions = struck.conditions
        made = struck_ball(
            *struck.stroke,
            ball_mass=conditions.masses[CUE_BALL], ball_radius=conditions.radii[CUE_BALL],
        )  # fmt: skip
        row = [number for number, _, _ in struck.places].index(CUE_BALL)
        return simulate(shot.struck(row, made.velocity, made.spin), until=LONGEST_S)
    except (ShotError, SimulationError) as error:
        raise ValueError(f"stroke: {error}") from None


def play(round_: Round) -> Played:
    """What comes of the stroke that a round is in the midst of."""
    struck = round_.last
    assert struck is not None
    trajectory = trajectory_of(struck)
    summary = summarize(trajectory)
    verdict = struck.game.judge(summary, struck.call)
    frame = Frame(
        struck.game, lie_from(struck.places, struck.conditions.balls), struck.conditions.table,
        struck.conditions.physics,
    )  # fmt: skip
    following = frame.follow(verdict, after_shot(frame.lie, summary))
    after = msgspec.structs.replace(
        round_,
        game=following.game,
        places=places_from(following.lie),
        call=Call(),
        words=tuple(verdict.words),
        foul=bool(verdict.fouls),
    )
    return Played(trajectory, summary, verdict, with_white(after))


def choose(round_: Round, name: str, seed: int) -> Round:
    """The round after the player at turn has chosen an option; ValueError if there is no such option.

    seed: of a new rack, if that was chosen.
    """
    verdict = round_.game.choose(name)
    frame = round_.frame.follow(verdict, round_.lie, seed)
    after = msgspec.structs.replace(
        round_, game=frame.game, places=places_from(frame.lie), words=tuple(verdict.words), foul=False
    )
    return with_white(after)


def next_rack(round_: Round, seed: int) -> Round:
    """The next rack of the same players. ValueError if the table has none."""
    verdict = round_.game.next_rack()
    frame = round_.frame.follow(verdict, round_.lie, seed)
    after = msgspec.structs.replace(
        round_, game=frame.game, places=places_from(frame.lie), words=tuple(verdict.words), foul=False,
        last=None, earlier=None, call=Call(),
    )  # fmt: skip
    return with_white(after)

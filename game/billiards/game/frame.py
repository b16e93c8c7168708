"""A frame: game, table and balls together, what was played last, and what a stroke or a choice makes of them.

All values are immutable: undo keeps the frame before, and plays on from it. Nothing here knows a screen or
the time.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import msgspec

from game.billiards.game.arrangement import (
    Arrangement,
    BallSet,
    Stroke,
    after_shot,
    arrange,
    is_free,
    nearest_free,
    racked,
    spotted,
)
from game.billiards.game.rules import CUE_BALL, Call, Game, Hand, ShotSummary, Verdict
from game.billiards.game.summary import summarize
from game.billiards.game.tally import Tally, merit
from game.billiards.shot.cue import strike as struck_ball
from game.billiards.shot.physics import Physics, ShotError
from game.billiards.shot.shot import Shot
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import SimulationError, simulate
from game.billiards.table.rack import HEAD_SPOT
from game.billiards.table.table import Table

LONGEST_S = 60.0  # s; without cloth a shot would never end
MOST_KEPT = 60  # frames that can be gone back to


class Conditions(NamedTuple):
    """Under which a stroke is played, as plain values: balls, cloth, cushions; with pockets or without.

    pockets: of another cut than usual, the first jaw, x, y and radius m.
    """

    radii: tuple[float, ...]
    masses: tuple[float, ...]
    physics: Physics
    pockets: bool | tuple[float, ...]


class Frame(msgspec.Struct, frozen=True, eq=False):
    """A game between two strokes, or in the midst of one.

    game: the rules' state. layout: where the balls lie, or lay before the stroke that is being played.
    last: the stroke that is being played, or was last. words: what the last verdict said; foul: it had a
    foul. strokes: so many were played. earlier: the frame to go back to. tallies: what is counted of each
    player in the match, rack_tallies: in this rack; best: the best stroke of this rack, None if none has
    scored yet.
    """

    game: Game
    layout: Arrangement
    table: Table
    physics: Physics = Physics()
    last: Struck | None = None
    words: tuple[str, ...] = ()
    foul: bool = False
    strokes: int = 0
    earlier: Frame | None = None
    tallies: tuple[Tally, Tally] = (Tally(), Tally())
    rack_tallies: tuple[Tally, Tally] = (Tally(), Tally())
    best: BestStroke | None = None

    def replace(self, **changes: Any) -> Frame:
        """The same with some fields changed."""
        return msgspec.structs.replace(self, **changes)

    @property
    def cue_ball(self) -> tuple[float, float] | None:
        """Where the cue ball lies, m; None if it is not on the table."""
        return self.layout.place_of(CUE_BALL)

    @property
    def playable(self) -> bool:
        """True if a stroke may be played now."""
        return not self.game.over and not self.game.options and self.cue_ball is not None

    @property
    def conditions(self) -> Conditions:
        """What strokes are played under; equal for frames on which equal strokes do the same."""
        balls = self.layout.balls
        return Conditions(
            tuple(balls.radii.tolist()), tuple(balls.masses.tolist()), self.physics,
            _pockets_of(self.table),
        )  # fmt: skip

    # -- the cue ball in hand -----------------------------------------------------------------------

    def place_cue_ball(self, x: float, y: float) -> Frame:
        """The cue ball put down at (x, y) m. ValueError if it is not in hand, or not allowed there."""
        hand = self._hand()
        if not is_free(self.layout, self.table, CUE_BALL, x, y, hand):
            raise ValueError(f"cue ball: ({x:.3f}, {y:.3f}) m is not free, or not {hand}")
        return self.replace(layout=self.layout.with_ball(CUE_BALL, (x, y)))

    def move_cue_ball(self, x: float, y: float) -> Frame:
        """The cue ball put at (x, y) m, or as near to it as it may lie. ValueError if it is not in hand."""
        hand = self._hand()
        if not is_free(self.layout, self.table, CUE_BALL, x, y, hand):
            x, y = nearest_free(self.layout, self.table, CUE_BALL, x, y, hand)
        return self.replace(layout=self.layout.with_ball(CUE_BALL, (x, y)))

    def with_cue_ball(self) -> Frame:
        """The same with the cue ball on the head spot or near it, if it is in hand and not on the table."""
        if self.cue_ball is not None or not self.game.in_hand:
            return self
        return self.move_cue_ball(0.5 * self.table.width, HEAD_SPOT * self.table.length)

    def _hand(self) -> Hand:
        """Where the cue ball may be put; ValueError if it stays."""
        if not self.game.in_hand:
            raise ValueError("cue ball: it is not in hand")
        return self.game.in_hand

    # -- strokes and choices ------------------------------------------------------------------------

    def play(self, stroke: Stroke, call: Call = Call()) -> Played:  # noqa: B008  (immutable)
        """Play a stroke and judge it. ValueError if it may not be played, or the cue ball is not down."""
        return self.strike(stroke, call).outcome()

    def strike(self, stroke: Stroke, call: Call = Call()) -> Frame:  # noqa: B008  (immutable)
        """The frame in the midst of a stroke. ValueError if none may be played."""
        self.game.check_playable()
        if self.cue_ball is None:
            raise ValueError("cue ball: it must be put down first")
        alone = self.replace(
            last=None, earlier=None, best=None
        )  # else each stroke would hold all those before it
        return self.replace(
            last=Struck(alone, stroke, call), strokes=self.strokes + 1, earlier=self.shortened(), words=(),
            foul=False,
        )  # fmt: skip

    def outcome(self) -> Played:
        """What comes of the stroke that this frame is in the midst of. ValueError if it cannot be played."""
        if self.last is None:
            raise ValueError("frame: no stroke has been played")
        before, _, call = self.last
        trajectory = trajectory_of(self.last)
        summary = summarize(trajectory)
        verdict = before.judged(trajectory, summary, call)
        layout = before._layout_after(verdict, after_shot(before.layout, summary), None)
        following = self._following(verdict, layout)
        tallies, in_rack = (
            _counted(counts, before.game, call, verdict) for counts in (self.tallies, self.rack_tallies)
        )
        worth = merit(summary, verdict)
        if worth > 0.0 and (self.best is None or worth >= self.best.merit):
            following = following.replace(best=BestStroke(self.last, summary, worth))
        return Played(trajectory, summary, verdict, following.replace(tallies=tallies, rack_tallies=in_rack))

    def judged(self, trajectory: Trajectory, summary: ShotSummary, call: Call) -> Verdict:
        """What the game says of a stroke that was played from this frame."""
        return self.game.judge(summary, call)

    def choose(self, name: str, seed: int | None = None) -> Frame:
        """The frame after the player at turn has chosen an option; ValueError if there is no such option.

        seed: of a new rack, if that was chosen.
        """
        verdict = self.game.choose(name)
        return self._following(verdict, self._layout_after(verdict, self.layout, seed))

    def next_rack(self, seed: int | None = None) -> Frame:
        """The next rack of the same players. ValueError if the game has none."""
        verdict = self.game.next_rack()
        following = self._following(verdict, self._layout_after(verdict, self.layout, seed))
        return following.replace(last=None, earlier=None, best=None, rack_tallies=(Tally(), Tally()))

    def _layout_after(self, verdict: Verdict, layout: Arrangement, seed: int | None) -> Arrangement:
        """What a verdict makes of the balls as they came to rest; this frame is the one before the stroke."""
        if verdict.reset:
            return self.layout
        if verdict.places:
            return arrange({ball: (x, y) for ball, x, y in verdict.places}, self.layout.balls)
        if verdict.rack:
            return rack_for(verdict.game, self.table, self.layout.balls, seed)
        return spotted(layout, self.table, verdict.spot)

    def _following(self, verdict: Verdict, layout: Arrangement) -> Frame:
        return self.replace(
            game=verdict.game, layout=layout, words=tuple(verdict.words), foul=bool(verdict.fouls)
        )

    def shortened(self, most: int = MOST_KEPT) -> Frame:
        """The frame with at most so many before it."""
        chain: list[Frame] = []
        at: Frame | None = self
        while at is not None and len(chain) < most + 1:
            chain.append(at)
            at = at.earlier
        if at is None:
            return self
        kept: Frame | None = None
        for link in reversed(chain[:most]):
            kept = link.replace(earlier=kept)
        assert kept is not None
        return kept


def _counted(counts: tuple[Tally, Tally], game: Game, call: Call, verdict: Verdict) -> tuple[Tally, Tally]:
    """The tallies of both players with one more stroke of the one at turn in a game."""
    first, second = (
        one.after(game, call, verdict) if player == game.turn else one for player, one in enumerate(counts)
    )
    return first, second


class Struck(NamedTuple):
    """A stroke, what was called for it, and the frame from which it was played."""

    frame: Frame
    stroke: Stroke
    call: Call = Call()


class BestStroke(NamedTuple):
    """The best stroke of a rack so far: what was played, what it did, how much it is worth."""

    struck: Struck
    summary: ShotSummary
    merit: float


class Played(NamedTuple):
    """A stroke that has been played: its paths, its summary, the verdict, and the frame to go on with."""

    trajectory: Trajectory
    summary: ShotSummary
    verdict: Verdict
    frame: Frame


@lru_cache(maxsize=4)
def _resting_shot(frame: Frame) -> Shot:
    """The balls at rest, checked and ready for many strokes. ShotError if they overlap."""
    return frame.layout.shot(frame.table, frame.physics)


def trajectory_of(struck: Struck) -> Trajectory:
    """The paths of a stroke, for at most LONGEST_S. ValueError if it cannot be played."""
    frame, balls = struck.frame, struck.frame.layout.balls
    try:
        shot = _resting_shot(frame)
        made = struck_ball(
            *struck.stroke,
            ball_mass=float(balls.masses[CUE_BALL]), ball_radius=float(balls.radii[CUE_BALL]),
        )  # fmt: skip
        row = frame.layout.numbers.index(CUE_BALL)
        return simulate(shot.struck(row, made.pressed(struck.stroke.elevation), made.spin), until=LONGEST_S)
    except (ShotError, SimulationError) as error:
        raise ValueError(f"stroke: {error}") from None


def _pockets_of(table: Table) -> bool | tuple[float, ...]:
    """What conditions say of a table's pockets."""
    usual = not len(table.pockets) or table.jaws.tobytes() in _usual_jaws()
    return bool(len(table.pockets)) if usual else tuple(table.jaws[0].tolist())


@lru_cache(maxsize=1)
def _usual_jaws() -> tuple[bytes, ...]:
    """The jaws of the tables that are played on unless something else is said."""
    return Table.pool().jaws.tobytes(), Table.snooker().jaws.tobytes()


def rack_for(game: Game, table: Table, balls: BallSet | None = None, seed: int | None = None) -> Arrangement:
    """The balls racked for a game, those that it is played with."""
    kind = {10: "ten-ball"}.get(highest := max(game.on_table, default=0), "eight-ball")
    full = racked(table, "nine-ball" if highest <= 9 else kind, balls, seed)
    return full.without(*(n for n in full.numbers if n != CUE_BALL and n not in game.on_table))


def new_frame(game: Game, table: Table | None = None, balls: BallSet | None = None,
              seed: int | None = None) -> Frame:  # fmt: skip
    """A game with its balls racked on a pool table. seed: see `arrangement.racked`."""
    table = Table.pool() if table is None else table
    return Frame(game, rack_for(game, table, balls, seed), table)

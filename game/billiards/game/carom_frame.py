"""A frame of carom: game, balls and cloth together, and what strokes and choices make of them."""

from __future__ import annotations

from typing import Any, NamedTuple

import msgspec
import numpy as np

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_summary import CaromSummary, summarize_carom
from game.billiards.game.games.carom import Carom, CaromVerdict
from game.billiards.shot.cloths import CLOTHS, HEATED
from game.billiards.shot.cue import strike
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import SimulationError, simulate
from game.billiards.table.carom import BALL_MASS, BALL_NAMES, BALL_RADIUS, RED
from game.billiards.table.table import Table

Points = tuple[tuple[float, float], tuple[float, float], tuple[float, float]]

LONGEST_S = 60.0  # s; without cloth a shot would never end
MOST_KEPT = 60  # frames that can be gone back to


def carom_shot(
    table: Table, physics: Physics, places: Floats, cue: int, stroke: Stroke | None = None
) -> Shot:
    """The shot of a stroke with ball `cue`, which is its first row, then the other cue ball, then the red
    one.

    places (3, 2) m of white, yellow, red. Without a stroke all lie at rest. ShotError if balls overlap.
    """
    rows = rows_of(cue)
    shot = make_shot(
        table, places[rows], radii=BALL_RADIUS, masses=BALL_MASS, physics=physics,
        ids=tuple(BALL_NAMES[ball] for ball in rows),
    )  # fmt: skip
    if stroke is None:
        return shot
    made = strike(*stroke, ball_mass=BALL_MASS, ball_radius=BALL_RADIUS)
    return shot.struck(0, made.pressed(stroke.elevation), made.spin)


def rows_of(cue: int) -> list[int]:
    """Balls in the order of the rows of a shot with ball `cue`."""
    return [cue, 1 - cue, RED]


class CaromFrame(msgspec.Struct, frozen=True, eq=False):
    """A game between two strokes, or in the midst of one.

    game: the rules' state. places: where white, yellow and red lie, m, or lay before the stroke that is being
    played. last: the stroke that is being played, or was last. words: what the last verdict said. strokes: so
    many were played. earlier: the frame to go back to.
    """

    game: Carom
    places: Points
    table: Table
    physics: Physics = CLOTHS[HEATED]
    last: CaromStruck | None = None
    words: tuple[str, ...] = ()
    foul: bool = False
    strokes: int = 0
    earlier: CaromFrame | None = None

    def replace(self, **changes: Any) -> CaromFrame:
        """The same with some fields changed."""
        return msgspec.structs.replace(self, **changes)

    @property
    def positions(self) -> Floats:
        """Places (3, 2) m of white, yellow, red."""
        return np.array(self.places)

    @property
    def playable(self) -> bool:
        """True if a stroke may be played now."""
        return not self.game.ended and not self.game.options

    def strike(self, stroke: Stroke, safety: bool = False) -> CaromFrame:
        """The frame while a stroke is being played. ValueError if none may be, or it cannot be struck."""
        self.game.check_playable()
        struck = CaromStruck(self.replace(earlier=None, last=None), stroke, safety)
        carom_shot(self.table, self.physics, self.positions, self.game.cue, stroke)
        return self.replace(last=struck, words=(), foul=False, earlier=self.shortened())

    def outcome(self) -> CaromPlayed:
        """What comes of the last stroke. ValueError if there was none, or it cannot be played."""
        if self.last is None:
            raise ValueError("frame: no stroke has been played")
        before = self.last.frame
        trajectory = carom_trajectory(before, self.last.stroke)
        summary = summarize_carom(trajectory, before.game.cue, before.game.rule.barred)
        verdict = before.game.judge(summary, self.last.safety)
        after = self.replace(
            game=verdict.game, places=points_of(verdict.places), words=verdict.words,
            foul=bool(verdict.fouls), strokes=self.strokes + 1,
        )  # fmt: skip
        return CaromPlayed(trajectory, summary, verdict, after)

    def play(self, stroke: Stroke, safety: bool = False) -> CaromPlayed:
        """Play a stroke and judge it. ValueError as `strike` and `outcome`."""
        return self.strike(stroke, safety).outcome()

    def choose(self, name: str) -> CaromFrame:
        """What follows from the player at turn choosing an option. ValueError if there is no such."""
        return self._followed(self.game.choose(name, self.positions))

    def next_game(self) -> CaromFrame:
        """The next game of the same players."""
        return self._followed(self.game.next_game())

    def _followed(self, verdict: CaromVerdict) -> CaromFrame:
        return self.replace(
            game=verdict.game, places=points_of(verdict.places), words=verdict.words, last=None, foul=False,
            earlier=self.shortened(),
        )  # fmt: skip

    def shortened(self) -> CaromFrame:
        """The same without the frames that lie too far back."""
        chain = [self]
        while chain[-1].earlier is not None and len(chain) < MOST_KEPT:
            chain.append(chain[-1].earlier)
        if chain[-1].earlier is None:
            return self
        kept = chain[-1].replace(earlier=None)
        for frame in reversed(chain[:-1]):
            kept = frame.replace(earlier=kept)
        return kept


class CaromStruck(NamedTuple):
    """A stroke, and the frame it was played from."""

    frame: CaromFrame
    stroke: Stroke
    safety: bool = False


class CaromPlayed(NamedTuple):
    """What came of a stroke: how the balls rolled, what the referee saw and said, the frame to go on with."""

    trajectory: Trajectory
    summary: CaromSummary
    verdict: CaromVerdict
    frame: CaromFrame


def carom_trajectory(frame: CaromFrame, stroke: Stroke) -> Trajectory:
    """The balls' paths after a stroke. ValueError if it cannot be played to its end."""
    shot = carom_shot(frame.table, frame.physics, frame.positions, frame.game.cue, stroke)
    try:
        return simulate(shot, until=LONGEST_S)
    except SimulationError as error:
        raise ValueError(f"stroke: {error}") from None


def points_of(places: Floats) -> Points:
    """Places (3, 2) m as plain values."""
    white, yellow, red = ((float(x), float(y)) for x, y in places.tolist())
    return white, yellow, red


def new_carom(game: Carom, physics: Physics = CLOTHS[HEATED]) -> CaromFrame:
    """A game at its beginning, on a match table."""
    return CaromFrame(game, points_of(game.start()), Table.carom(), physics)

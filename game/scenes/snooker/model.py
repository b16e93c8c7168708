"""What lies on the snooker table: the frame that is played, where the balls are, how they are turned."""

from __future__ import annotations

import msgspec
import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame, Played
from game.billiards.game.rules import CUE_BALL, Call, ShotSummary, Verdict
from game.billiards.game.snooker.frame import SnookerFrame, new_snooker_frame, snooker_layout
from game.billiards.game.snooker.rules import Snooker
from game.billiards.shot.cloths import SNOOKER_CLOTH, faster
from game.billiards.shot.physics import Physics
from game.billiards.shot.trajectory import rotation_matrices
from game.billiards.shot_effects import physics_of, table_of
from game.billiards.table.snooker import BALLS, name_of
from game.billiards.table.table import Table
from game.physics.effects import EffectSet
from game.scenes.shared.tables.choices import ahead
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.scenes.shared.tables.furnishing.choices import FAST, TIGHT
from game.scenes.shared.tables.moments import Moments
from game.scenes.shared.tables.outcome import Outcome
from game.scenes.snooker.level import SnookerContent, begun
from game.scenes.snooker.parameters import SnookerParameters
from game.stage import Part


class SnookerModel(Part):
    """The frame, and the balls as they move.

    places (22, 2) m by number; turns, turns_before (22, 3, 3): how the balls are turned, and were before the
    last stroke. These arrays belong to the state; frames are immutable.
    """

    def __init__(
        self, content: SnookerContent, parameters: SnookerParameters, active: EffectSet, seed: int
    ) -> None:
        self.content = content
        self.parameters = parameters
        self.seed_of_lots = seed
        self.frame = self._begin(*self._table_and_physics(active))
        self.places = np.zeros((BALLS, 2))
        self.turns = rotation_matrices(scattered_orientations(BALLS, seed))
        self.turns_before = self.turns.copy()
        self._outcome = Outcome[SnookerFrame, Played](_said)
        self._lay_out()

    def _begin(self, table: Table, physics: Physics) -> SnookerFrame:
        game, places = begun(self.content, self.seed_of_lots)
        frame = new_snooker_frame(self._opened(game), places, table, physics)
        before = {ball.number: ball.position for ball in self.content.put_back}
        return self._as_snooker(frame.replace(put_back=snooker_layout(before) if before else None))

    def _opened(self, game: Snooker) -> Snooker:
        """A match at its beginning, with the head start of one of two players."""
        if len(game.players) != 2 or self.content.saved:
            return self._set(game)
        return msgspec.structs.replace(self._set(game), won=ahead(self.parameters.head_start))

    def _set(self, game: Snooker) -> Snooker:
        """The game with what the parameters say of it."""
        best_of = 0 if self.parameters.best_of == "open" else int(str(self.parameters.best_of))
        return msgspec.structs.replace(game, best_of=best_of, miss_rule=str(self.parameters.miss))

    def configure(self, active: EffectSet) -> None:
        """Let parameters and effects act from the next stroke on."""
        table, physics = self._table_and_physics(active)
        self.frame = self._as_snooker(
            self.frame.replace(table=table, physics=physics, game=self._set(self.game))
        )

    def _table_and_physics(self, active: EffectSet) -> tuple[Table, Physics]:
        chosen = self.parameters
        physics = SNOOKER_CLOTH._replace(
            sliding=chosen.sliding, rolling=chosen.rolling,
            ball_restitution=chosen.ball_restitution, cushion_restitution=chosen.cushion_restitution,
        )  # fmt: skip
        if chosen.table == FAST:
            physics = faster(physics)
        return table_of(active, Table.snooker(chosen.table == TIGHT)), physics_of(active, physics)

    @staticmethod
    def _as_snooker(frame: Frame) -> SnookerFrame:
        assert isinstance(frame, SnookerFrame)
        return frame

    @property
    def game(self) -> Snooker:
        """The rules' state."""
        return self.frame.snooker

    @property
    def played(self) -> Played | None:
        """What comes, or came, of the last stroke; None before the first."""
        return self._outcome.played(self.frame)

    @property
    def moments(self) -> Moments | None:
        """What of the last stroke is worth a second look; None before the first."""
        return self._outcome.moments(self.frame, self.numbers.index(CUE_BALL) if self.numbers else 0)

    @property
    def word(self) -> str:
        """A word that stands for the frame, for the digest: equal frames, equal words."""
        return self._outcome.word(self.frame)

    def word_of(self, frame: SnookerFrame) -> str:
        """The same of any frame."""
        return self._outcome.word_of(frame)

    def _lay_out(self) -> None:
        self.places[list(self.frame.layout.numbers)] = self.frame.layout.positions

    # -- strokes ------------------------------------------------------------------------------------

    def strike(self, stroke: Stroke, call: Call) -> None:
        """Play a stroke. ValueError if it cannot be played; then the frame is what it was."""
        struck = self._as_snooker(self.frame.strike(stroke, call))
        self._outcome.played(struck)
        self.frame = struck
        self.turns_before[:] = self.turns

    @property
    def numbers(self) -> list[int]:
        """Numbers of the balls of the last stroke, in its trajectory's order."""
        return list(self.frame.last.frame.layout.numbers) if self.frame.last is not None else []

    def roll(self, time: float) -> None:
        """The balls where they are at a time of the shot, s."""
        played = self.played
        if played is not None:
            self.places[self.numbers] = played.trajectory.state_at(time).positions

    def settle(self) -> None:
        """The shot is over: its verdict holds."""
        played = self.played
        assert played is not None
        numbers, now = self.numbers, self.frame
        end = played.trajectory.orientations_at(played.trajectory.end_time, self.turns_before[numbers])
        self.turns[numbers] = end
        following = played.frame.with_cue_ball().replace(table=now.table, physics=now.physics)
        self.frame = self._as_snooker(following)
        self._lay_out()

    # -- choices, and what no stroke brings about ---------------------------------------------------

    def go_back_to(self, frame: Frame) -> None:
        """A frame before the last stroke, the balls turned as they were."""
        self.frame = self._as_snooker(frame)
        self.turns[:] = self.turns_before
        self._lay_out()

    def move_cue_ball(self, x: float, y: float) -> None:
        """The cue ball in hand put at (x, y) m, or near it. ValueError if it is not in hand."""
        self.frame = self._as_snooker(self.frame.move_cue_ball(x, y))
        self._lay_out()

    def choose(self, row: int) -> None:
        """The player at turn chooses one of the options, counted from 0."""
        before = self.frame
        following = before.choose(self.game.options[row].name).with_cue_ball()
        words = (*following.words, *before.words[:-1])  # what was said of the stroke stays in sight
        self.frame = self._as_snooker(following.replace(words=words, foul=before.foul))
        self._lay_out()

    def rule(self, verdict: Verdict) -> None:
        """A concession, a claim, or a restart."""
        self.frame = self._as_snooker(self.frame.ruled(verdict).with_cue_ball())
        self._lay_out()

    def next_frame(self) -> None:
        """The next frame if this one is over; a drill, or a frame that is not, from its beginning."""
        game = self.game
        if game.over and not game.drill and len(game.players) == 2:
            following = self._as_snooker(self.frame.next_rack().with_cue_ball())
            won = ahead(self.parameters.head_start) if game.match_over else following.game.won
            self.frame = self._as_snooker(
                following.replace(game=msgspec.structs.replace(following.game, won=won))
            )
        else:
            content = self.content
            if not game.drill:
                content = msgspec.structs.replace(content, saved={})
            self.frame = self._again(content)
        self._lay_out()

    def _again(self, content: SnookerContent) -> SnookerFrame:
        """A level at its beginning, with what was counted of a drill."""
        game = self.game
        fresh, places = begun(content, self.seed_of_lots)
        fresh = msgspec.structs.replace(
            self._set(fresh), attempts=game.attempts, made=game.made, high=game.high, winner=None,
        )  # fmt: skip
        return new_snooker_frame(fresh, places, self.frame.table, self.frame.physics)

    # -- lessons ------------------------------------------------------------------------------------

    def put_back(self, words: tuple[str, ...]) -> None:
        """The balls as a lesson begins, after a stroke of which this is said; it can be seen again."""
        again = self._again(self.content)
        following = self.frame.replace(game=again.game, layout=again.layout, words=words, foul=False)
        self.frame = self._as_snooker(following)
        self._lay_out()

    def seen(self) -> ShotSummary | None:
        """What the referee saw of the last stroke; None before the first."""
        return self.played.summary if self.played is not None else None

    @staticmethod
    def name_of(ball: int) -> str:
        """A ball in words."""
        return name_of(ball)


def _said(frame: SnookerFrame) -> object:
    """What a frame says, but for the frames before it."""
    last = frame.last
    return (
        msgspec.to_builtins(frame.game), frame.layout.places, frame.conditions, frame.strokes,
        None if last is None
        else (last.frame.layout.places, last.stroke, last.call, last.frame.conditions),
    )  # fmt: skip

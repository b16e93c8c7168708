"""What lies on the billiard table: the frame that is played, where the balls are, how they are turned."""

from __future__ import annotations

from functools import lru_cache

import msgspec
import numpy as np

from game.billiards.game.arrangement import Arrangement, Stroke
from game.billiards.game.frame import Frame, Played
from game.billiards.game.games import AnyGame, Drill, Ghost, Practice
from game.billiards.game.rules import CUE_BALL, Call, Game, Hand
from game.billiards.game.tally import Tally
from game.billiards.shot.cloths import faster
from game.billiards.shot.physics import Physics
from game.billiards.shot.trajectory import rotation_matrices
from game.billiards.shot_effects import physics_of, table_of
from game.billiards.table.table import Table
from game.physics.effects import EffectSet
from game.scenes.billiards.level import BilliardsContent, ball_set, best_of, game_of, layout_for
from game.scenes.billiards.outcome import Decided, PoolOutcome
from game.scenes.billiards.parameters import BilliardsParameters
from game.scenes.shared.tables.choices import ahead
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.scenes.shared.tables.furnishing.choices import FAST, TIGHT
from game.scenes.shared.tables.moments import Moments
from game.stage import Part

NO_TALLIES = (Tally(), Tally())
LEFT_MATCH = ("What you set up is practice: nothing is forbidden.", "U, or To match, goes back to the match.")


class BilliardsModel(Part):
    """The frame, and the balls as they move.

    places (16, 2) m by number. turns, turns_before (16, 3, 3): how the balls are turned, and were before the
    last stroke. These arrays belong to the state; frames are immutable and are remembered as they are.
    """

    def __init__(
        self, content: BilliardsContent, parameters: BilliardsParameters, active: EffectSet, seed: int
    ) -> None:
        self.content = content
        self.parameters = parameters
        self.racks = 0
        self._rack_seed = seed * 1000
        balls = ball_set(parameters.radius_spread, parameters.mass_spread, seed)
        table, physics = self._table_and_physics(active)
        game = self._begun(content)
        self.frame = Frame(
            game,
            layout_for(content, game, table, balls, seed),
            table,
            physics,
            tallies=content.tallies,
            rack_tallies=content.rack_tallies,
        ).with_cue_ball()
        self.frame = self.frame.replace(best=best_of(content, self.frame, seed))
        self.places = np.zeros((16, 2))
        self.turns = rotation_matrices(scattered_orientations(16, seed))
        self.turns_before = self.turns.copy()
        self._outcome = PoolOutcome()
        self._lay_out()

    def _begun(self, content: BilliardsContent) -> AnyGame:
        """The game that a content begins, with the head start of one of two players."""
        game = game_of(content)
        if content.saved:
            return game
        return msgspec.structs.replace(game, won=self._head_start(game))

    def _head_start(self, game: Game) -> tuple[int, ...]:
        """Racks that the players of a match begin with."""
        if len(game.players) != 2 or isinstance(game, Ghost):
            return (0,) * len(game.won)
        return ahead(self.parameters.head_start)

    def configure(self, active: EffectSet) -> None:
        """Let parameters and effects act from the next stroke on."""
        table, physics = self._table_and_physics(active)
        self.frame = self.frame.replace(table=table, physics=physics)

    def _table_and_physics(self, active: EffectSet) -> tuple[Table, Physics]:
        chosen = self.parameters
        physics = Physics(
            sliding=chosen.sliding, rolling=chosen.rolling,
            ball_restitution=chosen.ball_restitution, cushion_restitution=chosen.cushion_restitution,
            slate_restitution=chosen.slate_restitution, cushion_hop=chosen.cushion_hop,
        )  # fmt: skip
        if chosen.table == FAST:
            physics = faster(physics)
        tight = chosen.table == TIGHT
        return table_of(active, _table(tight)), physics_of(active, physics)

    @property
    def played(self) -> Played | None:
        """What comes, or came, of the last stroke; None before the first. ValueError if it cannot be."""
        return self._outcome.played(self.frame)

    @property
    def decided(self) -> Decided | None:
        """The pot that decided the rack, if the last stroke did."""
        return self._outcome.decided(self.frame)

    @property
    def moments(self) -> Moments | None:
        """What of the last stroke is worth a second look; None before the first."""
        last = self.frame.last
        cue = last.frame.layout.numbers.index(CUE_BALL) if last is not None else 0
        return self._outcome.moments(self.frame, cue)

    @property
    def word(self) -> str:
        """A word that stands for the frame, for the digest: equal frames, equal words."""
        return self._outcome.word(self.frame)

    def word_of(self, frame: Frame) -> str:
        """The same of any frame."""
        return self._outcome.word_of(frame)

    def _lay_out(self) -> None:
        """The places follow the frame."""
        self.places[list(self.frame.layout.numbers)] = self.frame.layout.positions

    # -- strokes ------------------------------------------------------------------------------------

    def strike(self, stroke: Stroke, call: Call) -> None:
        """Play a stroke. ValueError if it cannot be played; then the frame is what it was."""
        struck = self.frame.strike(stroke, call)
        self._outcome.played(struck)
        self.frame = struck
        self.turns_before[:] = self.turns

    def roll(self, time: float) -> None:
        """The balls where they are at a time of the shot, s."""
        played = self.played
        if played is not None:
            self.places[self._struck_numbers()] = played.trajectory.state_at(time).positions

    def settle(self) -> None:
        """The shot is over: its verdict holds."""
        played = self.played
        assert played is not None
        numbers = self._struck_numbers()
        end = played.trajectory.orientations_at(played.trajectory.end_time, self.turns_before[numbers])
        self.turns[numbers] = end
        now = self.frame  # table and physics may have been changed while the balls rolled
        self.frame = played.frame.with_cue_ball().replace(table=now.table, physics=now.physics)
        self._lay_out()

    def _struck_numbers(self) -> list[int]:
        """Numbers of the balls of the last stroke, in its trajectory's order."""
        return list(self.frame.last.frame.layout.numbers) if self.frame.last is not None else []

    def go_back_to(self, frame: Frame) -> None:
        """A frame before the last stroke, the balls turned as they were."""
        self.frame = frame
        self.turns[:] = self.turns_before
        self._lay_out()

    # -- choices ------------------------------------------------------------------------------------

    def move_cue_ball(self, x: float, y: float) -> None:
        """The cue ball in hand put at (x, y) m, or near it. ValueError if it is not in hand."""
        self.frame = self.frame.move_cue_ball(x, y)
        self._lay_out()

    def choose(self, row: int) -> None:
        """The player at turn chooses one of the options, counted from 0."""
        name = self.frame.game.options[row].name
        self.frame = self.frame.choose(name, self._next_seed()).with_cue_ball()
        self._lay_out()

    def rack(self, new_match: bool = False) -> None:
        """The next rack if the game is over, else this game, or this drill, from its beginning. A position of
        one's own is set up again.

        new_match: no racks are won yet.
        """
        seed = self._next_seed()
        frame, drill = self.frame, isinstance(self.frame.game, Drill)
        if isinstance(frame.game, Practice) and frame.game.set_up:
            self.frame = frame.next_rack(seed).with_cue_ball().replace(earlier=_before_set_up(frame))
            self._lay_out()
            return
        if new_match:
            nothing = msgspec.structs.replace(frame.game, won=self._head_start(frame.game))
            frame = frame.replace(game=nothing, tallies=NO_TALLIES)
        if frame.game.over and not drill:
            self.frame = frame.next_rack(seed).with_cue_ball()
        else:
            content = self.content
            if not drill:
                content = msgspec.structs.replace(
                    content, balls=[], saved={}, tallies=NO_TALLIES, rack_tallies=NO_TALLIES, best=None
                )
            game = self._begun(content)
            layout = layout_for(content, game, frame.table, frame.layout.balls, seed)
            self.frame = Frame(game, layout, frame.table, frame.physics).with_cue_ball()
        self._lay_out()

    def _next_seed(self) -> int:
        self.racks += 1
        return self._rack_seed + self.racks

    # -- balls placed freely ------------------------------------------------------------------------

    def begin_set_up(self) -> None:
        """What is placed from here on can be undone in one."""
        self.frame = self.frame.replace(earlier=self.frame.shortened())

    def set_up(self, layout: Arrangement) -> None:
        """Other balls, at other places."""
        self.frame = self.frame.replace(layout=layout)
        self._lay_out()

    def end_set_up(self) -> None:
        """What was set up is practised; if nothing was, the game goes on."""
        self.frame = self.after_set_up
        self._lay_out()

    @property
    def after_set_up(self) -> Frame:
        """The frame that is played once the set-up ends: what was set up, else the one before."""
        before = self.frame.earlier
        if before is None:
            return self.frame
        if before.layout.places == self.frame.layout.places:
            return before
        words = LEFT_MATCH if len(before.game.players) == 2 else ()
        return as_practice(self.frame).replace(last=None, words=words, foul=False).with_cue_ball()

    def show(self, frame: Frame) -> None:
        """Another frame in play, on the table and the cloth that there are now; the balls turned as they
        are.
        """
        self.frame = frame.replace(table=self.frame.table, physics=self.frame.physics)
        self._lay_out()

    def begin(self, content: BilliardsContent) -> None:
        """Another content in place of the game, on the same table. ValueError if it contradicts itself."""
        now, game = self.frame, game_of(content)
        layout = layout_for(content, game, now.table, now.layout.balls, self._next_seed())
        self.content = content
        self.frame = Frame(game, layout, now.table, now.physics).with_cue_ball()
        self._lay_out()

    @property
    def match_behind(self) -> bool:
        """True if what was done last has left a game between two, to which undoing it leads back."""
        before = self.frame.earlier
        return before is not None and len(before.game.players) == 2 and len(self.frame.game.players) == 1


def as_practice(frame: Frame) -> Frame:
    """The same balls to practise with: nothing is forbidden, and nothing counted."""
    numbers = tuple(number for number in frame.layout.numbers if number != CUE_BALL)
    hand: Hand = "" if frame.cue_ball is not None else "anywhere"
    game = Practice(
        rack="", on_table=numbers, opening=False, in_hand=hand, set_up=frame.layout.places, hand=hand
    )
    return frame.replace(game=game)


def _before_set_up(frame: Frame) -> Frame | None:
    """The frame that was left for a position of one's own, which undoing leads back to; None if none was."""
    own, before = frame.game, frame.earlier
    assert isinstance(own, Practice)
    while before is not None and isinstance(before.game, Practice) and before.game.set_up == own.set_up:
        before = before.earlier
    return before


@lru_cache(maxsize=2)
def _table(tight: bool) -> Table:
    """The pool table."""
    return Table.pool(tight)

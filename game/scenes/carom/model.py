"""What lies on the carom table: the frame that is played, where the balls are, how they are turned."""

from __future__ import annotations

import msgspec

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromFrame, CaromPlayed, points_of, rows_of
from game.billiards.game.carom_summary import as_shot
from game.billiards.game.games.carom import Carom
from game.billiards.game.rules import ShotSummary
from game.billiards.shot.cloths import CLOTHS
from game.billiards.shot.physics import Physics
from game.billiards.shot.trajectory import rotation_matrices
from game.billiards.shot_effects import physics_of
from game.billiards.table.carom import BALL_NAMES, BALL_RADIUS, CAROM_LENGTH, CAROM_WIDTH, WHITE, fits
from game.billiards.table.table import Table
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.scenes.carom.level import CaromContent, begun
from game.scenes.carom.parameters import CaromParameters
from game.scenes.shared.tables.choices import ahead
from game.scenes.shared.tables.demo_shots import scattered_orientations
from game.scenes.shared.tables.moments import Moments
from game.scenes.shared.tables.outcome import Outcome
from game.stage import Part

APART = 2.0 * BALL_RADIUS * (1.0 + 1e-9)  # m; of balls that are put as near as they go


class CaromModel(Part):
    """The frame, and the balls as they move.

    places (3, 2) m of white, yellow, red; turns, turns_before (3, 3, 3): how they are turned, and were before
    the last stroke. The arrays belong to the state; frames are immutable.
    """

    def __init__(
        self, content: CaromContent, parameters: CaromParameters, active: EffectSet, seed: int
    ) -> None:
        self.content = content
        self.parameters = parameters
        game, places = begun(content, int(parameters.target), int(parameters.innings))
        game = self._opened(game, content)
        self.frame = CaromFrame(game, places, Table.carom(), self._physics(active))
        self.places = self.frame.positions
        self.turns = rotation_matrices(scattered_orientations(3, seed))
        self.turns_before = self.turns.copy()
        self._outcome = Outcome[CaromFrame, CaromPlayed](_said)

    def _opened(self, game: Carom, content: CaromContent) -> Carom:
        """A game at its beginning, with the head start of one of two players."""
        if len(game.players) != 2 or (content.saved and not game.opening):
            return game
        start = ahead(self.parameters.head_start)
        return msgspec.structs.replace(game, points=start, given=start)

    def configure(self, active: EffectSet) -> None:
        """Let the cloth, the ends of the game and the effects act from the next stroke on."""
        game = self.frame.game
        if len(game.players) == 2:
            ends = {"target": int(self.parameters.target), "most_innings": int(self.parameters.innings)}
            game = msgspec.structs.replace(game, **ends)
        self.frame = self.frame.replace(physics=self._physics(active), game=game)

    def _physics(self, active: EffectSet) -> Physics:
        return physics_of(active, CLOTHS[str(self.parameters.cloth)])

    @property
    def played(self) -> CaromPlayed | None:
        """What comes, or came, of the last stroke; None before the first."""
        return self._outcome.played(self.frame)

    @property
    def moments(self) -> Moments | None:
        """What of the last stroke is worth a second look; None before the first."""
        return self._outcome.moments(self.frame, 0)

    @property
    def word(self) -> str:
        """A word that stands for the frame, for the digest: equal frames, equal words."""
        return self._outcome.word(self.frame)

    def word_of(self, frame: CaromFrame) -> str:
        """The same of any frame."""
        return self._outcome.word_of(frame)

    # -- strokes ------------------------------------------------------------------------------------

    def strike(self, stroke: Stroke, safety: bool) -> None:
        """Play a stroke. ValueError if it cannot be played; then the frame is what it was."""
        struck = self.frame.strike(stroke, safety)
        self._outcome.played(struck)
        self.frame = struck
        self.turns_before[:] = self.turns

    def roll(self, time: float) -> None:
        """The balls where they are at a time of the shot, s."""
        played = self.played
        if played is not None:
            self.places[self.rows] = played.trajectory.state_at(time).positions

    def turns_at(self, time: float) -> Floats:
        """How white, yellow and red are turned at a time of the last stroke (3, 3, 3)."""
        turns = self.turns.copy()
        played = self.played
        if played is not None:
            turns[self.rows] = played.trajectory.orientations_at(time, self.turns_before[self.rows])
        return turns

    @property
    def rows(self) -> list[int]:
        """Balls in the order of the last stroke's trajectory."""
        last = self.frame.last
        return rows_of(last.frame.game.cue if last is not None else self.frame.game.cue)

    def settle(self) -> None:
        """The shot is over: its verdict holds."""
        played = self.played
        assert played is not None
        self.turns[:] = self.turns_at(played.trajectory.end_time)
        self.frame = played.frame.replace(physics=self.frame.physics)
        self._lay_out()

    def _lay_out(self) -> None:
        self.places[:] = self.frame.positions

    # -- choices, and balls moved by hand -----------------------------------------------------------

    def go_back_to(self, frame: CaromFrame) -> None:
        """A frame before, the balls turned as they were."""
        self.frame = frame.replace(physics=self.frame.physics)
        self.turns[:] = self.turns_before
        self._lay_out()

    def choose(self, row: int) -> None:
        """The player at turn chooses one of the options, counted from 0."""
        self.frame = self.frame.choose(self.frame.game.options[row].name)
        self._lay_out()

    def next_game(self) -> None:
        """The next game if this one is over; else this level from its beginning."""
        if self.frame.game.ended:
            following = self.frame.next_game()
            self.frame = following.replace(game=self._opened(following.game, self.content))
        else:
            content = msgspec.structs.replace(self.content, saved={})
            game, places = begun(content, int(self.parameters.target), int(self.parameters.innings))
            self.frame = CaromFrame(self._opened(game, content), places, self.frame.table, self.frame.physics)
        self._lay_out()

    # -- lessons ------------------------------------------------------------------------------------

    def put_back(self, words: tuple[str, ...]) -> None:
        """The balls as a lesson begins, after a stroke of which this is said; it can be seen again."""
        content = msgspec.structs.replace(self.content, saved={})
        game, places = begun(content, int(self.parameters.target), int(self.parameters.innings))
        self.frame = self.frame.replace(game=game, places=places, words=words, foul=False)
        self._lay_out()

    def seen(self) -> ShotSummary | None:
        """What the referee saw of the last stroke, the cue ball being 0; None before the first."""
        played, last = self.played, self.frame.last
        if played is None or last is None:
            return None
        return as_shot(played.summary, last.frame.game.cue)

    @staticmethod
    def name_of(ball: int) -> str:
        """A ball in words, in a lesson, which is played with the white one."""
        return "cue ball" if ball == WHITE else BALL_NAMES[ball]

    def begin_moving(self) -> bool:
        """Balls are going to be moved by hand: a game between two becomes practice. True if it was one."""
        game = self.frame.game
        was = len(game.players) == 2
        after = game.alone() if was else msgspec.structs.replace(game, opening=False, options=(), run=0)
        self.frame = self.frame.replace(
            game=after, last=None, words=(), foul=False, earlier=self.frame.shortened()
        )
        return was

    def move_ball(self, ball: int, x: float, y: float) -> None:
        """Put a ball at (x, y) m, or as near to it as it can lie."""
        places = self.frame.positions
        places[ball] = free_place(places, ball, x, y)
        self.frame = self.frame.replace(places=points_of(places))
        self._lay_out()


def free_place(places: Floats, ball: int, x: float, y: float) -> tuple[float, float]:
    """Where a ball can lie near (x, y) m: on the bed, beside the others. places (3, 2) m."""
    old = (float(places[ball, 0]), float(places[ball, 1]))
    now = places.copy()
    for _ in range(8):
        x = min(max(x, BALL_RADIUS), CAROM_WIDTH - BALL_RADIUS)
        y = min(max(y, BALL_RADIUS), CAROM_LENGTH - BALL_RADIUS)
        now[ball] = x, y
        if fits(now):
            return x, y
        for other in range(3):
            dx, dy = x - float(places[other, 0]), y - float(places[other, 1])
            distance = elementary.hypot(dx, dy)
            if other != ball and distance < APART:
                ux, uy = (dx / distance, dy / distance) if distance > 1e-9 else (1.0, 0.0)
                x, y = float(places[other, 0]) + APART * ux, float(places[other, 1]) + APART * uy
    return old


def _said(frame: CaromFrame) -> object:
    """What a frame says, but for the frames before it."""
    last, game = frame.last, msgspec.to_builtins(frame.game)
    if not frame.game.anchored:  # the word of a game without anchors stays what it was before these
        del game["anchored"]
    if not any(frame.game.given):  # nor does that of a game at level change
        del game["given"]
    return (
        game, frame.places, frame.physics, frame.strokes,
        None if last is None else (last.frame.places, last.stroke, last.safety, last.frame.physics),
    )  # fmt: skip

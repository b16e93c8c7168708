"""How a frame of snooker stands before a stroke: what is on, points, breaks, what is left on the table.

Numbers are those of the WPBSA's Official Rules of the Games of Snooker and Billiards (2019).
"""

from __future__ import annotations

from typing import Literal

import msgspec

from game.billiards.game.rules import Call, Game, Hand
from game.billiards.game.snooker.misses import MissRule
from game.billiards.game.snooker.stroke import LEAST, Target
from game.billiards.table.snooker import BLACK, COLOURS, RED_NUMBERS, value_of

Stage = Literal["red", "colour", "order"]
Drill = Literal["", "break", "pot", "escape"]
SIX = 6
SUM_OF_COLOURS = sum(value_of(colour) for colour in COLOURS)  # 27


class Before(msgspec.Struct, frozen=True):
    """What was on before a stroke that may have to be played again (3.14(a))."""

    stage: Stage
    free_ball: bool
    on_table: tuple[int, ...]
    in_hand: Hand


class SnookerStanding(Game, frozen=True, kw_only=True):
    """A frame of snooker before a stroke; players are two, or one who practises.

    reds: at the start. best_of: frames, 0 for no end. stage: what is on: a red, a colour after a red, or the
    colours in order. points, high (the highest break): of each player; run: points of this break. free_ball:
    the next stroke may be at a free ball. before, misses, full_misses: the stroke that was a miss, the number
    of misses in a row from there, and of those with a full ball in sight. quiet: strokes since the last
    point. black_again: the black was put back after a tie. lot: of the draw then.

    drill: of one who practises: a break that a miss ends, one pot, or one ball on to be hit; attempts and
    made are counted.
    """

    on_table: tuple[int, ...] = (*RED_NUMBERS, *COLOURS)
    in_hand: Hand = "in the D"
    opening: bool = True
    reds: int = 15
    best_of: int = 1
    miss_rule: MissRule = "professional"
    stage: Stage = "red"
    points: tuple[int, ...] = (0, 0)
    high: tuple[int, ...] = (0, 0)
    run: int = 0
    free_ball: bool = False
    before: Before | None = None
    misses: int = 0
    full_misses: int = 0
    quiet: int = 0
    black_again: bool = False
    lot: int = 0
    drill: Drill = ""
    attempts: int = 0
    made: int = 0

    # -- what is on, and how it stands --------------------------------------------------------------

    @property
    def reds_left(self) -> tuple[int, ...]:
        """Numbers of the reds on the table."""
        return tuple(ball for ball in self.on_table if ball in RED_NUMBERS)

    @property
    def colours_left(self) -> tuple[int, ...]:
        """Numbers of the colours, the lowest first."""
        return tuple(ball for ball in self.on_table if ball in COLOURS)

    def balls_on(self) -> tuple[int, ...]:
        """Balls that are on, a free ball left out (2.11)."""
        if self.stage == "red":
            return self.reds_left
        return self.colours_left if self.stage == "colour" else self.colours_left[:1]

    def legal_first(self) -> tuple[int, ...]:
        """Balls that may be hit first: with a free ball any, once it is nominated."""
        return self.on_table if self.free_ball else self.balls_on()

    def targets(self) -> tuple[int, ...]:
        """Balls that would score now."""
        return self.legal_first()

    def needs_call(self) -> bool:
        """True if the striker says which ball is on: a colour after a red, or a free ball (2.12)."""
        return not self.over and not self.options and (self.stage == "colour" or self.free_ball)

    def target(self, call: Call = Call()) -> Target:  # noqa: B008  (immutable)
        """What a stroke is played for. call: its ball is the one nominated."""
        on = self.balls_on()
        ball = call.ball if call.ball in self.on_table else None
        value = 1 if self.stage == "red" else value_of(on[0])
        if self.free_ball and ball is not None and ball not in on:
            return Target((ball,), (*on, ball), value, free=ball)
        if self.stage != "colour":
            return Target(on, on, value)
        if ball in COLOURS and ball is not None:
            return Target((ball,), (ball,), value_of(ball))
        return Target(on, on, LEAST, nominated=False)

    @property
    def points_left(self) -> int:
        """The most points that the table still gives: eight for each red with its black, and the colours (27
        of them). A free ball is worth a red with its black, in the order of the colours the one that is on.
        """
        if self.stage == "order":
            free = value_of(self.colours_left[0]) if self.free_ball and self.colours_left else 0
            return free + sum(value_of(ball) for ball in self.on_table)
        after_red = value_of(BLACK) if self.stage == "colour" else 0
        if self.free_ball and self.stage == "red":
            after_red = 1 + value_of(BLACK)
        return len(self.reds_left) * (1 + value_of(BLACK)) + SUM_OF_COLOURS + after_red

    def snookers_needed(self, player: int) -> int:
        """Fouls of the least value that a player needs to draw level at best; 0: none."""
        if len(self.players) == 1:
            return 0
        missing = self.points[1 - player] - self.points[player] - self.points_left
        least = max(LEAST, value_of(self.balls_on()[0])) if self.stage == "order" and self.on_table else LEAST
        return max(0, -(-missing // least))

    @property
    def excused(self) -> bool:
        """3.14: a player needs penalty points, or no more than the difference is left on the table."""
        if len(self.players) == 1:
            return False
        return abs(self.points[0] - self.points[1]) >= self.points_left

    @property
    def frames_to_win(self) -> int:
        """Frames that win the match; 0 if it has no end."""
        return self.best_of // 2 + 1 if self.best_of else 0

    @property
    def match_over(self) -> bool:
        """True if a player has won the match."""
        return self.over and 0 < self.frames_to_win <= max(self.won)

    @property
    def six_red(self) -> bool:
        """True at six-red snooker."""
        return self.reds == SIX

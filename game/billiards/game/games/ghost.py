"""The ghost: one plays alone against an opponent who never misses (Alciatore, "Playing the ghost").

Break, then the cue ball in hand anywhere, whatever the break has brought. A player that clears the table from
there as the discipline asks wins the rack; one miss or foul, and the ghost has it. Balls that fall at the
break stay down. After ten racks the count is a measure of one's play: see `game.billiards.game.rating`.

What counts in a stroke follows the World Pool-Billiard Association, as far as one stroke goes: nine-ball
(2.), ten-ball with its called shots (9., the 10 at the break is put back), eight-ball (3.) with the group
that falls first.
"""

from __future__ import annotations

from typing import Literal

import msgspec

from game.billiards.game.games.eight_ball import EIGHT, GROUPS
from game.billiards.game.games.nine_ball import NINE, NINE_BALLS
from game.billiards.game.games.ten_ball import TEN, TEN_BALLS
from game.billiards.game.rules import (
    Call,
    Foul,
    Game,
    Hand,
    ShotSummary,
    Verdict,
    common_fouls,
    named,
    rack_won,
    remaining,
)

RACKS = 10  # of a set
Discipline = Literal["nine-ball", "ten-ball", "eight-ball"]
BALLS: dict[Discipline, tuple[int, ...]] = {
    "nine-ball": NINE_BALLS,
    "ten-ball": TEN_BALLS,
    "eight-ball": tuple(range(1, 16)),
}
LAST = {"nine-ball": NINE, "ten-ball": TEN, "eight-ball": EIGHT}
PLAYER, GHOST = 0, 1


class Ghost(Game, frozen=True, kw_only=True, tag="ghost"):
    """A rack against the ghost, who is the second player and never at turn. racks: of a set; group: at
    eight-ball the one that fell first, "" while none has.
    """

    players: tuple[str, ...] = ("Player", "Ghost")
    discipline: Discipline = "nine-ball"
    on_table: tuple[int, ...] = NINE_BALLS
    in_hand: Hand = "behind the line"
    opening: bool = True
    racks: int = RACKS
    group: Literal["", "solids", "stripes"] = ""

    @property
    def last(self) -> int:
        """The ball that wins the rack."""
        return LAST[self.discipline]

    @property
    def set_over(self) -> bool:
        """True if all racks of the set have been played."""
        return sum(self.won) >= self.racks

    @property
    def final(self) -> bool:
        """True: no stroke is taken back."""
        return True

    def legal_first(self) -> tuple[int, ...]:
        """The lowest ball; at eight-ball one's own, the 8 when they have gone."""
        if self.discipline != "eight-ball":
            return self.on_table[:1]
        if self.opening:
            return self.on_table
        own = self._own()
        return own or (EIGHT,)

    def barred(self) -> tuple[int, ...]:
        """At eight-ball the 8 before its turn."""
        early = self.discipline == "eight-ball" and not self.opening and self.legal_first() != (EIGHT,)
        return (EIGHT,) if early else ()

    def targets(self) -> tuple[int, ...]:
        """What may be potted; all balls, where any combination counts."""
        return self.legal_first() if self.discipline == "eight-ball" else self.on_table

    def needs_call(self) -> bool:
        """Ten-ball is played with called shots (9.5)."""
        return self.discipline == "ten-ball" and not self.opening and not self.over

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke. ValueError if the rack is over."""
        self.check_playable()
        if self.opening:
            return self._judge_break(shot)
        fouls = common_fouls(self, shot, self.legal_first(), False)
        why = fouls[0].words if fouls else self._why_nothing(shot, call)
        if why:
            return self._ghost_wins(shot, fouls, why)
        if self.last in shot.balls_down and self._wins(call):
            return self._player_wins(shot, f"{self.shooter} clears the table and wins the rack.")
        back = (self.last,) if self.last in shot.balls_down else ()
        words = [f"The {self.last} was not called, and is put back."] * len(back)
        after = self._after(shot, back)
        if self.discipline == "eight-ball" and not self.group:
            first = next(ball for ball in shot.balls_down if ball != EIGHT)
            after = msgspec.structs.replace(after, group="solids" if first < EIGHT else "stripes")
            words.append(f"{self.shooter} has the {after.group}.")
        return Verdict(after, (), shot.balls_down, (*words, f"{self.shooter} plays on."), back)

    def _judge_break(self, shot: ShotSummary) -> Verdict:
        """The cue ball in hand, whatever came. The 9 wins if it falls without a foul (2.)."""
        fouls = common_fouls(self, shot, self.legal_first(), False)
        fouls = tuple(foul for foul in fouls if foul.kind != "no cushion")
        if self.discipline == "nine-ball" and NINE in shot.balls_down and not fouls:
            return self._player_wins(shot, f"{self.shooter} pots the 9 at the break and wins.")
        back = tuple({self.last} & {*shot.balls_down, *shot.off_table})
        after = msgspec.structs.replace(self._after(shot, back), in_hand="anywhere")
        words = [foul.words for foul in fouls] + [f"The {self.last} is put back."] * len(back)
        words.append(f"{self.shooter} has the cue ball in hand; one miss, and the ghost wins.")
        return Verdict(after, fouls, (), tuple(words), back)

    def _why_nothing(self, shot: ShotSummary, call: Call) -> str:
        """Why a stroke without a foul has lost the rack; empty if it has not."""
        if not shot.pocketed:
            return "Nothing went down."
        if self.discipline == "ten-ball":
            if call.ball is None or call.pocket is None:
                return "No ball and pocket were called."
            fallen = shot.pocketing(call.ball)
            if fallen is None:
                return f"The {named(call.ball)} did not go down as called."
            return "" if fallen.pocket == call.pocket else "The called ball went into another pocket."
        if self.discipline == "eight-ball":
            if EIGHT in shot.balls_down:
                return "" if self.legal_first() == (EIGHT,) else "The 8 went down before its turn."
            own = [ball for ball in shot.balls_down if ball in self._own()]
            return "" if own else f"None of the {self.group} went down."
        return ""

    def _wins(self, call: Call) -> bool:
        """True if the last ball, which has gone down in a stroke that counts, wins."""
        return self.discipline != "ten-ball" or call.ball == TEN

    def _own(self) -> tuple[int, ...]:
        """At eight-ball the balls that may be played before the 8."""
        if self.group:
            return tuple(ball for ball in self.on_table if ball in GROUPS[self.group])
        return tuple(ball for ball in self.on_table if ball != EIGHT)

    def _after(self, shot: ShotSummary, back: tuple[int, ...] = ()) -> Ghost:
        """The rack after a stroke. back: balls that are put back at once."""
        on_table = tuple(sorted({*remaining(self, shot), *back}))
        return msgspec.structs.replace(self, on_table=on_table, in_hand="", opening=False)

    def _player_wins(self, shot: ShotSummary, words: str) -> Verdict:
        won = msgspec.structs.replace(self._after(shot), winner=PLAYER, won=rack_won(self, PLAYER))
        return Verdict(won, (), shot.balls_down, (words,))

    def _ghost_wins(self, shot: ShotSummary, fouls: tuple[Foul, ...], why: str) -> Verdict:
        lost = msgspec.structs.replace(self._after(shot), winner=GHOST, won=rack_won(self, GHOST))
        return Verdict(lost, fouls, (), (why, "The ghost wins the rack."))

    def next_rack(self) -> Verdict:
        """The next rack; the player breaks again."""
        state = new_ghost(self.discipline, self.players[PLAYER], self.racks)
        state = msgspec.structs.replace(state, won=self.won)
        words = f"Rack {sum(self.won) + 1} of {self.racks}: {state.shooter} breaks."
        return Verdict(state, words=(words,), rack=True)


def new_ghost(discipline: Discipline, player: str = "Player", racks: int = RACKS) -> Ghost:
    """A set against the ghost at its beginning."""
    return Ghost(players=(player, "Ghost"), discipline=discipline, on_table=BALLS[discipline], racks=racks)

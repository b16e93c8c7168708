"""What nine-ball and ten-ball share: the lowest ball is hit first, and one ball, the highest, wins.

Numbers of paragraphs are those of nine-ball (WPA 2) and ten-ball (WPA 9), in this order.
"""

from __future__ import annotations

from typing import Any, ClassVar

import msgspec

from game.billiards.game.rules import (
    MOST_FOULS,
    NEEDED_AT_BREAK,
    Call,
    Foul,
    Game,
    Hand,
    Option,
    ShotSummary,
    Verdict,
    common_fouls,
    counted_fouls,
    driven_to_cushions,
    rack_won,
    remaining,
)

PLAY = Option("play", "Play the table as it lies.")
PASS_BACK = Option("pass back", "Let the player who pushed out play.")


class Rotation(Game, frozen=True, kw_only=True):
    """A rack of which the highest ball wins. push_out_next: the next stroke, the first after the break, may
    be a push-out.
    """

    winning: ClassVar[int]  # the ball that wins

    in_hand: Hand = "behind the line"
    opening: bool = True
    push_out_next: bool = False

    def legal_first(self) -> tuple[int, ...]:
        """The lowest ball (2., 9.)."""
        return self.on_table[:1]

    def targets(self) -> tuple[int, ...]:
        """Whatever goes down counts, as long as the lowest is hit first."""
        return self.on_table

    def may_push_out(self) -> bool:
        """True if the next stroke may be announced as a push-out (2.4, 9.4)."""
        return self.push_out_next and not self.over and not self.options

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke. ValueError for a push-out where none is allowed."""
        self.check_playable()
        if call.push_out and not self.push_out_next:
            raise ValueError("call push_out: only the first stroke after the break may be a push-out")
        fouls = common_fouls(self, shot, self.legal_first(), call.push_out)
        if self.opening:
            fouls = self._break_fouls(shot, fouls)
        back = self._put_back(shot, call, fouls)
        after = msgspec.structs.replace(
            self,
            on_table=tuple(sorted({*remaining(self, shot), *back})),
            in_hand="",
            opening=False,
            push_out_next=self.opening and not fouls,
            fouls_in_row=counted_fouls(self, bool(fouls)),
        )
        words = [foul.words for foul in fouls] + [f"The {self.winning} is put back."] * len(back)
        if fouls:
            return self._judge_foul(after, fouls, words, back)
        if self.winning in shot.balls_down and not back:
            won = msgspec.structs.replace(after, winner=self.turn, won=rack_won(self, self.turn))
            words.append(f"{self.shooter} pots the {self.winning} and wins.")
            return Verdict(won, (), shot.balls_down, tuple(words))
        if call.push_out:
            asked = msgspec.structs.replace(after, turn=self.other, options=(PLAY, PASS_BACK))
            words += [f"{self.shooter} pushed out.", f"{asked.shooter} chooses who plays."]
            return Verdict(asked, (), (), tuple(words), back)
        return self._go_on(after, shot, call, words)._replace(spot=back)

    def _put_back(self, shot: ShotSummary, call: Call, fouls: tuple[Foul, ...]) -> tuple[int, ...]:
        """The winning ball, if it has gone without winning; no other ball is ever put back (2.7, 9.9)."""
        raise NotImplementedError

    def _go_on(self, after: Rotation, shot: ShotSummary, call: Call, words: list[str]) -> Verdict:
        """What follows from a stroke without a foul that has not won. after: the same player at turn."""
        raise NotImplementedError

    def _break_fouls(self, shot: ShotSummary, fouls: tuple[Foul, ...]) -> tuple[Foul, ...]:
        """2.3, 9.3: at the break four balls reach a cushion, or one goes down."""
        fouls = tuple(foul for foul in fouls if foul.kind != "no cushion")
        driven = driven_to_cushions(shot)
        if shot.first and not shot.pocketed and driven < NEEDED_AT_BREAK:
            said = f"At the break no ball went down, and {driven} of {NEEDED_AT_BREAK} reached a cushion."
            fouls += (Foul("break", said),)
        return fouls

    def _judge_foul(
        self, after: Rotation, fouls: tuple[Foul, ...], words: list[str], back: tuple[int, ...]
    ) -> Verdict:
        """The cue ball in hand for the other player; three fouls in a row lose the rack (2.8, 9.11)."""
        count = after.fouls_in_row[self.turn]
        if count >= MOST_FOULS:
            fouls += (Foul("three in a row", f"{self.shooter} fouled {count} times in a row."),)
            words += [fouls[-1].words, f"{self.players[self.other]} wins the rack."]
            after = msgspec.structs.replace(after, winner=self.other, won=rack_won(self, self.other))
            return Verdict(after, fouls, (), tuple(words), back)
        if count == MOST_FOULS - 1:
            words.append(f"{self.shooter} is on two fouls: a third loses the rack.")
        after = msgspec.structs.replace(after, turn=self.other, in_hand="anywhere")
        words.append(f"{after.shooter} has the cue ball in hand.")
        return Verdict(after, fouls, (), tuple(words), back)

    def choose(self, name: str) -> Verdict:
        """What follows from the choice after a push-out (2.4, 9.4), or after a ball went down uncalled."""
        self.check_option(name)
        turn = self.turn if name == PLAY.name else self.other
        state = msgspec.structs.replace(self, options=(), turn=turn)
        return Verdict(state, words=(f"{state.shooter} plays.",))

    def next_rack(self) -> Verdict:
        """The next rack; the players break in turns."""
        breaker = (self.breaker + 1) % len(self.players)
        fresh: Any = type(self)
        state = fresh(players=self.players, turn=breaker, breaker=breaker, won=self.won)
        return Verdict(state, words=(f"{state.shooter} breaks.",), rack=True)

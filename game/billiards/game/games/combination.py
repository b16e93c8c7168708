"""The combination match: a ball counts if it goes down by way of at least one other ball.

The cue ball strikes a numbered ball, that one another, and so on to the one that falls. A single last ball
has no other to be potted by: it is potted directly. In a stroke that counts, whatever else goes down counts
too. What goes down without counting is put back.
"""

from __future__ import annotations

import msgspec

from game.billiards.game.rules import (
    Call,
    Game,
    Hand,
    Pocketing,
    ShotSummary,
    Verdict,
    common_fouls,
    rack_won,
    remaining,
)

SHORTEST_CHAIN = 3  # the cue ball, another, and the one that falls


class CombinationMatch(Game, frozen=True, kw_only=True, tag="combination"):
    """A combination match. points: balls of each player. rounds: strokes that counted.

    alternating: players take turns also after a stroke that counted.
    """

    on_table: tuple[int, ...] = tuple(range(1, 16))
    in_hand: Hand = "behind the line"
    opening: bool = True
    points: tuple[int, ...] = (0, 0)
    rounds: int = 0
    alternating: bool = False

    def counts(self, fallen: Pocketing) -> bool:
        """True if a ball went down by way of another, or was the last one."""
        return len(fallen.chain) >= SHORTEST_CHAIN or len(self.on_table) == 1

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke."""
        self.check_playable()
        fouls = common_fouls(self, shot, self.on_table, push_out=False)
        words = [foul.words for foul in fouls]
        scores = not fouls and any(self.counts(fallen) for fallen in shot.pocketed)
        scored = shot.balls_down if scores else ()
        back = tuple(sorted({*shot.numbered_off, *(() if scores else shot.balls_down)}))
        after = msgspec.structs.replace(
            self,
            on_table=tuple(sorted({*remaining(self, shot), *back})),
            opening=False,
            in_hand="anywhere" if fouls else "",
            points=tuple(n + len(scored) * (k == self.turn) for k, n in enumerate(self.points)),
            rounds=self.rounds + scores,
        )
        if scores:
            words += [_described(fallen) for fallen in shot.pocketed]
            if not after.on_table:
                return self._finished(after, scored, words)
            if self.alternating:
                after = msgspec.structs.replace(after, turn=self.other)
                return Verdict(after, fouls, scored, (*words, f"{after.shooter} plays."))
            return Verdict(after, fouls, scored, (*words, f"{self.shooter} plays on."))
        if shot.pocketed and not fouls:
            words.append("No ball went down by way of another, so it is put back.")
        after = msgspec.structs.replace(after, turn=self.other)
        hand = " with the cue ball in hand" if fouls else ""
        return Verdict(after, fouls, (), (*words, f"{after.shooter} plays{hand}."), back)

    def _finished(self, after: CombinationMatch, scored: tuple[int, ...], words: list[str]) -> Verdict:
        """The table is empty: more balls win; with as many each, the player who potted the last."""
        most = max(after.points)
        winner = self.turn if after.points[self.turn] == most else after.points.index(most)
        won = msgspec.structs.replace(after, winner=winner, won=rack_won(self, winner))
        score = " : ".join(str(n) for n in after.points)
        return Verdict(won, (), scored, (*words, f"{self.players[winner]} wins, {score}."))

    def next_rack(self) -> Verdict:
        """The next match of the same players."""
        breaker = (self.breaker + 1) % len(self.players)
        state = CombinationMatch(
            players=self.players,
            turn=breaker,
            breaker=breaker,
            won=self.won,
            points=(0,) * len(self.players),
            alternating=self.alternating,
        )
        return Verdict(state, words=(f"{state.shooter} breaks.",), rack=True)


def _described(fallen: Pocketing) -> str:
    """How a ball went down, in words."""
    between = fallen.chain[1:-1]
    if not between:
        return f"The {fallen.ball} went down."
    return f"The {fallen.ball} went down by way of {' and '.join(f'the {ball}' for ball in between)}."

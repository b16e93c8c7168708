"""What is counted of each player over the racks of a match, and which stroke of a rack was the best."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import msgspec

from game.billiards.game.rules import Call, Game, Pocketing, ShotSummary, Verdict

Count = Annotated[int, msgspec.Meta(ge=0)]

# merit of a stroke, beside 1 for each ball that counts: for each ball in between, for each cushion, for the
# rack that it wins
BY_WAY_OF, OFF_A_CUSHION, WINS = 0.8, 0.5, 0.4


class Tally(NamedTuple):
    """Of one player. tries: strokes that were to pot (no break, safety or push-out). scoring: those of them
    that did. run: balls that counted since the last miss; longest: the most of them. fouls: of all strokes.
    """

    tries: Count = 0
    scoring: Count = 0
    run: Count = 0
    longest: Count = 0
    fouls: Count = 0

    @property
    def rate(self) -> float | None:
        """Share of tries that scored; None before the first."""
        return self.scoring / self.tries if self.tries else None

    def after(self, game: Game, call: Call, verdict: Verdict) -> Tally:
        """With one more stroke. game: as it was before it."""
        tried = not (game.opening or call.safety or call.push_out)
        scored = len(verdict.scored) if verdict.legal else 0
        run = self.run + scored if scored else 0
        return Tally(
            self.tries + tried, self.scoring + (tried and scored > 0), run, max(self.longest, run),
            self.fouls + (not verdict.legal),
        )  # fmt: skip


def merit(shot: ShotSummary, verdict: Verdict) -> float:
    """How much a stroke is worth being seen again; 0 for one that scored nothing."""
    if not verdict.legal:
        return 0.0
    worth = sum(
        1.0 + BY_WAY_OF * balls_between(fallen) + OFF_A_CUSHION * min(fallen.rails, 3)
        for fallen in shot.pocketed
        if fallen.ball in verdict.scored
    )
    return worth + WINS * verdict.game.over if worth else 0.0


def balls_between(fallen: Pocketing) -> int:
    """How many balls stood between the cue ball and the one that fell."""
    return sum(1 for ball in fallen.chain if ball not in (0, fallen.ball))

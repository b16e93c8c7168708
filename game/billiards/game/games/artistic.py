"""Artistic billiards: figures with a declared way for the cue ball, each tried up to three times.

Both players play the same figure from the same places, with the white ball. Who makes it has its points, and
tries it no more. After the last figure the player with more points wins.
"""

from __future__ import annotations

from typing import Annotated, Any

import msgspec
import numpy as np

from game.arrays import Floats
from game.billiards.game.carom_summary import BALL, CUSHION, CaromSummary
from game.billiards.game.games.artistic_figures import FIGURES, LETTERS, Figure
from game.billiards.game.games.carom import Carom, CaromVerdict
from game.billiards.game.games.carom_kinds import Kind
from game.billiards.game.rules import Foul
from game.billiards.table.carom import BALL_NAMES, WHITE

ATTEMPTS = 3  # at a figure, of each player


def route_of(shot: CaromSummary) -> str:
    """What the white ball touched up to the second ball, in LETTERS; "" if it did not touch both.

    A ball that is touched several times with nothing between is written once.
    """
    scoring = shot.scoring(WHITE)
    if scoring is None:
        return ""
    letters = [LETTERS[number if kind == CUSHION else 3 + number] for kind, number in scoring.order]
    kept = [
        one for k, one in enumerate(letters)
        if not k or one != letters[k - 1] or scoring.order[k][0] != BALL
    ]  # fmt: skip
    return "".join(kept)


class Artistic(Carom, frozen=True, kw_only=True, tag="artistic"):
    """A match over the figures. figure: the one that is played, by its place; attempts: so many of the player
    at turn have failed at it. run: figures made one after the other; target is not used.
    """

    kind: Kind = "artistic"
    target: int = 0
    opening: bool = False
    figure: Annotated[int, msgspec.Meta(ge=0, lt=len(FIGURES))] = 0
    attempts: Annotated[int, msgspec.Meta(ge=0, lt=ATTEMPTS)] = 0

    @property
    def cue(self) -> int:
        """The white ball, for both."""
        return WHITE

    @property
    def now(self) -> Figure:
        """The figure that is played."""
        return FIGURES[self.figure]

    def start(self) -> Floats:
        """Places (3, 2) m of the figure."""
        return np.array([self.now.white, self.now.yellow, self.now.red])

    def judge(self, shot: CaromSummary, safety: bool = False) -> CaromVerdict:
        """What follows from an attempt. ValueError if the match is over."""
        self.check_playable()
        fouls = tuple(
            Foul("off the table", f"The {BALL_NAMES[ball]} ball left the table.") for ball in shot.off_table
        )
        fouls += tuple(
            Foul("touching", f"The cue ball was played into the {BALL_NAMES[ball]} ball it touched.")
            for ball in shot.into
        )
        words = [foul.words for foul in fouls]
        if not fouls and route_of(shot) == self.now.route:
            return self._made(words)
        words += [] if fouls else [f"Not the declared way: {self.now.name} asks for another."]
        if self.attempts + 1 < ATTEMPTS:
            again = msgspec.structs.replace(self, attempts=self.attempts + 1)
            words.append(f"Attempt {again.attempts + 1} of {ATTEMPTS}.")
            return CaromVerdict(again, again.start(), False, fouls, tuple(words))
        failed = msgspec.structs.replace(self, run=0)
        return failed._next_player(False, fouls, words)

    def _made(self, words: list[str]) -> CaromVerdict:
        """The points of the figure."""
        points = tuple(n + self.now.points * (k == self.turn) for k, n in enumerate(self.points))
        high = tuple(max(n, self.run + 1) if k == self.turn else n for k, n in enumerate(self.high_runs))
        words = [*words, f"{self.shooter} makes it: {self.now.points} points."]
        return msgspec.structs.replace(self, points=points, high_runs=high, run=self.run + 1)._next_player(
            True, (), words
        )

    def _next_player(self, scored: bool, fouls: tuple[Foul, ...], words: list[str]) -> CaromVerdict:
        """The other player at this figure, or both at the next one."""
        turn = self.other
        last = turn == self.breaker  # both have played it
        figure = self.figure + last
        if figure >= len(FIGURES):
            return self._end(self.start(), fouls, words)._replace(scored=scored)
        begun = tuple(n + (k == turn) for k, n in enumerate(self.innings))
        run = self.run if len(self.players) == 1 else 0
        game = msgspec.structs.replace(self, turn=turn, figure=figure, attempts=0, innings=begun, run=run)
        said = f"Figure {figure + 1}, {game.now.name}: {game.now.points} points." if last else ""
        words = [*words, *([said] if said else []), f"{game.shooter} plays."]
        return CaromVerdict(game, game.start(), scored, fouls, tuple(words))

    def facing(self, places: Floats) -> Artistic:
        """No player has a choice: the figure says how the balls lie."""
        return self

    def next_game(self) -> CaromVerdict:
        """The figures from the first one, the other player before."""
        verdict = super().next_game()
        game: Any = msgspec.structs.replace(verdict.game, figure=0, attempts=0, opening=False)
        return CaromVerdict(game, game.start(), words=verdict.words)


AnyCarom = Carom | Artistic  # for msgspec, which reads it by its tag

"""Carom billiards: straight rail, balkline, one-cushion and three-cushion, of two players or one.

A point is made by a stroke whose cue ball touches both other balls, in cushion games after so many cushions.
Rules are those of the Union Mondiale de Billard (World rules of carom billiard); numbers of articles are
theirs. Safeties are counted as the Billiard Congress of America does: none twice in a row.
"""

from __future__ import annotations

from typing import NamedTuple

import msgspec

from game.arrays import Floats
from game.billiards.game.carom_summary import BALL, CaromSummary
from game.billiards.game.games.carom_kinds import RULES, Kind, Rule
from game.billiards.game.games.carom_zones import Counts, counts_after, entered, must_leave, stayed
from game.billiards.game.rules import Foul, Option
from game.billiards.table.balk import Zone
from game.billiards.table.carom import BALL_NAMES, RED, respotted, starting_position, touching

PLAY_AWAY = Option("away", "Play away from the ball that the cue ball touches.")
RESPOT = Option("spots", "Have the balls that touch put on their spots.")
RESTART = Option("start", "Begin from the starting position.")
ACCEPT = Option("accept", "Play from where the balls lie.")


class CaromVerdict(NamedTuple):
    """What follows from a stroke, or from a choice.

    game: the state to go on with. places (3, 2) m: where the balls then lie. scored: a point was made. fouls
    and words as for the games of pool.
    """

    game: Carom
    places: Floats
    scored: bool = False
    fouls: tuple[Foul, ...] = ()
    words: tuple[str, ...] = ()


class Carom(msgspec.Struct, frozen=True, kw_only=True, tag="carom", tag_field="game"):
    """A game of carom before a stroke. Player 0 plays the white ball, player 1 the yellow one.

    target: points that end it, 0 for none. most_innings: of each player, 0 for no limit. equalise: the second
    player has as many innings as the first. points, innings (begun), high_runs, safeties (in a row), won
    (games): of each player. given: points of each that are a head
    start. run: points of this inning. inside: ENTERED or INSIDE while both object balls lie
    in one barred corner or box, else 0; anchored: the same of one anchor. alone_with: the
    ball that a player without another one plays. opening: the stroke is made from the starting position.
    ended: the game has ended; winner: None too if it is drawn.
    """

    kind: Kind = "three-cushion"
    players: tuple[str, ...] = ("Player 1", "Player 2")
    target: int = 15
    most_innings: int = 0
    most_safeties: int = 1
    equalise: bool = True
    turn: int = 0
    breaker: int = 0
    points: tuple[int, ...] = (0, 0)
    given: tuple[int, int] = (0, 0)
    innings: tuple[int, ...] = (1, 0)
    high_runs: tuple[int, ...] = (0, 0)
    safeties: tuple[int, ...] = (0, 0)
    won: tuple[int, ...] = (0, 0)
    run: int = 0
    inside: int = 0
    anchored: int = 0
    alone_with: int = 0
    opening: bool = True
    options: tuple[Option, ...] = ()
    ended: bool = False
    winner: int | None = None

    @property
    def cue(self) -> int:
        """The ball that the player at turn plays: WHITE or YELLOW."""
        return self.turn if len(self.players) == 2 else self.alone_with

    @property
    def shooter(self) -> str:
        """Name of the player at turn."""
        return self.players[self.turn]

    @property
    def other(self) -> int:
        """Number of the player who is not at turn; in a game of one, the same."""
        return (self.turn + 1) % len(self.players)

    @property
    def over(self) -> bool:
        """True if the game has ended, as at every other table."""
        return self.ended

    @property
    def cushions(self) -> int:
        """Cushions that the cue ball needs before the second object ball."""
        return self.rule.cushions

    @property
    def rule(self) -> Rule:
        """What this kind of carom asks for."""
        return RULES[self.kind]

    @property
    def counts(self) -> Counts:
        """How the barred zones stand."""
        return Counts(self.inside, self.anchored)

    def must_leave(self, places: Floats) -> tuple[Zone, ...]:
        """Zones of which a point must drive an object ball out (54). places (3, 2) m."""
        return must_leave(self.rule.barred, self.counts, places, self.cue)

    def average(self, player: int) -> float:
        """Points made in an inning by a player, without those of a head start; 0 before the first."""
        innings, made = self.innings[player], self.points[player] - self.given[player]
        return made / innings if innings else 0.0

    def start(self) -> Floats:
        """Places (3, 2) m of the starting position of the player at turn."""
        return starting_position(self.cue)

    # -- a stroke -----------------------------------------------------------------------------------

    def judge(self, shot: CaromSummary, safety: bool = False) -> CaromVerdict:
        """What follows from a stroke; safety: it was announced as one. ValueError if none may be played."""
        self.check_playable()
        scoring = shot.scoring(self.cue)
        fouls = self._fouls(shot, safety)
        scored = not fouls and not safety and scoring is not None and scoring.cushions >= self.cushions
        words = [foul.words for foul in fouls]
        restart = bool(shot.off_table) and self.kind != "three-cushion"
        inside, anchored = counts_after(self.rule.barred, self.counts, shot, self.cue)
        after = msgspec.structs.replace(
            self, opening=restart, inside=inside, anchored=anchored,
            safeties=_with(self.safeties, self.turn, self._safeties(safety)),
        )  # fmt: skip
        places = self._put_back(shot)
        if not scored:
            return after._next_inning(places, fouls, words + self._why_not(shot, fouls, safety))
        run = self.run + 1
        after = msgspec.structs.replace(
            after, run=run, points=_with(self.points, self.turn, self.points[self.turn] + 1),
            high_runs=_with(self.high_runs, self.turn, max(run, self.high_runs[self.turn])),
        )  # fmt: skip
        words.append(f"{self.shooter} scores: a run of {run}.")
        if self.target and after.points[self.turn] >= self.target:
            return after._target_reached(places, words)
        return after._ready(CaromVerdict(after, places, True, (), tuple(words)))

    def _fouls(self, shot: CaromSummary, safety: bool) -> tuple[Foul, ...]:
        """Articles 23, 27, 41, 54, and safeties in a row."""
        fouls = [
            Foul("off the table", f"The {BALL_NAMES[ball]} ball left the table.") for ball in shot.off_table
        ]
        fouls += [Foul("touching", f"The cue ball was played into the {BALL_NAMES[ball]} ball it touched.")
                  for ball in shot.into]  # fmt: skip
        if self.opening and shot.path[:1] != ((BALL, RED),):
            fouls.append(
                Foul("opening", "From the starting position the red ball is played first, directly.")
            )
        if safety and not any(kind == BALL for kind, _ in shot.path):
            fouls.append(Foul("no contact", "A safety must touch a ball."))
        if safety and self._safeties(True) > self.most_safeties:
            fouls.append(Foul("safety", f"No more than {self.most_safeties} safety in a row."))
        return (*fouls, *stayed(self.rule.barred, self.counts, shot))

    def _safeties(self, safety: bool) -> int:
        return self.safeties[self.turn] + 1 if safety else 0

    def _why_not(self, shot: CaromSummary, fouls: tuple[Foul, ...], safety: bool) -> list[str]:
        """Why a stroke without a foul made no point."""
        if fouls:
            return []
        if safety:
            return [f"{self.shooter} plays safe."]
        scoring = shot.scoring(self.cue)
        if scoring is None:
            met = {number for kind, number in shot.path if kind == BALL}
            missed = [BALL_NAMES[ball] for ball in (1 - self.cue, RED) if ball not in met]
            return [f"Not touched: {' and '.join(missed)}."]
        return [f"Only {scoring.cushions} of {self.cushions} cushions before the second ball."]

    def _put_back(self, shot: CaromSummary) -> Floats:
        """28: balls that left the table go to their spots; in the games of fewer cushions all start again."""
        if not shot.off_table:
            return shot.rest
        if self.kind == "three-cushion":
            return respotted(shot.rest, shot.off_table, self.other if len(self.players) == 2 else self.cue)
        return starting_position(self.other if len(self.players) == 2 else self.cue)

    # -- what follows -------------------------------------------------------------------------------

    def _next_inning(self, places: Floats, fouls: tuple[Foul, ...], words: list[str]) -> CaromVerdict:
        """The inning is over: the other player's begins, unless the game ends."""
        turn = self.other
        closed = turn == self.breaker  # both have had as many innings
        if self.ended_by_innings(closed):
            return self._end(places, fouls, words)
        inside, anchored = entered(self.rule.barred, places, turn if len(self.players) == 2 else self.cue)
        game = msgspec.structs.replace(
            self, turn=turn, run=0, inside=inside, anchored=anchored,
            innings=_with(self.innings, turn, self.innings[turn] + 1),
        )  # fmt: skip
        verdict = CaromVerdict(game, places, False, fouls, (*words, f"{game.shooter} plays."))
        if any(foul.kind == "safety" for foul in fouls):
            game = msgspec.structs.replace(game, options=(ACCEPT, RESTART))
            return verdict._replace(game=game)
        return game._ready(verdict)

    def ended_by_innings(self, closed: bool) -> bool:
        """True if no inning is left. closed: all players have had as many."""
        if self.target and max(self.points) >= self.target:
            return closed
        return bool(self.most_innings) and closed and self.innings[self.turn] >= self.most_innings

    def _target_reached(self, places: Floats, words: list[str]) -> CaromVerdict:
        """29: the second player may draw level, in an inning from the starting position."""
        if len(self.players) == 2 and self.equalise and self.turn == self.breaker:
            turn = self.other
            game = msgspec.structs.replace(
                self, turn=turn, run=0, inside=0, anchored=0, opening=True,
                innings=_with(self.innings, turn, self.innings[turn] + 1),
            )  # fmt: skip
            words += [f"{self.shooter} has {self.points[self.turn]}.", f"{game.shooter} has the last inning."]
            return CaromVerdict(game, starting_position(game.cue), True, (), tuple(words))
        verdict = self._end(places, (), words)
        return verdict._replace(scored=True)

    def _end(self, places: Floats, fouls: tuple[Foul, ...], words: list[str]) -> CaromVerdict:
        """The most points win."""
        most = max(self.points)
        leaders = [player for player in range(len(self.players)) if self.points[player] == most]
        winner = leaders[0] if len(leaders) == 1 else None
        won = self.won if winner is None else _with(self.won, winner, self.won[winner] + 1)
        score = " to ".join(str(self.points[player]) for player in range(len(self.players)))
        words.append(f"Drawn, {score}." if winner is None else f"{self.players[winner]} wins, {score}.")
        game = msgspec.structs.replace(self, ended=True, winner=winner, won=won, run=0)
        return CaromVerdict(game, places, False, fouls, tuple(words))

    def _ready(self, verdict: CaromVerdict) -> CaromVerdict:
        """What the player at turn may choose, coming to the table."""
        return verdict._replace(game=self.facing(verdict.places))

    def facing(self, places: Floats) -> Carom:
        """27: a player whose ball touches another may have the balls put on their spots. places (3, 2) m."""
        if self.opening or self.ended or not touching(places, self.cue):
            return self
        return msgspec.structs.replace(self, options=(PLAY_AWAY, RESPOT))

    def coming_to(self, places: Floats) -> Carom:
        """53: a player who comes to such a position has entered, but at the opening. places (3, 2) m."""
        if self.opening or self.rule.barred.strokes is None:
            return self
        inside, anchored = entered(self.rule.barred, places, self.cue)
        return msgspec.structs.replace(self, inside=inside, anchored=anchored)

    def choose(self, name: str, places: Floats) -> CaromVerdict:
        """What follows from the player at turn choosing an option. places (3, 2) m. ValueError if none is."""
        names = [option.name for option in self.options]
        if name not in names:
            raise ValueError(f"game option {name!r}: {', '.join(names) or 'there is nothing to choose'}")
        game = msgspec.structs.replace(self, options=())
        if name == RESTART.name or (name == RESPOT.name and self.kind != "three-cushion"):
            game = msgspec.structs.replace(game, opening=True, inside=0, anchored=0)
            return CaromVerdict(game, game.start(), words=("The balls lie in the starting position.",))
        if name == RESPOT.name:
            balls = (self.cue, *touching(places, self.cue))
            return CaromVerdict(
                game, respotted(places, balls, self.cue), words=("The balls lie on their spots.",)
            )
        return game._ready(CaromVerdict(game, places)) if name == ACCEPT.name else CaromVerdict(game, places)

    def next_game(self) -> CaromVerdict:
        """The next game of the same players, who begin in turns."""
        breaker = (self.breaker + 1) % len(self.players)
        zeros = (0,) * len(self.players)
        game = msgspec.structs.replace(
            self, turn=breaker, breaker=breaker, points=zeros, given=(0, 0),
            innings=_with(zeros, breaker, 1),
            high_runs=zeros, safeties=zeros, run=0, inside=0, anchored=0, opening=True, options=(),
            ended=False, winner=None,
        )  # fmt: skip
        return CaromVerdict(game, game.start(), words=(f"{game.shooter} begins.",))

    def alone(self) -> Carom:
        """Practice of the player at turn: the same kind of game without an end, with the same ball."""
        one = (0,)
        return Carom(
            kind=self.kind, players=("Practice",), target=0, alone_with=self.cue, opening=False, points=one,
            innings=(1,), high_runs=one, safeties=one, won=one,
        )  # fmt: skip

    def check_playable(self) -> None:
        """ValueError if no stroke may be played now."""
        if self.ended:
            raise ValueError("game: it is over")
        if self.options:
            raise ValueError(f"game: {self.shooter} must choose first")


def _with(row: tuple[int, ...], player: int, value: int) -> tuple[int, ...]:
    """A tuple with one number changed."""
    return tuple(value if k == player else old for k, old in enumerate(row))

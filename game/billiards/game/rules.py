"""What all games share: the summary of a shot, fouls in words, verdicts, and the state of a game.

No screen and no physics: a game is given what a stroke did (`ShotSummary`, made from a played shot by
`game.billiards.game.summary`), and says what follows (`Verdict`). Games are immutable values; the one before
a stroke is the one to go back to, and msgspec writes any of them to a file. Each game has its own module in
`game.billiards.game.games`.

Rules are those of the World Pool-Billiard Association (the rules of play of 2016); numbers such as 6.2 are
theirs.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import msgspec

CUE_BALL = 0
NEEDED_AT_BREAK = 4  # object balls that reach a cushion, if none goes down (2.3, 3.3)
MOST_FOULS = 3  # in a row lose a rack of nine-ball (2.8)

Hand = Literal["", "behind the line", "anywhere", "in the D"]


class Pocketing(NamedTuple):
    """A numbered ball that went down: into which pocket, and how it was sent there.

    chain: the balls from the cue ball (0) to this one in order of contact; empty: not known. cushions: how
    often it touched cushions and jaws on its path; rails: cushions off which it came, those in the mouth of
    its pocket left out.
    """

    ball: int
    pocket: int
    chain: tuple[int, ...] = ()
    cushions: int = 0
    rails: int = 0


class ShotSummary(NamedTuple):
    """What a stroke did, as the referee sees it. Balls by their numbers, the cue ball is 0.

    first: the balls that the cue ball touched first, several if at one moment. pocketed: numbered balls in
    order. cue_pocketed: the cue ball went down. cushioned: balls that were driven to a cushion after the
    first contact, each once, in order. off_table: balls that left the table, the cue ball among them.
    cue_path: what the cue ball touched, ("ball" or "cushion", number), in order. touched: numbered balls that
    any ball touched, in order. rest: (ball, x, y) m of what lies on the table in the end. short: the first
    ball lay behind the head string, and the cue ball had not crossed it before.
    """

    first: tuple[int, ...] = ()
    pocketed: tuple[Pocketing, ...] = ()
    cue_pocketed: bool = False
    cushioned: tuple[int, ...] = ()
    off_table: tuple[int, ...] = ()
    cue_path: tuple[tuple[str, int], ...] = ()
    touched: tuple[int, ...] = ()
    rest: tuple[tuple[int, float, float], ...] = ()
    short: bool = False

    @property
    def cue_lost(self) -> bool:
        """True if the cue ball is not on the table any more: it went down, or left it."""
        return self.cue_pocketed or CUE_BALL in self.off_table

    @property
    def numbered_off(self) -> tuple[int, ...]:
        """Numbered balls that left the table."""
        return tuple(ball for ball in self.off_table if ball != CUE_BALL)

    @property
    def balls_down(self) -> tuple[int, ...]:
        """Numbers of the pocketed balls, in order."""
        return tuple(fallen.ball for fallen in self.pocketed)

    def pocketing(self, ball: int) -> Pocketing | None:
        """How a ball went down; None if it did not."""
        return next((fallen for fallen in self.pocketed if fallen.ball == ball), None)


class Call(NamedTuple):
    """What the shooter announces: ball and pocket (None: nothing), or a safety, or a push-out."""

    ball: int | None = None
    pocket: int | None = None
    safety: bool = False
    push_out: bool = False


class Foul(NamedTuple):
    """A foul: its kind, one of FOULS, and what happened in words."""

    kind: str
    words: str


FOULS = (
    "scratch", "off the table", "no contact", "wrong ball", "behind the line", "no cushion", "break",
    "three in a row",
)  # fmt: skip


class Option(NamedTuple):
    """One of several ways to go on, that a player chooses: `name` for `Game.choose`, words for people."""

    name: str
    words: str


class Verdict(NamedTuple):
    """What follows from a stroke, or from a choice.

    game: the state to go on with. fouls: of this stroke. scored: balls that count for the shooter. words:
    messages in order, fouls among them, the last says what follows. spot: balls to be put back on the foot
    spot. rack: all balls are to be racked again; the cue ball is in hand behind the line. reset: all balls
    are to be put back where they were before the stroke. places: ball, x, y m, where all balls are to be put.
    """

    game: Game
    fouls: tuple[Foul, ...] = ()
    scored: tuple[int, ...] = ()
    words: tuple[str, ...] = ()
    spot: tuple[int, ...] = ()
    rack: bool = False
    reset: bool = False
    places: tuple[tuple[int, float, float], ...] = ()

    @property
    def legal(self) -> bool:
        """True if the stroke had no foul."""
        return not self.fouls


class Game(msgspec.Struct, frozen=True, kw_only=True, tag_field="game"):
    """A game between two players, or of one, before a stroke.

    turn: who plays (or chooses). on_table: numbered balls in play. in_hand: where the cue ball may be put,
    "" if it stays. opening: the next stroke is the break. options: ways to go on of which the player at turn
    must choose one before anybody plays. winner: None while the rack goes on. fouls_in_row, won: of each
    player; won counts racks.
    """

    players: tuple[str, ...] = ("Player 1", "Player 2")
    turn: int = 0
    on_table: tuple[int, ...] = ()
    in_hand: Hand = ""
    opening: bool = False
    options: tuple[Option, ...] = ()
    winner: int | None = None
    fouls_in_row: tuple[int, ...] = (0, 0)
    won: tuple[int, ...] = (0, 0)
    breaker: int = 0

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
        """True if the rack has been won."""
        return self.winner is not None

    @property
    def final(self) -> bool:
        """True if strokes count for good, so that none is taken back."""
        return False

    @property
    def set_over(self) -> bool:
        """True if the last rack of a set of racks has been played, where the game has sets."""
        return False

    def legal_first(self) -> tuple[int, ...]:
        """Numbers of the balls that the cue ball may touch first."""
        return self.on_table

    @property
    def from_behind(self) -> bool:
        """True if the cue ball is played from behind the line, and must meet no ball first that lies there,
        too (6.11).
        """
        return self.in_hand == "behind the line"

    def barred(self) -> tuple[int, ...]:
        """Numbers of the balls that lose the rack if they go down now."""
        return ()

    def targets(self) -> tuple[int, ...]:
        """Numbers of the balls that would count for the shooter if they went down now."""
        return self.on_table

    def needs_call(self) -> bool:
        """True if the next stroke scores only with ball and pocket called."""
        return False

    def may_push_out(self) -> bool:
        """True if the next stroke may be a push-out."""
        return False

    def judge(self, shot: ShotSummary, call: Call = Call()) -> Verdict:  # noqa: B008  (immutable)
        """What follows from a stroke. ValueError if the rack is over, or a choice is open."""
        raise NotImplementedError

    def choose(self, name: str) -> Verdict:
        """What follows from the player at turn choosing the option of that name; ValueError if none is."""
        self.check_option(name)
        raise NotImplementedError

    def next_rack(self) -> Verdict:
        """The next rack of the same players, who break in turns. ValueError if a game has none."""
        raise NotImplementedError

    def check_playable(self) -> None:
        """ValueError if no stroke may be played now."""
        if self.over:
            raise ValueError("game: the rack is over")
        if self.options:
            raise ValueError(f"game: {self.shooter} must choose first")

    def check_option(self, name: str) -> None:
        """ValueError if the player at turn has no such option."""
        names = [option.name for option in self.options]
        if name not in names:
            raise ValueError(f"game option {name!r}: {', '.join(names) or 'there is nothing to choose'}")


def common_fouls(game: Game, shot: ShotSummary, allowed: tuple[int, ...], push_out: bool) -> tuple[Foul, ...]:
    """Fouls of every game: scratch (6.1), wrong ball first (6.2), no cushion (6.3), off the table (6.5), and
    from behind the line a ball that lies there, too (6.11).

    allowed: balls that may be touched first. push_out: 6.2 and 6.3 do not hold.
    """
    fouls = []
    if shot.cue_pocketed:
        fouls.append(Foul("scratch", "The cue ball went down."))
    fouls += [Foul("off the table", f"The {named(ball)} left the table.") for ball in shot.off_table]
    if push_out:
        return tuple(fouls)
    fouls += contact_fouls(game, shot.first, shot.short, allowed)
    reached = shot.pocketed or shot.cushioned or shot.cue_pocketed or shot.off_table
    if shot.first and not reached:
        fouls.append(Foul("no cushion", "After the contact no ball went down and none reached a cushion."))
    return tuple(fouls)


def contact_fouls(
    game: Game, first: tuple[int, ...], short: bool, allowed: tuple[int, ...]
) -> tuple[Foul, ...]:
    """What is wrong with the first contact: no ball, the wrong one (6.2), or one behind the line (6.11).

    first, short: as in `ShotSummary`; allowed: balls that may be touched first.
    """
    if not first:
        return (Foul("no contact", "The cue ball touched no ball."),)
    fouls = []
    if not any(ball in allowed for ball in first):
        fouls.append(Foul("wrong ball", f"The {named(first[0])} was hit first, not {listed(allowed)}."))
    if short and game.from_behind:
        fouls.append(Foul("behind the line", f"The {named(first[0])} lies behind the line, too."))
    return tuple(fouls)


def remaining(game: Game, shot: ShotSummary) -> tuple[int, ...]:
    """Numbered balls left on the table."""
    gone = {*shot.balls_down, *shot.off_table}
    return tuple(ball for ball in game.on_table if ball not in gone)


def counted_fouls(game: Game, foul: bool) -> tuple[int, ...]:
    """Fouls in a row of each player after a stroke of the one at turn."""
    row = list(game.fouls_in_row)
    row[game.turn] = row[game.turn] + 1 if foul else 0
    return tuple(row)


def rack_won(game: Game, winner: int) -> tuple[int, ...]:
    """Racks won by each player, with one more for the winner."""
    return tuple(count + (player == winner) for player, count in enumerate(game.won))


def driven_to_cushions(shot: ShotSummary) -> int:
    """How many numbered balls were driven to a cushion."""
    return sum(1 for ball in shot.cushioned if ball != CUE_BALL)


def named(ball: int) -> str:
    """A ball in words."""
    return "cue ball" if ball == CUE_BALL else str(ball)


def listed(balls: tuple[int, ...]) -> str:
    """Balls in words: the 1, the 5 or the 9 to 15."""
    runs: list[list[int]] = []
    for ball in balls:
        if runs and runs[-1][-1] == ball - 1:
            runs[-1].append(ball)
        else:
            runs.append([ball])
    words = []
    for run in runs:
        single = [f"the {named(ball)}" for ball in run]
        words += single if len(run) < 3 else [f"the {run[0]} to {run[-1]}"]
    return " or ".join([", ".join(words[:-1]), words[-1]]) if len(words) > 1 else "".join(words) or "no ball"

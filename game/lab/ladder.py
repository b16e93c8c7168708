"""How strong the players of the ladder are: they play each other, and ratings explain who won.

    python -m game.lab.ladder --billiards 20 --carom 20 --snooker 8

Those meet that stand next, or next but one, to each other on the ladder. Each pair plays until it has so many
games in that family. The count is kept in assets/ladder.json, to which a further run adds. A game is a rack
of eight-ball, a frame of six-red snooker, or three-cushion to four points (a draw is played again); who
breaks alternates. What comes out depends on games and seeds only.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import msgspec

from game.billiards.game.carom_frame import CaromFrame, points_of
from game.billiards.game.frame import new_frame
from game.billiards.game.games import EightBall
from game.billiards.game.games.carom import Carom
from game.billiards.game.rules import CUE_BALL
from game.billiards.game.snooker.frame import new_snooker_frame
from game.billiards.game.snooker.rules import new_snooker
from game.billiards.players import carom as carom_players_of
from game.billiards.players import snooker as snooker_players_of
from game.billiards.players.graded import carom_players, pool_players, snooker_players
from game.billiards.players.ladder import CAROM, FAMILIES, POOL, SNOOKER, ladder_of
from game.billiards.players.ladder_ratings import FILE_NAME, Count, LadderGames, read_games
from game.billiards.players.opponents import decide, stroke_of_hand
from game.billiards.players.taste import SAFETY
from game.billiards.table.table import Table
from game.files import write_text
from game.folders import data_folder

MOST_STROKES = 300
CAROM_POINTS = 4
BANKS = ("bank", "kick")


class Told(NamedTuple):
    """What a player thought of a stroke: its kind, and the chance it gave it."""

    player: str
    kind: str
    chance: float


class Game(NamedTuple):
    """A game: who won it, None for neither; what both thought of each stroke."""

    winner: str | None
    strokes: tuple[Told, ...]


def play_game(family: str, players: tuple[str, str], seed: int) -> Game:
    """A game between two players of the ladder; the first breaks. ValueError for an unknown family."""
    if family not in PLAYED:
        raise ValueError(f"family: {family!r}, expected one of {', '.join(FAMILIES)}")
    return PLAYED[family](players, seed)


class Called(NamedTuple):
    """A game with pots, of either table: its beginning, and what differs between pool and snooker.

    decide: (frame, grade, seed) to a decision. choose: (frame, option, seed) to the frame after it.
    hand: (frame, stroke, grade, seed) to the stroke as the hand does it. settled: the frame for the next
    stroke. put: (frame, x, y) with the cue ball there.
    """

    frame: Any
    grades: tuple[Any, ...]
    decide: Callable[[Any, Any, int], Any]
    choose: Callable[[Any, str, int], Any]
    hand: Callable[[Any, Any, Any, int], Any]
    settled: Callable[[Any], Any]
    put: Callable[[Any, float, float], Any]


def _pool(players: tuple[str, str], seed: int) -> Game:
    frame = new_frame(EightBall(players=players), seed=seed)
    return _called(players, seed, Called(
        frame, tuple(pool_players()[name] for name in players),
        lambda frame, grade, mine: decide(frame, grade, mine, threads=1),
        lambda frame, option, mine: frame.choose(option, mine),
        lambda frame, stroke, grade, mine: stroke_of_hand(
            stroke, grade, mine, float(frame.layout.balls.radii[CUE_BALL])
        ),
        lambda frame: frame,
        lambda frame, x, y: frame.place_cue_ball(x, y),
    ))  # fmt: skip


def _snooker(players: tuple[str, str], seed: int) -> Game:
    def choose(frame: Any, option: str, mine: int) -> Any:
        if option == "concede":
            return frame.ruled(frame.snooker.concede())
        return frame.choose(option).with_cue_ball()

    return _called(players, seed, Called(
        new_snooker_frame(new_snooker(players, 6, lot=seed)),
        tuple(snooker_players()[name] for name in players),
        lambda frame, grade, mine: snooker_players_of.decide_snooker(frame, grade, mine, threads=1),
        choose,
        lambda frame, stroke, grade, mine: snooker_players_of.hand_of(stroke, grade, mine),
        lambda frame: frame.with_cue_ball(),
        lambda frame, x, y: frame.move_cue_ball(x, y),
    ))  # fmt: skip


def _called(players: tuple[str, str], seed: int, game: Called) -> Game:
    """Play a game with pots to its end."""
    frame, told = game.frame, []
    for turn in range(MOST_STROKES):
        if frame.game.over:
            break
        mine = seed * 100_003 + turn
        grade = game.grades[frame.game.turn]
        made = game.decide(frame, grade, mine)
        if made.option:
            frame = game.choose(frame, made.option, mine)
            continue
        if made.place is not None:
            frame = game.put(frame, *made.place)
        assert made.stroke is not None
        if made.kind:
            told.append(Told(grade.name, made.kind, made.chance))
        stroke = game.hand(frame, made.stroke, grade, mine + 50_021)
        frame = game.settled(frame.play(stroke, made.call).frame)
    winner = frame.game.winner
    return Game(None if winner is None else players[winner], tuple(told))


def _carom(players: tuple[str, str], seed: int) -> Game:
    grades = tuple(carom_players()[name] for name in players)
    game = Carom(players=players, target=CAROM_POINTS)
    frame = CaromFrame(game, points_of(game.start()), Table.carom())
    told = []
    for turn in range(MOST_STROKES):
        if frame.game.ended:
            break
        grade = grades[frame.game.turn]
        made = carom_players_of.decide_carom(frame, grade)
        if made.stroke is None:
            frame = frame.choose(made.option)
            continue
        if made.choices:
            group = made.choices[0].group
            cushions = carom_players_of.cushions_of(group.code)
            told.append(Told(grade.name, "bank" if cushions > 3 else "direct", group.chance))
        stroke = carom_players_of.hand_of(made.stroke, grade, seed * 100_003 + turn)
        frame = frame.play(stroke).frame
    winner = frame.game.winner
    return Game(None if winner is None else players[winner], tuple(told))


PLAYED: dict[str, Callable[[tuple[str, str], int], Game]] = {POOL: _pool, SNOOKER: _snooker, CAROM: _carom}


class Style(NamedTuple):
    """How a player plays: strokes, shares of safeties and of ways by cushions, mean chance of its pots."""

    strokes: int
    safeties: float
    banks: float
    chance: float


def style_of(told: list[Told]) -> Style:
    """The style that strokes of one player show. ValueError without strokes."""
    if not told:
        raise ValueError("style: no strokes")
    kinds = Counter(one.kind for one in told)
    pots = [one.chance for one in told if one.kind != SAFETY]
    banks = sum(kinds[kind] for kind in BANKS)
    return Style(
        len(told), kinds[SAFETY] / len(told), banks / len(told), sum(pots) / len(pots) if pots else 0.0
    )


def pairs_of(family: str) -> list[tuple[str, str]]:
    """Who meets whom: those that stand next, or next but one, to each other."""
    names = [player.name for player in ladder_of(family)]
    return [(names[i], names[j]) for i in range(len(names)) for j in range(i + 1, min(i + 3, len(names)))]


def rounds(known: LadderGames, games: dict[str, int]) -> Iterator[tuple[str, tuple[str, str], int]]:
    """What is left to be played: family, players, number of the game. games: wanted of each family."""
    played = Counter({(one.family, *one.players): one.won[0] + one.won[1] for one in known.counts})
    for number in range(max(games.values())):
        for family in FAMILIES:
            for pair in pairs_of(family):
                if played[family, *pair] <= number < games[family]:
                    yield family, pair, number


def add(known: LadderGames, family: str, pair: tuple[str, str], winner: str) -> LadderGames:
    """The count with one game more."""
    counts = list(known.counts)
    places = [k for k, one in enumerate(counts) if (one.family, one.players) == (family, pair)]
    place = places[0] if places else len(counts)
    won = counts[place].won if places else (0, 0)
    one = Count(family, pair, (won[0] + (winner == pair[0]), won[1] + (winner == pair[1])))
    counts[place : place + 1] = [one]
    return LadderGames(known.command, tuple(counts))


def save(games: LadderGames, path: Path) -> None:
    """Write the count. FileProblem if that fails."""
    lines = ",\n".join("  " + msgspec.json.encode(one).decode() for one in sorted(games.counts))
    head = msgspec.json.encode(games.command).decode()
    write_text(path, f'{{\n "command": {head},\n "counts": [\n{lines}\n ]\n}}\n')


def main() -> None:
    """Play what is left, and keep the count after each game."""
    parser = argparse.ArgumentParser(description="matches of the ladder")
    for family in FAMILIES:
        parser.add_argument(f"--{family}", type=int, default=0, metavar="N", help="games of each pair")
    parser.add_argument("--out", type=Path, default=data_folder("assets") / FILE_NAME)
    chosen = parser.parse_args()
    games = {family: int(getattr(chosen, family)) for family in FAMILIES}
    known = read_games(chosen.out) if chosen.out.exists() else LadderGames("", ())
    asked = " ".join(f"--{family} {number}" for family, number in games.items() if number)
    known = known._replace(command=f"python -m game.lab.ladder {asked}")
    for family, pair, number in rounds(known, games):
        game = Game(None, ())
        for again in range(10):
            first, second = pair if number % 2 == 0 else pair[::-1]
            game = play_game(family, (first, second), 1000 * again + number)
            if game.winner is not None:
                break
        if game.winner is not None:
            known = add(known, family, pair, game.winner)
            save(known, chosen.out)


if __name__ == "__main__":
    main()

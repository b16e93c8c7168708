"""How the game stands, in words: who plays, with what, what each player does, the score."""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.game.games import (
    CombinationMatch,
    Drill,
    EightBall,
    Ghost,
    NineBall,
    Practice,
    RunDrill,
    StraightPool,
    TenBall,
)
from game.billiards.game.games.eight_ball import GROUPS
from game.billiards.game.games.rotation import Rotation
from game.billiards.game.rules import Game, listed
from game.billiards.players.ladder import BY_NAME
from game.scenes.billiards.play import REPLAY, ROLLING, SET_UP, STRIKING, Play
from game.scenes.billiards.practice.sets import GHOST_TITLES
from game.scenes.shared.tables.seats.cup import with_round
from game.scenes.shared.thinker import Thinker

GAME_TITLES = {
    EightBall: "8-ball", NineBall: "9-ball", TenBall: "10-ball", StraightPool: "Straight pool",
    CombinationMatch: "Combination", Practice: "Practice", Drill: "Drill", RunDrill: "Drill",
}  # fmt: skip
MOST_CHIPS = 9


class Card(NamedTuple):
    """What the card of a player says. lit: at turn, or the winner. chips: balls; those gone are ticked."""

    name: str
    status: str
    lit: bool
    chips: tuple[tuple[int, bool], ...] = ()


class Standing(NamedTuple):
    """All that the board says."""

    title: str
    under: str
    cards: tuple[Card, ...]
    score: str
    caption: str


def standing_of(play: Play, thinker: Thinker, title: str = "") -> Standing:
    """How the game stands. title: of the level, which names a drill."""
    game = play.model.frame.game
    game_title = GHOST_TITLES[game.discipline] if isinstance(game, Ghost) else GAME_TITLES.get(type(game), "")
    if play.phase == SET_UP:
        game_title, under = "Set up", "free placing"
    elif play.phase == REPLAY:
        under = "replay"
    else:
        under = _situation(game)
    if play.coached:
        under = "coached"
    if len(game.players) == 1:
        return Standing(game_title, under, (_single(game, title),), "", "")
    cards = tuple(_card(play, thinker, player) for player in range(2))
    score = f"{game.won[0]} : {game.won[1]}"
    caption = f"racks, race to {play.racks_to_win}" if play.racks_to_win else "racks"
    if isinstance(game, Ghost):
        caption = f"{sum(game.won)} of {game.racks} racks"
    if isinstance(game, CombinationMatch):
        score, caption = f"{game.points[0]} : {game.points[1]}", "balls"
    if isinstance(game, StraightPool):
        score = " : ".join(f"{n}".replace("-", "\u2212") for n in game.points)
        caption = f"points, race to {game.target}"
    return Standing(game_title, under, cards, score, with_round(caption, play))


def _situation(game: Game) -> str:
    if game.over:
        return "rack over"
    if game.opening:
        return "break"
    if isinstance(game, EightBall) and game.open_table:
        return "open table"
    return f"{len(game.on_table)} on the table"


def _card(play: Play, thinker: Thinker, player: int) -> Card:
    """The card of one of two players."""
    game = play.model.frame.game
    active = game.turn == player and not game.over
    won = game.over and game.winner == player
    prize = "won the match" if play.match_over and not isinstance(game, Ghost) else "won the rack"
    doing = _doing(play, thinker) if active else prize if won else ""
    parts = []
    chips: tuple[tuple[int, bool], ...] = ()
    if isinstance(game, EightBall) and game.groups[player]:
        group = GROUPS[game.groups[player]]
        left = game.balls_of(player)
        chips = tuple((ball, ball not in left) for ball in group)
        count = "" if doing else f", {len(left)} left"  # at the turn the chips alone tell it: space is scarce
        if not won:
            parts.append(f"{game.groups[player]}{count}" if left else "on the 8")
    elif (isinstance(game, Ghost) and game.group and active) or (
        isinstance(game, Rotation | Ghost) and active and not game.options and not game.opening
    ):
        parts.append(f"on {listed(game.legal_first())}")
    if isinstance(game, StraightPool):
        parts.append(
            f"run {game.run}, high {game.high[player]}" if active else f"high run {game.high[player]}"
        )
    if game.fouls_in_row[player] and isinstance(game, Rotation | StraightPool):
        parts.append(f"{game.fouls_in_row[player]} foul{'s' * (game.fouls_in_row[player] > 1)} in a row")
    run, longest = play.model.frame.tallies[player].run, play.model.frame.tallies[player].longest
    if active and run > 1:
        parts.append(f"run {run}")
    elif longest > 1 and not won:
        parts.append(f"high run {longest}")
    if doing:
        parts.insert(0, doing)  # first, since what is too long is cut at its end
    grade = play.grade_of(player)
    name = game.players[player]
    if grade in BY_NAME:
        name = BY_NAME[grade].title
    elif grade != "person":
        name = f"{name} ({grade})"
    return Card(name, " · ".join(parts), active or won, chips)


def _doing(play: Play, thinker: Thinker) -> str:
    """What the player at turn does."""
    game = play.model.frame.game
    if play.phase in (SET_UP, REPLAY):
        return ""
    if play.phase in (STRIKING, ROLLING):
        return "plays"
    if game.options:
        return "chooses"
    if play.plays_itself:
        return "plays by itself"
    if not play.person_plays:
        return "thinks" if thinker.warm else thinker.getting_ready
    if play.aiming.call.safety:
        return "plays safe"
    if play.aiming.call.push_out:
        return "pushes out"
    return "ball in hand" if game.in_hand else "aims"


def _single(game: Game, level_title: str) -> Card:
    """The card of the only player."""
    if isinstance(game, Drill):
        stars = "★" * game.best + "☆" * (1 + len(game.more) - game.best)
        tries = (
            f"{game.made} of {game.attempts} made, {game.streak} in a row" if game.attempts else "first try"
        )
        if game.tries:
            tries = f"{tries}   ·   {game.needed} of {game.tries} needed"
        return Card(level_title or game.players[0], f"{stars}   {tries}", True)
    if isinstance(game, RunDrill):
        tries = f"try {min(game.attempts + 1, game.tries or 1_000_000)}" + f" of {game.tries}" * (
            game.tries > 0
        )
        balls = f"{game.run} of {game.count} balls, best {max(game.best, game.run)}"
        needed = f"   ·   {game.potted} in all, {game.needed} needed" if game.tries else ""
        return Card(level_title or game.players[0], f"{tries}   {balls}{needed}", True)
    if isinstance(game, Practice):
        strokes = f"{game.strokes} stroke{'s' * (game.strokes != 1)}"
        status = f"{game.potted} potted with {strokes}, run of {game.run}"
        return Card(
            game.players[0], status, True, tuple((ball, False) for ball in game.on_table[:MOST_CHIPS])
        )
    return Card(game.players[0], "", True)

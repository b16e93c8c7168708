"""What a referee calls out after a stroke, from the rules' verdict: few words, as at a table."""

from __future__ import annotations

from typing import NamedTuple

from game.billiards.game.games.carom import Carom, CaromVerdict
from game.billiards.game.games.eight_ball import EIGHT, EightBall
from game.billiards.game.rules import Game, Verdict
from game.billiards.game.snooker.rules import REPLAY, Snooker
from game.billiards.table.snooker import BLACK, value_of

FOUL, SCORE, END = "foul", "score", "end"  # what a call is about
STILL = 3  # points to go from which on they are called
LEAST_RUN = 2  # balls of a run that is called


class Spoken(NamedTuple):
    """A call: its words, empty for none, and what it is about."""

    words: str = ""
    about: str = SCORE


def pool_call(verdict: Verdict, run: int, match_over: bool = False) -> Spoken:
    """At a pool table. run: balls of the player at turn since the last miss."""
    game = verdict.game
    if game.over and game.winner is not None and len(game.players) == 2:
        return Spoken(f"{game.players[game.winner]} wins the {'match' if match_over else 'rack'}", END)
    if verdict.fouls:
        hand = "ball in hand" if game.in_hand == "anywhere" else game.in_hand and f"in hand {game.in_hand}"
        return Spoken(_joined(f"Foul: {verdict.fouls[0].kind}", hand), FOUL)
    if not verdict.scored:
        return Spoken()
    return Spoken(
        _joined(f"Run of {run}" if run >= LEAST_RUN else "", "game ball" if game_ball(game) else "")
    )


def game_ball(game: Game) -> bool:
    """True if the one ball that the player at turn may pot next wins the rack."""
    if game.over or len(game.players) != 2:
        return False
    if isinstance(game, EightBall):
        return not game.open_table and tuple(game.legal_first()) == (EIGHT,)
    return len(game.on_table) == 1


def snooker_call(before: Snooker, verdict: Verdict) -> Spoken:
    """At a snooker table. before: the game as it was before the stroke."""
    game = verdict.game
    assert isinstance(game, Snooker)
    if game.over and game.winner is not None and len(game.players) == 2:
        what = "Frame and match" if game.match_over else "Frame"
        return Spoken(f"{what}, {game.players[game.winner]}", END)
    if verdict.fouls:
        given = sum(game.points) - sum(before.points)
        missed = any(option.name == REPLAY.name for option in game.options)
        free = "free ball" if game.free_ball else ""
        return Spoken(
            _joined(f"Foul, {given}" if given else "Foul", "and a miss" if missed else "", free), FOUL
        )
    if not verdict.scored:
        return Spoken()
    return Spoken(_joined(f"{game.run}", "frame ball" if frame_ball(game) else ""))


def frame_ball(game: Snooker) -> bool:
    """True if the next ball wins the frame: what the table then gives the other is less than the lead."""
    if game.over or len(game.players) != 2 or game.free_ball or not game.balls_on():
        return False
    lead = game.points[game.turn] - game.points[1 - game.turn]
    for_other = game.points_left - (value_of(BLACK) if game.stage == "colour" else 0)  # after a miss
    worth = min(value_of(ball) for ball in game.balls_on())
    gone = {"red": worth + value_of(BLACK), "colour": 0}.get(game.stage, worth)
    return lead <= for_other and lead + worth > for_other - gone


def carom_call(verdict: CaromVerdict) -> Spoken:
    """At a carom table: the points of the inning, and how many are still to go."""
    game: Carom = verdict.game
    if game.ended and len(game.players) == 2:
        return Spoken("Drawn" if game.winner is None else f"{game.players[game.winner]} wins", END)
    if verdict.fouls:
        return Spoken(f"Foul: {verdict.fouls[0].kind}", FOUL)
    if not verdict.scored:
        return Spoken()
    left = game.target - game.points[game.turn] if game.target and len(game.players) == 2 else 0
    return Spoken(_joined(f"{game.run}", f"and {left} to go" if 0 < left <= STILL else ""))


def _joined(*parts: str) -> str:
    """Parts that say something, with commas; the first letter is a capital."""
    words = ", ".join(part for part in parts if part).replace(", and ", " and ")
    return words[:1].upper() + words[1:]

"""What a level file of carom may say: the game, the players, where the balls lie, a saved game."""

from __future__ import annotations

from typing import Annotated, Any

import msgspec
import numpy as np

from game.billiards.game.carom_frame import Points, points_of
from game.billiards.game.games.artistic import AnyCarom, Artistic
from game.billiards.game.games.carom import Carom
from game.billiards.game.games.carom_kinds import Kind
from game.billiards.table.carom import BALL_RADIUS, CAROM_LENGTH, CAROM_WIDTH, RED, fits
from game.scenes.shared.tables.lessons.lesson import Lesson, check_goals
from game.scenes.shared.tables.seats.cup import Round

Name = Annotated[str, msgspec.Meta(min_length=1, max_length=16)]
Across = Annotated[float, msgspec.Meta(ge=0.0, le=CAROM_WIDTH)]  # m
Along = Annotated[float, msgspec.Meta(ge=0.0, le=CAROM_LENGTH)]  # m
Place = tuple[Across, Along]
ROUNDING = 1e-6  # m; balls that a stroke has left touching overlap by rounding


class CaromContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a level of carom.

    white, yellow, red: places (x, y) m; left out, all three lie in the starting position. practice: one
    player, without an end. cup: of which round of a cup the match is. lesson: what the level
    teaches, with one stroke at a time. saved: a game under way, as msgspec writes it.
    """

    game: Kind = "three-cushion"
    players: tuple[Name, Name] = ("Ada", "Ben")
    cup: Round = ""
    white: Place | None = None
    yellow: Place | None = None
    red: Place | None = None
    practice: bool = False
    lesson: Lesson | None = None
    saved: dict[str, Any] = {}


def game_of(content: CaromContent, target: int, innings: int) -> Carom:
    """The game that a level begins with. ValueError for a saved one that cannot be read."""
    if content.saved:
        return read_game(content.saved)
    if content.lesson is not None:
        check_goals(content.lesson.goals, RED)
    placed = content.white is not None
    if content.game == "artistic":
        match = Artistic(players=tuple(content.players))
        return match.alone() if content.practice or placed else match
    game = Carom(
        kind=content.game,
        players=tuple(content.players),
        target=target,
        most_innings=innings,
        opening=not placed,
    )
    return game.alone() if content.practice or content.lesson is not None else game


def read_game(saved: dict[str, Any]) -> Carom:
    """A game from what `msgspec.to_builtins` made of it. ValueError says what is wrong."""
    try:
        game: Carom = msgspec.convert(saved, AnyCarom)
    except (msgspec.ValidationError, TypeError) as error:
        raise ValueError(f"saved: {str(error).replace('`', '')}") from None
    count = len(game.players)
    if not 1 <= count <= 2:
        raise ValueError("saved.players: expected one or two names")
    for name in ("points", "innings", "high_runs", "safeties", "won"):
        if len(getattr(game, name)) != count:
            raise ValueError(f"saved.{name}: expected a number for each player")
    for name in ("turn", "breaker"):
        if not 0 <= getattr(game, name) < count:
            raise ValueError(f"saved.{name}: {getattr(game, name)} is no player")
    if game.alone_with not in (0, 1):
        raise ValueError(f"saved.alone_with: expected 0 or 1, got {game.alone_with}")
    return game


def places_of(content: CaromContent, game: Carom) -> Points:
    """Where white, yellow and red lie. ValueError if one is missing, outside, or in another."""
    given = (content.white, content.yellow, content.red)
    if all(place is None for place in given):
        return points_of(game.start())
    for name, place in zip(("white", "yellow", "red"), given, strict=True):
        if place is None:
            raise ValueError(f"{name}: give the places of all three balls, or of none")
    places = np.array(given, dtype=np.float64)
    inset = np.clip(places, BALL_RADIUS, (CAROM_WIDTH - BALL_RADIUS, CAROM_LENGTH - BALL_RADIUS))
    if float(np.abs(inset - places).max()) > ROUNDING:
        raise ValueError("white, yellow, red: a ball lies in a cushion")
    middle = inset.mean(axis=0)
    if not fits(middle + (inset - middle) * (1.0 + 1e-4)) and not fits(inset):
        raise ValueError("white, yellow, red: two balls lie in each other")
    return points_of(inset)


def begun(content: CaromContent, target: int, innings: int) -> tuple[Carom, Points]:
    """Game and places that a level begins with; who plays may have to choose first. ValueError as above."""
    game = game_of(content, target, innings)
    places = places_of(content, game)
    if content.saved:
        return game, places
    return game.coming_to(np.array(places)).facing(np.array(places)), places

"""What a level file of snooker may say: the game, the players, the balls, what is on, a saved game."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import msgspec

from game.billiards.game.rules import CUE_BALL
from game.billiards.game.snooker.rules import Snooker, new_snooker
from game.billiards.game.snooker.sight import Places
from game.billiards.table.snooker import (
    BALL_RADIUS,
    COLOURS,
    RED_NUMBERS,
    SPOTS,
    opening_places,
)
from game.billiards.table.table import SNOOKER_LENGTH, SNOOKER_WIDTH
from game.physics.kernels import elementary
from game.scenes.shared.tables.lessons.lesson import Lesson, check_goals
from game.scenes.shared.tables.seats.cup import Round

MOUTH = 0.045  # m; a ball may stand so far outside the noses' lines, in a pocket's mouth
OVERLAP = 1e-6  # m; balls that a stroke has left touching overlap by rounding
Coordinate = Annotated[float, msgspec.Meta(ge=-1.0, le=5.0)]  # m
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=16)]
Number = Annotated[int, msgspec.Meta(ge=0, le=COLOURS[-1])]
Points = Annotated[int, msgspec.Meta(ge=0, le=400)]


class PlacedBall(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """A ball on the table: its number (0 cue ball, 1 to 15 reds, 16 to 21 yellow to black), its place, m."""

    number: Number
    position: tuple[Coordinate, Coordinate]


class SnookerContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a level of snooker.

    cup: of which round of a cup the match is.
    balls: where they lie; left out, all are set up for the break-off. spotted: colours on their spots
    besides. after_red: a colour is on. free_ball: the striker has one. points: of both at the start.
    practice: one player; drill: a break that a miss ends, one pot, or one ball on to be hit, again and
    again. lesson: what the level teaches, with one stroke at a time.
    saved: a game under way, as msgspec writes it; put_back: where the balls lay before a miss in it.
    """

    game: Literal["snooker", "six-red"] = "snooker"
    players: tuple[Name, Name] = ("Ada", "Ben")
    cup: Round = ""
    balls: Annotated[list[PlacedBall], msgspec.Meta(max_length=22)] = []
    spotted: tuple[Number, ...] = ()
    after_red: bool = False
    free_ball: bool = False
    points: tuple[Points, Points] = (0, 0)
    practice: bool = False
    drill: Literal["", "break", "pot", "escape"] = ""
    lesson: Lesson | None = None
    saved: dict[str, Any] = {}
    put_back: Annotated[list[PlacedBall], msgspec.Meta(max_length=22)] = []


def game_of(content: SnookerContent, places: Places | None, lot: int) -> Snooker:
    """The game that a level begins with. ValueError for a saved one that cannot be read, or a
    contradiction.
    """
    if content.saved:
        return read_game(content.saved)
    drill = "pot" if content.lesson is not None else content.drill
    alone = content.practice or bool(drill)
    if content.lesson is not None:
        check_goals(content.lesson.goals, COLOURS[-1])
    players = ("Player",) if alone else tuple(content.players)
    game = new_snooker(players, 6 if content.game == "six-red" else 15, lot=lot)
    if places is None:
        if content.after_red or content.free_ball or drill or any(content.points):
            raise ValueError("balls: give their places, if a frame is to begin in its midst")
        return game
    numbers = tuple(sorted(ball for ball in places if ball != CUE_BALL))
    if not numbers:
        raise ValueError("balls: expected an object ball")
    reds = any(ball in RED_NUMBERS for ball in numbers)
    if reds and not set(COLOURS) <= set(numbers) and not alone:
        raise ValueError("balls: while there are reds, all six colours are on the table")
    stage = "colour" if content.after_red else "red" if reds else "order"
    return msgspec.structs.replace(
        game, on_table=numbers, opening=False, in_hand="" if CUE_BALL in places else "in the D", stage=stage,
        free_ball=content.free_ball, points=(0,) if alone else content.points, drill=drill,
    )  # fmt: skip


def read_game(saved: dict[str, Any]) -> Snooker:
    """A game from what `msgspec.to_builtins` made of it. ValueError says what is wrong."""
    try:
        game = msgspec.convert(saved, Snooker)
    except (msgspec.ValidationError, TypeError) as error:
        raise ValueError(f"saved: {str(error).replace('`', '')}") from None
    count = len(game.players)
    if not 1 <= count <= 2:
        raise ValueError("saved.players: expected one or two names")
    for name in ("points", "high", "won", "fouls_in_row"):
        if len(getattr(game, name)) != count:
            raise ValueError(f"saved.{name}: expected a number for each player")
    for name in ("turn", "breaker"):
        if not 0 <= getattr(game, name) < count:
            raise ValueError(f"saved.{name}: {getattr(game, name)} is no player")
    if game.winner is not None and not 0 <= game.winner < count:
        raise ValueError(f"saved.winner: {game.winner} is no player")
    if game.reds not in (15, 10, 6):
        raise ValueError(f"saved.reds: expected 15, 10 or 6, got {game.reds}")
    if any(not 1 <= ball <= COLOURS[-1] for ball in game.on_table) or len(set(game.on_table)) != len(
        game.on_table
    ):
        raise ValueError(f"saved.on_table: expected different numbers from 1 to {COLOURS[-1]}")
    if not game.over and not game.balls_on():
        raise ValueError(f"saved.stage: no ball is on in the stage {game.stage!r}")
    return game


def places_of(content: SnookerContent) -> Places | None:
    """Where the balls of a level lie, m by number; None: as before the break-off. ValueError for a ball
    that is there twice, outside or in another.
    """
    if not content.balls and not content.spotted:
        return None
    places: Places = {}
    given = [(ball.number, ball.position) for ball in content.balls]
    for number in content.spotted:
        if number not in COLOURS:
            raise ValueError(f"spotted: {number} is no colour (16 to 21)")
    for number, at in (*given, *((number, SPOTS[number]) for number in content.spotted)):
        if number in places:
            raise ValueError(f"balls: number {number} is there twice")
        _check_place(places, number, at)
        places[number] = at
    return dict(sorted(places.items()))


def _check_place(places: Places, number: int, at: tuple[float, float]) -> None:
    """ValueError for a ball beyond the cushions' noses, or in another."""
    x, y = at
    if not (-MOUTH <= x <= SNOOKER_WIDTH + MOUTH and -MOUTH <= y <= SNOOKER_LENGTH + MOUTH):
        raise ValueError(f"balls: number {number} at {at} lies outside")
    for other, (px, py) in places.items():
        if elementary.hypot(x - px, y - py) < 2.0 * BALL_RADIUS - OVERLAP:
            raise ValueError(f"balls: number {number} at {at} lies in number {other}")


def begun(content: SnookerContent, lot: int) -> tuple[Snooker, Places]:
    """Game and places that a level begins with. ValueError if they contradict each other."""
    places = places_of(content)
    game = game_of(content, places, lot)
    if places is None:
        return game, opening_places(game.reds)
    if {ball for ball in places if ball != CUE_BALL} != set(game.on_table):
        raise ValueError("saved.on_table: not the balls that lie on the table")
    if CUE_BALL not in places and not game.in_hand and not game.over:
        raise ValueError("balls: expected the cue ball (number 0)")
    return game, places

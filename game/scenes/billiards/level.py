"""What a level file of the billiard table may say: the game, the players, the balls, a goal, a saved game."""

from __future__ import annotations

import math
from typing import Annotated, Any, Literal

import msgspec
import numpy as np

from game.billiards.game.arrangement import Arrangement, BallSet, Stroke
from game.billiards.game.frame import BestStroke, Frame, rack_for
from game.billiards.game.games import GAMES, AnyGame, Drill, Ghost, RunDrill, StraightPool
from game.billiards.game.games.ghost import GHOST
from game.billiards.game.games.straight_pool import TARGET
from game.billiards.game.goals import Goal
from game.billiards.game.rules import CUE_BALL, Call, Game
from game.billiards.game.tally import Tally
from game.billiards.shot.balls import OVERLAP
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS
from game.billiards.table.table import Table
from game.physics.kernels import elementary, linear
from game.scenes.shared.tables.lessons.lesson import Solution, check_goals
from game.scenes.shared.tables.seats.cup import Round
from game.worlds.entries.entry import LevelEntry

# the cushions' model needs a nose below the top of every ball, 1.27 R0 < 2 R: R > 0.635 R0
MOST_RADIUS_SPREAD = 0.35
LARGEST = 15  # number of a ball at pool
MOUTH = 0.045  # m; a ball may stand so far outside the noses' lines, in a pocket's mouth
Coordinate = Annotated[float, msgspec.Meta(ge=-1.0, le=5.0)]  # m
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=16)]


class PlacedBall(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """A ball on the table: its number (0 is the cue ball) and its place, m."""

    number: Annotated[int, msgspec.Meta(ge=0, le=15)]
    position: tuple[Coordinate, Coordinate]


class BestPlayed(LevelEntry, frozen=True, kw_only=True):
    """The best stroke of a rack so far, as it can be played again: where the balls lay, the game then as
    msgspec writes it, the stroke (m/s, rad, rad, radii, radii) and what was called."""

    balls: Annotated[list[PlacedBall], msgspec.Meta(min_length=1, max_length=16)]
    game: dict[str, Any]
    stroke: tuple[float, float, float, float, float]
    ball: Annotated[int, msgspec.Meta(ge=1, le=15)] | None = None
    pocket: Annotated[int, msgspec.Meta(ge=0, le=5)] | None = None
    safety: bool = False
    push_out: bool = False


class BilliardsContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a billiards level.

    cup: of which round of a cup the match is.
    target: points that win a game of straight pool. alternating: in a combination match players take turns
    also after a stroke that counted.
    balls: where they lie; left out, they are racked. goal, more, solution: of a drill or a puzzle, `more` for
    the second and third star. lesson: what a drill teaches, in a sentence. in_hand: the cue ball may be moved
    before each try. tries, needed: a drill is met if so many of so many tries meet its goal (0: there are no
    sets); of a run-drill, `needed` are balls.
    ordered, pocket, off_cushions: see `RunDrill`. log: see practice/log_text.py. saved: a game under way, as
    msgspec writes it; tallies: what has been counted of its players; best: the best stroke of the rack.
    """

    game: Literal[
        "eight-ball", "nine-ball", "ten-ball", "straight-pool", "combination", "practice", "drill",
        "run-drill", "ghost-nine-ball", "ghost-ten-ball", "ghost-eight-ball",
    ] = "eight-ball"  # fmt: skip
    players: tuple[Name, Name] = ("Ada", "Ben")
    cup: Round = ""
    calling: Literal["all", "eight", "none"] = "none"
    alternating: bool = False
    target: Annotated[int, msgspec.Meta(ge=1, le=1000)] = TARGET
    balls: Annotated[list[PlacedBall], msgspec.Meta(max_length=16)] = []
    goal: Goal | None = None
    more: Annotated[list[Goal], msgspec.Meta(max_length=2)] = []
    lesson: Annotated[str, msgspec.Meta(max_length=120)] = ""
    solution: Solution | None = None
    in_hand: Literal["", "behind the line", "anywhere"] = ""
    tries: Annotated[int, msgspec.Meta(ge=0, le=100)] = 0
    needed: Annotated[int, msgspec.Meta(ge=0, le=1500)] = 0
    ordered: bool = False
    pocket: Annotated[int, msgspec.Meta(ge=0, le=5)] | None = None
    off_cushions: bool = False
    log: Annotated[str, msgspec.Meta(max_length=400_000)] = ""
    saved: dict[str, Any] = {}
    tallies: tuple[Tally, Tally] = (Tally(), Tally())
    rack_tallies: tuple[Tally, Tally] = (Tally(), Tally())
    best: BestPlayed | None = None


def ball_set(radius_spread: float, mass_spread: float, seed: int) -> BallSet:
    """Radii and masses of the balls; spreads (0 to MOST_RADIUS_SPREAD, 0 to 0.9) vary the numbered ones by
    the seed."""
    radii, masses = np.full(16, BALL_RADIUS), np.full(16, BALL_MASS)
    if radius_spread or mass_spread:
        random = np.random.default_rng((seed, 16))
        # the largest ball keeps the pool measure, so that every ball fits through the pockets
        radii[1:] *= 1.0 - radius_spread * linear.uniform(random, 0.0, 1.0, 15)
        masses[1:] *= elementary.cube(radii[1:] / BALL_RADIUS) * (
            1.0 + mass_spread * linear.uniform(random, -1.0, 1.0, 15)
        )
    return BallSet(radii, masses)


def game_of(content: BilliardsContent) -> AnyGame:
    """The game that a level begins with. ValueError for a saved one that cannot be read."""
    if content.saved:
        return read_game(content.saved)
    numbers = tuple(sorted(ball.number for ball in content.balls if ball.number != CUE_BALL))
    placed = bool(content.balls)
    most = content.tries * (len(numbers) if content.game == "run-drill" else 1)
    if content.needed > most:
        raise ValueError(f"needed: {content.needed} of {most} cannot be met")
    if content.game == "drill":
        if not content.goal or not placed:
            raise ValueError("goal: a drill needs a goal, and balls")
        check_goals((content.goal, *content.more), LARGEST)
        return Drill(
            goal=content.goal, more=tuple(content.more), set_up=numbers, on_table=numbers,
            in_hand=content.in_hand, tries=content.tries, needed=content.needed,
        )  # fmt: skip
    if content.game == "run-drill":
        return _run_drill(content, numbers)
    if content.goal is not None:
        raise ValueError(f"goal: only a drill has one, not {content.game}")
    game: Any = GAMES[content.game]()
    if isinstance(game, Ghost):
        game = msgspec.structs.replace(game, players=(content.players[0], game.players[GHOST]))
    elif content.game != "practice":
        game = msgspec.structs.replace(game, players=tuple(content.players))
    if content.game == "combination":
        game = msgspec.structs.replace(game, alternating=content.alternating)
    if isinstance(game, StraightPool):
        game = msgspec.structs.replace(game, target=content.target)
    if content.game == "eight-ball":
        game = msgspec.structs.replace(game, calling=content.calling)
    if placed:
        hand = content.in_hand or ("" if _has_cue_ball(content) else "anywhere")
        own: dict[str, Any] = {}
        if content.game == "practice" and numbers != tuple(range(1, 16)):
            own = {"rack": "", "set_up": _places_of(content), "hand": hand}
        game = msgspec.structs.replace(game, on_table=numbers, opening=False, in_hand=hand, **own)
    return game


def _run_drill(content: BilliardsContent, numbers: tuple[int, ...]) -> RunDrill:
    """A drill of many strokes at its beginning. ValueError without a ball, or without the cue ball."""
    if not numbers or not _has_cue_ball(content):
        raise ValueError("balls: a run-drill needs the cue ball (number 0) and another one")
    if content.goal is not None:
        raise ValueError("goal: a run-drill has none")
    return RunDrill(
        on_table=numbers, in_hand=content.in_hand, hand=content.in_hand, set_up=_places_of(content),
        ordered=content.ordered, pocket=content.pocket, off_cushions=content.off_cushions,
        tries=content.tries, needed=content.needed,
    )  # fmt: skip


def read_game(saved: dict[str, Any]) -> AnyGame:
    """A game from what `msgspec.to_builtins` made of it. ValueError says what is wrong."""
    try:
        game = msgspec.convert(saved, AnyGame)
    except (msgspec.ValidationError, TypeError) as error:
        raise ValueError(f"saved: {str(error).replace('`', '')}") from None
    check_game(game)
    return game


def best_of(content: BilliardsContent, now: Frame, seed: int) -> BestStroke | None:
    """The best stroke that a level tells of, played again on the table of the frame ``now``.

    None if there is none, or if it scores no more as the table is now. ValueError if it cannot be played.
    """
    entry = content.best
    if entry is None:
        return None
    try:
        game = read_game(entry.game)
        told = msgspec.structs.replace(content, balls=entry.balls)
        layout = layout_for(told, game, now.table, now.layout.balls, seed)
        before = Frame(game, layout, now.table, now.physics)
        call = Call(entry.ball, entry.pocket, entry.safety, entry.push_out)
        return before.strike(Stroke(*entry.stroke), call).outcome().frame.best
    except ValueError as error:
        raise ValueError(f"best: {error}") from None


def check_game(game: Game) -> None:
    """ValueError if a game read from a file contradicts itself."""
    count = len(game.players)
    if not 1 <= count <= 2:
        raise ValueError("saved.players: expected one or two names")
    for name, number in (("turn", game.turn), ("breaker", game.breaker)):
        if not 0 <= number < count:
            raise ValueError(f"saved.{name}: {number} is no player")
    if game.winner is not None and not 0 <= game.winner < count:
        raise ValueError(f"saved.winner: {game.winner} is no player")
    for name in ("fouls_in_row", "won", "points", "high"):
        if len(getattr(game, name, (0,) * count)) != count:
            raise ValueError(f"saved.{name}: expected a number for each player")
    if any(not 1 <= ball <= 15 for ball in game.on_table) or len(set(game.on_table)) != len(game.on_table):
        raise ValueError("saved.on_table: expected different numbers from 1 to 15")


def layout_for(content: BilliardsContent, game: Game, table: Table, balls: BallSet, seed: int) -> Arrangement:
    """Where the balls of a level lie. ValueError for a ball that is there twice, outside or in another."""
    if not content.balls:
        return rack_for(game, table, balls, seed)
    numbers = [ball.number for ball in content.balls]
    if len(set(numbers)) != len(numbers):
        double = next(number for number in numbers if numbers.count(number) > 1)
        raise ValueError(f"balls: number {double} is there twice")
    layout = Arrangement((), np.empty((0, 2)), balls)
    for ball in content.balls:
        _check_place(layout, table, ball)
        layout = layout.with_ball(ball.number, ball.position)
    placed = {number for number in numbers if number != CUE_BALL}
    if placed != set(game.on_table):
        raise ValueError("saved.on_table: not the balls that lie on the table")
    if CUE_BALL not in numbers and not (game.in_hand or game.over or game.options):
        raise ValueError("balls: expected the cue ball (number 0)")
    return layout


def _check_place(layout: Arrangement, table: Table, ball: PlacedBall) -> None:
    """ValueError for a ball beyond the cushions' noses, or in another.

    Balls that a shot has left touching overlap by rounding, and one may stand in the mouth of a pocket.
    """
    x, y = ball.position
    if not (-MOUTH <= x <= table.width + MOUTH and -MOUTH <= y <= table.length + MOUTH):
        raise ValueError(f"balls: number {ball.number} at {ball.position} lies outside")
    radius = float(layout.balls.radii[ball.number])
    for other, (ox, oy) in zip(layout.numbers, layout.positions.tolist(), strict=True):
        reach = 2.0 * math.sqrt(radius * float(layout.balls.radii[other]))
        if elementary.hypot(x - ox, y - oy) < reach - OVERLAP:
            raise ValueError(f"balls: number {ball.number} at {ball.position} lies in number {other}")


def _places_of(content: BilliardsContent) -> tuple[tuple[int, float, float], ...]:
    """Ball, x, y m of everything placed."""
    return tuple(sorted((ball.number, *ball.position) for ball in content.balls))


def _has_cue_ball(content: BilliardsContent) -> bool:
    return any(ball.number == CUE_BALL for ball in content.balls)

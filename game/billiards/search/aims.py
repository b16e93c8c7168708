"""From a game to what its shooter is after: the aims that the search follows."""

from __future__ import annotations

from game.billiards.game.games.combination import SHORTEST_CHAIN, CombinationMatch
from game.billiards.game.games.eight_ball import EIGHT, GROUPS, EightBall
from game.billiards.game.games.ghost import Ghost
from game.billiards.game.games.rotation import Rotation
from game.billiards.game.games.straight_pool import StraightPool
from game.billiards.game.rules import CUE_BALL, Game
from game.billiards.search.rating import Aims


def bits_of(numbers: tuple[int, ...], chosen: tuple[int, ...]) -> int:
    """Balls as bits of their rows. numbers: of the rows."""
    return sum(1 << row for row, number in enumerate(numbers) if number in chosen)


def aims_of(game: Game, numbers: tuple[int, ...], solo: bool = False) -> list[Aims]:
    """What the shooter may be after: one for each group while an eight-ball table is open, else one.

    numbers: of the balls on the table, by row, the cue ball among them. solo: only clearing it counts.
    """
    if isinstance(game, EightBall):
        return _eight_ball_aims(game, numbers, solo)
    balls = bits_of(numbers, game.on_table)
    if isinstance(game, Rotation):
        last = bits_of(numbers, (game.winning,))
        lowest, called = bits_of(numbers, game.legal_first()), game.needs_call()
        return [Aims(lowest, balls, balls, win=last, other=balls, called=called, rotation=True, solo=solo)]
    if isinstance(game, StraightPool):
        return [Aims(balls, balls, balls, other=balls, solo=solo)]
    if isinstance(game, CombinationMatch):
        chain = SHORTEST_CHAIN if len(game.on_table) > 1 else 0
        return [Aims(balls, balls, balls, other=balls, called=False, solo=solo, chain=chain)]
    first, barred = bits_of(numbers, game.legal_first()), bits_of(numbers, game.barred())
    if isinstance(game, Ghost):
        return [_ghost_aims(game, numbers, first, barred)]
    return [Aims(first, balls, balls, lose=barred, called=False, solo=True)]


def _ghost_aims(game: Ghost, numbers: tuple[int, ...], first: int, barred: int) -> Aims:
    """Aims of who plays the ghost: to clear the table, as the discipline asks."""
    last, targets = bits_of(numbers, (game.last,)), bits_of(numbers, game.targets())
    eight = game.discipline == "eight-ball"
    return Aims(
        first, targets, targets | last, win=0 if barred else last, lose=barred,
        called=game.discipline == "ten-ball", rotation=not eight, solo=True,
    )  # fmt: skip


def _eight_ball_aims(game: EightBall, numbers: tuple[int, ...], solo: bool) -> list[Aims]:
    """Aims for the own group, or for each of them."""
    eight = bits_of(numbers, (EIGHT,))
    found = []
    for group in GROUPS if game.open_table else (game.groups[game.turn],):
        own = bits_of(numbers, GROUPS[group])
        others = bits_of(numbers, tuple(b for name in GROUPS if name != group for b in GROUPS[name]))
        first = own if own else eight
        playable = bits_of(numbers, game.legal_first()) if game.open_table else first
        found.append(
            Aims(
                playable | first, first, own | eight, win=0 if own else eight, lose=eight if own else 0,
                other=others | eight, called=game.calling == "all" or (game.calling == "eight" and not own),
                solo=solo,
            )
        )  # fmt: skip
    return found


def all_aims(numbers: tuple[int, ...], targets: tuple[int, ...], first: tuple[int, ...], chain: int) -> Aims:
    """Aims without a game: any of the targets, in any order, after the cue ball has met one of `first`."""
    potted = bits_of(numbers, targets)
    numbered = tuple(number for number in numbers if number != CUE_BALL)
    return Aims(bits_of(numbers, first or numbered), potted, potted, solo=True, chain=chain)

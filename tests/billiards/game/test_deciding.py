"""The strokes that decided a match: the last racks' winning strokes, and the highest run."""

from __future__ import annotations

from typing import Any

from game.billiards.game.deciding import LAST_RACKS, deciding_strokes, highest_run
from game.billiards.game.frame import Struck, new_frame
from game.billiards.game.games import GAMES
from game.billiards.game.log import Log, Logged


def log_of(*told: tuple[Any, ...], at: int | None = None) -> Log:
    """Strokes as (rack, player, balls down, winner, after); the last two may be left out."""
    frame = new_frame(GAMES["nine-ball"]())
    entries = []
    for number, (rack, player, down, *more) in enumerate(told, start=1):
        winner, after = (*more, *("", number - 1)[len(more) :])
        turned = frame.replace(game=frame.game.__class__(turn=player))
        entries.append(
            Logged(number, after, rack, Struck(turned, None), tuple(range(1, down + 1)), winner=winner)
        )
    return Log(tuple(entries), len(entries) if at is None else at)


def numbers(log: Log) -> list[int]:
    return [entry.number for entry in deciding_strokes(log)]


def test_nothing_decides_before_a_ball_is_down():
    assert numbers(log_of()) == numbers(log_of((1, 0, 0), (1, 1, 0))) == []


def test_the_winning_strokes_of_the_last_racks_and_the_highest_run():
    told = [(rack, 0, 1, "Ada") for rack in range(1, LAST_RACKS + 3)]
    told[0] = (1, 0, 0, "Ada")
    assert numbers(log_of(*told))[-LAST_RACKS:] == [3, 4, 5]
    log = log_of((1, 0, 1), (1, 0, 2), (1, 0, 0), (1, 1, 1), (1, 1, 1, "Ben"), (2, 1, 1, "Ben"))
    assert numbers(log) == [1, 2, 5, 6]  # three balls by two strokes; a run ends with the rack
    assert [entry.number for entry in highest_run(list(log.entries))] == [1, 2]


def test_what_was_taken_back_decides_nothing():
    log = log_of((1, 0, 3), (1, 0, 1, "Ada"), (1, 0, 1, "Ada", 0))
    assert numbers(log) == [3]
    assert numbers(log_of((1, 0, 3), (1, 0, 1, "Ada"), at=1)) == [1]

"""Rules as tables: a game, what a stroke did, and what is expected to follow from it."""

from __future__ import annotations

from typing import Any, NamedTuple

import msgspec
import pytest

from game.billiards.game.games import AnyGame, Practice
from game.billiards.game.rules import Call, Game, Pocketing, ShotSummary

FOUR = (1, 2, 3, 4)


class Situation(NamedTuple):
    """A game, a stroke, and what is expected: fields of the game after it, and of the verdict."""

    name: str
    game: Game
    shot: ShotSummary
    expected: dict[str, Any]
    call: Call = Call()


def shot(
    *first: int, down: tuple[Any, ...] = (), cushioned: tuple[int, ...] = (0,), **more: Any
) -> ShotSummary:
    """A summary; `down` names balls, or balls with pocket and chain."""
    pocketed = tuple(Pocketing(*(d if isinstance(d, tuple) else (d, 0))) for d in down)
    return ShotSummary(first, pocketed, cushioned=cushioned, **more)


def observed(situation: Situation, name: str) -> Any:
    """What a verdict says under a name that situations use."""
    verdict = situation.game.judge(situation.shot, situation.call)
    own = {
        "fouls": [foul.kind for foul in verdict.fouls],
        "options": [option.name for option in verdict.game.options],
        "missing": tuple(sorted(set(situation.game.on_table) - set(verdict.game.on_table))),
        "row": verdict.game.fouls_in_row,
        "push": getattr(verdict.game, "push_out_next", None),
        "next": verdict.game.legal_first(),
        "scored": verdict.scored,
        "spot": verdict.spot,
        "rack": verdict.rack,
    }
    return own[name] if name in own else getattr(verdict.game, name)


def check_situation(situation: Situation) -> None:
    """What is expected of a situation follows from it."""
    assert {name: observed(situation, name) for name in situation.expected} == situation.expected


def check_verdict(situation: Situation) -> None:
    """A verdict says its fouls, can be kept in a file, and its choices can be taken."""
    verdict = situation.game.judge(situation.shot, situation.call)
    assert all(foul.words in verdict.words for foul in verdict.fouls)
    assert verdict.words or isinstance(verdict.game, Practice)
    kept = msgspec.json.decode(msgspec.json.encode(verdict.game), type=AnyGame)
    assert kept == verdict.game and type(kept) is type(verdict.game)
    for option in verdict.game.options:
        chosen = verdict.game.choose(option.name)
        assert not chosen.game.options and chosen.words
    if verdict.game.over:
        with pytest.raises(ValueError, match="over"):
            verdict.game.judge(situation.shot, situation.call)

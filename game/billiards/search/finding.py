"""`find_shots`: the shots that a table offers, played exactly and under noise, the best first."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from typing import Any, NamedTuple

from game.arrays import Floats
from game.billiards.game.arrangement import Arrangement, Stroke
from game.billiards.game.rules import CUE_BALL
from game.billiards.search import candidates
from game.billiards.search.aims import all_aims
from game.billiards.search.candidates import CUT_FROM, KINDS, NO_POT
from game.billiards.search.deeper import look_deeper
from game.billiards.search.looking import Effort, Looked, look
from game.billiards.search.rating import Aims
from game.billiards.search.strokes import Board, Noise, draw_noise
from game.billiards.search.view import Clock, View
from game.billiards.shot.physics import Physics
from game.billiards.table.table import Table
from game.physics.kernels import elementwise

DRAWS = 256  # of noise, for each search
QUICK = Effort(finalists=96, samples=64)


class FoundShot(NamedTuple):
    """A stroke, and what it is good for.

    stroke: as it is meant. ball, pocket: what it pots, None with a safe stroke. kind: "direct", "cut",
    "bank", "kick", "combination" or "safety". via: number of the ball in between, None if there is none.
    chance: share of its noisy samples that pot the ball without a foul. worth: estimated chance to win
    (alone: to clear the table).
    """

    stroke: Stroke
    ball: int | None
    pocket: int | None
    kind: str
    via: int | None
    chance: float
    worth: float


@lru_cache(maxsize=4)
def thread_pool(threads: int) -> ThreadPoolExecutor | None:
    """Threads that are kept for all searches; None for one, which needs no other."""
    return None if threads <= 1 else ThreadPoolExecutor(threads, thread_name_prefix="search")


def processors() -> int:
    """How many threads a search takes unless it is given another number."""
    return os.cpu_count() or 1


class ShotFilter(NamedTuple):
    """Which shots to look for.

    targets: numbers of the balls to pot (none: all); first: those that may be hit first (none: all). kinds:
    of "direct" (with cuts), "bank", "kick", "combination". chain: least balls in the potted one's chain, the
    cue ball and itself counted.
    """

    targets: tuple[int, ...] = ()
    first: tuple[int, ...] = ()
    kinds: tuple[str, ...] = KINDS
    chain: int = 0

    def check(self, layout: Arrangement) -> None:
        """ValueError for unknown kinds, or a ball that is not there."""
        for kind in self.kinds:
            if kind not in KINDS:
                raise ValueError(f"find_shots kinds: {kind!r} is not one of {', '.join(KINDS)}")
        for number in (*self.targets, *self.first):
            if number not in layout.numbers or number == CUE_BALL:
                raise ValueError(f"find_shots: ball {number!r} is not on the table")

    def aims(self, numbers: tuple[int, ...]) -> Aims:
        """The aims of a shooter at these balls, the cue ball among them."""
        numbered = tuple(number for number in numbers if number != CUE_BALL)
        return all_aims(numbers, self.targets or numbered, self.first, self.chain)


def find_shots(
    layout: Arrangement,
    table: Table | None = None,
    *,
    physics: Physics = Physics(),  # noqa: B008  (immutable)
    noise: Noise = Noise(),  # noqa: B008  (immutable)
    effort: Effort = QUICK,
    limit: int = 10,
    seed: int = 0,
    threads: int | None = None,
    seconds: float | None = None,
    **which: Any,
) -> list[FoundShot]:
    """The shots that pot a ball, the best first: at most `limit`, at most one for each ball, pocket and kind.

    layout: the balls, the cue ball among them; table: the pool table if left out. which: what to look for,
    by the fields of `ShotFilter` (``targets=(3,)``). noise: how unsteady the hand is. effort: how many
    strokes are tried. threads: None: one for each processor. seconds: stop looking after about so long;
    without it what is found depends on nothing but the other arguments.

    ValueError for unknown kinds, a target that is not there, a limit below 1, or a table without the cue
    ball.
    """
    wanted = ShotFilter(**which)
    wanted.check(layout)
    if limit < 1:
        raise ValueError(f"find_shots limit: expected at least 1, got {limit!r}")
    view = View(Board(layout, Table.pool() if table is None else table, physics), noise)
    effort = effort._replace(kinds=tuple(kind for kind in effort.kinds if kind in wanted.kinds))
    looked = search(view, wanted.aims(layout.numbers), effort, seed, threads, Clock(seconds))
    if looked is None:
        return []
    return [shot for shot in named_shots(view, looked) if shot.chance > 0.0][:limit]


def search(
    view: View,
    aims: Aims,
    effort: Effort,
    seed: int,
    threads: int | None = None,
    clock: Clock = Clock(),  # noqa: B008
) -> Looked | None:
    """Look, and look deeper if the effort says so."""
    pool = thread_pool(processors() if threads is None else threads)
    draws = draw_noise(seed, DRAWS)
    looked = look(view, aims, effort, draws, pool, clock)
    if looked is None or not effort.deep or clock.is_out():
        return looked
    return look_deeper(view, aims, looked, effort, draws, pool, clock)


def named_shots(view: View, looked: Looked, limit: int | None = None) -> list[FoundShot]:
    """The best stroke for each ball, pocket and kind, at most `limit` if one is given."""
    found: dict[tuple[float, ...], FoundShot] = {}
    numbers = view.board.layout.numbers
    for stroke, candidate, chance, worth in zip(
        looked.strokes, looked.candidates, looked.chance.tolist(), looked.worth.tolist(), strict=True
    ):
        key = tuple(candidate[[candidates.BALL, candidates.INTO, candidates.KIND, candidates.VIA]].tolist())
        if key in found:
            continue
        ball, pocket, via = (
            int(candidate[column]) for column in (candidates.BALL, candidates.INTO, candidates.VIA)
        )
        found[key] = FoundShot(
            Stroke(*stroke.tolist()), numbers[ball] if ball >= 0 else None, pocket if ball >= 0 else None,
            _kind_name(view, candidate), numbers[via] if via >= 0 else None, chance, worth,
        )  # fmt: skip
        if len(found) == limit:
            break
    return list(found.values())


def _kind_name(view: View, candidate: Floats) -> str:
    """The kind of a candidate; a direct one with a cut is a cut."""
    if int(candidate[candidates.KIND]) == NO_POT:
        return "safety"
    if int(candidate[candidates.KIND]) != candidates.DIRECT:
        return KINDS[int(candidate[candidates.KIND])]
    ball, pocket = int(candidate[candidates.BALL]), int(candidate[candidates.INTO])
    line = view.geometry.gates[pocket, :2] - view.places[ball]
    away = float(candidate[candidates.AIM]) - float(elementwise.arctan2(line[1], line[0]))
    return "cut" if elementwise.cos(away) < elementwise.cos(CUT_FROM) else "direct"

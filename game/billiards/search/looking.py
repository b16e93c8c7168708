"""Looking for a stroke: candidates, fans of exact shots, then noisy samples of the best.

Every stage keeps the better part of what the one before left, and costs some thousand exact shots.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.laws.state import IN_MASS
from game.billiards.search.candidates import BALL, INTO, KINDS, SPREAD
from game.billiards.search.fans import (
    chance_of_run,
    make_styles,
    rays_for,
    spread_fans,
    squirt_of,
    widest_runs,
)
from game.billiards.search.outcomes import Outcomes
from game.billiards.search.rating import SCORED, WON, Aims
from game.billiards.search.strokes import AZIMUTH, with_noise
from game.billiards.search.view import UNLIMITED, Clock, View
from game.billiards.shot.cue import CUE_END_MASS

MISS_WORTH = 0.3  # of a stroke that misses, before it is looked at closely
STROKES_A_PART = 4096  # of fans, between two looks at the clock


class Effort(NamedTuple):
    """How hard to look. kinds: of KINDS. speeds m/s, ups, lefts (tip, ball radii): how to strike.

    candidates: at most so many are tried. rays: most in a fan. finalists: strokes that are sampled with
    noise, samples: how often each. deep: how many of them are sampled `close` times, and judged by the best
    stroke after them, from deep_samples of what they leave; after: how hard to look for that.
    """

    kinds: tuple[str, ...] = KINDS
    speeds: tuple[float, ...] = (0.5, 0.8, 1.2, 1.7, 2.4, 3.4)
    ups: tuple[float, ...] = (-0.4, -0.2, 0.0, 0.2, 0.4)
    lefts: tuple[float, ...] = (-0.3, 0.0, 0.3)
    candidates: int = 16
    rays: int = 41
    finalists: int = 64
    samples: int = 48
    deep: int = 0
    close: int = 128
    deep_samples: int = 0
    after: Effort | None = None


class Looked(NamedTuple):
    """Strokes that were sampled, the best first.

    strokes (f, 5); candidates (f, 8): what each is after; chance (f,): share of samples that scored; worth
    (f,): mean estimated chance to win; kinds, values (f, k): classes and worths of the samples; outcomes
    (f k).
    """

    strokes: Floats
    candidates: Floats
    chance: Floats
    worth: Floats
    kinds: NDArray[np.int64]
    values: Floats
    outcomes: Outcomes

    def taken(self, order: NDArray[np.intp]) -> Looked:
        """Some of them, in an order (k,) of their rows."""
        k = self.kinds.shape[1]
        rows = (order[:, None] * k + np.arange(k)).ravel()
        return Looked(
            self.strokes[order], self.candidates[order], self.chance[order], self.worth[order],
            self.kinds[order], self.values[order], self.outcomes.rows(rows),
        )  # fmt: skip


def look(
    view: View,
    aims: Aims,
    effort: Effort,
    draws: Floats,
    pool: ThreadPoolExecutor | None = None,
    clock: Clock = UNLIMITED,
) -> Looked | None:
    """The best strokes under noise; None if nothing pots a ball. draws (k, 5): see `with_noise`."""
    candidates = view.candidates(aims, effort.kinds, effort.candidates)
    if not len(candidates):
        return None
    styles = make_styles(effort.speeds, effort.ups, effort.lefts)
    fans: list[tuple[Floats, Floats, Floats]] = []
    for part in _parts(candidates, styles, effort):
        if fans and clock.is_out():
            break
        fan = _best_of_fans(view, aims, part, styles, effort, pool)
        if fan is not None:
            fans.append(fan)
    if not fans:
        return None
    strokes, chosen, first = (np.concatenate(column) for column in zip(*fans, strict=True))
    order = np.argsort(-first, kind="stable")[: effort.finalists]
    return sample(view, aims, strokes[order], chosen[order], draws[: effort.samples], pool)


def _parts(candidates: Floats, styles: Floats, effort: Effort) -> list[Floats]:
    """Candidates in parts of not too many strokes."""
    strokes = np.cumsum(rays_for(candidates, most=effort.rays) * len(styles)) // STROKES_A_PART
    return [candidates[strokes == part] for part in np.unique(strokes)]


def _best_of_fans(
    view: View,
    aims: Aims,
    candidates: Floats,
    styles: Floats,
    effort: Effort,
    pool: ThreadPoolExecutor | None,
) -> tuple[Floats, Floats, Floats] | None:
    """The middles of the best runs with their candidates and a first idea of their worth; None: no run."""
    board = view.board
    rays = rays_for(candidates, most=effort.rays)
    sizes = rays * len(styles)
    starts = np.concatenate([[0], np.cumsum(sizes)[:-1]]).astype(np.int64)
    strokes = np.empty((int(sizes.sum()), 5))
    squirt = squirt_of(styles, float(board.base[board.cue, IN_MASS]), CUE_END_MASS)
    spread_fans(candidates, styles, rays, starts, squirt, strokes)
    outcomes = board.play(strokes, pool)
    meant = np.repeat(candidates[:, [BALL, INTO]].astype(np.int64), sizes, axis=0)
    kinds = view.classes(outcomes, aims, meant)
    middles = np.empty((len(candidates), len(styles)), np.int64)
    lengths = np.empty((len(candidates), len(styles)))
    widest_runs(kinds, rays, starts, len(styles), middles, lengths)
    some = np.flatnonzero(lengths.ravel() > 0.0)
    if not len(some):
        return None
    rows, lengths = middles.ravel()[some], lengths.ravel()[some]
    of = some // len(styles)
    steps = 2.0 * candidates[of, SPREAD] / (rays[of] - 1)
    chance = chance_of_run(0.5 * lengths * steps, view.geometry.sight)
    worth = view.worth(outcomes.rows(rows), aims, kinds[rows], pool)
    first = chance * worth + (1.0 - chance) * (0.0 if aims.solo else MISS_WORTH)
    order = np.argsort(-first, kind="stable")[: effort.finalists]
    best = strokes[rows[order]]
    # a run of an even number of rays has its middle between two of them
    best[:, AZIMUTH] += np.where(lengths[order] % 2 == 0, 0.5 * steps[order], 0.0)
    return best, candidates[of[order]], first[order]


def sample(
    view: View,
    aims: Aims,
    strokes: Floats,
    candidates: Floats,
    draws: Floats,
    pool: ThreadPoolExecutor | None = None,
) -> Looked:
    """Each stroke (f, 5) with each draw of noise (k, 5); the best first. candidates (f, 8)."""
    f, k = len(strokes), len(draws)
    noisy = with_noise(strokes, draws, view.noise, view.board.radius)
    outcomes = view.board.play(noisy, pool)
    meant = np.repeat(candidates[:, [BALL, INTO]].astype(np.int64), k, axis=0)
    kinds = view.classes(outcomes, aims, meant)
    values = view.worth(outcomes, aims, kinds, pool).reshape(f, k)
    worth = values.mean(axis=1)
    kinds = kinds.reshape(f, k)
    chance = ((kinds == SCORED) | (kinds == WON)).mean(axis=1)
    looked = Looked(strokes, candidates, chance, worth, kinds, values, outcomes)
    return looked.taken(np.argsort(-worth, kind="stable"))

"""The paper on motion that keeps time with a sound (P22), in billiards."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from time import thread_time

from game.billiards.rhythm import search as s
from game.billiards.rhythm.candidates import EXTRA
from game.billiards.rhythm.search import Rhythm, RhythmSearch
from game.billiards.simulation import simulate_exact
from game.billiards.table.table import Table
from game.lab.timing import least_time
from game.scenes.beat.figure import draw_laying
from game.scenes.shared.marks import dot
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

CLAVE = (0.0, 0.45, 0.9, 1.5, 1.8)  # s
ROUNDS = 30
SHOWN, SHOWN_SEED, SHOWN_ROUNDS = (0.0, 0.1, 0.2, 0.9, 1.0), 2, 8  # of the figures: a hard beat, s


@lru_cache(maxsize=1)
def _searched() -> tuple[Rhythm, Rhythm, tuple[float, ...]]:
    """Of a search: the best as it was laid, the best at the end, and costs (s) of the rounds between."""
    search, costs = RhythmSearch(SHOWN, Table.pool(), seed=SHOWN_SEED), []
    while not search.laid:
        search.improve()
    laid = search.best()
    for _ in range(SHOWN_ROUNDS):
        best = search.best()
        costs.append(best.cost if best is not None else math.nan)
        search.improve()
    varied = search.best()
    if laid is None or varied is None:
        raise RuntimeError("P22: no shot was laid for the beat")
    return laid, varied, tuple(costs)


def _draw_heard(pen: Pen) -> None:
    """Every impact that is heard of the best layout: beside a beat, or off all of them."""
    laid, _, _ = _searched()
    until = SHOWN[-1] + 0.1

    def at(time: float) -> float:
        return 30.0 + 236.0 * time / until

    for beat in SHOWN:
        pen.line(((at(beat), 40.0), (at(beat), 150.0)), "amber", 1.2, dash=3.0)
    taken = {beat + miss for beat, miss in zip(SHOWN, laid.misses, strict=True)}
    pen.line(((24.0, 95.0), (272.0, 95.0)), "text3", 1.2)
    for impact in laid.impacts:
        on_beat = min(abs(impact - one) for one in taken) < 1e-9
        dot(pen, (at(impact), 95.0), "chalk" if on_beat else "vermilion", 4.5)
    worst = 1e3 * max(map(abs, laid.misses))
    pen.words(f"{len(laid.impacts)} impacts for {len(SHOWN)} beats", 148.0, 20.0, "text2")
    pen.words(f"at most {worst:.3g} ms beside a beat", 148.0, 172.0, "chalk")


def _draw_rounds(pen: Pen) -> None:
    """The cost of the best layout by the rounds that varied it."""
    _, _, costs = _searched()
    pen.line(((44.0, 18.0), (44.0, 168.0), (280.0, 168.0)), "text3", 1.0)
    low = math.floor(math.log10(max(min(costs), 1e-6)))
    high = math.ceil(math.log10(max(*costs, 1e-5)))
    line = [
        (44.0 + 236.0 * k / (len(costs) - 1),
         168.0 - 145.0 * (math.log10(max(cost, 1e-6)) - low) / (high - low))
        for k, cost in enumerate(costs)
    ]  # fmt: skip
    pen.line(line, "green", 2.0)
    for tenth in range(low, high + 1):
        y = 168.0 - 145.0 * (tenth - low) / (high - low)
        pen.words(f"{1e3 * 10.0**tenth:g} ms", 40.0, y, "text2", "right", size=10)
    pen.words("laid", 48.0, 184.0, "text2", "left")
    pen.words(f"{len(costs) - 1} rounds on", 280.0, 184.0, "text2", "right")


def _draw_events(pen: Pen) -> None:
    """The beat, the impacts of the best layout, and those of what it was varied to."""
    laid, varied, _ = _searched()

    def at(time: float) -> float:
        return 30.0 + 236.0 * time / SHOWN[-1]

    for y, name, impacts, color in (
        (54.0, "the beat", SHOWN, "amber"),
        (108.0, f"laid: {laid.extras} too many, {1e3 * laid.error_s:.2g} ms off", laid.impacts, "vermilion"),
        (
            162.0,
            f"varied: {varied.extras} too many, {1e3 * varied.error_s:.2g} ms off",
            varied.impacts,
            "green",
        ),
    ):
        pen.line(((24.0, y), (272.0, y)), "text3", 1.2)
        pen.words(name, 24.0, y - 18.0, "text2", align="left")
        for impact in impacts:
            dot(pen, (min(at(impact), 272.0), y), color, 4.2)


def _measure() -> Iterator[Comparison]:
    start = thread_time()
    search = RhythmSearch(CLAVE, Table.pool(), seed=1)
    found: Rhythm | None = search.run(ROUNDS)
    spent = thread_time() - start
    if found is None:
        yield Comparison("son clave, five strokes: shot found", "", "none")
        return
    yield Comparison(
        "son clave, five strokes: largest timing error", "", f"{1e3 * max(map(abs, found.misses)):.3g} ms"
    )
    yield Comparison("impacts that no stroke asks for", "", str(found.extras))
    laying = len(CLAVE) - 1
    yield Comparison(
        "rounds of the search: balls laid, layouts varied", "", f"{laying}, {search.steps - laying}"
    )
    yield Comparison(
        "variants tried in a round, at most, and played to the end", "",
        f"{s.BEAM * s.CHILDREN}, {s.BEAM * s.HEARD}",
    )  # fmt: skip
    yield Comparison("time of the search", "", f"{spent:.2f} s")
    each = least_time(lambda: simulate_exact(found.shot), 20)
    yield Comparison("one shot simulated", "", f"{1e6 * each:.0f} \u00b5s")


FOLEY = Paper(
    problem=(
        "Sound for an animation is usually made to fit the picture. Here the sound is given, a rhythm of "
        "impacts, and a physical motion is wanted whose impacts are heard at just those times.",
    ),
    idea=(
        "Do not steer the motion: search among plausible ones. Many short motions are simulated ahead, and "
        "a path from impact to impact is chosen whose times fit. What is still off is taken up by changes "
        "too small to be seen.",
    ),
    steps=(
        Step("Hear the beat: the times of the strokes, tapped here.", _draw_events),
        Step(
            "Lay a ball for each beat in turn, where one that moves at that time will just meet it, in "
            "several directions. Keep the layouts that promise most: "
            f"{s.DIRECTIONS} directions from each moving ball, {s.BEAM} kept, {s.FAMILY} of a family.",
            draw_laying,
        ),
        Step(
            "Play each candidate with the exact table and hear all its impacts, those off the beat too.",
            _draw_heard,
        ),
        Step(
            "Vary all numbers a little, again and again, and keep what is nearer to the beat. The cost c is "
            f"the root mean square miss, and {1e3 * EXTRA:g} ms for each impact that no stroke asks for.",
            _draw_rounds,
            r"c = \sqrt{\frac{1}{n} \sum_k (t_k - b_k)^2} + n_+ \cdot \text{" + f"{1e3 * EXTRA:g}" + r" ms}",
        ),
    ),
    showed=(
        "Motions of many rigid bodies synchronised to hundreds of sounds. They are found in a graph of "
        "contact events, made from hundreds of thousands of simulated motions. Transitions are blended by "
        "changed contact impulses, and free flights are slightly retimed.",
    ),
    measure=_measure,
    limits=(
        "Here one stroke makes all impacts, and nothing is blended or retimed: the motion is true physics "
        "from the first to the last beat, so beats are at most sixteen and lie within a few seconds. "
        "Drops of solid bodies are not searched.",
    ),
    after=(
        "Sound and motion from one model (Wang, Qu, Langlois, James 2018), and learned pairs of impact "
        "sounds and videos, look at the same question from the other side.",
    ),
)

"""The paper on motion that keeps time with a sound (P22), in billiards."""

from __future__ import annotations

from collections.abc import Iterator
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


def _draw_events(pen: Pen) -> None:
    """A beat, and impacts that miss it and then meet it."""

    def at(time: float) -> float:
        return 30.0 + 236.0 * time / CLAVE[-1]

    for y, name, misses, color in (
        (54.0, "the beat", (0.0,) * 5, "amber"),
        (108.0, "a shot", (0.0, 0.09, -0.13, 0.05, 0.16), "vermilion"),
        (162.0, "varied", (0.0,) * 5, "green"),
    ):
        pen.line(((24.0, y), (272.0, y)), "text3", 1.2)
        pen.words(name, 24.0, y - 18.0, "text2", align="left")
        for beat, miss in zip(CLAVE, misses, strict=True):
            if miss:
                pen.line(((at(beat), y - 7.0), (at(beat), y + 7.0)), "text3", 1.0, dash=2.0)
            dot(pen, (min(at(beat + miss), 272.0), y), color, 4.2)


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
        "Do not steer the motion: search among plausible ones. Many short motions are simulated ahead, "
        "and a way from impact to impact is chosen whose times fit; what is still off is taken up by "
        "small changes that nobody sees.",
    ),
    steps=(
        Step("Hear the beat: the times of the strokes, tapped here.", _draw_events),
        Step(
            "Lay a ball for each beat in turn, where one that moves at that time will just meet it, in "
            "several directions; keep the layouts that promise most: "
            f"{s.DIRECTIONS} directions from each moving ball, {s.BEAM} kept, {s.FAMILY} of a family.",
            draw_laying,
        ),
        Step("Play each candidate with the exact table and hear all its impacts, those off the beat too."),
        Step(
            "Vary all numbers a little, again and again, and keep what is nearer to the beat. The cost c is "
            f"the root mean square miss, and {1e3 * EXTRA:g} ms for each impact that no stroke asks for.",
            None,
            r"c = \sqrt{\frac{1}{n} \sum_k (t_k - b_k)^2} + n_+ \cdot \text{" + f"{1e3 * EXTRA:g}" + r" ms}",
        ),
    ),
    showed=(
        "Motions of many rigid bodies synchronised to hundreds of sounds, found in a graph of contact "
        "events made from hundreds of thousands of simulated motions, with transitions blended by changed "
        "contact impulses and free flights slightly retimed.",
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

"""What finding a shot on the beat costs: balls laid one by one and varied, beside layouts drawn at random."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.billiards.rhythm.candidates import STROKE, Candidates
from game.billiards.rhythm.search import FASTEST, SLOWEST, RhythmSearch
from game.billiards.shot.physics import Physics
from game.billiards.table.table import Table
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation

BEATS = (0.0, 0.4, 0.8, 1.2, 1.4, 1.6, 2.0, 2.4)
ROUNDS = (1, 3, 9, 25)  # the first lays the balls
RANDOM_A_ROUND = 6144  # layouts: what a round of varying plays
LEAST = 1e-12  # s; a smaller error is rounding


def _settings() -> list[Setting]:
    return [
        Setting(
            method,
            float(rounds),
            scene={"rounds": rounds - 1} if method == "laying" else {},
            weight=float(rounds),
        )
        for rounds in ROUNDS
        for method in ("laying", "random")
    ]


def _laid(rounds: int) -> tuple[float, int]:
    """The cost of the best shot of a search, infinite without one, and the steps of the search."""
    search = RhythmSearch(BEATS, Table.pool(), seed=3)
    found = search.run(len(BEATS) - 1 + rounds, good_s=LEAST)
    return (math.inf if found is None else found.cost), search.steps


def _at_random(count: int) -> tuple[float, int]:
    """The cost of the best of so many layouts at random."""
    table, rng, n = Table.pool(), np.random.default_rng(3), len(BEATS)
    candidates = Candidates(table, Physics(), n)
    low = np.array([SLOWEST, -math.pi, -0.4, -0.4] + [0.05, 0.05] * n)
    high = np.array([FASTEST, math.pi, 0.4, 0.4] + [table.width - 0.05, table.length - 0.05] * n)
    drawn = low + (high - low) * rng.random((count, STROKE + 2 * n))
    return float(np.min(candidates.rough_costs(drawn, np.array(BEATS)))), count


def _judged(found: tuple[float, int]) -> Outcome:
    cost, steps = found
    return Outcome(max(cost, LEAST), steps, "" if cost < math.inf else "no shot")


def _trial(setting: Setting) -> Trial:
    rounds = int(setting.knob)
    if setting.method == "laying":
        return computation(BEATS[-1], lambda: _laid(rounds - 1), _judged)
    return computation(BEATS[-1], lambda: _at_random(rounds * RANDOM_A_ROUND), _judged)


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting("laying", 1.0 + float(parameters["rounds"]))


RHYTHM_STUDY = Study(
    name="p22",
    title="A shot for eight beats",
    error="cost: error of the impacts, and 20 ms for each off the beat",
    error_unit="s",
    counter="steps, or layouts",
    knob=Knob("rounds", "Rounds", parts=True),
    methods=(
        Method("laying", "a ball laid for each beat", note="then varied, so many rounds"),
        Method("random", "layouts at random", note="as many as the rounds play"),
    ),
    settings=_settings,
    trial=_trial,
    present=_present,
    workload=Workload(f"{len(BEATS)} beats in {BEATS[-1]:g} s"),
    reference="Each shot is played by the exact table; its impacts are compared with the beats.",
    expectation="Laying is on the beat at once, to rounding; rounds take away what clicks between the beats. "
    "Random layouts gain with the logarithm of their number and never come near.",
    floor=1e-9,
    short="Search",
)

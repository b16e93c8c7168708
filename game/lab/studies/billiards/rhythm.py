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

BEATS = (0.0, 0.4, 0.8, 1.2, 1.4, 1.6, 2.0, 2.4)
ROUNDS = (1, 3, 9, 25)  # the first lays the balls
RANDOM_A_ROUND = 6144  # layouts: what a round of varying plays
LEAST = 1e-12  # s; a smaller error is rounding


class LayingTrial:
    """A search that lays a ball a beat, and so many rounds of varying."""

    simulated_s = BEATS[-1]

    def __init__(self, rounds: int) -> None:
        self._rounds = rounds
        self._cost, self._steps = math.inf, 0

    def reset(self) -> None:
        """Nothing is kept between runs."""

    def run(self) -> None:
        """The whole search."""
        search = RhythmSearch(BEATS, Table.pool(), seed=3)
        found = search.run(len(BEATS) - 1 + self._rounds, good_s=LEAST)
        self._cost, self._steps = (math.inf if found is None else found.cost), search.steps

    def outcome(self) -> Outcome:
        """The cost of the best shot, and the steps of the search."""
        return Outcome(max(self._cost, LEAST), self._steps, "" if self._cost < math.inf else "no shot")


class RandomTrial:
    """The best of so many layouts at random."""

    simulated_s = BEATS[-1]

    def __init__(self, count: int) -> None:
        self._count = count
        self._cost = math.inf

    def reset(self) -> None:
        """Nothing is kept between runs."""

    def run(self) -> None:
        """Draw and play them all."""
        table, rng, n = Table.pool(), np.random.default_rng(3), len(BEATS)
        candidates = Candidates(table, Physics(), n)
        low = np.array([SLOWEST, -math.pi, -0.4, -0.4] + [0.05, 0.05] * n)
        high = np.array([FASTEST, math.pi, 0.4, 0.4] + [table.width - 0.05, table.length - 0.05] * n)
        drawn = low + (high - low) * rng.random((self._count, STROKE + 2 * n))
        self._cost = float(np.min(candidates.rough_costs(drawn, np.array(BEATS))))

    def outcome(self) -> Outcome:
        """The cost of the best, and how many there were."""
        return Outcome(max(self._cost, LEAST), self._count, "" if self._cost < math.inf else "no shot")


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


def _trial(setting: Setting) -> Trial:
    rounds = int(setting.knob)
    return LayingTrial(rounds - 1) if setting.method == "laying" else RandomTrial(rounds * RANDOM_A_ROUND)


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

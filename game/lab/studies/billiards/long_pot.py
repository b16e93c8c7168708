"""How often a hand makes a long pot at snooker: what more samples are worth, and what geometry alone says.

A red is cut by a few degrees into a corner of the twelve-foot table, from two metres. Its chance is the share
of a hand's strokes that pot it; computer players estimate such chances from geometry before they play any.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.snooker.frame import snooker_layout
from game.billiards.search.next_pot import best_chances
from game.billiards.search.outcomes import POCKET
from game.billiards.search.strokes import Board, Noise, draw_noise, with_noise
from game.billiards.search.view import View
from game.billiards.shot.cloths import SNOOKER_CLOTH
from game.billiards.table.snooker import BALL_RADIUS
from game.billiards.table.table import Table
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload

PLACES = {0: (1.05, 0.5), 1: (0.6, 2.4)}
STROKE = Stroke(1.2, 1.79674, 0.0, 0.0, 0.2)
RED, CORNER = 1, 4  # row, pocket
HANDS = {"steady": 1.0, "average": 2.8}  # times the usual noise; the scene's hands of these names
SAMPLES = (16, 64, 256, 1024, 4096)
TRUTH = 40_000  # samples behind the reference; its own error is 0.002
SEED = 11


def board() -> Board:
    """The table with its two balls."""
    return Board(snooker_layout(PLACES), Table.snooker(), SNOOKER_CLOTH)


def share(count: int, hand: str, seed: int) -> float:
    """Share of so many strokes of a hand that pot the red."""
    noisy = with_noise(np.array([STROKE]), draw_noise(seed, count), Noise().scaled(HANDS[hand]), BALL_RADIUS)
    return float((board().play(noisy).histories[:, RED, POCKET] == CORNER).mean())


@lru_cache(maxsize=2)
def true_chance(hand: str) -> float:
    """The chance of a hand, from many samples of their own."""
    return share(TRUTH, hand, SEED + 1)


class PotChance:
    """The chance from so many samples, or from geometry; error: how far it is from that of many."""

    simulated_s = 1.0  # the price is that of one chance

    def __init__(self, setting: Setting) -> None:
        self.by_geometry = setting.method == "geometry"
        self.hand = "steady" if self.by_geometry else setting.method
        self.count = int(setting.knob)
        self.view = View(board(), Noise().scaled(HANDS[self.hand]))
        self.chance = 0.0

    def reset(self) -> None:
        self.chance = 0.0

    def run(self) -> None:
        if not self.by_geometry:
            self.chance = share(self.count, self.hand, SEED)
            return
        found = np.empty(1)
        best_chances(self.view.places[None], self.view.geometry, np.array([1 << RED]), found)
        self.chance = float(found[0])

    def outcome(self) -> Outcome:
        return Outcome(abs(self.chance - true_chance(self.hand)), self.count)


def _settings() -> Sequence[Setting]:
    sampled = [
        Setting(hand, float(count), {}, {"hand": hand}, float(count)) for hand in HANDS for count in SAMPLES
    ]
    return [*sampled, Setting("geometry", 1.0)]


def present_setting(parameters: Mapping[str, object]) -> Setting:
    """Where the scene stands: its chance of a pot is from 128 strokes of a hand."""
    hand = str(parameters["hand"])
    return Setting(hand if hand in HANDS else "steady", 128.0)


long_pot_study = Study(
    name="snooker-long-pot",
    title="Snooker: what the chance of a pot costs",
    error="share of strokes that pot, off that of 40 000",
    error_unit="",
    counter="strokes",
    knob=Knob("samples", "samples", parts=True),
    methods=(
        Method("steady", "steady hand"),
        Method("average", "average hand"),
        Method("geometry", "geometry alone"),
    ),
    settings=_settings,
    short="Long pot",
    trial=PotChance,
    present=present_setting,
    workload=Workload("the chance of one long pot from so many samples"),
    reference="40 000 strokes on the exact table.",
    expectation="The error falls with the root of the samples, for a steady hand as for another. Geometry "
    "tells a chance at once, good enough to choose what to look at; how far it is off does not change.",
)

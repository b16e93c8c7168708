"""How often a hand makes a stroke at carom: what more samples are worth, and what each model says of it.

The stroke is one over three cushions. Its chance is the share of a hand's strokes that score; the hand is
that of a club player. With the exact table the error falls with the square root of the samples. The other
models tell another chance however many are drawn: their table is another one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache

import numpy as np

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import carom_shot
from game.billiards.game.carom_summary import summarize_carom
from game.billiards.map.carom import Position
from game.billiards.map.routes import Wanted
from game.billiards.search.strokes import Noise, draw_noise, with_noise
from game.billiards.shot.cloths import CLOTHS, HEATED
from game.billiards.simulation import simulate
from game.billiards.table.carom import BALL_RADIUS, WHITE
from game.billiards.table.table import Table
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload

PLACES = np.array([[0.9, 0.7], [0.41, 1.1], [0.71, 2.13]])
STROKE = Stroke(4.8, 1.69, 0.0, 0.25, 0.0)
HAND = Noise().scaled(2.8)
WANTED = Wanted(3)
SAMPLES = {"exact": (16, 64, 256, 1024, 4096), "stepped": (16, 64), "lecture": (16, 64)}
SCENES = {"exact": {"odds": "club"}}  # the scene plays on the exact table only
TRUTH = 60_000  # samples behind the reference; its own error is 0.002
SEED = 7


def position() -> Position:
    """Where the stroke is played from."""
    return Position(PLACES, WHITE, Table.carom(), CLOTHS[HEATED], WANTED)


@lru_cache(maxsize=1)
def true_chance() -> float:
    """The chance on the exact table, from many samples of their own."""
    noisy = with_noise(np.array([STROKE]), draw_noise(SEED + 1, TRUTH), HAND, BALL_RADIUS)
    return float(WANTED.scores(position().play(noisy)).mean())


class Chance:
    """The chance from so many samples under a model; error: how far it is from that of the exact table."""

    simulated_s = 1.0  # the price is that of one chance

    def __init__(self, setting: Setting) -> None:
        self.model = setting.method
        draws = draw_noise(SEED, int(setting.knob))
        self.strokes = with_noise(np.array([STROKE]), draws, HAND, BALL_RADIUS)
        self.position = position()
        self.scored = 0

    def reset(self) -> None:
        self.scored = 0

    def run(self) -> None:
        if self.model == "exact":
            self.scored = int(WANTED.scores(self.position.play(self.strokes)).sum())
            return
        board = self.position.board
        for stroke in self.strokes.tolist():
            shot = carom_shot(board.table, board.physics, PLACES, WHITE, Stroke(*stroke))
            scoring = summarize_carom(simulate(shot, self.model), WHITE).scoring(WHITE)
            self.scored += scoring is not None and scoring.cushions >= WANTED.cushions

    def outcome(self) -> Outcome:
        return Outcome(abs(self.scored / len(self.strokes) - true_chance()), len(self.strokes))


def _settings() -> Sequence[Setting]:
    return [
        Setting(model, float(count), {}, SCENES.get(model, {}), count * (1.0 if model == "exact" else 300.0))
        for model, counts in SAMPLES.items()
        for count in counts
    ]


def present_setting(parameters: Mapping[str, object]) -> Setting:
    """Where the scene stands: chances in its list are from 96 strokes on the exact table."""
    return Setting("exact", 96.0)


chances_study = Study(
    name="carom-chances",
    title="Carom: what a chance costs",
    error="share of strokes that score, off that of 60 000 on the exact table",
    error_unit="",
    counter="strokes",
    knob=Knob("samples", "samples", parts=True),
    methods=(
        Method("exact", "exact table"),
        Method("stepped", "stepped table"),
        Method("lecture", "lecture's table"),
    ),
    settings=_settings,
    short="Chances",
    trial=Chance,
    present=present_setting,
    workload=Workload("the chance of one stroke from so many samples"),
    reference="60 000 strokes on the exact table.",
    expectation="With the exact table the error falls with the root of the samples: a hundred tell a "
    "chance to 0.05, ten thousand to 0.005. The stepped table tells nearly the same at a thousand times the "
    "price. "
    "The lecture's has no spin, and its balls hardly ever take this way: more samples do not help it.",
)

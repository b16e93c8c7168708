"""What accuracy costs for a ball in a loop: the least height from which it comes round."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.studies.qualities import quality_marks
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.kernels import elementwise
from game.physics.solids import TIERS
from game.physics.solids.tracks import DISC, Curve, TrackSettings, TrackWorld
from game.physics.solids.tracks.motion import FREE, PIECE, X, Y

GRAVITY, LOOP, BALL, STEP = 9.81, 1.0, 0.1, 1.0 / 120.0
EXACT = 0.5 * (5.0 + DISC) * (LOOP - BALL)  # m, drop of the centre
HALVINGS, MOST_STEPS = 16, 240
SMOOTH, CORNERS = "smooth", "chords"
CHORDS = {SMOOTH: (20, 50, 100, 400), CORNERS: (20, 50, 100, 200, 400, 800)}
SUBSTEPS = (1, 2, 4, 8, 16)
MARKED, QUALITIES = 100, (12, 24)  # chords; substeps of the qualities that are not among these


def comes_round(method: str, chords: int, substeps: int, drop: float) -> bool:
    """Whether a disc that rolls into the loop, after that drop (m), passes its top."""
    turn = np.linspace(-0.5 * math.pi, 1.5 * math.pi, chords + 1)
    points = LOOP * np.stack([elementwise.cos(turn), 1.0 + elementwise.sin(turn)], axis=1)
    curve = Curve(points, corner=35.0 if method == SMOOTH else 0.0)
    world = TrackWorld([curve], TrackSettings(substeps))
    speed = math.sqrt(2.0 * GRAVITY * drop / (1.0 + DISC))
    ball = world.add_ball((1e-3, BALL), BALL, (speed, 0.0), -speed / BALL, friction=1e6)
    world.put_down(ball, 0.05)
    hops = 0
    for _ in range(MOST_STEPS):
        world.step(STEP)
        x, y = world.balls.rows[ball, [X, Y]].tolist()
        hops = hops + 1 if world.balls.pieces[ball, PIECE] == FREE else 0
        if hops > 6:  # it flies for longer than a corner takes
            return False
        if x < -0.3 and 0.3 < y < 0.9:
            return True
    return False


class LoopTrial:
    """The limit by halving between two heights."""

    simulated_s = 1.0

    def __init__(self, setting: Setting):
        self.setting = setting
        self.chords = int(setting.others["chords"])

    def reset(self) -> None:
        """Nothing is kept between runs."""

    def run(self) -> None:
        """All trials from all heights."""
        low, high = 0.5 * EXACT, 3.0 * EXACT
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            if comes_round(self.setting.method, self.chords, int(self.setting.knob), middle):
                high = middle
            else:
                low = middle
        self.limit = high

    def outcome(self) -> Outcome:
        """How far the limit is from the exact one."""
        return Outcome(abs(self.limit - EXACT), HALVINGS * int(self.setting.knob))


def _substeps(method: str, chords: int) -> tuple[int, ...]:
    if method != SMOOTH:
        return (4,)
    return (*SUBSTEPS, *QUALITIES) if chords == MARKED else SUBSTEPS


def _settings() -> list[Setting]:
    return [
        Setting(
            method,
            float(n),
            {"chords": float(chords)},
            {"tier": "own", "substeps": n, "chords": chords},
            float(n * chords),
        )
        for method in (SMOOTH, CORNERS)
        for chords in CHORDS[method]
        for n in _substeps(method, chords)
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    chords = float(parameters["chords"]) or 100.0
    substeps = TIERS.get(str(parameters["tier"]), int(parameters["substeps"]))
    return Setting(SMOOTH, float(substeps), {"chords": chords})


loop_study = Study(
    name="loop",
    title="The least height for a loop",
    error="limit of the drop against (5 + k)/2 (R - r)",
    error_unit="m",
    counter="substeps",
    knob=Knob("substeps", "substeps"),
    methods=(Method(SMOOTH, "smooth curve", 2.0), Method(CORNERS, "chords with corners")),
    settings=_settings,
    trial=LoopTrial,
    reference="the energy at the top, where the track presses no more.",
    expectation="Each corner of chords is an impact that takes speed; a smooth curve takes none.",
    present=_present,
    workload=Workload("a disc of 0.1 m in a loop of 1 m, tried from sixteen heights"),
    mark=quality_marks(SMOOTH, {"chords": float(MARKED)}),
)

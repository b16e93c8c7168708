"""What accuracy costs for a floating log: its draft, by hydrostatics and in a liquid."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.grid.layout import Grid
from game.physics.hydrostatics import FloatingBody, FloatingSettings, exact, make_floater
from game.physics.hydrostatics.motion import TURN, Tank
from game.physics.liquid import Liquid, LiquidSettings
from game.physics.solids import Material, SolidSettings, SolidWorld, box
from game.physics.surfaces import SolidSurface

WIDTH, HEIGHT, RATIO = 0.5, 0.2, 0.5  # of the log, m, and its density beside water's
TANK, DEPTH, HEEL, SWUNG = 1.25, 0.5, 0.06, 2.0  # m, m, rad, s
STEP = 1.0 / 240.0
CELLS, PARTS = (20, 28, 40, 56), (1, 2, 4, 8)
BESIDE = exact.roll_period(WIDTH, HEIGHT, RATIO)


def period_of(angles: list[float]) -> float:
    """s, of a value sampled each `STEP`, from where it passes 0; infinite where it does not twice."""
    off = np.array(angles)
    at = np.flatnonzero(off[:-1] * off[1:] < 0.0)
    if len(at) < 2:
        return float("inf")
    times = STEP * (at + off[at] / (off[at] - off[at + 1]))
    return 2.0 * float(np.diff(times).mean())


class RollTrial:
    """A log that is let go a little heeled. Its first swings are timed, and its draft is taken at the end."""

    simulated_s = SWUNG

    def __init__(self, setting: Setting):
        self.setting = setting

    def reset(self) -> None:
        """In calm water."""
        level = DEPTH + WIDTH * HEIGHT * RATIO / TANK
        if self.setting.method == "liquid":
            n = max(8, round(TANK / self.setting.knob))
            cell = TANK / n
            self.world = SolidWorld(SolidSettings(gravity=(0.0, -exact.G)))
            wood = Material(density=1000.0 * RATIO)
            self.body = self.world.add_body(box(WIDTH, HEIGHT, material=wood), (0.5 * TANK, level), HEEL)
            self.liquid = Liquid(Grid(n, int(0.65 * n), cell), LiquidSettings(), most=6 * n * n)
            self.liquid.set_solids(SolidSurface(self.world))
            self.liquid.add(self.liquid.lattice((0.0, 0.0), (TANK, level)))
        else:
            w, h = 0.5 * WIDTH, 0.5 * HEIGHT
            log = make_floater([(-w, -h), (w, -h), (w, h), (-w, h)], 1000.0 * RATIO)
            added = int(self.setting.method == "ellipse")
            self.law = FloatingBody(
                log, Tank(TANK, TANK * DEPTH, 1000.0), (0.5 * TANK, level), HEEL,
                settings=FloatingSettings(added=added, drag=0.0, waves=0.0),
            )  # fmt: skip

    def run(self) -> None:
        """Swing."""
        self.angles = [HEEL]
        for _ in range(round(SWUNG / STEP)):
            if self.setting.method == "liquid":
                self.liquid.set_solids(SolidSurface(self.world))
                self.liquid.advance(STEP)
                self.world.step(STEP)
                self.angles.append(float(self.world.bodies.angles[self.body]))
            else:
                self.law.step(STEP, max(1, round(STEP / self.setting.knob)))
                self.angles.append(float(self.law.pose[TURN]))

    def outcome(self) -> Outcome:
        """How much longer a roll lasts than without added mass, as a share; the liquid's has it by itself."""
        found = period_of(self.angles)
        error = abs(found / BESIDE - 1.0) if np.isfinite(found) else 1.0
        return Outcome(max(error, 1e-7), len(self.angles) - 1)


def _settings() -> list[Setting]:
    law = [
        Setting(method, STEP / parts, {}, {}, float(parts))
        for method in ("none", "ellipse")
        for parts in PARTS
    ]
    return [*law, *(Setting("liquid", TANK / n, {}, {}, 30.0 * n) for n in CELLS)]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's liquid, as large a share of the tank."""
    cell = min(max(TANK / int(parameters["cells"]), TANK / CELLS[-1]), TANK / CELLS[0])
    return Setting("liquid", cell, {})


floating_study = Study(
    name="floating",
    title="A log rolls",
    error="roll period beyond hydrostatics",
    error_unit="",
    counter="steps",
    knob=Knob("cell", "cell, or step", ""),
    methods=(
        Method("none", "hydrostatics, without added mass", 1.0),
        Method("ellipse", "hydrostatics, half an ellipse", 0.0),
        Method("liquid", "in a liquid", 0.0),
    ),
    settings=_settings,
    trial=RollTrial,
    reference="2 pi sqrt((b^2 + h^2)/(12 g GM)), without added mass",
    expectation="Statics alone is exact for its own law; water that moves along makes a roll longer.",
    present=_present,
    workload=Workload("a log 0.5 m wide, for 2 s"),
)

"""What accuracy costs for a floating log: its draft, by hydrostatics and in a liquid."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.grid.layout import Grid
from game.physics.hydrostatics import FloatingBody, FloatingSettings, exact, make_floater
from game.physics.hydrostatics.motion import Tank, Y
from game.physics.liquid import Liquid, LiquidSettings
from game.physics.solids import Material, SolidSettings, SolidWorld, box
from game.physics.surfaces import SolidSurface

WIDTH, HEIGHT, RATIO = 0.5, 0.2, 0.5  # of the log, m, and its density beside water's
TANK, DEPTH, HEEL = 1.25, 0.5, 0.1  # m, m, rad
SWUNG, MEAN = 4.0, 1.5  # s, and the last of them over which it is taken in the mean
STEP = 1.0 / 120.0
CELLS, PARTS = (20, 28, 40, 56), (1, 2, 4, 8)
LEAST = 1e-7


class DraftTrial:
    """A log that is let go a little heeled. When its swings have died down its draft is taken."""

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
            water = self.liquid.count * self.liquid.area
            self.level = (water + WIDTH * HEIGHT * RATIO) / TANK
        else:
            w, h = 0.5 * WIDTH, 0.5 * HEIGHT
            log = make_floater([(-w, -h), (w, -h), (w, h), (-w, h)], 1000.0 * RATIO)
            added = int(self.setting.method == "ellipse")
            self.level = level
            self.law = FloatingBody(
                log, Tank(TANK, TANK * DEPTH, 1000.0), (0.5 * TANK, level), HEEL,
                settings=FloatingSettings(added=added, waves=0.3),
            )  # fmt: skip

    def run(self) -> None:
        """Swing, and come to rest."""
        self.heights = list[float]()
        for _ in range(round(SWUNG / STEP)):
            if self.setting.method == "liquid":
                self.liquid.set_solids(SolidSurface(self.world))
                self.liquid.advance(STEP)
                self.world.step(STEP)
                self.heights.append(float(self.world.bodies.positions[self.body, 1]))
            else:
                self.law.step(STEP, max(1, round(STEP / self.setting.knob)))
                self.heights.append(float(self.law.pose[Y]))

    def outcome(self) -> Outcome:
        """Error of the mean draft over what Archimedes says."""
        mean = float(np.mean(self.heights[-round(MEAN / STEP) :]))
        draft = self.level - (mean - 0.5 * HEIGHT)
        return Outcome(max(abs(draft / (RATIO * HEIGHT) - 1.0), LEAST), len(self.heights))


def _settings() -> list[Setting]:
    law = [
        Setting(method, STEP / parts, {}, {"added": method, "both": False}, float(parts))
        for method in ("none", "ellipse")
        for parts in PARTS
    ]
    return [*law, *(Setting("liquid", TANK / n, {}, {"both": True}, 30.0 * n) for n in CELLS)]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's liquid, as large a share of the tank."""
    cell = min(max(TANK / int(parameters["cells"]), TANK / CELLS[-1]), TANK / CELLS[0])
    return Setting("liquid", cell, {})


floating_study = Study(
    name="floating",
    title="A log comes to rest",
    error="relative error of the draft",
    error_unit="",
    counter="steps",
    knob=Knob("cell", "cell, or step", ""),
    methods=(
        Method("none", "hydrostatics, without added mass", 0.0),
        Method("ellipse", "hydrostatics, half an ellipse", 0.0),
        Method("liquid", "in a liquid", 1.0),
    ),
    settings=_settings,
    trial=DraftTrial,
    reference="Archimedes: the draft is the density beside water's times the height",
    expectation="Hydrostatics is exact at rest, for next to nothing; in the liquid some percent are left.",
    present=_present,
    workload=Workload("a log 0.5 m wide, for 4 s"),
)

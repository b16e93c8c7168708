"""One dam by several methods, beside what was measured and what is exactly known."""

from __future__ import annotations

import math
from typing import Annotated

import msgspec
import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.particle_fluids import FluidSettings
from game.physics.waves import DamBreak, dam_break
from game.physics.waves.experiments import filmed_front
from game.scenes.liquid.level import Size
from game.scenes.liquid.methods import COLUMNS, TALL, Column, DamMethod, DamState
from game.stage import Choice, Param, Parameters, Readout, Toggle, control_of
from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations
from game.worlds.world import World

EARTH = 9.81  # m/s²
OTHER_CODE = 13.8  # s of processor for a second of a column 1 m wide there: PySPH, 3,938 particles
GAP = 0.12  # of the column's height, between two tanks and above the upper one
BESIDE = 0.7  # of the floor's length, right of the tanks, where each method is spoken of


class DamContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level: width and height of the column, length of the floor, m."""

    width: Size = 0.5
    height: Size = 1.0
    length: Annotated[float, msgspec.Meta(ge=0.05, le=100.0)] = 3.0
    expected: Expectations = ()

    @property
    def rise(self) -> float:
        """m from one floor to the next."""
        return (TALL + GAP) * self.height

    @property
    def view(self) -> View:
        """All tanks, and what is said beside them."""
        edge, many = 0.04 * self.length, len(COLUMNS)
        right = (1.0 + BESIDE) * self.length
        return View(
            left=-edge, bottom=-0.1 * self.height, right=right, top=many * self.rise + 0.1 * self.height
        )


class DamParameters(Parameters):
    """The methods, and what is shown beside them."""

    gravity = Param(9.81, 0.1, 30.0, unit="m/s²", group="World", rebuild=True, help="downwards")
    cells = Param(
        20, 4, 64, whole=True, log=True, group="Liquid", rebuild=True, help="along the column's width"
    )
    carrier = Choice(
        "apic", ("apic", "pic-flip"), labels=("APIC", "PIC and FLIP"), group="Liquid", rebuild=True,
        label="Speeds by", help="how speeds pass between particles and cells",
    )  # fmt: skip
    particles = Param(512, 32, 4096, whole=True, log=True, group="Particles", rebuild=True, label="How many",
                      help="about so many, whole rows in the column")  # fmt: skip
    law = control_of(
        FluidSettings, "law", labels=("Müller 2003 (P09)", "Clavet 2005 (P11)", "Position based", "DFSPH"),
        group="Particles", rebuild=True, label="Pressure by",
    )  # fmt: skip
    row = Param(400, 20, 4000, whole=True, log=True, group="Shallow water", rebuild=True, label="Cells",
                help="along the floor")  # fmt: skip
    exact = Toggle(True, group="Shown", help="the surface of shallow water by Ritter")
    experiment = Toggle(True, group="Shown", help="the front as it was measured")


class DamWorld(World):
    """Columns one above the other, that fall at the same time. methods: all that there are, from the top."""

    state_type = DamState

    def __init__(self, content: DamContent, parameters: DamParameters, active: EffectSet, seed: int):
        if content.width >= content.length:
            raise ValueError(
                f"width = {content.width!r}: expected less than the length, {content.length:g} m"
            )
        column = Column(content.width, content.height, content.length, float(parameters.gravity))
        self.column = column
        floors = [content.rise * k for k in reversed(range(len(COLUMNS)))]
        self.methods: tuple[DamMethod, ...] = tuple(
            make(column, floor, parameters) for make, floor in zip(COLUMNS, floors, strict=True)
        )
        self.theory: DamBreak = dam_break(content.height, 0.0, column.gravity)
        super().__init__(content, parameters, active, *self.methods)

    @property
    def scaled(self) -> float:
        """The time as t sqrt(2 g / width)."""
        return self.time * math.sqrt(2.0 * self.column.gravity / self.column.width)

    @property
    def alike(self) -> bool:
        """Whether the column is as high beside its width as in the experiment."""
        return abs(self.column.height / self.column.width - 2.0) < 1e-6

    def times_as_fast(self, one: DamMethod) -> float:
        """As a particle code by others (PySPH); NaN for other columns, and before a step was measured.

        A column so wide falls as one of 1 m does, but in √(width / gravity) of its time.
        """
        if not self.alike:
            return math.nan
        pace = math.sqrt(self.column.gravity / (EARTH * self.column.width))
        return OTHER_CODE * pace * one.stepped / one.watch.median("step")

    def measured(self) -> float:
        """The front of the experiment now, m; NaN for other columns, before and after what was measured."""
        front = filmed_front(self.column.height, self.time, self.column.gravity)
        return self.column.width + front if self.alike else math.nan

    def exact_front(self) -> float:
        """Ritter's, m; NaN as soon as it is at the end of the floor."""
        front = self.column.width + self.theory.bore * self.time
        return front if front < self.column.length else math.nan

    def surface(self) -> tuple[Floats, Floats] | None:
        """x and depth (n,) m by Ritter, until the wave that goes back meets the wall; then None."""
        back = math.sqrt(self.theory.gravity * self.theory.left) * self.time
        if not 0.0 < back < self.column.width or math.isnan(self.exact_front()):
            return None
        x = np.linspace(0.0, self.exact_front(), 80)
        return x, self.theory.at(x - self.column.width, self.time)[0]


def readouts(model: DamWorld) -> list[Readout]:
    """Fronts, then volumes and prices of each method."""
    fronts = [Readout(f"front, {one.name}", one.front(), "m") for one in model.methods]
    losses = [Readout(f"volume error, {one.name}", one.volume() / one.area - 1.0) for one in model.methods]
    prices = [Readout(f"price, {one.name}", one.watch.median("step"), "s") for one in model.methods]
    return [
        *fronts, Readout("front, experiment", model.measured(), "m"),
        Readout("front, Ritter", model.exact_front(), "m"), *losses, *prices,
        Readout("scaled time", model.scaled),
    ]  # fmt: skip

"""What accuracy costs in the wind tunnel: cells and steps against drag, angles and order against the fit."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache, partial
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.kernels import elementwise
from game.physics.tunnel import (
    Sweep,
    SweepPlan,
    Tunnel,
    TunnelSettings,
    fit_plate,
    fit_series,
    shape_named,
)
from game.physics.tunnel.averages import Average
from game.physics.tunnel.sweep import BOOK, DRAG, with_images

CHANNEL_DRAG, CHANNEL_LIFT = 5.57953523384, 0.010618948146  # Schäfer and Turek 1996, 2D-1, by Nabh 1998
SETTLED, WINDOW = 24.0, 1.0  # diameters over mean wind
METHODS = ("book", "wall")


def channel(cells: float, courant: float = 0.5, width: float = 14.0) -> TunnelSettings:
    """Schäfer and Turek's channel (1996), test 2D-1, with the diameter as the metre: 4.1 high, the cylinder 2
    from inflow and floor, walls that the air sticks to, Reynolds number 20 by the mean wind. Theirs: 22 long.
    """
    return TunnelSettings(
        cells=cells, width=width, height=4.1, at=(2.0, 2.0), reynolds=20.0, walls="no-slip",
        profile="parabolic", courant=courant, nudge=0.0,
    )  # fmt: skip


class DragTrial:
    """The cylinder in the channel on so many cells to its diameter, until the flow stands."""

    simulated_s = SETTLED + WINDOW

    def __init__(self, setting: Setting):
        self.cells, self.method = float(setting.knob), setting.method

    def reset(self) -> None:
        """The wind as it begins."""
        self.tunnel = Tunnel(shape_named("disc"), channel(self.cells))
        self.average = Average(SETTLED, WINDOW)

    def run(self) -> None:
        """All steps."""
        while not self.average.done:
            self.tunnel.step()
            self.average.take(self.tunnel.reading, self.tunnel.step_length)

    def outcome(self) -> Outcome:
        """Error of the drag coefficient, over the drag coefficient."""
        mean = self.average.mean()
        found = mean.book[0] if self.method == "book" else mean.wall[0]
        steps = round(self.simulated_s / self.tunnel.step_length)
        return Outcome(abs(found / CHANNEL_DRAG - 1.0), steps)


def _settings(cells: tuple[int, ...]) -> list[Setting]:
    return [
        Setting(name, float(n), {}, {"cells": n, "measure": name}, 1.0 / n) for name in METHODS for n in cells
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting(str(parameters["measure"]), float(parameters["cells"]), {})


FIT_CELLS, FIT_RE, FIT_SETTLE, FIT_WINDOW, ANGLES_OF_ALL = 8.0, 60.0, 6.0, 6.0, 48


@lru_cache(maxsize=1)
def plate_polar() -> tuple[np.ndarray, np.ndarray]:
    """Angles (n,) rad and coefficients (n, 3) of a plate, every 7.5 degrees of the whole turn."""
    outline, sweep = shape_named("plate"), Sweep()
    settings = TunnelSettings(cells=FIT_CELLS, width=10.0, height=6.0, reynolds=FIT_RE, nudge=0.0)
    following: float | None = sweep.begin(outline, SweepPlan(ANGLES_OF_ALL, 0))
    tunnel, average = Tunnel(outline, settings), Average(FIT_SETTLE, FIT_WINDOW)
    while following is not None:
        tunnel.turn(following)
        average.clear()
        while not average.done:
            tunnel.step()
            average.take(tunnel.reading, tunnel.step_length)
        following = sweep.keep(average.mean())
    rows = sweep.measured()
    rows[:, DRAG : DRAG + 3] = rows[:, BOOK : BOOK + 3]
    return with_images(rows, outline)


class FitTrial:
    """A fit to some of the angles of a plate's polar, judged at the others."""

    simulated_s = 1.0

    def __init__(self, setting: Setting):
        self.count, self.method = int(setting.knob), setting.method

    def reset(self) -> None:
        """The polar, measured once."""
        self.angles, self.values = plate_polar()

    def run(self) -> None:
        """The fit."""
        given = slice(None, None, ANGLES_OF_ALL // self.count)
        angles, values = self.angles[given], self.values[given]
        if self.method == "series":
            found = fit_series(angles, values, (self.count - 1) // 2)
            away = found.at(self.angles) - self.values
        else:
            plate = fit_plate(angles, values)
            turn = 2.0 * self.angles
            drag = plate.drag - plate.drag_turn * elementwise.cos(turn)
            away = np.stack([drag, plate.glide * elementwise.sin(turn)], axis=1) - self.values[:, :2]
        left = np.ones(len(self.angles), bool)
        left[given] = False
        self.error = float(np.sqrt(np.mean(away[left, :2] * away[left, :2])))

    def outcome(self) -> Outcome:
        """Root mean square of drag and lift at the angles that the fit was not given."""
        return Outcome(self.error, self.count)


def _fit_settings() -> list[Setting]:
    return [
        Setting(name, float(n), {}, {"angles": n}, 1.0 / n)
        for name in ("series", "plate")
        for n in (4, 8, 12, 16, 24)
    ]


def _present_fit(parameters: Mapping[str, Any]) -> Setting:
    return Setting("series", float(parameters["angles"]), {})


fit_study = Study(
    name="polar-fit",
    title="A plate's polar from few angles",
    error="drag and lift at angles that were not given, root mean square",
    error_unit="",
    counter="angles",
    knob=Knob("angles", "angles of a whole turn"),
    methods=(Method("series", "Fourier series", None), Method("plate", "plates' law", None)),
    settings=_fit_settings,
    trial=FitTrial,
    reference="The same tunnel at 48 angles.",
    expectation="Three numbers of the plates' law cannot follow a polar; a series needs a dozen angles.",
    present=_present_fit,
    workload=Workload("a plate at Reynolds number 60, 8 cells to its chord"),
)

drag_study = Study(
    name="channel-drag",
    title="Drag of a cylinder in a channel",
    error="drag coefficient, over what it is",
    error_unit="",
    counter="steps",
    knob=Knob("cells", "cells to a diameter"),
    methods=(Method("book", "momentum book", 1.0), Method("wall", "pressure and friction", 1.0)),
    settings=partial(_settings, (5, 7, 10, 14)),
    trial=DragTrial,
    reference="5.57953523384, Schäfer and Turek's test 2D-1 (1996) by Nabh (1998).",
    expectation="The book of momentum does not ask what happens at the wall, and is nearer on few cells.",
    present=_present,
    workload=Workload("Reynolds number 20 by the mean wind, from rest for 25 diameters over wind"),
    related=(fit_study,),
)

"""What accuracy costs in the wind tunnel: cells and steps against drag, angles and order against the fit."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache, partial
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import Computation, chosen_setting, every_setting
from game.physics.kernels import elementwise
from game.physics.tunnel import (
    Sweep,
    SweepPlan,
    Tunnel,
    TunnelSettings,
    fit_plate,
    fit_series,
    outline_of,
    shape_named,
)
from game.physics.tunnel.averages import Average, Mean
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


def drag_trial(setting: Setting) -> Trial:
    """The cylinder in the channel on so many cells to its diameter: relative error of its drag."""

    def begin() -> Tunnel:
        return Tunnel(shape_named("disc"), channel(float(setting.knob)))

    def work(tunnel: Tunnel) -> tuple[Tunnel, Mean]:
        average = Average(SETTLED, WINDOW)
        while not average.done:
            tunnel.step()
            average.take(tunnel.reading, tunnel.step_length)
        return tunnel, average.mean()

    def judge(done: tuple[Tunnel, Mean]) -> Outcome:
        tunnel, mean = done
        found = mean.book[0] if setting.method == "book" else mean.wall[0]
        steps = round((SETTLED + WINDOW) / tunnel.step_length)
        return Outcome(abs(found / CHANNEL_DRAG - 1.0), steps)

    return Computation(SETTLED + WINDOW, begin, work, judge)


def _settings(cells: tuple[int, ...]) -> list[Setting]:
    return every_setting(METHODS, cells, lambda name, n: {"cells": n, "measure": name}, lambda n: 1.0 / n)


FIT_CELLS, FIT_RE, FIT_SETTLE, FIT_WINDOW, ANGLES_OF_ALL = 8.0, 25.0, 10.0, 1.0, 48


@lru_cache(maxsize=1)
def plate_polar() -> tuple[np.ndarray, np.ndarray]:
    """Angles (n,) rad and coefficients (n, 3) of a slab, every 7.5 degrees of the whole turn."""
    half, thin = 0.5, 0.125
    outline = outline_of([(-half, -thin), (half, -thin), (half, thin), (-half, thin)], 1.0)
    sweep = Sweep()
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


def fit_trial(setting: Setting) -> Trial:
    """A fit to some of the angles of a slab's polar: root mean square of drag and lift at the others."""
    count = int(setting.knob)

    def work(polar: tuple[np.ndarray, np.ndarray]) -> float:
        every, measured = polar
        given = slice(None, None, ANGLES_OF_ALL // count)
        if setting.method == "series":
            away = fit_series(every[given], measured[given], (count - 1) // 2).at(every) - measured
        else:
            plate = fit_plate(every[given], measured[given])
            turn = 2.0 * every
            drag = plate.drag - plate.drag_turn * elementwise.cos(turn)
            away = np.stack([drag, plate.glide * elementwise.sin(turn)], axis=1) - measured[:, :2]
        left = np.ones(len(every), bool)
        left[given] = False
        return float(np.sqrt(np.mean(away[left, :2] * away[left, :2])))

    return Computation(1.0, plate_polar, work, lambda error: Outcome(error, count))


def _fit_settings() -> list[Setting]:
    counts = (4, 8, 12, 16, 24)
    return every_setting(("series", "plate"), counts, lambda _, n: {"angles": n}, lambda n: 1.0 / n)


def _present_fit(parameters: Mapping[str, Any]) -> Setting:
    return Setting("series", float(parameters["angles"]), {})


fit_study = Study(
    name="polar-fit",
    short="Polar",
    title="A slab's polar from few angles",
    error="drag and lift at angles that were not given, root mean square",
    error_unit="",
    counter="angles",
    knob=Knob("angles", "angles of a whole turn", parts=True),
    methods=(Method("series", "Fourier series", None), Method("plate", "plates' law", None)),
    settings=_fit_settings,
    trial=fit_trial,
    reference="The same tunnel at 48 angles.",
    expectation="Three numbers of the plates' law err alike, whatever is measured. A series of a dozen "
    "angles errs by half of it; what is left is the grid, on which each angle lies in another way.",
    present=_present_fit,
    workload=Workload("a slab, a quarter as thick as long, at Reynolds number 25, 8 cells to its chord"),
)

TIMES_CELLS, BEGIN, LONG = 8.0, 40.0, 160.0  # chords over wind: left out, and averaged as the reference


@lru_cache(maxsize=1)
def swinging_drag() -> tuple[np.ndarray, np.ndarray]:
    """s and drag by the book (n,) of a plate at 60 degrees, whose wake swings."""
    settings = TunnelSettings(cells=TIMES_CELLS, width=10.0, height=6.0, reynolds=100.0)
    tunnel, rows = Tunnel(shape_named("plate"), settings, math.radians(60.0)), []
    for _ in range(round((BEGIN + LONG) / tunnel.step_length)):
        tunnel.step()
        rows.append((float(tunnel.pose[1]), float(tunnel.reading[6])))
    found = np.array(rows)
    return found[:, 0], found[:, 1]


def window_trial(setting: Setting) -> Trial:
    """Means over windows of a length, one after another, of the drag of a swinging wake: their scatter."""
    window = float(setting.knob)

    def work(record: tuple[np.ndarray, np.ndarray]) -> float:
        times, drag = record
        drag = drag[times > BEGIN]
        count = round(window / (times[1] - times[0]))
        parts = drag[: len(drag) // count * count].reshape(-1, count).mean(axis=1)
        away = parts - drag.mean()
        return float(np.sqrt(np.mean(away * away)) / drag.mean())

    return Computation(window, swinging_drag, work, lambda error: Outcome(error, round(window)))


def _windows() -> list[Setting]:
    return [Setting("mean", w, {}, {"window": w}, 1.0 / w) for w in (2.0, 4.0, 8.0, 16.0, 32.0)]


def _present_window(parameters: Mapping[str, Any]) -> Setting:
    return Setting("mean", float(parameters["window"]), {})


window_study = Study(
    name="drag-window",
    short="Wake",
    title="How long a swinging wake is averaged",
    error="mean drag, over that of 160 chords",
    error_unit="",
    counter="chords",
    knob=Knob("window", "chords that the wind goes", parts=True),
    methods=(Method("mean", "mean over a window", 1.0),),
    settings=_windows,
    trial=window_trial,
    reference="The mean over 160 chords of wind.",
    expectation="A window of some beats errs by the part of a beat that it cuts off: one over its length.",
    present=_present_window,
    workload=Workload("a plate at 60 degrees and Reynolds number 100, on 8 cells to its chord"),
)

drag_study = Study(
    name="channel-drag",
    short="Drag",
    title="Drag of a cylinder in a channel",
    error="drag coefficient, over what it is",
    error_unit="",
    counter="steps",
    knob=Knob("cells", "cells to a diameter", parts=True),
    methods=(
        Method("book", "momentum book", None, "its error falls faster than the cells"),
        Method("wall", "pressure and friction", 1.0),
    ),
    settings=partial(_settings, (5, 7, 10, 14)),
    trial=drag_trial,
    reference="5.57953523384, Schäfer and Turek's test 2D-1 (1996) by Nabh (1998).",
    expectation="The book of momentum does not ask what happens at the wall: from seven cells it is nearer.",
    present=chosen_setting("measure", "cells"),
    workload=Workload("Reynolds number 20 by the mean wind, from rest for 25 diameters over wind"),
    related=(fit_study, window_study),
)

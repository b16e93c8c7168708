"""The paper on aerodynamics from data, whatever the direction of the wind (P16)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from time import thread_time
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.lab.studies.flow.wind_tunnel import CHANNEL_DRAG, channel
from game.lab.timing import least_time
from game.physics.kernels import elementary, elementwise
from game.physics.plates import Plate
from game.physics.tunnel import (
    DataFlight,
    SeriesFit,
    Sweep,
    SweepPlan,
    Tunnel,
    TunnelSettings,
    fit_plate,
    fit_series,
    shape_named,
)
from game.physics.tunnel.averages import Average
from game.physics.tunnel.sweep import ANGLE, BOOK, DRAG, with_images
from game.scenes.shared.marks import dot
from game.scenes.wind_tunnel.figure import draw_box, draw_forces
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

COARSE = TunnelSettings(cells=6.0, width=8.0, height=5.0, reynolds=60.0, nudge=0.0)
ANGLES, CHECKS, ORDER = 24, 3, 6
SETTLE, WINDOW = 4.0, 4.0


def _law(plate: Plate) -> SeriesFit:
    """The plates' law as a series."""
    values = np.zeros((3, 5))
    values[0, 0], values[0, 3], values[1, 4] = plate.drag, -plate.drag_turn, plate.glide
    values[2, 4] = 0.25 * math.pi * (1.0 - plate.thickness * plate.thickness)
    return SeriesFit(2, values, np.zeros(3))


class Swept(NamedTuple):
    """angles (n,) rad and values (n, 3) of a series; checks (m, k): rows of angles kept apart."""

    angles: Floats
    values: Floats
    checks: Floats


@lru_cache(maxsize=1)
def swept_plate() -> Swept:
    """A plate in the tunnel on a coarse grid, with its mirror images."""
    outline, sweep = shape_named("plate"), Sweep()
    following: float | None = sweep.begin(outline, SweepPlan(ANGLES, CHECKS))
    tunnel, average = Tunnel(outline, COARSE), Average(SETTLE, WINDOW)
    while following is not None:
        tunnel.turn(following)
        average.clear()
        while not average.done:
            tunnel.step()
            average.take(tunnel.reading, tunnel.step_length)
        following = sweep.keep(average.mean())
    sweep.table[:, DRAG : DRAG + 3] = sweep.table[:, BOOK : BOOK + 3]
    return Swept(*with_images(sweep.measured(), outline), sweep.measured(True))


def measured_plate() -> tuple[SeriesFit, Floats, Floats]:
    """A plate on a coarse grid: the series through its angles, errors at the checks (drag, lift) of series
    and plates' law."""
    angles, values, rows = swept_plate()
    series, plate = fit_series(angles, values, ORDER), fit_plate(angles, values)
    twice = 2.0 * rows[:, ANGLE]
    by_law = np.stack(
        [plate.drag - plate.drag_turn * elementwise.cos(twice), plate.glide * elementwise.sin(twice)], axis=1
    )
    away = by_law - rows[:, DRAG : DRAG + 2]
    law_error = np.sqrt(np.mean(away * away, axis=0))
    return series, series.error(rows[:, ANGLE], rows[:, DRAG : DRAG + 3])[:2], law_error


def _measure() -> Iterator[Comparison]:
    tunnel, average = Tunnel(shape_named("disc"), channel(8.0, 0.8, 9.0)), Average(14.0, 1.0)
    tunnel.step()
    steps, start = 0, thread_time()
    while not average.done:
        tunnel.step()
        average.take(tunnel.reading, tunnel.step_length)
        steps += 1
    cost, mean = (thread_time() - start) / steps, average.mean()
    yield Comparison(
        f"drag of a cylinder on 8 cells where it is {CHANNEL_DRAG:.2f} (Schäfer and Turek 1996), by the "
        "momentum book and along the wall", "", f"{mean.book[0]:.2f}, {mean.wall[0]:.2f}",
    )  # fmt: skip
    series, by_series, by_law = measured_plate()
    yield Comparison(
        "drag and lift of a plate at angles that were not measured: a series of order 6 errs by", "",
        f"{by_series[0]:.2f}, {by_series[1]:.2f}",
    )  # fmt: skip
    yield Comparison("the plates' law, fitted to the same, by", "", f"{by_law[0]:.2f}, {by_law[1]:.2f}")
    flight = DataFlight(Plate(0.05, 1.4, 0.1), series)
    each = least_time(lambda: flight.step(1.0 / 60.0), 200)
    yield Comparison(
        "a frame of flight by the series, and a step of the air around it", "",
        f"{1e6 * each:.0f} µs, {1e6 * cost:.0f} µs",
    )  # fmt: skip


def _draw_series(pen: Pen) -> None:
    """Twelve angles of a plate by the law, and series of order 1 and 2 through them."""
    plate = Plate()
    angles = 2.0 * math.pi * np.arange(12) / 12.0 - math.pi
    values = _law(plate).at(angles)

    def place(angle: float, value: float) -> tuple[float, float]:
        return 148.0 + 124.0 * angle / math.pi, 126.0 - 38.0 * value

    pen.line((place(-math.pi, 0.0), place(math.pi, 0.0)), "text3", 1.0)
    for order, color, dash in ((1, "text3", 4.0), (2, "vermilion", 0.0)):
        series = fit_series(angles, values, order)
        line = [place(a, float(series.at(a)[0, 0])) for a in np.linspace(-math.pi, math.pi, 73).tolist()]
        pen.line(line, color, 1.8, dash=dash)
    lift = fit_series(angles, values, 2)
    pen.line(
        [place(a, float(lift.at(a)[0, 1])) for a in np.linspace(-math.pi, math.pi, 73).tolist()], "green", 1.8
    )
    for angle, row in zip(angles.tolist(), values.tolist(), strict=True):
        dot(pen, place(angle, row[0]), "vermilion", 3.2)
        dot(pen, place(angle, row[1]), "green", 3.2)
    pen.words("drag", 40.0, 16.0, "vermilion")
    pen.words("lift", 90.0, 16.0, "green")
    pen.words("−180°", 30.0, 192.0, "text2")
    pen.words("180°", 268.0, 192.0, "text2")


def _draw_checks(pen: Pen) -> None:
    """The series through measured angles, and what was measured at angles that it was not given."""
    angles, values, rows = swept_plate()
    series = fit_series(angles, values, ORDER)
    most = float(np.max(np.abs(values[:, :2])))

    def place(angle: float, value: float) -> tuple[float, float]:
        return 24.0 + 250.0 * angle / (0.5 * math.pi), 120.0 - 90.0 * value / most

    pen.line((place(0.0, 0.0), place(0.5 * math.pi, 0.0)), "text3", 1.0)
    shown = np.linspace(0.0, 0.5 * math.pi, 61)
    for column, color in ((0, "vermilion"), (1, "green")):
        curve = series.at(shown)[:, column].tolist()
        pen.line([place(a, c) for a, c in zip(shown.tolist(), curve, strict=True)], color, 1.8)
        for angle, value in zip(angles.tolist(), values[:, column].tolist(), strict=True):
            if -1e-9 <= angle <= 0.5 * math.pi + 1e-9:
                dot(pen, place(angle, value), color, 3.2)
        for row in rows:
            dot(pen, place(float(row[ANGLE]), float(row[DRAG + column])), "amber", 4.8, ring=1.6)
    pen.words("drag", 40.0, 16.0, "vermilion")
    pen.words("lift", 90.0, 16.0, "green")
    pen.words("not given", 150.0, 16.0, "amber")
    pen.words("0°", 24.0, 192.0, "text2")
    pen.words("90°", 270.0, 192.0, "text2")


def _draw_flight(pen: Pen) -> None:
    """A plate that falls by the law's own coefficients, and one that is lifted half as much."""
    plate = Plate(0.05, 1.4)
    for share, color, left in ((1.0, "chalk", 70.0), (0.5, "amber", 190.0)):
        series = _law(plate)
        series.coefficients[1] *= share
        flight = DataFlight(plate, series)
        flight.row[2] = 0.2
        for step in range(130):
            if step % 4 == 0:
                x, y, turn = left + 150.0 * flight.row[0], 22.0 - 210.0 * flight.row[1], flight.row[2]
                along = 11.0 * elementary.cos(turn), -11.0 * elementary.sin(turn)
                if not (12.0 < x < 284.0 and y < 196.0):
                    break
                pen.line(((x - along[0], y - along[1]), (x + along[0], y + along[1])), color, 1.8)
            flight.step(1.0 / 120.0)


OMNIAD = Paper(
    problem=(
        "Leaves, sheets and kites tumble, glide and flutter in ways that a drag alone does not give. To "
        "compute the air around each is slow, and a wind tunnel gives drag and lift for a few directions of "
        "the wind only. Can the air's force on a rigid thing of any shape be had for every direction, and "
        "cheaply enough for play?",
    ),
    idea=(
        "Let force and moment be smooth functions of the direction from which the wind comes, written in a "
        "few smooth waves over all directions: spherical harmonics. Find their coefficients from data, and "
        "take them in place of the air.",
    ),
    steps=(
        Step(
            "In the frame of the thing the wind has a direction and a speed. At a given direction force and "
            "moment go with the square of the speed.",
            draw_forces,
            r"F = \frac{1}{2} \rho U^2 c C(\alpha)",
        ),
        Step(
            "The authors take their data from the fall of the thing itself, filmed by one camera. Ours come "
            "from a tunnel on a grid: the wind blows past the shape, and the momentum that a box around it "
            "loses is the force.",
            draw_box,
            r"\v{F} = - \dot{\v{P}} - \int (\v{u} u_n + p \v{n} - \tau)",
        ),
        Step(
            "In a plane the harmonics are a Fourier series in the angle of attack; least squares give its "
            "coefficients. Too low an order misses what the air does (dashed: order 1).",
            _draw_series,
            r"C = a_0 + \sum a_k \cos k \alpha + b_k \sin k \alpha",
        ),
        Step(
            "Integrate the rigid thing with these forces, added mass and the drag on its spin: it flutters, "
            "tumbles or glides by its coefficients alone (blue: a plate; amber: with half the lift).",
            _draw_flight,
        ),
        Step(
            "Angles that no fit was given tell what it is worth: the amber rings of this scene.",
            _draw_checks,
        ),
    ),
    showed=(
        "Coefficients of real things from their fall before one camera. Leaves and the like tumble and "
        "glide in real time with no air computed. With a tool one designs kites of unusual shapes that do "
        "fly.",
    ),
    measure=_measure,
    limits=(
        "Ours is a plane, at Reynolds numbers of tens to hundreds, on a grid whose walls stand near. What "
        "flies takes the coefficients of that Reynolds number. What is measured at rest knows nothing of "
        "the lift and drag on a spin, which are the plates' law's. A force that depends on the wind of "
        "this moment alone has no memory: vortices that were shed before, and may come back, are left out.",
    ),
    after=(
        "Flow and forces about a shape that is still being drawn, learnt from many simulations (Umetani "
        "and Bickel 2018). Wings by a panel method whose matrices are made before (Xie, Igarashi and "
        "Miyata 2018).",
    ),
)

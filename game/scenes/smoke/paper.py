"""The papers on stable fluids (P14): Stam 1999, and his program of 2003."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from game.lab.studies.gases.whirl import METHODS, whirl_after
from game.lab.timing import least_time
from game.physics.stable_fluids import PrintedFluid
from game.scenes.smoke.figure import draw_projection, draw_trace
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

CELLS = 32
TURNS = 0.5  # s that the whirl is followed
NAMES = {"stam-1999": "1999 as printed", "stam-2003": "2003 as printed", "time-centred": "time-centred"}


def _draw_dye(pen: Pen) -> None:
    """A disc of dye after it has been carried across by both papers' ways, in a steady whirl."""
    for place, paper in ((12.0, "stam-1999"), (154.0, "stam-2003")):
        fluid = PrintedFluid((CELLS, CELLS), 1.0 / CELLS, 1, paper)
        x = (np.arange(CELLS) + 0.5) / CELLS
        fluid.inner[0][:] = np.sin(math.pi * x)[None, :] * np.cos(math.pi * x)[:, None]
        fluid.inner[1][:] = -np.cos(math.pi * x)[None, :] * np.sin(math.pi * x)[:, None]
        fluid.inner[2][18:26, 12:20, 0] = 1.0
        for _ in range(20):
            fluid.step(0.05)
        dye, side = np.clip(fluid.inner[2][..., 0], 0.0, 1.0), 130.0 / CELLS
        for j in range(CELLS):
            for i in range(CELLS):
                if dye[j, i] > 0.04:
                    size = side * math.sqrt(float(dye[j, i]))
                    middle = (place + (i + 0.5) * side, 168.0 - (j + 0.5) * side)
                    pen.box(middle[0] - 0.5 * size, middle[1] - 0.5 * size, size, size, "chalk")
        far = place + 130.0
        pen.line(((place, 38.0), (far, 38.0), (far, 168.0), (place, 168.0), (place, 38.0)),
                 "text3", 1.0)  # fmt: skip
        pen.words(NAMES[paper], place + 65.0, 186.0, "text2")


def _draw_force(pen: Pen) -> None:
    """A jet's force on fluid at rest: what one step adds, and the flow that it has made after twenty."""
    fluid = PrintedFluid((CELLS, CELLS), 1.0 / CELLS, 0, "stam-1999")
    for place, steps in ((12.0, 1), (154.0, 19)):
        for _ in range(steps):
            fluid.inner[0][14:18, 4:8] += 0.2
            if place > 12.0:
                fluid.step(0.05)
        far, side = place + 130.0, 130.0 / CELLS
        pen.line(((place, 38.0), (far, 38.0), (far, 168.0), (place, 168.0), (place, 38.0)),
                 "text3", 1.0)  # fmt: skip
        for j in range(1, CELLS, 3):
            for i in range(1, CELLS, 3):
                u, v = float(fluid.inner[0][j, i]), float(fluid.inner[1][j, i])
                x, y = place + (i + 0.5) * side, 168.0 - (j + 0.5) * side
                long = max(math.hypot(u, v), 1e-12)
                size = min(40.0 * long, 11.0) / long
                if long * size > 1.0:
                    pen.arrow((x, y), (x + size * u, y - size * v), "chalk", 1.2)
                else:
                    pen.disc(x, y, 0.8, "text3")
    pen.words("force of one step", 77.0, 186.0, "text2")
    pen.words("twenty steps later", 219.0, 186.0, "text2")


def _draw_viscosity(pen: Pen) -> None:
    """The speed across a jet: before, and after one step of a tenth of a second with two viscosities."""
    middle = (np.arange(CELLS) + 0.5) / CELLS
    jet = np.exp(-np.square((middle - 0.5) / 0.08))
    pen.line(((40.0, 20.0), (40.0, 176.0)), "text3", 1.0)
    for row, (viscosity, color) in enumerate(((0.0, "text1"), (0.02, "chalk"), (2.0, "amber"))):
        fluid = PrintedFluid((CELLS, CELLS), 1.0 / CELLS, 0, "stam-1999", viscosity)
        fluid.inner[0][:] = jet[:, None] * np.sin(math.pi * middle)[None, :]
        fluid.step(0.1)
        speeds = fluid.inner[0][:, CELLS // 2].tolist()
        line = [(40.0 + 190.0 * u, 176.0 - 156.0 * y) for u, y in zip(speeds, middle.tolist(), strict=True)]
        pen.line(line, color, 1.8)
        pen.words(f"{viscosity:g} m²/s", 284.0, 30.0 + 17.0 * row, color, "right")
    pen.words("u", 226.0, 192.0, "text2")


def _draw_sweeps(pen: Pen) -> None:
    """Divergence that is left of one whirl, of an eighth and of all the box, by the number of sweeps."""
    pen.line(((44.0, 18.0), (44.0, 168.0), (280.0, 168.0)), "text3", 1.0)
    counts = (1, 2, 5, 10, 20, 50, 100, 200, 400, 800)

    def place(count: float, share: float) -> tuple[float, float]:
        return 44.0 + 80.0 * math.log10(count), 28.0 - 32.0 * math.log10(max(share, 10.0**-4.3))

    x = (np.arange(CELLS) + 0.5) / CELLS
    for waves, color, words in ((4, "chalk", "an eighth of the box"), (1, "amber", "half a wave across it")):
        line = []
        for count in counts:
            fluid = PrintedFluid((CELLS, CELLS), 1.0 / CELLS, 0, "stam-2003", 0.0, count)
            fluid.inner[0][:] = np.sin(math.pi * waves * x)[None, :] * np.cos(math.pi * waves * x)[:, None]
            before = float(np.max(np.abs(fluid.divergence())))
            fluid.step(1e-9)
            line.append(place(count, float(np.max(np.abs(fluid.divergence()))) / before))
        pen.line(line, color, 1.8)
        pen.words(words, 52.0, 112.0 + 17.0 * (waves == 1), color, "left", size=11)
    pen.line((place(20, 1.0), place(20, 1e-4)), "vermilion", 1.2, dash=4.0)
    pen.words("20", place(20, 1.0)[0], 182.0, "vermilion")
    pen.words("sweeps", 264.0, 182.0, "text2")
    pen.words("1", 36.0, 28.0, "text2", "right")
    pen.formula("10^{-4}", 24.0, 156.0, "text2")


def _measure() -> Iterator[Comparison]:
    divergence, energy, cost = {}, {}, {}
    for method in METHODS:
        found = whirl_after(method, CELLS, TURNS)
        spent = least_time(partial(whirl_after, method, CELLS, TURNS))
        cost[method] = 1e9 * spent / (found.steps * CELLS * CELLS // 2)
        divergence[method], energy[method] = found.divergence, found.energy
    for method, words in NAMES.items():
        yield Comparison(f"divergence that is left, {words}", "", f"{divergence[method]:.1e} /s")
    for method, words in NAMES.items():
        yield Comparison(
            f"energy of a steady whirl after {TURNS:g} s, {words}", "", f"{100.0 * energy[method]:.1f} %"
        )
    for method, words in NAMES.items():
        yield Comparison(f"a cell and step, {words}", "", f"{cost[method]:.0f} ns")
    fluid = PrintedFluid((16, 16), 1.0 / 16, 0, "stam-1999")
    fluid.inner[0][:] = np.random.default_rng(4).normal(0.0, 1.0, (16, 16))
    for _ in range(5):
        fluid.step(100.0)
    grown = float(np.max(np.abs(fluid.inner[0])))
    yield Comparison(
        "fastest after five steps of 100 s, from 1 m/s", "stable for any step", f"{grown:.2g} m/s"
    )


STABLE = Paper(
    problem=(
        "Fluids for pictures were computed explicitly: a step had to be shorter than the way through a "
        "cell, or all blew up. Can one be made that stays bounded whatever the step, and is quick enough "
        "to be stirred by hand?",
    ),
    idea=(
        "Do not push the velocity on; ask of each cell where its fluid was one step ago, and take the "
        "velocity from there. What is found is a mean of values that were there, so nothing can grow. "
        "Then subtract a gradient so that nothing is squeezed any more.",
    ),
    steps=(
        Step(
            "Add what forces do in a step to the velocity.",
            _draw_force,
            r"\v{u}_1 = \v{u}_0 + \Delta t \v{f}",
        ),
        Step(
            "Trace back from the middle of each cell along the flow, and take the velocity between the "
            "four cells where that ends. In 1999 in two stages, in 2003 straight.",
            draw_trace,
            r"\v{u}_2(\v{x}) = \v{u}_1(\v{p}(\v{x}, - \Delta t))",
        ),
        Step(
            "Let viscosity act implicitly: a linear system, stable for any viscosity.",
            _draw_viscosity,
            r"(1 - \nu \Delta t \nabla^2) \v{u}_3 = \v{u}_2",
        ),
        Step(
            "Any flow is one without sources plus a gradient (Helmholtz and Hodge). Solve for the "
            "pressure, and keep what has no sources.",
            draw_projection,
            r"\nabla^2 p = \nabla \cdot \v{u}_3",
        ),
        Step("Carry dye, heat and smoke along the same way.", _draw_dye),
        Step(
            "The program of 2003: a hundred lines, twenty sweeps of Gauss and Seidel for each system, two "
            "projections.",
            _draw_sweeps,
        ),
    ),
    showed=(
        "Flows in two and three dimensions that were stirred while they ran, on a workstation of 1999; "
        "smoke, and textures that are carried along. In 2003 the whole program in C, in real time on an "
        "ordinary computer.",
    ),
    measure=_measure,
    limits=(
        "Each interpolation smears: a steady whirl loses energy that no viscosity took. Velocities in the "
        "middles of cells leave a checkerboard that the pressure does not see, so some divergence stays "
        "however well one solves. Splitting advection from projection is of first order, and it, more "
        "than the interpolation, takes the whirls away: our time-centred step carries a part of the old "
        "pressure along instead.",
        "Twenty sweeps leave what is large: on 128 cells a sweep takes 0.06 % of the widest wave.",
    ),
    after=(
        "Vorticity confinement put small whirls back (Fedkiw, Stam and Jensen 2001); MacCormack's "
        "correction made the carrying second order (Selle and others 2008); reflections (Zehnder and "
        "others 2018) and flow maps (Nabizadeh and others 2022) keep them; multigrid made the pressure "
        "cheap.",
    ),
)

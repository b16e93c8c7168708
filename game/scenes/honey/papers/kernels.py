"""The paper on particle fluids for interactive applications (P09)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from game.arrays import Floats
from game.lab.studies.particle_fluids import DamTrial
from game.lab.study import Setting
from game.lab.timing import least_time
from game.physics.particle_fluids import LAWS, FluidSettings, Liquid, NeighbourSearch, ParticleFluid, lattice
from game.physics.particle_fluids.smoothing import POLY6, SPIKY, VISCOUS
from game.physics.particle_fluids.sums import fill_gradients
from game.scenes.honey.papers.plots import Plot, draw_particles, kernel_values, placed
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

PRINTED = {POLY6: ("poly6", "chalk"), SPIKY: ("spiky", "vermilion"), VISCOUS: ("for viscosity", "green")}
MANY, FRAME = 5000, 1.0 / 60.0
DROP, SPACING = 1.0, 0.05  # m
POOL = ((0.0, 0.0), (3.2, 0.0), (3.2, 2.4), (0.0, 2.4))


def integral(kind: int) -> float:
    """Of a kernel over the plane, by Gauss' rule."""
    points, parts = np.polynomial.legendre.leggauss(64)
    q = 0.5 * (1.0 + points)
    return float(np.sum(0.5 * parts * 2.0 * math.pi * q * kernel_values(kind, q)[0]))


def _bend(kind: int, q: Floats) -> Floats:
    """Laplacian in the plane of poly6, of support 1; and the one that the law takes for viscosity."""
    if kind == VISCOUS:
        return np.asarray(40.0 / math.pi * (1.0 - q))
    return np.asarray(-48.0 / math.pi * (1.0 - q * q) * (1.0 - 3.0 * q * q))


def pool(count: int, law: int = 0) -> ParticleFluid:
    """About so many particles of water in the corner of a box, by Müller's law unless another is said."""
    side = round(math.sqrt(count / 2.0))
    spacing = 0.8 / side
    fluid = ParticleFluid(spacing, [Liquid(viscosity=0.5)], [POOL], FluidSettings(law=law))
    fluid.add(lattice((0.0, 0.0), (1.6, 0.8), spacing))
    return fluid


def lopsided(symmetric: bool) -> float:
    """What pressures between disordered particles add to their momentum, against the sum of all forces.

    The plain sum takes the pressure of the other alone, the symmetric one the mean of both.
    """
    fluid = ParticleFluid(SPACING, [Liquid()], [], FluidSettings(law=0, gravity=0.0))
    random = np.random.default_rng(1)
    places = lattice((0.0, 0.0), (1.0, 1.0), SPACING)
    fluid.add(places + random.normal(0.0, 0.2 * SPACING, places.shape))
    work = fluid.scratch()
    work.gather(fluid)
    count = int(work.pairs.start[-1])
    first = np.repeat(np.arange(len(work.order)), np.diff(work.pairs.start))
    second, pull = work.pairs.other[:count], work.felt.pull[:count]
    pressure = np.maximum(work.work.density - 1.0, 0.0)
    mean = 0.5 * (pressure[first] + pressure[second])
    of_first, of_second = (mean, mean) if symmetric else (pressure[second], pressure[first])
    force = np.zeros_like(work.place)
    np.add.at(force, first, -of_first[:, None] * pull)
    np.add.at(force, second, of_second[:, None] * pull)
    size = float(np.sum(np.sqrt(np.sum(np.square(force), axis=1))))
    return float(np.sqrt(np.sum(np.square(np.sum(force, axis=0))))) / size


def rim(spacing: float = SPACING) -> tuple[Floats, Floats, float]:
    """Places (n, 2) of a disc, the gradient of its colour field there, and the curvature at its rim, 1/m.

    As printed: the field's Laplacian over the length of its gradient, at particles where that is long enough.
    """
    fluid = ParticleFluid(spacing, [Liquid()], [], FluidSettings(law=0, gravity=0.0))
    places = lattice((-DROP, -DROP), (DROP, DROP), spacing)
    fluid.add(places[np.sum(np.square(places), axis=1) < DROP * DROP])
    work = fluid.scratch()
    work.gather(fluid)
    normal = np.zeros_like(work.place)
    fill_gradients(work.pairs, work.felt, work.body, normal)
    length = np.sqrt(np.sum(np.square(normal), axis=1))
    count = int(work.pairs.start[-1])
    first = np.repeat(np.arange(len(length)), np.diff(work.pairs.start))
    second, q = work.pairs.other[:count], work.pairs.gap[:count] / fluid.support
    share = spacing * spacing / fluid.support**4
    bent = share * _bend(POLY6, np.append(q, 0.0))
    total = (
        np.bincount(first, bent[:-1], len(length)) + np.bincount(second, bent[:-1], len(length)) + bent[-1]
    )
    known = length * fluid.support > 0.5
    return work.place.copy(), normal, float(np.mean(-total[known] / length[known]))


def _draw_kernels(pen: Pen) -> None:
    q = np.linspace(0.02, 1.0, 90)
    plot = Plot(pen, (30.0, 20.0, 280.0, 176.0), (0.0, 1.0), (0.0, 3.4))
    for k, (kind, (words, color)) in enumerate(PRINTED.items()):
        plot.curve(q, kernel_values(kind, q)[0], color)
        pen.words(words, 226.0, 30.0 + 18.0 * k, color)
    pen.words("distance over support", 156.0, 192.0, "text2", size=11)


def _draw_density(pen: Pen) -> None:
    """A particle of a pool, and the others as much as it feels them."""
    fluid = pool(400)
    for _ in range(20):
        fluid.advance(FRAME)
    middle = int(np.argmin(np.sum(np.square(fluid.place - (0.5, 0.35)), axis=1)))
    x, y = fluid.place[middle].tolist()
    gaps = np.sqrt(np.sum(np.square(fluid.place - (x, y)), axis=1)) / fluid.support
    shares = kernel_values(POLY6, np.minimum(gaps, 1.0))[0]
    frame, box = ((x - 0.32, x + 0.32), (y - 0.21, y + 0.21)), (8.0, 8.0, 288.0, 192.0)
    seen = (np.abs(fluid.place[:, 0] - x) < 0.3) & (np.abs(fluid.place[:, 1] - y) < 0.19)
    for place, share in zip(fluid.place[seen].tolist(), shares[seen].tolist(), strict=True):
        color = pen.veiled("amber", 1.0 - share / float(np.max(shares))) if share else "body"
        pen.disc(*placed(box, frame, *place), 7.5, color)
    pen.arc(placed(box, frame, x, y), fluid.support * 437.5, 0.0, 360.0, "amber")


def _draw_pairs(pen: Pen) -> None:
    """Sums of the forces of disordered particles by both rules, as bars."""
    for y, symmetric, words in ((60.0, False, "the other's pressure"), (130.0, True, "the mean of both")):
        found = lopsided(symmetric)
        pen.words(words, 20.0, y - 18.0, "text1", align="left")
        pen.box(20.0, y, 250.0, 16.0, "text3", ring=1.0)
        pen.box(
            20.0, y, max(250.0 * min(found / 0.1, 1.0), 1.0), 16.0, "vermilion" if not symmetric else "green"
        )
        pen.words(
            f"momentum made: {100.0 * found:.2g} % of the forces", 20.0, y + 30.0, "text2", align="left"
        )


def _draw_bends(pen: Pen) -> None:
    q = np.linspace(0.06, 0.98, 90)
    plot = Plot(pen, (30.0, 20.0, 280.0, 176.0), (0.0, 1.0), (-30.0, 30.0))
    plot.level(0.0, "text3")
    for k, kind in enumerate((POLY6, VISCOUS)):
        plot.curve(q, _bend(kind, q), PRINTED[kind][1])
        pen.words(PRINTED[kind][0], 226.0, 30.0 + 18.0 * k, PRINTED[kind][1])
    pen.words("distance over support", 156.0, 192.0, "text2", size=11)


def _draw_rim(pen: Pen) -> None:
    """Inward normals of a disc where the colour field has a slope."""
    places, normal, _ = rim(0.16)
    frame, box = ((-1.6, 1.6), (-1.1, 1.1)), (8.0, 6.0, 288.0, 198.0)
    draw_particles(pen, places, ["chalk"] * len(places), frame, box, 0.07)
    for place, slope in zip(places.tolist(), normal.tolist(), strict=True):
        if math.sqrt(slope[0] * slope[0] + slope[1] * slope[1]) > 0.8:
            tip = place[0] + 0.1 * slope[0], place[1] + 0.1 * slope[1]
            pen.arrow(placed(box, frame, *place), placed(box, frame, *tip), "amber", 1.4)


def _draw_cells(pen: Pen) -> None:
    """Particles of a pool, cells of the support's size, those in which neighbours are looked for."""
    fluid = pool(300)
    cell = fluid.support
    own = np.floor(fluid.place / cell).astype(int)
    at = np.array((4, 2))
    near = np.max(np.abs(own - at), axis=1) <= 1
    frame, box = ((0.0, 10.0 * cell), (0.0, 7.0 * cell)), (8.0, 6.0, 288.0, 202.0)
    for k in range(11):
        pen.line((placed(box, frame, k * cell, 0.0), placed(box, frame, k * cell, 7.0 * cell)), "line2", 1.0)
    for k in range(8):
        pen.line((placed(box, frame, 0.0, k * cell), placed(box, frame, 10.0 * cell, k * cell)), "line2", 1.0)
    seen = np.max(fluid.place / cell - (10.0, 7.0), axis=1) < 0.0
    colors = ["amber" if flag else "body" for flag in near[seen]]
    draw_particles(pen, fluid.place[seen], colors, frame, box, 0.22 * cell)


def _measure() -> Iterator[Comparison]:
    off = max(abs(integral(kind) - 1.0) for kind in PRINTED)
    yield Comparison(
        "integral of the three kernels, in the plane", "1, in space", f"1, off by {off:.0e} at most"
    )
    yield Comparison(
        "momentum that pressures of disordered particles make, against all forces",
        "none once symmetric", f"{100.0 * lopsided(False):.1f} % plain, {lopsided(True):.0e} symmetric",
    )  # fmt: skip
    found = [rim(spacing)[2] for spacing in (0.1, 0.05, 0.025)]
    yield Comparison(
        "curvature of a disc of 1 m by its colour field, 10, 20, 40 particles a radius", "1 /m",
        "as printed " + ", ".join(f"{one:.1f}" for one in found) + " /m",
    )  # fmt: skip
    fluid = pool(MANY)
    for _ in range(10):
        fluid.advance(1e-3)
    step = fluid.longest_step()
    cost = least_time(lambda: fluid.advance(min(step, 1e-3)))
    yield Comparison(f"{len(fluid.place)} particles: a step, in the plane", "interactive in space, to 5,000",
                     f"{1e3 * cost:.1f} ms")  # fmt: skip
    few = fluid.place[:2000].copy()
    search = NeighbourSearch(fluid.support)
    cells = least_time(lambda: search.find(few))
    square = fluid.support * fluid.support
    everyone = least_time(lambda: [np.sum(np.square(few - one), axis=1) < square for one in few], 1)
    yield Comparison("2,000 particles: neighbours by cells beside testing all (with arrays)", "far less work",
                     f"{everyone / cells:.0f} times as fast")  # fmt: skip
    trial = DamTrial(Setting(LAWS[0], 1.0 / 12.0, {}))
    trial.reset()
    trial.run()
    yield Comparison("front of a broken dam beside another code's, mean", "",
                     f"{100.0 * trial.outcome().error:.1f} % off")  # fmt: skip


KERNELS = Paper(
    problem=(
        "Water in a game or a simulator must answer a hand at once. Grids of the day were exact and slow, "
        "and air costs as much on them as water. Liquid that splashes and falls apart has no fixed shape.",
    ),
    idea=(
        "Let particles carry the liquid. A quantity at a place is a sum over the particles around it, each "
        "smoothed over a small disc by a kernel. Forces of the equations of flow become sums over "
        "neighbours, and mass is kept because no particle is lost.",
    ),
    steps=(
        Step(
            "Three kernels, each for its end: one that needs no root for densities, one that is steep in the "
            "middle for pressure, one for viscosity.",
            _draw_kernels,
            r"W = \frac{4}{\pi h^2} (1 - q^2)^3",
        ),
        Step("The density of a particle is what those within its support add up to.", _draw_density),
        Step(
            "Pressure follows from density as in a gas. Between two it is taken as the mean of both: "
            "otherwise what one gives is not what the other takes.",
            _draw_pairs,
            r"p = k (\rho - \rho_0)",
        ),
        Step(
            "Viscosity needs the kernel's Laplacian. Below zero it would speed up what it should slow down: "
            "the third kernel's is positive everywhere.",
            _draw_bends,
        ),
        Step(
            "Surface tension from a colour field, 1 where there is liquid: its gradient is the normal, and "
            "the curvature follows from that.",
            _draw_rim,
            r"\v{f} = - \sigma \kappa \v{n}",
        ),
        Step("Cells of the support's size leave nine to be searched.", _draw_cells),
    ),
    showed=(
        "Water poured into a glass and swirled, and a column that collapses, of up to 5,000 particles. "
        "They are drawn as splats, or as a surface by marching cubes, at interactive rates in 2003.",
    ),
    measure=_measure,
    limits=(
        "A gas is squeezed before it pushes back, so water lies lower under its weight and springs. A harder "
        "one needs shorter steps, and a least viscosity keeps them from gaining energy. Particles lie on one "
        "side of a surface only, so the printed curvature grows as they become smaller and tells nothing of "
        "the drop. Ours pull by forces between pairs instead, which keep momentum.",
    ),
    after=(
        "Liquid that is not squeezed: predicted and corrected pressures (Solenthaler and Pajarola 2009), an "
        "implicit solve (Ihmsen and others 2014), a flow without divergence (Bender and Koschier 2015), "
        "positions (Macklin and Müller 2013). The last two are laws of this scene.",
    ),
)

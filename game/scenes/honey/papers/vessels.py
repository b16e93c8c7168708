"""The paper on particle fluids in vessels of complex shapes (P12)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from game.arrays import Floats
from game.lab.timing import least_time
from game.physics.particle_fluids import WALLS, FluidSettings, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.smoothing import CUBIC
from game.physics.particle_fluids.walls import (
    EXACT,
    NONE,
    PARTICLES,
    WEIGHTS,
    edges_of,
    fill_shares,
    is_held,
    wall_table,
)
from game.scenes.honey.papers.plots import Plot, draw_particles, placed
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

BOX = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
BOWL = (
    (-1.1, 0.9),
    (-0.8, 0.2),
    (-0.2, 0.0),
    (0.35, 0.18),
    (0.6, 0.0),
    (1.0, 0.3),
    (1.15, 1.1),
    (-1.15, 1.1),
)
ROCK = ((-0.25, 0.5), (0.0, 0.3), (0.2, 0.55), (0.0, 0.67))
COLORS = {NONE: "vermilion", WEIGHTS: "amber", EXACT: "green", PARTICLES: "chalk"}
NAMES = {NONE: "nothing", WEIGHTS: "a plane's weights", EXACT: "exact share", PARTICLES: "wall particles"}
SPACING, MANY = 0.05, 64  # m; particles along a side of what is timed
QUARTER = edges_of([((0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0))])  # a corner, for a support of 1


def filled(walls: int, spacing: float = SPACING) -> ParticleFluid:
    """A box that is full of particles in rows; wall particles, which keep liquid off, stand farther out."""
    off = 0.5 * spacing if walls == PARTICLES else 0.0
    box = [(x + (2.0 * x - 1.0) * off, y + (2.0 * y - 1.0) * off) for x, y in BOX]
    fluid = ParticleFluid(spacing, [Liquid()], [box], FluidSettings(walls=walls))
    fluid.add(lattice((0.0, 0.0), (1.0, 1.0), spacing))
    return fluid


def density_errors(walls: int) -> tuple[float, float]:
    """Root mean square error of the density beside walls of a full box: in the rows, and in its corners."""
    fluid = filled(walls)
    off = np.square(fluid.density() - 1.0)
    gaps = np.sort(np.minimum(fluid.place, 1.0 - fluid.place), axis=1)
    corner, row = gaps[:, 1] < SPACING, (gaps[:, 0] < SPACING) & (gaps[:, 1] > 2.0 * fluid.support)
    return float(np.sqrt(np.mean(off[row]))), float(np.sqrt(np.mean(off[corner])))


def shares(places: Floats, method: int) -> Floats:
    """Share (n,) of a kernel of support 1 beyond the walls of a corner at places (n, 2)."""
    share, push = np.zeros(len(places)), np.zeros((len(places), 2))
    fill_shares(places, QUARTER, (method, CUBIC, 1.0), wall_table(CUBIC), share, push)
    return share


def step_cost(walls: int) -> tuple[float, int]:
    """Time (s) in which neighbours, kernels and walls of a full box are found; how many wall particles."""
    fluid = filled(walls, 1.0 / MANY)
    work = fluid.scratch()
    return least_time(lambda: work.gather(fluid), 4), len(work.walls)


def _draw_lack(pen: Pen) -> None:
    """Density over the distance from a wall, in rows of a full box, by what is felt of the wall."""
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 8.0), (0.5, 1.1))
    plot.level(1.0)
    for k, walls in enumerate((NONE, WEIGHTS)):
        fluid = filled(walls)
        middle = np.abs(fluid.place[:, 0] - 0.475) < 1e-6
        rows = fluid.place[middle, 1] / SPACING
        found = fluid.density()[middle]
        near = rows < 8.0
        plot.curve(rows[near], found[near], COLORS[walls])
        plot.points(rows[near], found[near], COLORS[walls])
        pen.words(NAMES[walls], 200.0, 120.0 + 18.0 * k, COLORS[walls])
    pen.words("spacings from the wall", 156.0, 186.0, "text2", size=11)


def _draw_weights(pen: Pen) -> None:
    """The wall's weight over the distance."""
    gaps = np.linspace(0.0, 1.0, 60)
    places = np.stack([np.full(60, 4.0), np.maximum(gaps, 1e-9)], axis=1)
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 1.0), (0.0, 0.55))
    plot.curve(gaps, shares(places, WEIGHTS), "amber")
    pen.words("half, at the wall", 110.0, 34.0, "text2")
    pen.words("distance over support", 156.0, 186.0, "text2", size=11)


def _inside(count: int) -> Floats:
    edges = edges_of([BOWL, ROCK])
    places = lattice((-1.1, 0.0), (1.15, 1.0), 2.25 / count)
    return places[np.array([is_held(edges, place) for place in places])]


def _draw_distance(pen: Pen) -> None:
    """Distance from the nearest edge of a vessel, as colours, and where the wall begins to be felt."""
    places = _inside(46)
    edges = edges_of([BOWL, ROCK])
    share, push = np.zeros(len(places)), np.zeros((len(places), 2))
    fill_shares(places, edges, (WEIGHTS, CUBIC, 0.3), wall_table(CUBIC), share, push)
    frame, box = ((-1.2, 1.2), (-0.05, 1.15)), (6.0, 24.0, 290.0, 166.0)
    for place, part in zip(places.tolist(), share.tolist(), strict=True):
        pen.disc(*placed(box, frame, *place), 2.8, pen.veiled("amber", 1.0 - min(2.0 * part, 1.0)))
    for loop in (BOWL, ROCK):
        pen.line([placed(box, frame, *corner) for corner in (*loop, loop[0])], "text2", 2.0)


def _draw_corner(pen: Pen) -> None:
    """Shares along the diagonal out of a corner: of the nearest plane, and exact."""
    gaps = np.linspace(1e-6, 1.0, 60)
    places = np.stack([gaps, gaps], axis=1)
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 1.0), (0.0, 0.8))
    for k, method in enumerate((WEIGHTS, EXACT)):
        plot.curve(gaps, shares(places, method), COLORS[method])
        pen.words(NAMES[method], 210.0, 32.0 + 18.0 * k, COLORS[method])
    pen.words("distance from both walls", 156.0, 186.0, "text2", size=11)


def _draw_vessel(pen: Pen) -> None:
    """Liquid that has come to rest in a vessel with a rock in it, without one wall particle."""
    fluid = ParticleFluid(0.045, [Liquid(viscosity=2.0)], [BOWL, ROCK], FluidSettings(iterations=15))
    places = lattice((-0.75, 0.5), (0.75, 1.0), 0.045)
    fluid.add(places[np.array([is_held(fluid.edges, place) for place in places])])
    for _ in range(60):
        fluid.advance(1.0 / 60.0)
    frame, box = ((-1.2, 1.2), (-0.05, 1.15)), (6.0, 24.0, 290.0, 166.0)
    draw_particles(pen, fluid.place, ["accent"] * len(fluid.place), frame, box, 0.02)
    for loop in (BOWL, ROCK):
        pen.line([placed(box, frame, *corner) for corner in (*loop, loop[0])], "text2", 2.0)


def _measure() -> Iterator[Comparison]:
    plane = shares(np.array([(4.0, 0.3)]), WEIGHTS)[0]
    yield Comparison(
        "weight of a plane wall at 0.3 supports, cubic spline", "0.14924, by integration", f"{plane:.5f}"
    )
    at = np.array([(1e-9, 1e-9)])
    yield Comparison("weight in a corner", "3/4, by integration",
                     f"plane's {shares(at, WEIGHTS)[0]:.3f}, exact {shares(at, EXACT)[0]:.3f}")  # fmt: skip
    found = {walls: density_errors(walls) for walls in range(len(WALLS))}
    for k, where in enumerate(("beside a plane wall", "in a corner")):
        words = ", ".join(f"{NAMES[walls]} {100.0 * off[k]:.1f} %" for walls, off in found.items())
        yield Comparison(f"error of the density {where}", "none once the wall is weighed", words)
    costs = {walls: step_cost(walls) for walls in (WEIGHTS, EXACT, PARTICLES)}
    words = ", ".join(f"{NAMES[walls]} {1e3 * cost:.2f}" for walls, (cost, _) in costs.items())
    yield Comparison(f"{MANY * MANY} particles: neighbours, kernels and walls", "less without wall particles",
                     f"{words} ms")  # fmt: skip
    yield Comparison(
        "particles that walls need, one row of them",
        "none",
        f"{costs[WEIGHTS][1]}, not {costs[PARTICLES][1]}",
    )


VESSELS = Paper(
    problem=(
        "Beyond a wall there are no particles, so those beside it lack density. Walls made of particles fill "
        "the gap, but they are many, they make every wall rough, and a slope becomes a staircase.",
    ),
    idea=(
        "What a wall would add to a sum depends on the distance from it alone, if it is plane. Work that "
        "out once for a kernel, keep it in a table, and look it up by the distance from the nearest wall.",
    ),
    steps=(
        Step("The row beside a wall lacks a sixth of its density, and more in a corner.", _draw_lack),
        Step(
            "The share of the kernel beyond a plane, over the distance: the wall's weight. "
            "Its slope is the push.",
            _draw_weights,
            r"\rho = \text{sum of } m W + \rho_0 w(d)",
        ),
        Step(
            "The distance comes from a field or from the nearest edge: a vessel of any shape will do.",
            _draw_distance,
        ),
        Step(
            "In a corner one plane is too little. Ours adds over all edges what the divergence theorem "
            "makes of the integral, which is exact for any polygon (after Ferrand and others 2013).",
            _draw_corner,
        ),
        Step("Liquid at rest in such a vessel: no wall particle, and no steps on its slopes.", _draw_vessel),
    ),
    showed=(
        "Liquid in vessels given by triangles, with distances from a field of cells. Density, pressure and "
        "viscosity of the wall come from tables, with fewer particles and less time than walls of particles.",
    ),
    measure=_measure,
    limits=(
        "A table over one distance is right for plane walls that are far from others. In corners and in gaps "
        "narrower than the support it is off. The exact share costs a few lines for each edge nearby.",
    ),
    after=(
        "Walls by integrals in space (Koschier and Bender 2017) and by volume maps (Bender and others 2019) "
        "carry the idea on to any surface, with the exact shares that the table leaves out.",
    ),
)

"""The paper on fluids of particles that meet: two liquids, heat, boiling, trapped air (P10)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from game.arrays import Floats
from game.lab.timing import least_time
from game.physics.kernels import elementwise
from game.physics.particle_fluids import FluidSettings, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.air import renew_air
from game.scenes.honey.papers.plots import Plot, draw_particles
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

BOX = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))
SPACING, FRAME, SIDE = 0.05, 1.0 / 60.0, 0.6  # m, s, m of a square drop
KINDS = ("chalk", "vermilion")
HOT, COLD, SPREADS = 350.0, 300.0, 2e-3  # K, K, m²/s


def layers(ratio: float, heavy_above: bool, seconds: float) -> ParticleFluid:
    """Two liquids of 1000 kg/m³ and of a share of it, 0.3 m of each, some time later."""
    heavy, light = Liquid(1000.0), Liquid(1000.0 / ratio)
    fluid = ParticleFluid(SPACING, [light, heavy] if heavy_above else [heavy, light], [BOX], FluidSettings())
    fluid.add(lattice((0.0, 0.0), (1.0, 0.3), SPACING), 0)
    above = lattice((0.0, 0.3), (1.0, 0.6), SPACING)
    fluid.add(above + np.random.default_rng(0).normal(0.0, 0.002, above.shape) * heavy_above, 1)
    for _ in range(round(seconds / FRAME)):
        fluid.advance(FRAME)
    return fluid


def densities_at_interface(ratio: float) -> tuple[Floats, Floats, Floats]:
    """Heights (n,) of a column of two liquids, and relative densities by masses and by volumes."""
    fluid = layers(ratio, False, 0.0)
    work = fluid.scratch()
    work.gather(fluid)
    count = int(work.pairs.start[-1])
    first = np.repeat(np.arange(len(work.order)), np.diff(work.pairs.start))
    second, felt = work.pairs.other[:count], work.felt.weight[:count]
    mass = work.sorted_rows(fluid.masses())
    by_mass: Floats = np.bincount(first, felt * mass[second], len(mass)).astype(np.float64)
    by_mass = by_mass + np.bincount(second, felt * mass[first], len(mass))
    own = mass / (SPACING * SPACING)  # density of its own kind
    alone = np.bincount(first, felt, len(mass)) + np.bincount(second, felt, len(mass))
    by_mass += (work.work.density - SPACING * SPACING * alone) * own  # itself, and the wall
    middle = np.abs(work.place[:, 0] - 0.475) < 1e-6
    return work.place[middle, 1], (by_mass / own)[middle], work.work.density[middle]


def square_drop(seconds: float) -> ParticleFluid:
    """A square of liquid that hangs free and is drawn round by its surface."""
    liquid = Liquid(viscosity=30.0, tension=60.0)
    fluid = ParticleFluid(SPACING, [liquid], [], FluidSettings(gravity=0.0))
    fluid.add(lattice((-0.5 * SIDE, -0.5 * SIDE), (0.5 * SIDE, 0.5 * SIDE), SPACING))
    for _ in range(round(seconds / FRAME)):
        fluid.advance(FRAME)
    return fluid


def roundness(places: Floats) -> float:
    """Diagonal of a drop over its width; places (n, 2) m. Of a square √2, of a disc 1."""
    reach = np.sort(np.sqrt(np.sum(np.square(places - places.mean(axis=0)), axis=1)))
    turned = places - places.mean(axis=0)
    across = float(np.ptp(turned[:, 0]))
    return float(2.0 * reach[-4:].mean() / across)


def warmed(seconds: float) -> tuple[Floats, Floats]:
    """Places (n,) m along a bar that was hot in its left half, and temperatures (n,) K."""
    settings = FluidSettings(gravity=0.0, diffusivity=SPREADS)
    fluid = ParticleFluid(SPACING, [Liquid()], [BOX], settings)
    fluid.add(lattice((0.0, 0.0), (1.0, 1.0), SPACING))
    fluid.heat[:] = np.where(fluid.place[:, 0] < 0.5, HOT, COLD)
    for _ in range(round(seconds / FRAME)):
        fluid.advance(FRAME)
    middle = np.abs(fluid.place[:, 1] - 0.475) < 0.4 * SPACING
    return fluid.place[middle, 0], fluid.temperature()[middle]


def heat_law(x: Floats, seconds: float) -> Floats:
    """Exact temperatures of that bar whose ends let nothing through (Fourier)."""
    total = np.full(len(x), 0.5)
    for k in range(1, 200, 2):
        sign = 1.0 if k % 4 == 1 else -1.0
        decay = math.exp(-SPREADS * (k * math.pi) * (k * math.pi) * seconds)
        total += 2.0 / (k * math.pi) * sign * decay * elementwise.cos(k * math.pi * x)
    return np.asarray(COLD + (HOT - COLD) * total)


def boiled() -> tuple[float, float]:
    """Mass (kg) before, and after a pool has boiled away and condensed again."""
    water = Liquid(1000.0, boils=373.0, latent=20.0, vapour=1)
    fluid = ParticleFluid(SPACING, [water, Liquid(100.0)], [BOX], FluidSettings())
    fluid.add(lattice((0.0, 0.0), (1.0, 0.3), SPACING))
    before = float(np.sum(fluid.masses()))
    fluid.heat[:] = 430.0
    fluid.advance(0.1)
    fluid.heat[:] = 300.0
    fluid.advance(0.1)
    return before, float(np.sum(fluid.masses()))


def falling_block() -> ParticleFluid:
    """A block that falls, and the air that was made on demand."""
    fluid = ParticleFluid(SPACING, [Liquid(), Liquid(100.0, air=True)], [BOX], FluidSettings())
    fluid.add(lattice((0.2, 0.4), (0.8, 0.8), SPACING), 0, (0.0, -3.0))
    for _ in range(3):
        renew_air(fluid)
        fluid.advance(0.005)
    return fluid


def _draw_interface(pen: Pen) -> None:
    heights, by_mass, by_volume = densities_at_interface(10.0)
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 0.6), (0.0, 4.0))
    plot.level(1.0)
    for k, (words, found, color) in enumerate(
        (("by masses", by_mass, "vermilion"), ("by volumes", by_volume, "green"))
    ):
        plot.curve(heights, found, color)
        plot.points(heights, found, color)
        pen.words(words, 90.0, 32.0 + 18.0 * k, color)
    pen.words("height; the lighter is on top", 156.0, 186.0, "text2", size=11)


def _draw_over(pen: Pen) -> None:
    """Heavy over light, and three seconds later."""
    for left, seconds in ((8.0, 0.0), (152.0, 3.0)):
        fluid = layers(2.0, True, seconds)
        frame, box = ((0.0, 1.0), (0.0, 0.8)), (left, 40.0, left + 136.0, 149.0)
        draw_particles(pen, fluid.place, [KINDS[k] for k in fluid.kind], frame, box, 0.022)
        pen.words(f"{seconds:.0f} s", left + 68.0, 170.0, "text1")


def _draw_round(pen: Pen) -> None:
    for left, seconds in ((8.0, 0.0), (152.0, 2.0)):
        fluid = square_drop(seconds)
        frame, box = ((-0.5, 0.5), (-0.4, 0.4)), (left, 40.0, left + 136.0, 149.0)
        draw_particles(pen, fluid.place, ["accent"] * len(fluid.place), frame, box, 0.022)
        pen.words(f"{seconds:.0f} s", left + 68.0, 170.0, "text1")


def _draw_heat(pen: Pen) -> None:
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 1.0), (COLD - 5.0, HOT + 5.0))
    x = np.linspace(0.0, 1.0, 80)
    for seconds, color in ((2.0, "vermilion"), (20.0, "amber")):
        plot.curve(x, heat_law(x, seconds), color, 4.0)
        plot.points(*warmed(seconds), color)
        pen.words(f"{seconds:.0f} s", 250.0, 34.0 if seconds < 5.0 else 52.0, color)
    pen.words("along a bar that was hot at the left; dashed: exact", 156.0, 186.0, "text2", size=11)


def _draw_air(pen: Pen) -> None:
    fluid = falling_block()
    frame, box = ((0.0, 1.0), (0.2, 0.9)), (6.0, 2.0, 290.0, 200.8)
    draw_particles(pen, fluid.place, [("accent", "amber")[k] for k in fluid.kind], frame, box, 0.02)


def _measure() -> Iterator[Comparison]:
    _, by_mass, by_volume = densities_at_interface(10.0)
    yield Comparison("highest density beside rest where 1000 meets 100 kg/m³", "by masses, as printed",
                     f"{np.max(by_mass):.1f} by masses, {np.max(by_volume):.2f} by volumes")  # fmt: skip
    fluid = layers(2.0, True, 4.0)
    means = [float(np.mean(fluid.place[fluid.kind == k, 1])) for k in (0, 1)]
    yield Comparison("twice as heavy on top, 4 s later: mean heights of both", "0.15, 0.45 m",
                     f"{means[1]:.2f}, {means[0]:.2f} m")  # fmt: skip
    before, after = roundness(square_drop(0.0).place), roundness(square_drop(2.0).place)
    yield Comparison(
        "a square drop after 2 s: diagonal over width", "1, round", f"{before:.2f}, then {after:.2f}"
    )
    x, found = warmed(20.0)
    off = float(np.max(np.abs(found - heat_law(x, 20.0)))) / (HOT - COLD)
    yield Comparison(
        "heat along a bar after 20 s, beside the exact law", "", f"{100.0 * off:.1f} % off at most"
    )
    first, last = boiled()
    yield Comparison("mass boiled away and condensed again", "kept", f"{first:.6g} kg, {last:.6g} kg")
    air = falling_block()
    made = air.place[air.kind == 1, 1]
    lowest = float(np.min(air.place[air.kind == 0, 1]))
    yield Comparison("air made about a falling block", "only where it is needed",
                     f"{len(made)} particles, {int(np.sum(made < lowest + SPACING))} under it")  # fmt: skip
    mixed = layers(2.0, True, 1.0)
    parts = mixed.advance(FRAME)
    cost = least_time(lambda: mixed.advance(FRAME), 2)
    yield Comparison(f"{len(mixed.place)} particles of two liquids: 1/60 s", "interactive",
                     f"{1e3 * cost:.1f} ms in {parts} steps")  # fmt: skip


LIQUIDS = Paper(
    problem=(
        "Water and oil, wax in a lamp, bubbles in a pot: liquids that meet have different weights, do not "
        "mix, and turn into one another. Air around them would need more particles than the liquid itself.",
    ),
    idea=(
        "Let each particle carry all that differs: mass, density of rest, viscosity, temperature. The "
        "same sums then do for any of them. Air is computed only where it is enclosed.",
    ),
    steps=(
        Step(
            "A particle asks its neighbours how dense it is. Taken by masses, as printed, a light one beside "
            "heavy ones seems squeezed. Ours counts volumes (Solenthaler and Pajarola 2008).",
            _draw_interface,
            r"\alpha_i = \text{sum of } V_j W_{ij}",
        ),
        Step("Weight alone then sorts liquids.", _draw_over),
        Step(
            "A tension holds each liquid together: the print has it from a colour field, ours from forces "
            "between pairs of one kind.",
            _draw_round,
        ),
        Step(
            "Heat spreads between neighbours, and makes liquid lighter.",
            _draw_heat,
            r"\dot{T} = c \nabla^2 T, \quad \rho = \frac{\rho_0}{1 + \beta (T - T_0)}",
        ),
        Step(
            "Where a surface looks down and moves, air (amber) is made a spacing off. "
            "Air that no liquid covers is gone.",
            _draw_air,
        ),
    ),
    showed=(
        "A lava lamp, water that boils in a pot, and water that takes air along as it is poured. There are "
        "some thousands of particles in space, at interactive rates.",
    ),
    measure=_measure,
    limits=(
        "Vapour here is a tenth as dense as its liquid and not a thousandth, and wax swells more than wax "
        "does. Rows of particles deep under pressure hold like grains, so what is slow may stay where it is. "
        "Air is no gas: it keeps its volume.",
    ),
    after=(
        "Density by volumes (Solenthaler and Pajarola 2008) let ratios grow to a hundred. Two phases with "
        "drift (Ren and others 2014) mix as well.",
    ),
)

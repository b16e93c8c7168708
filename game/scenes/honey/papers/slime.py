"""The paper on viscoelastic fluids of particles (P11)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.timing import least_time
from game.physics.particle_fluids import FluidSettings, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.printed import NEAR_STIFFNESS
from game.physics.particle_fluids.settings import CLAVET
from game.scenes.honey.papers.plots import Plot, draw_particles, placed
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

SPACING, FRAME, STRETCH = 0.05, 1.0 / 60.0, 1.6
HELD, HOLDING = 0.4, 0.002  # s, in steps of
MANY = 1000
RULES: dict[str, dict[str, Any]] = {
    "elastic": {"borne": 0.5}, "yielding": {"borne": 0.1, "flow": 20.0}, "no springs": {"stiffness": 0.0}
}  # fmt: skip
COLORS = {"elastic": "green", "yielding": "amber", "no springs": "vermilion"}


def heap(seconds: float, law: int = CLAVET) -> ParticleFluid:
    """400 particles in disorder over a square, and what a law made of them."""
    settings = FluidSettings(law=law, gravity=0.0)
    fluid = ParticleFluid(SPACING, [Liquid(viscosity=0.0)], [], settings)
    places = lattice((0.0, 0.0), (1.0, 1.0), SPACING)
    fluid.add(places + np.random.default_rng(2).normal(0.0, 0.4 * SPACING, places.shape))
    for _ in range(round(seconds / FRAME)):
        fluid.advance(FRAME)
    return fluid


def nearest(places: Floats) -> Floats:
    """Gap (n,) to the nearest other particle, m."""
    apart = places[:, None] - places[None]
    square = np.sum(np.square(apart), axis=2) + 1e9 * np.eye(len(places))
    return np.sqrt(np.min(square, axis=1))


def slab(rules: dict[str, Any], seconds: float) -> ParticleFluid:
    """A slab that hangs free, drawn out to STRETCH times its width, held so for HELD seconds, and let go."""
    settings = FluidSettings(law=CLAVET, gravity=0.0)._replace(stiffness=15_000.0)._replace(**rules)
    fluid = ParticleFluid(SPACING, [Liquid(viscosity=5.0, springy=True)], [], settings)
    fluid.add(lattice((0.0, 0.0), (0.6, 0.3), SPACING))
    fluid.advance(1e-4)
    fluid.place[:, 0] = 0.3 + STRETCH * (fluid.place[:, 0] - 0.3)
    fluid.place[:, 1] = 0.15 + (fluid.place[:, 1] - 0.15) / STRETCH
    drawn = fluid.place.copy()
    for _ in range(round(HELD / HOLDING)):
        fluid.advance(HOLDING)
        fluid.place[:], fluid.velocity[:] = drawn, 0.0
    for _ in range(round(seconds / FRAME)):
        fluid.advance(FRAME)
    return fluid


def flowed(seconds: float, flow: float = 4.0) -> tuple[float, float]:
    """How much a spring that is held at 1.5 times its length has grown, and what its law says, in lengths."""
    settings = FluidSettings(law=CLAVET, gravity=0.0, stiffness=0.0, borne=0.0, flow=flow, softness=2.0)
    fluid = ParticleFluid(SPACING, [Liquid(viscosity=0.0, springy=True)], [], settings)
    fluid.add([(0.0, 0.0), (0.04, 0.0)])
    fluid.advance(1e-6)
    steps = 400
    for _ in range(steps):
        fluid.place[:], fluid.velocity[:] = ((0.0, 0.0), (0.06, 0.0)), 0.0
        fluid.advance(seconds / steps)
    first = np.flatnonzero(fluid.partner[0] >= 0)[0]
    return float(fluid.length[0, first]) / 0.04 - 1.0, 0.5 * (1.0 - math.exp(-flow * seconds))


def pool(count: int) -> ParticleFluid:
    """A block of so many springy particles that lies on the floor of a box."""
    side = round(math.sqrt(count / 2.0))
    settings = FluidSettings(law=CLAVET, softness=15.0, stiffness=12_000.0)
    box = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)]
    fluid = ParticleFluid(0.03, [Liquid(1100.0, 10.0, springy=True)], [box], settings)
    fluid.add(lattice((0.0, 0.0), (0.06 * side, 0.03 * side), 0.03))
    return fluid


def _draw_relaxed(pen: Pen) -> None:
    """Strewn particles, and after the relaxation of half a second."""
    for left, seconds, words in ((10.0, 0.0, "predicted"), (156.0, 0.5, "relaxed")):
        fluid = heap(seconds)
        frame, box = ((0.1, 0.9), (0.1, 0.9)), (left, 24.0, left + 130.0, 154.0)
        inner = np.max(np.abs(fluid.place - 0.5), axis=1) < 0.38
        draw_particles(pen, fluid.place[inner], ["accent"] * int(np.sum(inner)), frame, box, 0.014)
        pen.words(words, left + 65.0, 176.0, "text1")


def _draw_two(pen: Pen) -> None:
    """What both pressures give a pair over its gap, at the density of rest."""
    q = np.linspace(0.0, 1.0, 80)
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 1.0), (-0.6, 2.6))
    plot.level(0.0, "text3")
    curves = (("pulls, if too few", -0.5 * (1.0 - q), "accent"),
              ("parts, if near", NEAR_STIFFNESS * np.square(1.0 - q), "vermilion"))  # fmt: skip
    for k, (words, values, color) in enumerate(curves):
        plot.curve(q, values, color)
        pen.words(words, 210.0, 32.0 + 18.0 * k, color)
    plot.curve(q, curves[0][1] + curves[1][1], "text1", 4.0)
    pen.words("their sum", 210.0, 68.0, "text1")
    pen.words("distance over support", 156.0, 186.0, "text2", size=11)


def _draw_clusters(pen: Pen) -> None:
    """How near the nearest is, before and after."""
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 1.4), (0.0, 1.0))
    for k, (seconds, color, words) in enumerate(((0.0, "vermilion", "disorder"), (0.5, "green", "relaxed"))):
        gaps = np.sort(nearest(heap(seconds).place)) / SPACING
        plot.curve(np.minimum(gaps, 1.4), np.arange(1, len(gaps) + 1) / len(gaps), color)
        pen.words(words, 76.0, 32.0 + 18.0 * k, color)
    pen.words("gap to the nearest, in spacings: share below", 156.0, 186.0, "text2", size=11)


def _draw_springs(pen: Pen) -> None:
    """Springs of a slab, coloured by whether they are drawn out."""
    fluid = slab(RULES["elastic"], 0.0)
    fluid.advance(1e-4)
    frame, box = ((-0.25, 0.85), (-0.22, 0.52)), (6.0, 6.0, 290.0, 196.0)
    spots = [placed(box, frame, *place) for place in fluid.place.tolist()]
    for a, row in enumerate(fluid.partner.tolist()):
        for s, b in enumerate(row):
            if b >= 0:
                gap = float(np.sqrt(np.sum(np.square(fluid.place[a] - fluid.place[b]))))
                pen.line(
                    (spots[a], spots[b]), "vermilion" if gap > 1.05 * fluid.length[a, s] else "text3", 1.2
                )
    for spot in spots:
        pen.disc(*spot, 3.4, "green")


def _draw_slabs(pen: Pen) -> None:
    """Width over time of a slab that was drawn out, by three rules."""
    plot = Plot(pen, (30.0, 20.0, 280.0, 168.0), (0.0, 1.0), (0.3, 0.9))
    plot.level(STRETCH * 0.55)
    plot.level(0.55, "text3")
    for k, (name, rules) in enumerate(RULES.items()):
        fluid = slab(rules, 0.0)
        widths = [float(np.ptp(fluid.place[:, 0]))]
        for _ in range(30):
            fluid.advance(2.0 * FRAME)
            widths.append(float(np.ptp(fluid.place[:, 0])))
        plot.curve(np.linspace(0.0, 1.0, 31), np.array(widths), COLORS[name])
        pen.words(name, 236.0, 30.0 + 18.0 * k, COLORS[name])
    pen.words("width over a second", 156.0, 186.0, "text2", size=11)


def _measure() -> Iterator[Comparison]:
    before, after = (100.0 * float(np.mean(nearest(heap(s).place) < 0.5 * SPACING)) for s in (0.0, 1.0))
    yield Comparison("particles nearer to another than half a spacing", "no clusters",
                     f"{before:.0f} % in disorder, {after:.1f} % after 1 s")  # fmt: skip
    fluid = heap(0.5)
    size = float(np.sum(fluid.masses()[:, None] * np.abs(fluid.velocity)))
    made = float(np.max(np.abs(fluid.momentum()))) / size
    yield Comparison("momentum that displacements make, against all of it", "none", f"{made:.0e}")
    ours, law = flowed(0.3)
    yield Comparison("a spring held at 1.5 lengths has grown after 0.3 s", f"{100.0 * law:.1f} % by its law",
                     f"{100.0 * ours:.1f} %")  # fmt: skip
    widths = {name: float(np.ptp(slab(rules, 1.0).place[:, 0])) for name, rules in RULES.items()}
    words = ", ".join(f"{name} {one / 0.55:.2f}" for name, one in widths.items())
    yield Comparison(
        f"a slab held at {STRETCH} of its width and let go, 1 s later", "springs back, or has flowed", words
    )
    block = pool(MANY)
    for _ in range(5):
        block.advance(FRAME)
    parts = block.advance(FRAME)
    cost = least_time(lambda: block.advance(FRAME), 2)
    yield Comparison(f"{len(block.place)} springy particles: 1/60 s", "interactive",
                     f"{1e3 * cost:.0f} ms in {parts} steps")  # fmt: skip


SLIME = Paper(
    problem=(
        "Mud, paint and slime spring back when they are drawn a little, and stay as they are when drawn far. "
        "Particles that are pushed apart by pressure cluster, and explicit springs force short steps.",
    ),
    idea=(
        "Predict where each particle goes, then displace it until density and springs are content. "
        "What displacement comes of it, over the step, is the velocity. A second density, of near neighbours "
        "alone, parts what the first would let cluster, and holds surfaces together.",
    ),
    steps=(
        Step(
            "Places are predicted by the velocities, then relaxed. Velocities follow from what came of it.",
            _draw_relaxed,
            r"\v{v} = \frac{\v{x} - \v{x}_{\text{before}}}{\Delta t}",
        ),
        Step(
            "Two densities of one pair: the first pulls where it is too low, the second always parts. "
            "Where they balance lies the distance of rest.",
            _draw_two,
            r"\Delta r = \Delta t^2 (P (1 - q) + P_{\text{near}} (1 - q)^2)",
        ),
        Step("So none comes to lie on another.", _draw_clusters),
        Step(
            "Each pair that comes near gets a spring of the length that it has.",
            _draw_springs,
            r"\Delta r = \Delta t^2 k (1 - \frac{L}{h}) (L - r)",
        ),
        Step(
            "A spring that is drawn or pressed by more than a share of its length flows: its length follows.",
            _draw_slabs,
            r"\Delta L = \Delta t \alpha (r - L - \gamma L)",
        ),
    ),
    showed=(
        "Rain drops, fountains, clay that is shaped and things that float, at interactive rates in space. "
        "Bodies meet the liquid both ways: particles push them, and are pushed out of them.",
    ),
    measure=_measure,
    limits=(
        "Stiffness depends on the step and on how many neighbours there are; nothing is given in pascals. "
        "The print moves particles one after the other; ours all at once, so that their order does not "
        "matter and momentum is kept. A viscosity of ours is implicit where the print has impulses. No body "
        "swims in our vessel yet.",
    ),
    after=(
        "Position based fluids (Macklin and Müller 2013) solve for the density instead of relaxing it. "
        "Viscoelastic liquids by material points (Ram and others 2015) have moduli that can be measured.",
    ),
)

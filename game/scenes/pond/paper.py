"""The paper on wave particles (P15)."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

import numpy as np

from game.lab.timing import least_time
from game.physics.waves.floats import FloatingBodies
from game.physics.waves.hull import Hull
from game.physics.waves.wave_particles import ANGLE, HEIGHT, KEEPS, WaveParticles, WaveSettings, X, Y
from game.scenes.pond.figure import draw_hump, draw_splitting, draw_wedge
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

SIZE, RADIUS, CELL, DT = (16.0, 9.0), 0.25, 0.05, 1.0 / 60.0
MIDDLE = 8.0, 4.5
MANY, FLOATS = 100_000, 300


def _ring(keeps: str, seconds: float, spacing: float = 0.5) -> WaveParticles:
    """A ring of 5 cm at half a metre, some time old, its heights found."""
    settings = WaveSettings(keeps=KEEPS.index(keeps), spacing=spacing, fading=0.0, lowest=0.0)
    water = WaveParticles(SIZE, (RADIUS,), CELL, settings)
    water.add_ring(MIDDLE, 0.05, 0.5)
    for _ in range(round(seconds / DT)):
        water.step(DT)
    water.find_heights()
    return water


def _draw_rings(pen: Pen) -> None:
    """Particles of a ring with splitting above, without it below, two seconds old."""
    for y, spacing, words in ((64.0, 0.5, "they divide"), (156.0, 1e9, "they do not")):
        water = _ring("energy", 2.2, spacing)
        fields = water.fields[:, water.fields[Y] > MIDDLE[1]]
        for x, up, tall in zip(fields[X].tolist(), fields[Y].tolist(), fields[HEIGHT].tolist(), strict=True):
            size = max(1.2, 60.0 * tall)
            pen.disc(150.0 + 32.0 * (x - MIDDLE[0]), y + 20.0 - 26.0 * (up - MIDDLE[1]), size, "accent")
        pen.words(words, 150.0, y + 12.0, "text2")


def _draw_heights(pen: Pen) -> None:
    """Crest of a ring over the way it has gone, by both rules, beside 1/d and its root."""
    left, foot = 44.0, 168.0
    pen.line(((left, 24.0), (left, foot), (282.0, foot)), "text3", 1.2)
    for keeps, color in (("height", "vermilion"), ("energy", "green")):
        line = [(left + 60.0 * d, foot - 2600.0 * _law(keeps, d)) for d in np.linspace(0.5, 3.9, 40).tolist()]
        pen.line(line, color, 1.4, dash=4.0)
        for seconds in (0.5, 1.5, 2.5, 3.5):
            water = _ring(keeps, seconds)
            away = 0.5 + float(water.speeds[0]) * seconds
            tall = float(np.max(water.heights[water.heights.shape[0] // 2]))
            pen.disc(left + 60.0 * away, foot - 2600.0 * tall, 3.5, color)
    pen.words("energy kept", 214.0, 96.0, "green")
    pen.words("height kept", 236.0, 152.0, "vermilion")
    pen.words("distance", 262.0, foot + 12.0, "text2", size=11)
    pen.words("crest", left, 14.0, "text2", size=11)


def _law(keeps: str, away: float) -> float:
    share = 0.5 / away
    return 0.05 * (share if keeps == "height" else math.sqrt(share))


def _draw_body(pen: Pen) -> None:
    """Faces of a float that goes to the right: those ahead raise water, those behind lower it."""
    x, y, radius = 150.0, 100.0, 44.0
    pen.disc(x, y, radius, "body")
    for k in range(8):
        turn = math.tau * k / 8
        c, s = math.cos(turn), math.sin(turn)
        if abs(c) < 0.1:
            continue
        color = "vermilion" if c > 0.0 else "accent"
        start = (x + (radius + 8.0) * c, y - (radius + 8.0) * s)
        reach = radius + 8.0 + 34.0 * abs(c)
        pen.arrow(start, (x + reach * c, y - reach * s), color, 2.0)
    pen.arrow((x - 18.0, y), (x + 22.0, y), "amber", 2.4)
    pen.words("crests", 262.0, 60.0, "vermilion")
    pen.words("troughs", 38.0, 60.0, "accent")


def _measure() -> Iterator[Comparison]:
    water = _ring("height", 3.0)
    start = _ring("height", 0.0)
    away = 0.5 + float(water.speeds[0]) * 3.0
    row = water.heights[water.heights.shape[0] // 2]
    half = len(row) // 2
    crest = (half + int(np.argmax(row[half:])) + 0.5) * water.cell - MIDDLE[0]
    yield Comparison("a ring after 3 s, by its speed", f"{away:.2f} m", f"{crest:.2f} m")
    yield Comparison(
        "sum of heights after it divided twice, as printed", "kept",
        f"off by {abs(water.volume() / start.volume() - 1.0):.0e}",
    )  # fmt: skip
    kept = _ring("energy", 3.0).energy() / _ring("energy", 0.0).energy()
    printed = water.energy() / start.energy()
    yield Comparison(
        "energy of the ring after 3 s: by our rule, as printed",
        "",
        f"{100.0 * kept:.1f} %, {100.0 * printed:.0f} %",
    )
    many = _many()
    cost = least_time(lambda: many.step(DT), 5)
    yield Comparison(f"{MANY:,} particles: a step", "", f"{1e3 * cost:.2f} ms")
    cost += least_time(many.find_heights, 5)
    floats = FloatingBodies(many)
    rng = np.random.default_rng(3)
    for x, y in (rng.uniform(0.05, 0.95, (FLOATS, 2)) * SIZE).tolist():
        floats.add((x, y), 0.15, 0.16, 0.5)
    cost += least_time(lambda: floats.step(DT), 5)
    yield Comparison(
        f"with heights on {many.heights.shape[1]} x {many.heights.shape[0]} points and {FLOATS} floats", "",
        f"{1e3 * cost:.2f} ms",
    )  # fmt: skip
    yield Comparison("wedge of a boat at twice its waves' speed", "30°", f"{_wedge():.1f}°")


def _many() -> WaveParticles:
    """So many particles all over that go on without dividing."""
    water = WaveParticles(SIZE, (RADIUS,), CELL, WaveSettings(lowest=0.0), MANY)
    rng = np.random.default_rng(2)
    while water.count < MANY - 100:
        water.drop(tuple((rng.random(2) * SIZE).tolist()), 0.02)
    water.fields[ANGLE] = 0.0
    return water


def _wedge() -> float:
    """Half the angle (degrees) of the lines through the outermost particles behind it."""
    water = WaveParticles((24.0, 13.5), (RADIUS,), 0.075, WaveSettings(lowest=1e-4))
    boat = Hull(water, (2.0, 6.75), 1.4, 0.46, 0.14)
    wave = float(water.speeds[0])
    for n in range(360):
        boat.step((2.0 * wave, 0.0), DT)
        water.step(DT)
        if n % 3 == 0:
            boat.send_waves(0)
    back, side = boat.pose[0] - water.fields[X], np.abs(water.fields[Y] - boat.pose[1])
    edges = np.linspace(2.5, 7.5, 13)
    outermost = [
        float(np.max(side[(back >= low) & (back < high)])) for low, high in itertools.pairwise(edges)
    ]
    return math.degrees(math.atan((outermost[-1] - outermost[0]) / float(edges[-2] - edges[0])))


WAVE_PARTICLES = Paper(
    problem=(
        "A lake of waves on a grid costs the same whether anything moves or not. What floats in it has to "
        "be fitted to its cells. Can waves of boats and stones be had for what they are, without a grid "
        "that is solved?",
    ),
    idea=(
        "Let particles carry the fronts. Each is a small hump that runs straight on at the speed of its "
        "wave, so that its place is known at any time. As a front grows, a lonely particle divides into "
        "three that share its height.",
    ),
    steps=(
        Step(
            "A particle is a rounded hump with a height and a radius. Side by side, the humps of a front "
            "make an even crest.",
            draw_hump,
            r"\frac{a}{2} (\cos \frac{\pi u}{r} + 1)",
        ),
        Step(
            "It knows the angle that it stands for, and how far behind it the front began. When neighbours "
            "are half a radius apart it becomes three of a third each.",
            draw_splitting,
        ),
        Step("Without that a ring falls into dots.", _draw_rings),
        Step(
            "What floats is lifted by the water it displaces and pushed down the slopes. Each of its faces "
            "raises or lowers water as it moves, and that leaves as a particle.",
            _draw_body,
        ),
        Step(
            "Sharing heights keeps their sum, so a ring sinks as 1/d. On water energy is kept, and it sinks "
            "as the root of that: our second choice.",
            _draw_heights,
            r"a \propto \frac{1}{\sqrt{d}}",
        ),
        Step(
            "A boat faster than its waves has them all in a wedge.", draw_wedge, r"\sin \alpha = \frac{c}{U}"
        ),
    ),
    showed=(
        "Pools and a lake with boats and hundreds of floating things. All act on the water and are acted "
        "on, in real time, among hundreds of thousands of particles on graphics hardware.",
    ),
    measure=_measure,
    limits=(
        "All waves of one radius have one speed. So the wake is Mach's and not Kelvin's, and a group of "
        "waves runs as fast as its crests. Ours go round nothing and throw no shadow. Humps alone cannot "
        "keep both the sum of heights and the energy. A float's waves are paid for by what its drag takes, "
        "a rule of ours.",
    ),
    after=(
        "Dispersive packets of waves (Jeschke and Wojtan 2015, 2017) carry whole groups with Kelvin's wakes. "
        "Water surface wavelets (Jeschke and others 2018) keep direction and length on a grid.",
    ),
)

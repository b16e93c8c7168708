"""The paper on Catmull-Rom curves (P48): what the power in their knots does."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
from numpy.typing import NDArray

from game.lab.timing import least_time
from game.physics.animation.crossings import crosses_itself
from game.physics.animation.curves import CatmullRom
from game.scenes.shared.marks import dot
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

POINTS = np.array([(30.0, 170.0), (128.0, 62.0), (142.0, 62.0), (262.0, 158.0)])  # px, two of them close
COLORS = {"uniform": "vermilion", "centripetal": "green", "chordal": "chalk"}
MANY = 40_000


def _draw_knots(pen: Pen) -> None:
    """The same four points on three rulers of knots."""
    shown = POINTS * (1.0, 0.8) - (0.0, 22.0)
    pen.line([tuple(point) for point in shown.tolist()], "text3", 1.2, dash=4.0)
    for i, (x, y) in enumerate(shown.tolist()):
        dot(pen, (x, y), "accent", 4.0, ring=1.6)
        pen.formula(f"P_{i}", x + (-14.0 if i < 2 else 14.0), y - 12.0)
    steps = np.hypot(*np.diff(POINTS, axis=0).T)
    for row, (kind, power) in enumerate((("uniform", 0.0), ("centripetal", 0.5), ("chordal", 1.0))):
        knots = np.concatenate(([0.0], np.cumsum(steps**power)))
        places = 108.0 + 120.0 * knots / knots[-1]
        y = 150.0 + 20.0 * row
        pen.words(kind, 98.0, y, COLORS[kind], align="right", size=11)
        pen.line(((108.0, y), (228.0, y)), "text3", 1.2)
        for x in places.tolist():
            pen.line(((x, y - 4.0), (x, y + 4.0)), COLORS[kind], 1.8)


def _draw_slopes(pen: Pen) -> None:
    """At one point: the parabola through it and its neighbours by centripetal knots, and its slope there."""
    knots = np.concatenate(([0.0], np.cumsum(np.hypot(*np.diff(POINTS, axis=0).T) ** 0.5)))
    time = np.linspace(knots[0], knots[2], 61)
    parts = [
        np.prod([(time - knots[j]) / (knots[i] - knots[j]) for j in range(3) if j != i], axis=0)
        for i in range(3)
    ]
    parabola = np.stack(parts, axis=1) @ POINTS[:3]
    pen.line([tuple(p) for p in parabola.tolist()], "text3", 1.4, dash=4.0)
    curve = CatmullRom(POINTS)
    pen.line([tuple(p) for p in curve.point(np.linspace(0.0, 3.0, 181)).tolist()], "green", 1.8)
    ahead = curve.point(np.array([1.0, 1.0 + 1e-6]))
    slope = (ahead[1] - ahead[0]) / np.hypot(*(ahead[1] - ahead[0]))
    x, y = POINTS[1].tolist()
    pen.arrow((x, y), (x + 64.0 * slope[0], y + 64.0 * slope[1]), "amber", 2.0)
    for k, (x, y) in enumerate(POINTS.tolist()):
        dot(pen, (x, y), "accent" if k < 3 else "text3", 4.0)
    pen.words("parabola", 30.0, 24.0, "text2", align="left")
    pen.words("curve", 30.0, 40.0, "green", align="left")
    pen.words("slope", 30.0, 56.0, "amber", align="left")


def _draw_curves(pen: Pen) -> None:
    """The three curves through four points, two of which lie close together."""
    for kind, color in COLORS.items():
        curve = CatmullRom(POINTS, kind)
        pen.line([tuple(p) for p in curve.point(np.linspace(0.0, 3.0, 181)).tolist()], color, 1.8)
    for x, y in POINTS.tolist():
        dot(pen, (x, y), "text1", 3.4)
    for row, (kind, color) in enumerate(COLORS.items()):
        pen.words(kind, 30.0, 24.0 + 16.0 * row, color, align="left")


def _draw_close_up(pen: Pen) -> None:
    """The short piece, eleven times larger."""
    low, scale = np.array((135.0, 58.0)), 11.0
    for kind, color in COLORS.items():
        piece = CatmullRom(POINTS, kind).point(np.linspace(1.0, 2.0, 121))
        pen.line([tuple(p) for p in ((piece - low) * scale + (148.0, 90.0)).tolist()], color, 2.0)
    for x, y in ((POINTS[1:3] - low) * scale + (148.0, 90.0)).tolist():
        dot(pen, (x, y), "text1", 3.8)


def _uneven_points() -> NDArray[np.float64]:
    """A walk whose steps differ by a factor of a hundred."""
    rng = np.random.default_rng(48)
    lengths = 10.0 ** rng.uniform(-1.5, 0.5, (MANY, 1))
    return np.asarray(np.cumsum(rng.standard_normal((MANY, 2)) * lengths, axis=0))


def _measure() -> Iterator[Comparison]:
    points = _uneven_points()
    kinds = ", ".join(COLORS)
    crossed = [int(crosses_itself(CatmullRom(points, kind).controls[1:-1]).sum()) for kind in COLORS]
    yield Comparison(
        f"{kinds}: pieces that cross themselves, of {MANY - 3} between uneven points",
        "centripetal: never (proven)",
        ", ".join(map(str, crossed)),
    )
    chords = np.hypot(*np.diff(points, axis=0)[1:-1].T)
    far = [
        float(np.percentile(_farthest(CatmullRom(points, kind).controls[1:-1]) / chords, 99.0))
        for kind in COLORS
    ]
    yield Comparison(
        f"{kinds}: 99 % of the pieces stay as near to their chord as, in chords",
        "",
        ", ".join(f"{reach:.2f}" for reach in far),
    )
    costs = {kind: least_time(partial(CatmullRom, points, kind), 9) for kind in ("uniform", "centripetal")}
    yield Comparison(
        "price of centripetal knots, to uniform ones",
        "",
        f"{costs['centripetal'] / costs['uniform']:.2f} times",
    )


def _farthest(controls: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far each piece goes from its chord at most, at 33 points."""
    t = np.linspace(0.0, 1.0, 33)[None, :, None]
    p0, p1, p2, p3 = (controls[:, i, None] for i in range(4))
    places = (1 - t) ** 3 * p0 + 3 * t * (1 - t) ** 2 * p1 + 3 * t * t * (1 - t) * p2 + t**3 * p3
    chord = p3 - p0
    part = np.clip(np.sum((places - p0) * chord, axis=2) / np.sum(chord * chord, axis=2), 0.0, 1.0)
    away = places - p0 - part[..., None] * chord
    return np.asarray(np.max(np.hypot(away[..., 0], away[..., 1]), axis=1))


CATMULL_ROM = Paper(
    problem=(
        "A path is to go smoothly through given points, and moving one of them should change it only "
        "nearby. Catmull-Rom curves do that, but where two points lie close together they swing out, form "
        "cusps or even loops between neighbours.",
    ),
    idea=(
        "A curve runs by a parameter, and how far apart the parameters (knots) of two neighbouring points "
        "lie is free. Let the distance of two knots be a power of the distance of the points. One power "
        "is special: with one half no piece can have a cusp or cross itself.",
    ),
    steps=(
        Step(
            "Lay the knots: power 0 ignores the distances (uniform), 1 takes them (chordal), one half "
            "lies between (centripetal).",
            _draw_knots,
            r"t_{i+1} = t_i + |\v{P}_{i+1} - \v{P}_i|^{\alpha}",
        ),
        Step(
            "At each point take the slope of the parabola through it and its two neighbours, by those knots.",
            _draw_slopes,
        ),
        Step(
            "Each piece is the cubic with these slopes at its ends; it depends on four points.", _draw_curves
        ),
        Step(
            "The short piece close up: uniform knots give it slopes far too large for its length; chordal "
            "ones make the pieces beside it bulge.",
            _draw_close_up,
        ),
    ),
    showed=(
        "They proved that of all powers only one half guarantees that no piece has a cusp or crosses "
        "itself. They bounded how far a curve can go from its chord, and showed it on hair, paths of "
        "cameras and strokes.",
    ),
    measure=_measure,
    limits=(
        "The promise holds within a piece: two pieces may still cross each other. It is about shape; the "
        "pace along the path still changes, which C01 evens out by its table of lengths.",
    ),
    after=(
        "Centripetal curves became the default of many engines. Curves with local control that also have "
        "continuous curvature came with Yan, Schiller, Wilensky, Carr and Schaefer (2017).",
    ),
)

"""The paper on liquids between recorded ones (P38)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from game.arrays import Floats
from game.lab.timing import least_time
from game.physics.effects import EffectSet
from game.physics.kernels import elementary
from game.physics.liquid.blending import Blend
from game.physics.liquid.distances import Run, area_of, run_of
from game.scenes.blend.level import BlendContent, RunEntry, WaterEntry
from game.scenes.blend.parameters import BlendParameters
from game.scenes.blend.world import BlendWorld
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

CELL, NODES, FRAMES, RADIUS = 0.05, 61, 5, 0.5
COLUMN = WaterEntry(low=(0.0, 0.0), high=(0.4, 0.6))
WALLS = ((0.1, 0.1), (0.4, 0.1), (0.1, 0.3), (0.4, 0.3))  # width and height, m
HALF = (0.5, 0.5)
Box = tuple[float, float, float, float]  # left, top, right, bottom in the figure


def disc(x: float, radius: float = RADIUS, rising: float = 0.0) -> Run:
    """A disc about (x, 0) m that rises by so much (m) in the run."""
    places = (np.arange(NODES) - NODES // 2) * CELL
    pictures = []
    for frame in range(FRAMES):
        up = places[:, None] - rising * (frame / (FRAMES - 1) - 0.5)
        distance = np.sqrt((places[None, :] - x) * (places[None, :] - x) + up * up) - radius
        pictures.append(np.clip(0.5 - 0.5 * distance / CELL, 0.0, 1.0))
    return run_of(np.stack(pictures), (CELL, CELL, CELL))


def pair(apart: float) -> Blend:
    """Two discs with their centres so many radii apart."""
    return Blend((disc(-0.5 * apart * RADIUS), disc(0.5 * apart * RADIUS)))


def kept(blend: Blend, aligned: bool, weights: tuple[float, float] = HALF) -> float:
    """Area in the middle of the run, beside the weighted mean of the areas of both."""
    frame = 0.5 * (blend.frames - 1)
    one, other = (area_of(blend.at(frame, ends), CELL) for ends in ((1.0, 0.0), (0.0, 1.0)))
    return area_of(blend.at(frame, weights, aligned), CELL) / (weights[0] * one + weights[1] * other)


def lens(apart: float) -> float:
    """What plain mixing of two equal discs keeps: an ellipse with both centres as its foci."""
    return math.sqrt(max(1.0 - 0.25 * apart * apart, 0.0))


def lost_at_ends(blend: Blend) -> float:
    """Largest difference in m between a run and what weight 1 for it gives."""
    count = len(blend.runs)
    return max(
        float(np.max(np.abs(blend.at(frame, np.eye(count)[k].tolist()) - blend.distances[k][frame])))
        for k in range(count)
        for frame in range(blend.frames)
    )


def dams() -> BlendWorld:
    """Four recorded dams before walls, and the nine of the square beside true runs."""
    runs = tuple(RunEntry(water=(COLUMN,), at=0.9, width=wide, height=high) for wide, high in WALLS)
    return BlendWorld(BlendContent(runs=runs, cells=64), BlendParameters(), EffectSet(), 0)


def _draw_liquid(pen: Pen, distance: Floats, box: Box, color: str) -> None:
    """Where distances (rows, columns) are below 0, row by row; the node rows fill the box from below."""
    rows, columns = distance.shape
    wide, high = (box[2] - box[0]) / columns, (box[3] - box[1]) / rows
    for row in range(rows):
        inside = np.concatenate([[False], distance[row] < 0.0, [False]])
        ends = np.flatnonzero(inside[1:] != inside[:-1])
        for start, end in zip(ends[::2].tolist(), ends[1::2].tolist(), strict=True):
            low = box[3] - row * high
            left, right = box[0] + start * wide, box[0] + end * wide
            pen.area([(left, low), (right, low), (right, low - high - 0.5), (left, low - high - 0.5)], color)


def _draw_runs(pen: Pen) -> None:
    """Pictures of a disc that rises, one behind the other."""
    run = disc(0.0, 0.35, 1.6)
    for frame in reversed(range(FRAMES)):
        left, top = 16.0 + 34.0 * frame, 74.0 - 14.0 * frame
        box = (left, top, left + 110.0, top + 110.0)
        pen.box(left, top, 110.0, 110.0, "text3", ring=1.0)
        _draw_liquid(pen, run.distance[frame], box, "chalk" if frame % 2 else "body")
    pen.words("time", 214.0, 168.0, "text2")


def _draw_vanishing(pen: Pen) -> None:
    """Half of one disc and half of another, further and further apart, plainly mixed."""
    for k, apart in enumerate((0.5, 1.0, 1.5, 2.5)):
        left = 8.0 + 70.0 * k
        blend = pair(apart)
        _draw_liquid(pen, blend.at(2.0, HALF, False), (left, 40.0, left + 66.0, 106.0), "vermilion")
        for ends in ((1.0, 0.0), (0.0, 1.0)):
            x = left + 33.0 + 66.0 / (NODES * CELL) * (ends[1] - 0.5) * apart * RADIUS
            pen.arc((x, 73.0), 66.0 / (NODES * CELL) * RADIUS, 0.0, 360.0, "text2")
        pen.words(f"{apart:g} r", left + 33.0, 122.0, "text2")
        pen.words(f"{100.0 * kept(blend, False):.0f} %", left + 33.0, 142.0, "vermilion")
    pen.words("centres apart, and area kept", 148.0, 176.0, "text2", size=12)


def _draw_matches(pen: Pen) -> None:
    """Points of two discs that the alignment matched, in the middle picture."""
    blend = Blend((disc(-0.8, 0.35), disc(0.6, 0.6)))
    box = (20.0, 20.0, 276.0, 276.0 - 80.0)
    scale = (box[2] - box[0]) / (NODES * CELL)
    pairs = blend.pairs[0]
    near = pairs[np.abs(pairs[:, 0] - 2.0 * CELL) < 0.5 * CELL][::3]
    for one in near.tolist():
        start = box[0] + scale * one[2], 108.0 - scale * (one[1] - 0.5 * NODES * CELL)
        end = box[0] + scale * one[5], 108.0 - scale * (one[4] - 0.5 * NODES * CELL)
        pen.line((start, end), "amber", 1.0)
        pen.disc(*start, 2.4, "chalk")
        pen.disc(*end, 2.4, "green")


def _draw_between(pen: Pen) -> None:
    """Five weights, aligned above, plain below."""
    blend = Blend((disc(-0.9, 0.3), disc(0.8, 0.55)))
    for k in range(5):
        share = 0.25 * k
        left = 6.0 + 57.0 * k
        for top, aligned, color in ((24.0, True, "amber"), (112.0, False, "vermilion")):
            pen.box(left, top, 54.0, 54.0, "text3", ring=1.0)
            picture = blend.at(2.0, (1.0 - share, share), aligned)
            _draw_liquid(pen, picture, (left, top, left + 54.0, top + 54.0), color)
        pen.words(f"{share:g}", left + 27.0, 188.0, "text2")
    pen.words("aligned", 34.0, 12.0, "amber")
    pen.words("plain", 28.0, 100.0, "vermilion")


def _measure() -> Iterator[Comparison]:
    ends = Blend((disc(-0.9, 0.3), disc(0.8, 0.55, 0.4)))
    yield Comparison(
        "weights 0 and 1: what comes back, beside the recorded runs",
        "the inputs", f"off by {lost_at_ends(ends):.0g} m at most",
    )  # fmt: skip
    far = pair(2.5)
    yield Comparison(
        "two discs that do not meet, half of each: area kept", "features are carried",
        f"{100.0 * kept(far, False):.0f} % plain, {100.0 * kept(far, True):.1f} % aligned",
    )  # fmt: skip
    near = pair(1.5)
    yield Comparison(
        "two discs 1.5 radii apart, plain: area kept", "",
        f"{100.0 * kept(near, False):.1f} %, by law {100.0 * lens(1.5):.1f} %",
    )  # fmt: skip
    unlike = Blend((disc(0.0, 0.3), disc(0.0, 0.75)))
    law = elementary.square(0.5 * (0.3 + 0.75)) / (0.5 * (0.3 * 0.3 + 0.75 * 0.75))
    yield Comparison(
        "discs of radii 0.3 and 0.75 m, aligned: area kept", "",
        f"{100.0 * kept(unlike, True):.1f} %; mean of the radii {100.0 * law:.1f} %",
    )  # fmt: skip
    world = dams()
    shown = [one for one in world.squares if 1.0 not in one.weights]
    areas, apart = [100.0 * one.area for one in shown], [100.0 * one.misplaced for one in shown]
    yield Comparison(
        "nine dams shown from four recorded: area beside true runs, the five between",
        "nine shown from four", ", ".join(f"{one:.1f}" for one in areas) + " % off",
    )  # fmt: skip
    yield Comparison("liquid that is elsewhere than in the true run", "",
                     f"{min(apart):.1f} to {max(apart):.1f} % of the area")  # fmt: skip
    yield Comparison("preparing: three alignments", "", f"{world.prepared:.2f} s")
    cost = least_time(lambda: world.blend.at(12.5, (0.25, 0.25, 0.25, 0.25)), 3)
    yield Comparison("a picture between four runs", "interactive", f"{1e3 * cost:.1f} ms")


BLENDING = Paper(
    problem=(
        "A liquid that was computed is what it is. To have the drop fall a little further to the left, or "
        "a lower wall, all must be computed again. The splash may turn out less fine.",
    ),
    idea=(
        "Take runs that are recorded, and make those between them. Each is one surface in place and time. "
        "Find what belongs together in two such surfaces, carry it a part of the way, and mix there.",
    ),
    steps=(
        Step(
            "A run is a stack of pictures. Distances from its surface are signed, and reach through time.",
            _draw_runs,
            r"s(x, y, t)",
        ),
        Step("The plain mean of two distances loses what does not overlap.", _draw_vanishing,
             r"\frac{A}{A_0} = \sqrt{1 - (\frac{d}{2 r})^2}"),
        Step(
            "Each point of one surface looks for the nearest of the other whose normal is alike. A smooth "
            "deformation of place and time follows, stiff at first. Links of the hand weigh more.",
            _draw_matches,
        ),
        Step(
            "Both runs are carried a part of the way each, and mixed where they meet.",
            _draw_between,
            r"s = (1 - w) s_1(q - w u) + w s_2(q + (1 - w) u)",
        ),
    ),
    showed=(
        "Splashes in space between recorded ones, moved by sliders while one looks. A square of dam "
        "breaks before walls of other widths and heights, from those in its corners.",
    ),
    measure=_measure,
    limits=(
        "Nothing of it is a law of motion: mass, momentum and walls are not known. A drop between a small "
        "and a large one has the mean of the radii, and so less than the mean of the areas. Where one run "
        "has a jet and the other none, the jet comes out of the nearest surface. Thin sheets are lost "
        "already at half of the resolution. Ours is in the plane, with a lattice for the deformation.",
    ),
    after=(
        "Liquids between recorded ones by optical flow on signed distances (Thuerey 2016), which needs no "
        "surfaces, and by networks that learn the deformation (Prantl, Bonev and Thuerey 2019).",
    ),
)  # fmt: skip

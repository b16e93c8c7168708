"""Shapes to try: convex ones, and unions of convex parts that do not overlap."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from game.physics.kernels import elementary
from game.physics.narrowphase.depth.shape import Shape

Part = list[tuple[float, float]]


def _box(left: float, bottom: float, right: float, top: float) -> Part:
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def _ring(count: int, radius: float = 1.0, start: float = 0.0) -> Part:
    turns = [start + 2.0 * math.pi * k / count for k in range(count)]
    return [(radius * elementary.cos(t), radius * elementary.sin(t)) for t in turns]


def _star(points: int, inner: float) -> list[Part]:
    """A polygon in the middle, and a triangle on each of its edges."""
    core = _ring(points, inner, math.pi / 2 + math.pi / points)
    tips = _ring(points, 1.0, math.pi / 2 + 2.0 * math.pi / points)
    return [core, *([core[k], tips[k], core[(k + 1) % points]] for k in range(points))]


def _gear(teeth: int) -> list[Part]:
    """A wheel with tapered teeth: its core has an edge for each tooth and each gap."""
    core = _ring(2 * teeth, 0.72)
    parts = [core]
    for k in range(teeth):
        a, b = core[2 * k], core[(2 * k + 1) % (2 * teeth)]
        middle = (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]))
        out = 1.0 / elementary.length(*middle)
        tips = [
            (middle[0] * out + 0.55 * (p[0] - middle[0]), middle[1] * out + 0.55 * (p[1] - middle[1]))
            for p in (a, b)
        ]
        parts.append([a, tips[0], tips[1], b])
    return parts


def _comb(teeth: int) -> list[Part]:
    """A back below, and teeth upwards 46 % of their pitch wide."""
    pitch = 2.0 / (teeth - 0.54)
    return [
        _box(-1.0, -0.6, 1.0, -0.3),
        *(_box(-1.0 + pitch * k, -0.3, -1.0 + pitch * (k + 0.46), 0.6) for k in range(teeth)),
    ]


MAKERS: dict[str, Callable[[], list[Part]]] = {
    "square": lambda: [_box(-0.7, -0.7, 0.7, 0.7)],
    "triangle": lambda: [_ring(3, 1.0, math.pi / 2)],
    "disc": lambda: [_ring(32)],
    "bar": lambda: [_box(-1.0, -0.12, 1.0, 0.12)],
    "sliver": lambda: [[(-1.0, 0.0), (1.0, -0.001), (1.0, 0.001)]],
    "L": lambda: [_box(-0.8, -0.8, 0.8, -0.3), _box(-0.8, -0.3, -0.3, 0.8)],
    "slot": lambda: [_box(-1.0, -0.8, 1.0, -0.4), _box(-1.0, -0.4, -0.16, 0.8), _box(0.16, -0.4, 1.0, 0.8)],
    "comb": lambda: _comb(4),
    "star": lambda: _star(5, 0.42),
    "gear": lambda: _gear(8),
}
PRESETS = tuple(MAKERS)


def preset(name: str, size: float = 1.0, flat: float = 1.0) -> Shape:
    """A shape by name, ``size`` m for half its width, its height times ``flat``. ValueError for others."""
    if name not in MAKERS:
        raise ValueError(f"shape {name!r}: expected one of {', '.join(PRESETS)}")
    if not (0.0 < size < math.inf and 0.0 < flat < math.inf):
        raise ValueError(f"size, flat = {size}, {flat}: expected positive numbers")
    return Shape([np.array(part) * (size, size * flat) for part in MAKERS[name]()])

"""What the farthest vertex along a direction costs: climbing along the outline against looking at all."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study, Workload
from game.physics.kernels import elementwise
from game.physics.narrowphase import PolygonSet
from game.physics.narrowphase.features import Polygon
from game.physics.narrowphase.simplex import support_cold, support_hc, support_scan

DIRECTIONS = 20_000
LEAST = 2.0**-56  # errors below are shown as this: they are zero
WAYS = ("climb-near", "climb-far", "scan")


def pebbles(corners: int, count: int, seed: int) -> list[Floats]:
    """Convex polygons (corners, 2) with uneven corners on ellipses of half axes 1 and 0.5 to 1."""
    random = np.random.default_rng(seed)
    shapes = []
    for _ in range(count):
        turns = (np.arange(corners) + random.uniform(-0.3, 0.3, corners)) * (2.0 * math.pi / corners)
        shapes.append(
            np.column_stack((elementwise.cos(turns), random.uniform(0.5, 1.0) * elementwise.sin(turns)))
        )
    return shapes


@lru_cache(maxsize=8)
def packed_pebbles(corners: int, count: int, seed: int) -> PolygonSet:
    """The same as a set, kept."""
    return PolygonSet(pebbles(corners, count, seed))


NO_PAIR = "No mark: there are no two convex polygons."


@lean_kernel
def ask(vertices, directions, way, found):
    """Write the vertex of (n, 2) farthest along each direction (m, 2), found in one of the ``WAYS``."""
    polygon = Polygon(vertices, 0, vertices.shape[0])
    k = 0
    for i in range(directions.shape[0]):
        x, y = directions[i, 0], directions[i, 1]
        if way == 0:
            k = support_hc(polygon, k, x, y)
        elif way == 1:
            k = support_cold(polygon, x, y)
        else:
            k = support_scan(polygon, x, y)
        found[i] = k


class Supports:
    """Support vertices along directions that turn slowly (near) or are anywhere (far)."""

    def __init__(self, corners: int, way: str) -> None:
        self.simulated_s = float(DIRECTIONS)
        self.way = WAYS.index(way)
        self.vertices = packed_pebbles(corners, 1, corners).vertices
        random = np.random.default_rng(7)
        turns = 0.01 * np.arange(DIRECTIONS) if way != "climb-far" else random.uniform(0.0, 7.0, DIRECTIONS)
        self.directions = np.column_stack((elementwise.cos(turns), elementwise.sin(turns)))
        self.found = np.zeros(DIRECTIONS, dtype=np.int64)

    def reset(self) -> None:
        self.found[:] = 0

    def run(self) -> None:
        ask(self.vertices, self.directions, self.way, self.found)

    def outcome(self) -> Outcome:
        reach = self.vertices @ self.directions.T
        missed = reach.max(axis=0) - reach[self.found, np.arange(DIRECTIONS)]
        n = len(self.vertices)
        if self.way == WAYS.index("scan"):
            looks = n * DIRECTIONS
        else:
            before = np.concatenate(([0], self.found[:-1])) if self.way == 0 else self.found * 0
            way = np.abs(self.found - before)
            steps = np.minimum(way, n - way) if self.way == 0 else np.full(DIRECTIONS, min(n, 8 + n // 16))
            looks = int((steps + 3).sum())
        return Outcome(max(LEAST, float(missed.max())), looks)


def support_settings() -> list[Setting]:
    """Four to a thousand vertices."""
    return [
        Setting(way, n, {}, {"method": "scan" if way == "scan" else "climb"}, 1.0 + 0.01 * n)
        for n in (4, 8, 16, 32, 64, 128, 256, 512, 1024)
        for way in WAYS
    ]


def support_trial(setting: Setting) -> Supports:
    """One polygon, asked for its farthest vertex along many directions."""
    return Supports(int(setting.knob), setting.method)


def present_support(parameters: Mapping[str, Any]) -> Setting | None:
    """How the scene asks its polygons, the one with more corners."""
    corners = float(parameters["corners"])
    climb = "climb-near" if parameters["coherence"] else "climb-far"
    return Setting("scan" if parameters["method"] == "scan" else climb, corners) if corners >= 3.0 else None


support_study = Study(
    name="c11-support",
    title="Support vertices: climbing against looking at all",
    error="how much farther another vertex is",
    error_unit="m",
    counter="vertices looked at",
    knob=Knob("corners", "vertices"),
    methods=(
        Method("climb-near", "climbing from the last", None, "directions turn by 0.01"),
        Method("climb-far", "eight asked, then climbing", None, "directions anywhere"),
        Method("scan", "all vertices", 1.0),
    ),
    settings=support_settings,
    trial=support_trial,
    reference="the largest product of all vertices with the direction.",
    expectation="All find the farthest vertex; looking at all of them pays for small polygons only.",
    present=present_support,
    no_place=NO_PAIR,
    workload=Workload("pebbles of as many vertices"),
    axes=Axes("knob", "cpu"),
    cost="CPU time for one direction",
    short="Support",
)

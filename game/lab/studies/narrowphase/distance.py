"""What closest points cost.

Steps and error of GJK against its tolerance, of V-Clip and GJK against the number of vertices and the motion
between queries.

Both methods are finite: the error falls from the tolerance to rounding within a few steps. With coherence
V-Clip takes a step or two whatever the number of vertices. If the shapes turn by an angle between queries it
walks past n angle / 2π of them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.studies.narrowphase.support import LEAST, NO_PAIR, packed_pebbles, support_study
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.kernels import elementary, elementwise
from game.physics.narrowphase import ConvexPolygon, PolygonSet, Proximities, gjk_batch, vclip_batch

PAIRS, FRAMES = 400, 8
SIZES = (8, 64, 512)
PER_QUERY = "CPU time for one query"


def poses_of(places: Floats, angles: Floats) -> Floats:
    """Poses (k, 4) x, y, cos, sin."""
    return np.column_stack((places, elementwise.cos(angles), elementwise.sin(angles)))


class Queries:
    """Pairs of pebbles that turn by an angle from query to query; ``method`` says how they are measured."""

    def __init__(
        self, corners: int, turn: float, method: str, tolerance: float = 1e-14, warm: bool = True
    ) -> None:
        self.simulated_s = float(PAIRS * FRAMES)
        self.shapes = [packed_pebbles(corners, PAIRS, seed) for seed in (1, 2)]
        random = np.random.default_rng(corners)
        far, around = random.uniform(2.1, 4.0, PAIRS), random.uniform(0.0, 2.0 * math.pi, PAIRS)
        self.places = np.column_stack((far * elementwise.cos(around), far * elementwise.sin(around)))
        self.starts = random.uniform(0.0, 2.0 * math.pi, (2, PAIRS))
        self.turn, self.method, self.tolerance, self.warm = turn, method, tolerance, warm
        self.found: list[Proximities] = []

    def reset(self) -> None:
        self.poses = [
            [
                poses_of(place, start + sign * self.turn * k)
                for place, start, sign in (
                    (0.0 * self.places, self.starts[0], 1.0), (self.places, self.starts[1], -1.0)
                )
            ]
            for k in range(-1, FRAMES)
        ]  # fmt: skip
        self.found = []
        self.features = np.full((PAIRS, 2), -1, dtype=np.int64)
        if self.warm:
            self._measure(0)  # where the last query ended

    def _measure(self, k: int) -> Proximities:
        if not self.warm:
            self.features[:] = -1
        a, b = self.shapes
        poses_a, poses_b = self.poses[k]
        if self.method == "vclip":
            return vclip_batch(a, b, None, poses_a, poses_b, self.features)
        return gjk_batch(
            a, b, None, poses_a, poses_b, self.features, self.tolerance,
            method="scan" if self.method == "scan" else "climb",
        )  # fmt: skip

    def run(self) -> None:
        self.found = [self._measure(k) for k in range(1, FRAMES + 1)]

    def outcome(self) -> Outcome:
        a, b = self.shapes
        error, steps = LEAST, 0
        for k, found in enumerate(self.found, start=1):
            poses_a, poses_b = self.poses[k]
            exact = gjk_batch(a, b, None, poses_a, poses_b, method="scan").distance
            error = max(error, float(np.abs(found.distance - exact).max()))
            steps += int(found.iterations.sum())
        return Outcome(error, steps)


# -- tolerance ------------------------------------------------------------------------------------------


def tolerance_settings() -> list[Setting]:
    """Tolerances from a tenth to rounding, for three sizes."""
    return [
        Setting(
            f"corners-{n}",
            elementary.pow(10.0, -exponent),
            {},
            {"exponent": -float(exponent)},
            1.0 + elementary.log2(n),
        )
        for exponent in range(1, 15)
        for n in SIZES
    ]


def tolerance_trial(setting: Setting) -> Queries:
    """Queries that begin again each time."""
    method = str(setting.scene.get("method", "climb"))
    n = int(setting.method.split("-")[1])
    return Queries(n, 0.3, "scan" if method == "scan" else "gjk", setting.knob, warm=False)


def present_tolerance(parameters: Mapping[str, Any]) -> Setting | None:
    """Where the scene stands: its tolerance, for as many corners as it has."""
    scene = {"method": parameters["method"]}
    corners = int(parameters["corners"])
    if corners < 3:
        return None
    return Setting(f"corners-{corners}", elementary.pow(10.0, float(parameters["exponent"])), {}, scene)


def own_corners(parameters: Mapping[str, Any]) -> str:
    """How many corners the scene's polygons have, if they are none of the study's."""
    corners = int(parameters["corners"])
    return "" if corners in SIZES else f"{corners}"


# -- vertices and coherence -----------------------------------------------------------------------------


class Coins(Queries):
    """The same with coins of radius 1 m: regular polygons in them, against the distance of the circles."""

    def __init__(self, corners: int, turn: float, method: str, warm: bool = True) -> None:
        super().__init__(corners, turn, method, warm=warm)
        turns = np.arange(corners) * (2.0 * math.pi / corners)
        coin = ConvexPolygon(np.column_stack((elementwise.cos(turns), elementwise.sin(turns))))
        self.shapes = [PolygonSet([coin] * PAIRS)] * 2

    def outcome(self) -> Outcome:
        exact = np.sqrt((self.places * self.places).sum(axis=1)) - 2.0
        error = max(float(np.abs(found.distance - exact).max()) for found in self.found)
        return Outcome(error, sum(int(found.iterations.sum()) for found in self.found))


TURNS = {
    "vclip-small": ("vclip", 1e-3),
    "vclip-medium": ("vclip", 0.03),
    "vclip-large": ("vclip", 1.0),
    "gjk-small": ("gjk", 1e-3),
    "gjk-large": ("gjk", 1.0),
}


CORNERS = (6, 8, 16, 32, 64, 128, 256, 512, 1000)


def coherence_settings() -> list[Setting]:
    """Six to a thousand vertices, turned a little or much from query to query."""
    return [
        Setting(name, 2.0 * math.pi / n, {}, {"coherence": True}, 1.0 + 0.05 * n * TURNS[name][1])
        for n in CORNERS
        for name in TURNS
    ]


def coherence_trial(setting: Setting) -> Coins:
    """Queries that begin at the last answer; those of a scene only if it lets them."""
    method, turn = TURNS.get(setting.method) or ("vclip", setting.others["turn"])
    return Coins(round(2.0 * math.pi / setting.knob), turn, method, bool(setting.scene["coherence"]))


def present_coherence(parameters: Mapping[str, Any]) -> Setting | None:
    """V-Clip on coins of as many corners as the scene's polygons, turned as they are."""
    corners = int(parameters["corners"])
    if corners < 3:
        return None
    coherence = {"coherence": bool(parameters["coherence"])}
    return Setting("present", 2.0 * math.pi / corners, {"turn": float(parameters["turn"])}, coherence)


gjk_study = Study(
    name="c11",
    title="GJK: tolerance",
    error="distance too large by at most",
    error_unit="m",
    counter="steps",
    knob=Knob("exponent", "relative tolerance"),
    methods=tuple(Method(f"corners-{n}", f"{n} vertices") for n in SIZES),
    settings=tolerance_settings,
    trial=tolerance_trial,
    reference="GJK at full tolerance, all vertices looked at; V-Clip says the same to rounding.",
    expectation=(
        "The walk is finite: a step takes many digits at once, so that nearly all tolerances cost the same."
    ),
    floor=1e-15,
    cost=PER_QUERY,
    present=present_tolerance,
    no_place=NO_PAIR,
    workload=Workload("pebbles of 8, 64 or 512 vertices", own_corners),
    short="Tolerance",
    related=(support_study,),
)

vclip_study = Study(
    name="c10",
    title="V-Clip and GJK: round shapes by many vertices",
    error="farthest from the distance of two circles",
    error_unit="m",
    counter="steps",
    knob=Knob("side", "side of the polygons", "m"),
    methods=(
        Method("vclip-small", "V-Clip, turned by 0.001", 2.0),
        Method("vclip-medium", "V-Clip, turned by 0.03", 2.0),
        Method("vclip-large", "V-Clip, turned by 1", 2.0, "walks past n / 2π features"),
        Method("gjk-small", "GJK, turned by 0.001", 2.0),
        Method("gjk-large", "GJK, turned by 1", 2.0),
    ),
    settings=coherence_settings,
    trial=coherence_trial,
    reference="the distance of the centres less two radii.",
    expectation=(
        "The polygons are measured to rounding; what is wrong is the polygon, by h²/4 for sides of h. With "
        "coherence more vertices cost V-Clip hardly anything; turned by a radian between queries, its walk "
        "grows with them, GJK's hardly."
    ),
    present=present_coherence,
    no_place=NO_PAIR,
    workload=Workload(
        "regular polygons in circles of 1 m", lambda p: "" if p["round"] else "polygons of another shape"
    ),
    cost=PER_QUERY,
)

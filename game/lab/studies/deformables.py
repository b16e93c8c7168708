"""What the size of cells and of the table cost: time of a detection against one, the other held."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.study import Axes, Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.deformables import Mesh, MeshCollider, MeshStore, blob, mean_edge, store_of
from game.physics.kernels import elementwise

BLOBS, RINGS, RADIUS = 40, 4, 0.1  # 3,840 triangles
PITCH = 0.95  # of a diameter: neighbours overlap a little
CELLS = (0.12, 0.2, 0.33, 0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 5.0, 8.0, 14.0)  # mean edges
TABLES = {"prime": (101, 211, 503, 1009, 2003, 4001, 10_007, 40_009, 160_001),
          "power": (128, 256, 512, 1024, 2048, 4096, 8192, 32_768, 131_072)}  # fmt: skip
USUAL_TABLE = 4001
PER_STEP = "CPU time of a detection"


def pile_of(blobs: int, rings: int, seed: int = 4) -> tuple[MeshStore, NDArray[np.float64]]:
    """So many blobs in rows, each turned and moved a little by chance, and where their vertices are (m)."""
    generator = np.random.default_rng(seed)
    mesh = blob(RADIUS, rings)
    across = round(math.sqrt(blobs) * 1.3)
    meshes = []
    for k in range(blobs):
        angle, (dx, dy) = generator.uniform(0.0, 6.28), generator.uniform(-0.05, 0.05, 2) * RADIUS
        turn = np.array(
            (
                (elementwise.cos(angle), -elementwise.sin(angle)),
                (elementwise.sin(angle), elementwise.cos(angle)),
            )
        )
        x = 2.0 * RADIUS * PITCH * (k % across + 0.5 * (k // across % 2))
        y = 2.0 * RADIUS * PITCH * 0.87 * (k // across)
        meshes.append(Mesh(mesh.points @ turn.T + (x + dx, y + dy), mesh.triangles))
    return store_of(meshes)


@lru_cache(maxsize=1)
def _pile() -> tuple[MeshStore, NDArray[np.float64], float]:
    store, points = pile_of(BLOBS, RINGS)
    return store, points, mean_edge(store, points)


@lru_cache(maxsize=1)
def _all_pairs() -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """What testing all pairs finds."""
    store, points, edge = _pile()
    collider = MeshCollider(store, edge, USUAL_TABLE)
    collider.find(points)
    return collider.naive()


def detection_trial(cell: float, table: int) -> Trial:
    """Detections of the pile with a size of cells (mean edges) and a table: pairs that differ from all."""
    store, points, edge = _pile()
    collider = MeshCollider(store, cell * edge, table)

    def judge(_: object) -> Outcome:
        found = collider.contact_keys, collider.crossing_keys
        wrong = sum(len(np.setxor1d(a, b)) for a, b in zip(found, _all_pairs(), strict=True))
        counts = collider.counts
        failure = f"{wrong} wrong pairs" if wrong else ""
        return Outcome(float(wrong), counts.tested + counts.strangers, failure)

    return computation(1.0, lambda: collider.find(points), judge)


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting("usual", float(parameters["cell"]))


table_study = Study(
    name="p04-table",
    title="Spatial hashing: time against the size of the table",
    error="pairs that differ from testing all",
    error_unit="",
    counter="vertices met",
    knob=Knob("table", "slots of the table"),
    methods=(Method("prime", "a prime number of slots"), Method("power", "a power of two")),
    settings=lambda: [
        Setting(method, float(table), {}, {"table": table}, 1.0 + 3e3 / table)
        for method, tables in TABLES.items()
        for table in tables
    ],
    trial=lambda setting: detection_trial(1.0, int(setting.knob)),
    reference="All pairs tested one by one: the same pairs for each table.",
    expectation="A short table has long chains of vertices that are nowhere near. Beyond some slots for each "
    "vertex nothing is gained any more; whether the number is prime hardly matters.",
    present=lambda parameters: Setting("prime", float(parameters["table"])),
    workload=Workload("40 blobs, 3,840 triangles, cells of a mean edge"),
    axes=Axes("knob", "cpu"),
    short="Table",
    cost=PER_STEP,
)
cell_study = replace(
    table_study,
    name="p04-cells",
    title="Spatial hashing: time against the size of cells",
    knob=Knob("cell", "cell size", "mean edges"),
    methods=(Method("usual", "4001 slots"), Method("short", "101 slots")),
    settings=lambda: [
        Setting(method, cell, {}, {"cell": cell, "table": table}, 1.0)
        for method, table in (("usual", USUAL_TABLE), ("short", 101))
        for cell in CELLS
    ],
    trial=lambda setting: detection_trial(setting.knob, USUAL_TABLE if setting.method == "usual" else 101),
    expectation="Small cells are many to look at, large ones are full. Vertices met are fewest at the mean "
    "length of an edge, which the authors found best; time hardly changes from there to three times that.",
    present=_present,
    workload=Workload("40 blobs, 3,840 triangles"),
    short="Cells",
    related=(table_study,),
)

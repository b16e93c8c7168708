"""The paper on spatial hashing for deformable objects (P04)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from game.lab.studies.deformables import CELLS, TABLES, pile_of
from game.lab.timing import least_time
from game.physics.deformables import MeshCollider, mean_edge
from game.physics.deformables.hashing import STAMP, slot_of
from game.scenes.deformables.figure import draw_depth, draw_slots, draw_two_passes
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

BLOBS, RINGS = 134, 5  # 20,100 triangles
SMALL, SMALL_RINGS = 30, 3
TABLE, SIDE = 40_009, 24  # slots; cells from the origin


def _milliseconds(collider: MeshCollider, points: np.ndarray) -> float:
    """The best of some detections."""
    return 1e3 * least_time(lambda: collider.find(points))


def mirrored_share() -> float:
    """The share of cells (i, j) near the origin whose slot is that of (-i, -j) as well."""
    cells = [(i, j) for i in range(1, SIDE + 1) for j in range(-SIDE, SIDE + 1) if j]
    return sum(slot_of(i, j, TABLE) == slot_of(-i, -j, TABLE) for i, j in cells) / len(cells)


def _few(table: int) -> tuple[MeshCollider, np.ndarray]:
    """Three blobs that overlap, and a collider with a table of so many slots."""
    store, points = pile_of(3, 2)
    return MeshCollider(store, mean_edge(store, points), table), points


def _draw_stamps(pen: Pen) -> None:
    """The slots of a table after a step, and after the next, in which the blobs have moved on."""
    collider, points = _few(60)
    for top, shift, words in ((34.0, 0.0, "a step"), (124.0, 0.9, "the next")):
        collider.find(points + shift)
        newest = int(collider.slots[:, STAMP].max())
        for k, stamp in enumerate(collider.slots[:, STAMP].tolist()):
            x, y = 18.0 + 13.2 * (k % 20), top + 14.0 * (k // 20)
            if stamp:
                pen.box(x, y, 11.0, 11.0, "chalk" if stamp == newest else pen.veiled("amber", 0.55))
            pen.box(x, y, 11.0, 11.0, "text3", ring=1.0)
        filled, old = (
            int(np.count_nonzero(one))
            for one in (
                collider.slots[:, STAMP] == newest,
                (collider.slots[:, STAMP] > 0) & (collider.slots[:, STAMP] < newest),
            )
        )
        pen.words(f"{words}: {filled} filled, {old} old stamps", 148.0, top - 14.0, "text2")


def _draw_crossings(pen: Pen) -> None:
    """Edges of three blobs, and those that cross the rim of another."""
    collider, points = _few(211)
    collider.find(points)
    edges = collider.store.topology.edges
    low, high = points.min(axis=0), points.max(axis=0)
    scale = min(270.0 / float(high[0] - low[0]), 170.0 / float(high[1] - low[1]))
    places = (
        148.0 + scale * (points[:, 0] - 0.5 * (low[0] + high[0])),
        (98.0 - scale * (points[:, 1] - 0.5 * (low[1] + high[1]))),
    )
    at = list(zip(places[0].tolist(), places[1].tolist(), strict=True))
    rims = {int(key) & 0xFFFF_FFFF for key in collider.crossing_keys}
    crossing = {int(key) >> 32 for key in collider.crossing_keys}
    for k, (a, b) in enumerate(edges.tolist()):
        color = "amber" if k in crossing else "chalk" if k in rims else "text3"
        pen.line((at[a], at[b]), color, 2.2 if k in crossing else 1.0)
    pen.words(f"{len(collider.crossing_keys)} crossings", 148.0, 196.0, "amber")


def _measure() -> Iterator[Comparison]:
    store, points = pile_of(BLOBS, RINGS)
    edge = mean_edge(store, points)
    collider = MeshCollider(store, edge, TABLE)
    took = _milliseconds(collider, points)
    yield Comparison(
        "20,000 elements, contacts and self-contacts", "in real time (tetrahedra)",
        f"{took:.1f} ms for {len(store.topology.triangles)} triangles",
    )  # fmt: skip
    times = {}
    for cell in CELLS[1:-2]:
        collider.set_cells(cell * edge, TABLE)
        times[cell] = _milliseconds(collider, points)
    least = min(times.values())
    good = [cell for cell, took in times.items() if took <= 1.1 * least]
    yield Comparison(
        "Size of cells of the least time", "about the mean edge length",
        f"{min(good):g} to {max(good):g} mean edges, all within 10 %",
    )  # fmt: skip
    collider.set_cells(edge, TABLE)
    collider.find(points)
    counts = collider.counts
    met = counts.tested + counts.strangers
    yield Comparison("Vertices met that another cell left in the slot", "",
                     f"{100.0 * counts.strangers / met:.1f} % with {TABLE} slots")  # fmt: skip
    yield Comparison(
        f"Cells (i, j), up to {SIDE} from the origin, that share a slot with (-i, -j)",
        "",
        f"{100.0 * mirrored_share():.1f} %",
    )
    speeds = []
    for table in (TABLES["prime"][-3], TABLES["power"][-3]):
        collider.set_cells(edge, table)
        speeds.append(_milliseconds(collider, points))
    yield Comparison(
        "Table of 8,192 slots against one of 10,007, a prime",
        "",
        f"{speeds[1] / speeds[0]:.2f} times the time",
    )
    store, points = pile_of(SMALL, SMALL_RINGS)
    collider = MeshCollider(store, mean_edge(store, points), 1009)
    collider.find(points)
    contacts, crossings = collider.naive()
    wrong = len(np.setxor1d(contacts, collider.contact_keys)) + len(
        np.setxor1d(crossings, collider.crossing_keys)
    )
    yield Comparison("Pairs that differ from testing all", "", f"{wrong} of {len(contacts) + len(crossings)}")


SPATIAL_HASHING = Paper(
    problem=(
        "Soft bodies touch each other and themselves, in places that change from step to "
        "step. A tree of boxes "
        "would have to be built or mended all the time, and it says nothing of a body that touches itself.",
    ),
    idea=(
        "Keep no structure. Cut space into equal cells, and put only what is there into "
        "a hash table of cells, "
        "anew in each step. Vertices in elements, of the same mesh or another, are then "
        "a matter of a few tests.",
    ),
    steps=(
        Step(
            "First pass: each vertex into its cell, and each cell into a slot of the table. "
            "Several cells may "
            "share a slot.",
            draw_slots,
            r"h = (i p_1 \oplus j p_2) \mod m",
        ),
        Step("The table is not cleared: a slot whose time stamp is old counts as empty.", _draw_stamps),
        Step(
            "Second pass: each triangle visits the cells of its box, and tests the vertices there by "
            "barycentric coordinates. Its own corners do not count; other vertices of its mesh do.",
            draw_two_passes,
            r"\beta_1, \beta_2, \beta_3 \ge 0",
        ),
        Step("The same table, with a new stamp, for edges that cross the rim of a mesh.", _draw_crossings),
        Step(
            "Response: where edges cross the rim, border vertices get a depth and a way out; these spread "
            "inwards, so that neighbours agree (Heidelberger and others 2004).",
            draw_depth,
        ),
    ),
    showed=(
        "How time depends on the hash function, the size of the table and the size of the cells. The best "
        "cells are near the mean edge length. Contacts and self-contacts of up to 20,000 tetrahedra are "
        "found in real time.",
    ),
    measure=_measure,
    limits=(
        "All is looked at once a step: what is thin and fast goes through between two steps. One size of "
        "cells suits elements of one size. Ours are triangles in the plane: a rim has two sides where a "
        "surface has many, and chains are shorter than in space. A mesh wholly inside another has no rim to "
        "cross, so it gets no way out. "
        "The printed hash puts some cells (i, j) into the slot of (-i, -j): near the origin it costs tests.",
    ),
    after=(
        "Depths that neighbours agree on (Heidelberger and others 2004), and cells of several sizes in one "
        "table (Eitz and Gu 2007). For surfaces that must not pass through each other, tests over the "
        "whole time step.",
    ),
)  # fmt: skip

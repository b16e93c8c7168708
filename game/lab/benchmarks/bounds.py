"""Trees of bounding volumes over rough coasts: building, overlap and distance, beside shapely."""

from __future__ import annotations

from functools import partial

import numpy as np

from game.arrays import Floats
from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.bounds import Query, build_tree, minimal_obb, nearest
from game.physics.kernels import elementary, elementwise

SEGMENTS = 1024
PLACES = [
    (1.9 + 0.2 * elementary.cos(0.02 * i), 0.2 * elementary.sin(0.02 * i)) for i in range(64)
]  # m, of the second
APART = (3.0, 0.4)  # m, where it is clear of the first


def coast(seed: int, segments: int = SEGMENTS) -> Floats:
    """A closed rough line about the origin, m."""
    rng = np.random.default_rng(seed)
    angle = 2 * np.pi * np.arange(segments) / segments
    radius = np.ones(segments)
    for k in range(2, 60):
        radius += 0.25 / k * rng.uniform(0.3, 1) * elementwise.sin(k * angle + rng.uniform(0, 7))
    return radius[:, None] * np.column_stack((elementwise.cos(angle), elementwise.sin(angle)))


def coast_query(kind: str, fit: str = "search") -> Query:
    """Trees of one kind over both coasts, two segments in a leaf."""
    a, b = (build_tree(coast(seed), kind, 2, closed=True, fit=fit) for seed in (1, 2))
    return Query(a, b)


def overlaps(query: Query, coherent: bool) -> int:
    """The query at all PLACES; the tests of volumes."""
    tests = 0
    for place in PLACES:
        query.run(place, coherent=coherent)
        tests += query.volume_tests
    return tests


def shapely_meetings() -> Call:
    """Whether shapely's prepared outlines meet at all, which is less."""
    import shapely

    a, b = (shapely.LinearRing(coast(seed)) for seed in (1, 2))
    shapely.prepare(a)
    moved = [shapely.transform(b, lambda xy, place=place: xy + place) for place in PLACES]
    return lambda: [bool(shapely.intersects(a, other)) for other in moved]


def shapely_crossings() -> Call:
    """All points in which both coasts cross, at all PLACES, by shapely."""
    import shapely

    a, b = (shapely.LinearRing(coast(seed)) for seed in (1, 2))
    moved = [shapely.transform(b, lambda xy, place=place: xy + place) for place in PLACES]
    return lambda: [shapely.intersection(a, other) for other in moved]


def shapely_distance() -> Call:
    """The distance of both coasts by shapely."""
    import shapely

    a, b = shapely.LinearRing(coast(1)), shapely.LinearRing(coast(2) + np.array(APART))
    return lambda: shapely.distance(a, b)


def shapely_box() -> Call:
    """The least box about a coast by shapely."""
    import shapely

    points = coast(1)
    return lambda: shapely.minimum_rotated_rectangle(shapely.MultiPoint(points))


def _overlap(kind: str) -> Call:
    return partial(overlaps, coast_query(kind), True)


def _distance() -> Call:
    query = coast_query("obb")
    return lambda: nearest(query.tree_a, query.tree_b, APART)


def _build() -> Call:
    points = coast(1)
    return lambda: build_tree(points, "obb", 1, closed=True)


def _box() -> Call:
    points = coast(1)
    return lambda: minimal_obb(points)


SHAPELY = (
    Peer("shapely intersection", shapely_crossings),
    Peer("shapely intersects, prepared: only whether", shapely_meetings),
)
SCENARIOS = (
    *(
        Scenario(
            f"overlap-{kind}", f"Crossings of two coasts of 1,024 segments, {title}", "query",
            partial(_overlap, kind), len(PLACES), SHAPELY,
        )
        for kind, title in (
            ("obb", "oriented boxes"), ("capsule", "capsules"), ("aabb", "axis-aligned boxes"),
        )
    ),
    Scenario(
        "distance", "Distance of two coasts, oriented boxes", "query", _distance,
        peers=(Peer("shapely distance", shapely_distance),),
    ),
    Scenario("build", "Tree of oriented boxes over 1,024 segments", "tree", _build),
    Scenario(
        "least-box", "Least box of 1,024 points", "box", _box,
        peers=(Peer("shapely minimum_rotated_rectangle", shapely_box),),
    ),
)  # fmt: skip

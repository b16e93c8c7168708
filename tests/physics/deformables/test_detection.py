"""What the table finds: equal to exact arithmetic and to testing all pairs, whatever the cells."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from game.physics.deformables import Mesh, MeshCollider, blob, comb, mean_edge, of_cells, store_of, strip
from game.physics.deformables.effects import MESH_CONTACTS, SELF_CONTACTS, SOFT
from game.physics.effects import EffectSet


def turn(a, b, p):
    return (a[0] - p[0]) * (b[1] - p[1]) - (a[1] - p[1]) * (b[0] - p[0])


def exact_contacts(store, points):
    """By fractions: closed triangles of an area, corners apart."""
    places = [tuple(map(Fraction, p)) for p in points.tolist()]
    found = []
    for t, corners in enumerate(store.topology.triangles.tolist()):
        a, b, c = (places[k] for k in corners)
        area = turn(b, c, a)
        if area == 0:
            continue
        for v, p in enumerate(places):
            sides = [turn(b, c, p) / area, turn(c, a, p) / area, turn(a, b, p) / area]
            if v not in corners and min(sides) >= 0:
                found.append((t << 32) | v)
    return found


def exact_crossings(store, points, contacts):
    """By fractions: ends strictly on both sides, of an edge that matters and one of the rim."""
    places = [tuple(map(Fraction, p)) for p in points.tolist()]
    inside = {key & 0xFFFF_FFFF for key in contacts}
    edges, rim = store.topology.edges.tolist(), set(store.topology.rim.tolist())
    found = []
    for e, (a, b) in enumerate(edges):
        if e not in rim and (a in inside) == (b in inside):
            continue
        for f in sorted(rim):
            c, d = edges[f]
            if (e in rim and f <= e) or {a, b} & {c, d}:
                continue
            a_, b_, c_, d_ = places[a], places[b], places[c], places[d]
            if turn(a_, b_, c_) * turn(a_, b_, d_) < 0 and turn(c_, d_, a_) * turn(c_, d_, b_) < 0:
                found.append((e << 32) | f)
    return found


def found_by(store, points, cell, table, effects=MESH_CONTACTS | SELF_CONTACTS):
    collider = MeshCollider(store, cell, table, effects)
    collider.find(points)
    return collider


@pytest.mark.parametrize("seed", range(6))
def test_on_whole_numbers_it_finds_what_exact_arithmetic_does(seed):
    """Corners on a coarse lattice: points on edges and on others, edges that only meet, flat triangles."""
    generator = np.random.default_rng(seed)
    store, points = store_of([strip(1.0, 1.0, 2, 2), blob(1.0, 1), strip(1.0, 1.0, 3, 1)])
    points = generator.integers(-3, 4, points.shape).astype(np.float64)
    collider = found_by(store, points, (0.7, 1.0, 2.5)[seed % 3], (1, 7, 64)[seed % 3])
    contacts = exact_contacts(store, points)
    assert collider.contact_keys.tolist() == contacts and len(contacts) > 20
    assert collider.crossing_keys.tolist() == exact_crossings(store, points, contacts)


WORKLOADS = {
    "overlapping": lambda points, generator: points + generator.normal(0.0, 0.02, points.shape),
    "crumpled": lambda points, generator: generator.normal(0.0, 0.2, points.shape),
    "tiny": lambda points, generator: 1e-9 * generator.random(points.shape),
    "flat": lambda points, generator: points * (1.0, 0.0),
    "all in one": lambda points, generator: np.full_like(points, 0.3),
    "far": lambda points, generator: points + generator.normal(0.0, 0.01, points.shape) + 1e9,
    "stretched": lambda points, generator: (
        points * np.where(generator.random((len(points), 1)) < 0.1, 50.0, 1.0)
    ),
    "huge": lambda points, generator: points * 1e150,
}


@pytest.mark.parametrize("cell", [0.01, 0.05, 0.4, 30.0])
@pytest.mark.parametrize("workload", WORKLOADS)
def test_on_every_workload_it_finds_what_all_pairs_do(workload, cell):
    generator = np.random.default_rng(7)
    one = blob(0.3, 3)
    store, points = store_of([one, Mesh(one.points + 0.25, one.triangles), comb(0.8, 0.5, 7, 3)])
    points = WORKLOADS[workload](points, generator)
    for table in (7, 64, 1009):
        for effects in (
            MESH_CONTACTS | SELF_CONTACTS,
            EffectSet([MESH_CONTACTS]),
            EffectSet([SELF_CONTACTS]),
        ):
            collider = found_by(store, points, cell, table, effects)
            contacts, crossings = collider.naive()
            assert np.array_equal(collider.contact_keys, contacts)
            assert np.array_equal(collider.crossing_keys, crossings)


def test_self_contacts_and_contacts_together_are_all():
    generator = np.random.default_rng(3)
    store, points = store_of([blob(1.0, 3), strip(2.0, 0.3, 12, 2)])
    points += generator.normal(0.0, 0.2, points.shape)
    both = found_by(store, points, 0.3, 211).contact_keys
    parts = [
        found_by(store, points, 0.3, 211, EffectSet([one])).contact_keys
        for one in (MESH_CONTACTS, SELF_CONTACTS)
    ]
    assert min(map(len, parts)) > 0
    assert np.array_equal(np.sort(np.concatenate(parts)), both)


def test_two_crossed_strips_have_crossings_and_no_vertex_inside():
    long = strip(2.0, 0.1, 1, 1)
    store, points = store_of([long, Mesh(long.points[:, ::-1] * (1.0, -1.0), long.triangles)])
    collider = found_by(store, points, 0.3, 101)
    assert len(collider.contact_keys) == 0 and len(collider.crossing_keys) == 4


def test_buffers_grow_and_stamps_begin_again():
    store, points = store_of([blob(1.0, 6)])
    collider = MeshCollider(store, 0.2, 101)
    collider.find(np.zeros_like(points) + 0.0 * points)
    assert len(collider.contact_keys) == 0  # flat triangles hold nothing
    crumpled = np.random.default_rng(1).normal(0.0, 0.3, points.shape)
    for _ in range(3):
        collider.find(crumpled)
        assert len(collider.contact_keys) > 3 * store.vertices
        assert np.array_equal(collider.contact_keys, collider.naive()[0])


def test_counts_are_what_a_table_must_have():
    store, points = store_of([blob(1.0, 5)])
    edge = mean_edge(store, points)
    one = found_by(store, points + 2.0, 100.0, 1009)
    assert one.counts == (1, 150, 0, 150 * 91, 91)
    short = found_by(store, points, edge, 1)
    assert short.counts.used == 1 and short.counts.longest == 91 and short.loads.tolist() == [91]
    assert short.counts.strangers + short.counts.tested == 91 * short.counts.visited
    long = found_by(store, points + 20.0 * edge, edge, 100_003)
    assert long.counts.strangers == 0
    assert int(long.loads.sum()) == 91 and np.count_nonzero(long.loads) == long.counts.used


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_what_is_no_number_is_refused(bad):
    store, points = store_of([blob(1.0, 1)])
    collider = MeshCollider(store, 0.2, 101)
    points[3, 1] = bad
    with pytest.raises(ValueError, match="finite"):
        collider.find(points)
    with pytest.raises(ValueError, match="finite"):
        store_of([Mesh(points, blob(1.0, 1).triangles)])


@pytest.mark.parametrize(
    "make, words",
    [
        (lambda: store_of([]), "one or more"),
        (lambda: store_of([Mesh(np.zeros((3, 2)), np.array([[0, 1, 1]]))]), "twice"),
        (lambda: store_of([Mesh(np.zeros((3, 2)), np.array([[0, 1, 3]]))]), "vertices 0 to 2"),
        (
            lambda: store_of([Mesh(np.zeros((5, 2)), np.array([[0, 1, 2], [1, 0, 3], [0, 1, 4]]))]),
            "three triangles",
        ),
        (lambda: store_of([Mesh(np.zeros((5, 2)), np.array([[0, 1, 2], [0, 3, 4]]))]), "once"),
        (lambda: MeshCollider(store_of([blob(1.0, 1)])[0], 0.0, 7), "cell_size"),
        (lambda: MeshCollider(store_of([blob(1.0, 1)])[0], 1.0, 0), "table_size"),
        (lambda: blob(1.0, 0), "rings"),
        (lambda: of_cells(np.zeros((2, 2), dtype=np.bool_), 1.0, 1.0), "cells"),
        (lambda: strip(-1.0, 1.0, 2, 2), "width"),
    ],
)
def test_nonsense_is_refused(make, words):
    with pytest.raises(ValueError, match=words):
        make()


def test_shapes_are_whole_and_counter_clockwise():
    for mesh, area in ((blob(1.0, 4), None), (strip(2.0, 1.0, 5, 3), 2.0), (comb(1.6, 0.7, 16, 7), 0.52)):
        store, points = store_of([mesh])
        a, b, c = points[mesh.triangles].transpose(1, 0, 2)
        twice = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
        assert np.all(twice > 0.0) and len(store.loops) == 1
        x, y = points[store.loops[0]].T
        assert 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) == pytest.approx(0.5 * twice.sum())
        assert area is None or 0.5 * twice.sum() == pytest.approx(area)
        assert len(points) - len(store.topology.edges) + len(mesh.triangles) == 1  # Euler
    assert SOFT.bit(SELF_CONTACTS) != SOFT.bit(MESH_CONTACTS)


def test_cells_on_opposite_sides_of_the_origin_share_slots_however_long_the_table():
    """-a xor -b is nearly always a xor b: a weakness of the printed hash, which costs tests and no errors."""
    store, points = store_of([blob(1.0, 5)])
    edge = mean_edge(store, points)
    about, beside = (
        found_by(store, places, edge, 1_000_003).counts for places in (points, points + 20.0 * edge)
    )
    assert about.strangers > 0.1 * about.tested and beside.strangers == 0

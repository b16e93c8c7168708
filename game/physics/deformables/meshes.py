"""Triangle meshes side by side in one set of arrays: vertices, triangles, edges, and which are of the rim."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Ints, Longs

MOST_VERTICES = 1_000_000


class Mesh(NamedTuple):
    """points: (n, 2) m; triangles: (t, 3) of them, counter-clockwise at rest."""

    points: Floats
    triangles: Longs


class Topology(NamedTuple):
    """What kernels know of all meshes, one after the other; it does not change while they deform.

    first (n + 1,), others (2 m,): the vertices that share an edge with vertex i are
    others[first[i]:first[i + 1]].
    """

    triangles: Ints  # (t, 3)
    mesh_of: Ints  # (n,)
    edges: Ints  # (m, 2), each once
    rim: Ints  # (r,) edges of one triangle only
    beyond: Ints  # (m,) of an edge of the rim the third vertex of its triangle, else -1
    first: Longs
    others: Longs


class MeshStore(NamedTuple):
    """Meshes side by side. loops: the rim's closed outlines, counter-clockwise, holes clockwise; loop_mesh:
    which mesh each is of."""

    topology: Topology
    loops: tuple[Longs, ...]
    loop_mesh: tuple[int, ...]

    @property
    def vertices(self) -> int:
        """Vertices."""
        return len(self.topology.mesh_of)


def store_of(meshes: Sequence[Mesh]) -> tuple[MeshStore, Floats]:
    """Meshes as one store, and the places (n, 2) m of all vertices. ValueError, naming what is wrong."""
    if not meshes:
        raise ValueError("meshes: expected one or more")
    points: list[Floats] = []
    triangles: list[Longs] = []
    counts: list[int] = []
    begin = 0
    for number, mesh in enumerate(meshes):
        places, corners = _checked(number, mesh.points, mesh.triangles)
        points.append(places)
        triangles.append(corners + begin)
        counts.append(len(places))
        begin += len(places)
    if begin > MOST_VERTICES:
        raise ValueError(f"meshes: {begin} vertices; at most {MOST_VERTICES}")
    all_triangles = np.concatenate(triangles)
    mesh_of = np.repeat(np.arange(len(meshes)), counts)
    return _assemble(all_triangles, mesh_of), np.concatenate(points)


def _checked(number: int, points: ArrayLike, triangles: ArrayLike) -> tuple[Floats, Longs]:
    places = np.array(points, dtype=np.float64)
    corners = np.array(triangles, dtype=np.int64)
    if places.ndim != 2 or places.shape[1:] != (2,) or not np.isfinite(places).all():
        raise ValueError(f"meshes[{number}]: expected points (n, 2) of finite numbers")
    if corners.ndim != 2 or corners.shape[1:] != (3,) or not len(corners):
        raise ValueError(f"meshes[{number}]: expected triangles (t, 3), one or more")
    if corners.min() < 0 or corners.max() >= len(places):
        raise ValueError(f"meshes[{number}]: there are vertices 0 to {len(places) - 1}")
    same = (corners == np.roll(corners, 1, axis=1)).any(axis=1)
    if same.any():
        raise ValueError(f"meshes[{number}]: triangle {int(np.argmax(same))} has a vertex twice")
    return places, corners


def _assemble(triangles: Longs, mesh_of: Longs) -> MeshStore:
    """Edges, rim, neighbours and outlines. ValueError for an edge of three triangles, a pinched rim."""
    n = len(mesh_of)
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    third = np.concatenate([triangles[:, 2], triangles[:, 0], triangles[:, 1]])
    ordered = np.sort(sides, axis=1)
    keys, first_side, times = np.unique(
        ordered[:, 0] * n + ordered[:, 1], return_index=True, return_counts=True
    )
    if times.max() > 2:
        raise ValueError(
            f"meshes: edge {ordered[first_side[np.argmax(times)]].tolist()} is of three triangles"
        )
    edges = np.stack([keys // n, keys % n], axis=1)
    rim = np.flatnonzero(times == 1)
    beyond = np.full(len(edges), -1)
    beyond[rim] = third[first_side[rim]]
    ends, other_ends = edges.T.reshape(-1), edges[:, ::-1].T.reshape(-1)
    order = np.argsort(ends, kind="stable")
    first = np.zeros(n + 1, dtype=np.int64)
    np.cumsum(np.bincount(ends, minlength=n), out=first[1:])
    loops = _loops(sides[first_side[rim]])
    parts = triangles, mesh_of, edges, rim, beyond
    a, b, c, d, e = (np.ascontiguousarray(part, dtype=np.int32) for part in parts)
    topology = Topology(a, b, c, d, e, first, other_ends[order])
    return MeshStore(topology, loops, tuple(int(mesh_of[loop[0]]) for loop in loops))


def _loops(sides: Longs) -> tuple[Longs, ...]:
    """Closed outlines of directed sides (r, 2). ValueError where a vertex has more than one way on."""
    onward = dict(sides.tolist())
    if len(onward) < len(sides):
        raise ValueError("meshes: expected a rim that passes each vertex once")
    found = []
    while onward:
        start, at = onward.popitem()
        loop = [start]
        while at != start:
            loop.append(at)
            at = onward.pop(at)
        found.append(np.array(loop, dtype=np.int64))
    return tuple(found[::-1])


def mean_edge(store: MeshStore, points: Floats) -> float:
    """The mean length (m) of all edges."""
    ways = points[store.topology.edges[:, 1]] - points[store.topology.edges[:, 0]]
    return float(np.mean(np.sqrt((ways * ways).sum(axis=1))))

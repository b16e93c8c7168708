"""Soft bodies as a level makes them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.constraints import PositionState
from game.physics.deformables import Counts, Mesh, Pushing, SoftBodies, store_of
from game.physics.effects import EffectSet
from game.physics.kernels import elementary, linear
from game.scenes.deformables.level import WIDTH, Body, DeformablesContent
from game.scenes.deformables.parameters import DeformablesParameters
from game.stage import Part

DENSITY = 50.0  # kg/m², of all meshes
MOST_NAIVE = 1_200  # triangles; above, all pairs are not tested for a readout


class DeformablesModel(Part):
    """The bodies of a level, and what their detection found. middle: x of the picture's middle, m."""

    def __init__(self, content: DeformablesContent, parameters: DeformablesParameters, active: EffectSet):
        self.content, self.parameters, self.active = content, parameters, active
        content.check_count()
        meshes, places, masses, speeds = [], [], [], []
        for body in content.bodies:
            mesh = body.mesh()
            weights = 1.0 / _vertex_masses(mesh)
            weights[body.is_fixed(mesh.points)] = 0.0
            start = mesh.points * ((-1.0, 1.0) if body.mirrored else (1.0, 1.0))
            for x, y, angle in body.places():
                turn = np.array(
                    (
                        (elementary.cos(angle), -elementary.sin(angle)),
                        (elementary.sin(angle), elementary.cos(angle)),
                    )
                )
                meshes.append(Mesh(mesh.points, mesh.triangles))
                places.append(linear.product(start, turn.T) + np.array((x, y)))
                masses.append(weights)
                speeds.append(np.broadcast_to(body.velocity, mesh.points.shape))
        store, rest = store_of(meshes)
        self.bodies = SoftBodies(
            store, np.concatenate(places), np.concatenate(masses), rest=rest,
            velocities=np.concatenate(speeds), effects=active, floor=0.0,
            left=-0.5 * WIDTH, right=0.5 * WIDTH,
        )  # fmt: skip
        self.middle = _middle_of(np.concatenate(places))
        for name in ("cell", "substeps", "gravity"):
            self.change_parameter(name)

    # -- changes --------------------------------------------------------------------------------------

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        chosen = self.parameters
        if name in ("cell", "table"):
            self.bodies.set_cells(chosen.cell * self.bodies.mean_edge, int(chosen.table))
        elif name in ("substeps", "push", "friction"):
            self.bodies.set_steps(int(chosen.substeps), Pushing(chosen.push, chosen.friction))
        else:
            self.bodies.system.change(
                gravity=chosen.gravity, damping=chosen.damping, iterations=int(chosen.iterations)
            )

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        self.active = active
        self.bodies.set_effects(active)

    def advance(self, dt: float) -> None:
        """One step."""
        self.bodies.step(dt)

    # -- what is there --------------------------------------------------------------------------------

    @property
    def contacts(self) -> NDArray[np.int64]:
        """(c, 2) triangle and vertex in it."""
        self.bodies.detect()
        keys = self.bodies.collider.contact_keys
        return np.stack([keys >> 32, keys & 0xFFFF_FFFF], axis=1)

    @property
    def crossings(self) -> NDArray[np.int64]:
        """(c, 2) edge and edge of the rim that it crosses."""
        self.bodies.detect()
        keys = self.bodies.collider.crossing_keys
        return np.stack([keys >> 32, keys & 0xFFFF_FFFF], axis=1)

    def of_self(self) -> int:
        """Contacts of meshes with themselves."""
        topology, pairs = self.bodies.store.topology, self.contacts
        owners = topology.mesh_of[topology.triangles[pairs[:, 0], 0]]
        return int(np.count_nonzero(owners == topology.mesh_of[pairs[:, 1]]))

    def counts(self) -> Counts:
        """The work of detection."""
        self.bodies.detect()
        return self.bodies.collider.counts

    def wrong(self) -> int | None:
        """Pairs that differ from what testing all pairs gives; None for meshes too large for that."""
        if len(self.bodies.store.topology.triangles) > MOST_NAIVE:
            return None
        self.bodies.detect()
        collider = self.bodies.collider
        contacts, crossings = collider.naive()
        return len(np.setxor1d(contacts, collider.contact_keys)) + len(
            np.setxor1d(crossings, collider.crossing_keys)
        )

    def inverted(self) -> int:
        """Triangles that are turned over."""
        corners = self.bodies.points[self.bodies.store.topology.triangles]
        one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        return int(np.count_nonzero(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0] < 0.0))

    def state(self) -> PositionState:
        """All that later steps depend on."""
        return self.bodies.state()

    def restore(self, state: PositionState) -> None:
        """Take over a copy of a state."""
        self.bodies.restore(state)


def exercise() -> None:
    """Call all kernels of a step once, on two blobs that overlap."""
    mesh = Body(rings=2).mesh()
    store, points = store_of([mesh, Mesh(mesh.points + 0.1, mesh.triangles)])
    bodies = SoftBodies(store, points)
    bodies.step(0.01)
    bodies.detect()
    bodies.collider.naive()
    assert bodies.collider.counts.used > 0


def _vertex_masses(mesh: Mesh) -> Floats:
    """(n,) kg: a third of each triangle that a vertex is of."""
    a, b, c = mesh.points[mesh.triangles].transpose(1, 0, 2)
    areas = 0.5 * np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    masses = np.zeros(len(mesh.points))
    for corner in range(3):
        np.add.at(masses, mesh.triangles[:, corner], DENSITY * areas / 3.0)
    return masses


def _middle_of(points: Floats) -> float:
    """The walls' middle, or that of points (n, 2) if none is between the walls, m."""
    low, high = float(points[:, 0].min()), float(points[:, 0].max())
    return 0.0 if low < 0.5 * WIDTH and high > -0.5 * WIDTH else 0.5 * (low + high)

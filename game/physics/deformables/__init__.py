"""Deformable triangle meshes: contacts by spatial hashing, their depth, soft bodies that are pushed out."""

from game.physics.deformables.bodies import Pushing, SoftBodies
from game.physics.deformables.collider import Counts, MeshCollider
from game.physics.deformables.meshes import Mesh, MeshStore, mean_edge, store_of
from game.physics.deformables.shapes import blob, comb, of_cells, strip

__all__ = [
    "Counts",
    "Mesh",
    "MeshCollider",
    "MeshStore",
    "Pushing",
    "SoftBodies",
    "blob",
    "comb",
    "mean_edge",
    "of_cells",
    "store_of",
    "strip",
]

"""Bounding volumes: oriented boxes and capsules round points, trees of them, two trees against each other.

`fit_obb`, `fit_capsule`: by angle steps; `minimal_obb`, `minimal_capsule`: of least area.
`build_tree`: top down. `tandem`: which leaves overlap and which segments meet; `Query`: the same from step
to step. `nearest`: how far apart two polylines are.
"""

from game.physics.bounds.fits import (
    Box,
    Capsule,
    fit_capsule,
    fit_obb,
    least_capsule,
    minimal_capsule,
    minimal_obb,
    near_least_capsule,
    principal_box,
    thinnest_box,
    thinnest_capsule,
    upright_box,
)
from game.physics.bounds.nearest import Nearest, nearest
from game.physics.bounds.query import Query, Tandem, tandem
from game.physics.bounds.segments import do_segments_meet, segment_distance
from game.physics.bounds.tree import FITS, KINDS, SPLITS, BoundingTree, build_tree

__all__ = [
    "FITS",
    "KINDS",
    "SPLITS",
    "BoundingTree",
    "Box",
    "Capsule",
    "Nearest",
    "Query",
    "Tandem",
    "build_tree",
    "do_segments_meet",
    "fit_capsule",
    "fit_obb",
    "least_capsule",
    "minimal_capsule",
    "minimal_obb",
    "near_least_capsule",
    "nearest",
    "principal_box",
    "segment_distance",
    "tandem",
    "thinnest_box",
    "thinnest_capsule",
    "upright_box",
]

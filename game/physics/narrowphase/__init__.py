"""Narrow phase: how near two convex polygons are, where, and how deep if they overlap."""

from game.physics.narrowphase.batch import PolygonSet, Proximities, gjk_batch, vclip_batch
from game.physics.narrowphase.convex import ConvexPolygon, NonConvexError, convex_hull
from game.physics.narrowphase.features import Feature
from game.physics.narrowphase.proximity import Proximity, certify
from game.physics.narrowphase.queries import epa, epa_trace, gjk, gjk_trace, sat, vclip, vclip_trace

__all__ = [
    "ConvexPolygon",
    "Feature",
    "NonConvexError",
    "PolygonSet",
    "Proximities",
    "Proximity",
    "certify",
    "convex_hull",
    "epa",
    "epa_trace",
    "gjk",
    "gjk_batch",
    "gjk_trace",
    "sat",
    "vclip",
    "vclip_batch",
    "vclip_trace",
]

"""Narrow phase: how near two convex polygons are, where, and how deep if they overlap."""

from game.physics.narrowphase.convex import ConvexPolygon, NonConvexError, convex_hull
from game.physics.narrowphase.features import Feature
from game.physics.narrowphase.proximity import Proximity, certify
from game.physics.narrowphase.queries import gjk, gjk_trace, sat, vclip, vclip_trace

__all__ = [
    "ConvexPolygon",
    "Feature",
    "NonConvexError",
    "Proximity",
    "certify",
    "convex_hull",
    "gjk",
    "gjk_trace",
    "sat",
    "vclip",
    "vclip_trace",
]

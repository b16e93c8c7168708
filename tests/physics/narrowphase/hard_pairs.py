"""Pairs of convex outlines that are hard to measure: name to (A, B, distance or minus depth or None).

Distances were reckoned with rational numbers on the doubles as given; None is left to the exact twin.
"""

from __future__ import annotations

import math

SQUARE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
DIAMOND = ((3.0, -1.214213562373095), (4.414213562373095, 0.1999999999999999),
           (3.0, 1.6142135623730949), (1.585786437626905, 0.20000000000000012))  # fmt: skip
SLIVER = ((0.0, 0.0), (10.0, 0.0), (10.0, 1e-09))


def box(x, y, width=2.0, height=2.0):
    return ((x, y), (x + width, y), (x + width, y + height), (x, y + height))


def scaled(points, factor):
    return tuple((x * factor, y * factor) for x, y in points)


def shifted(points, dx, dy):
    return tuple((x + dx, y + dy) for x, y in points)


def turned(points, angle, dx, dy):
    c, s = math.cos(angle), math.sin(angle)
    return tuple((c * x - s * y + dx, s * x + c * y + dy) for x, y in points)


def gon(count, phase=0.0, x=0.0, y=0.0):
    turns = (2.0 * math.pi * k / count + phase for k in range(count))
    return tuple((x + math.cos(t), y + math.sin(t)) for t in turns)


PAIRS = {
    "apart": (SQUARE, DIAMOND, 0.58578643762690508),
    "parallel edges beside each other": (SQUARE, box(2.0, -0.5), 1.0),
    "edges in line with a gap": (SQUARE, box(2.0, 1.0), 1.0),
    "corner to corner": (SQUARE, box(2.0, 3.0), 2.2360679774997897),
    "corner to the middle of an edge": (
        SQUARE,
        ((2.914213562373095, -1.414213562373095), (4.32842712474619, -1.1102230246251565e-16),
         (2.914213562373095, 1.414213562373095), (1.5, 1.1102230246251565e-16)), 0.5,
    ),
    "corners touch": (SQUARE, box(1.0, 1.0), 0.0),
    "edges touch": (SQUARE, box(1.0, -0.5), 0.0),
    "corner touches an edge": (SQUARE, ((1.0, 0.25), (2.0, -1.0), (2.0, 1.0)), 0.0),
    "one ulp apart": (
        SQUARE, ((1.0000000000000002, -1.0), (3.0, -1.0), (3.0, 1.0), (1.0000000000000002, 1.0)),
        2.2204460492503131e-16,
    ),
    "one ulp overlap": (
        SQUARE, ((0.9999999999999999, -1.0), (3.0, -1.0), (3.0, 1.0), (0.9999999999999999, 1.0)), None,
    ),
    "a gap of a picometre": (
        SQUARE,
        ((1.000000000001, -0.7), (3.000000000001, -0.7), (3.000000000001, 1.3), (1.000000000001, 1.3)),
        1.000088900582341e-12,
    ),
    "edges a nanoradian off parallel": (
        SQUARE,
        ((2.000000001, -0.9000000010000001), (4.000000001, -0.899999999),
         (3.999999999, 1.1000000010000002), (1.999999999, 1.099999999)), 0.99999999909999992,
    ),
    "edges a femtoradian off parallel": (
        SQUARE, ((2.0, -1.0), (4.0, -1.0), (4.0, 1.0), (2.0000000000000004, 1.0)), None,
    ),
    "overlap of a nanometre": (
        SQUARE,
        ((0.9999999989999999, -0.7), (2.999999999, -0.7), (2.999999999, 1.3), (0.9999999989999999, 1.3)),
        -1.00000008274037e-9,
    ),
    "the same twice": (SQUARE, SQUARE, -2.0),
    "concentric, turned": (SQUARE, turned(SQUARE, 0.5, 0.0, 0.0), None),
    "a small one inside": (
        SQUARE,
        ((0.11888404246547224, -0.015845593067913846), (0.3158455930679139, 0.018884042465472234),
         (0.2811159575345278, 0.21584559306791384), (0.08415440693208616, 0.18111595753452778)),
        -0.915845593067914,
    ),
    "a small one off the middle": (
        scaled(SQUARE, 100.0),
        ((54.63397459621556, 1.6339745962155614), (56.36602540378444, 2.633974596215561),
         (55.36602540378444, 4.366025403784438), (53.63397459621556, 3.366025403784439)), -46.3660254037844,
    ),
    "vertices on edges": (
        ((-1.0, -1.0), (0.0, -1.0), (0.5, -1.0), (1.0, -1.0), (1.0, 0.0), (1.0, 1.0), (-1.0, 1.0)),
        box(2.0, -0.5), 1.0,
    ),
    "vertices twice and thrice": (
        ((-1.0, -1.0), (1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (1.0, 1.0), (1.0, 1.0), (-1.0, 1.0)),
        ((3.4023275225397605, -0.2817127641115771), (5.281712764111577, 0.40232752253976023),
         (4.5976724774602395, 2.2817127641115773), (2.7182872358884227, 1.5976724774602398)),
        1.8192645259363842,
    ),
    "vertices nearly twice": (
        ((-1.0, -1.0), (1.0, -1.0), (1.0, -0.9999999999995), (1.0, 1.0), (0.9999999999996, 1.0), (-1.0, 1.0)),
        DIAMOND, 0.58578643762690508,
    ),
    "segment": (((0.0, 0.0), (2.0, 0.0)), box(0.0, 2.0), 2.0),
    "point": (((0.3, 0.4),), box(2.0, -1.0), 1.7),
    "point inside": (((0.3, 0.4),), SQUARE, -0.6),
    "two points": (((0.0, 3.0),), ((4.0, 0.0),), 5.0),
    "the same point": (((0.3, 0.4),), ((0.3, 0.4),), 0.0),
    "segments in line": (((0.0, 0.0), (1.0, 0.0)), ((2.0, 0.0), (5.0, 0.0)), 1.0),
    "segments that cross": (((-1.0, 0.0), (1.0, 0.0)), ((0.2, -1.0), (0.2, 1.0)), -0.8),
    "triangle without area": (((0.0, 0.0), (1.0, 1.0), (3.0, 3.0)), ((4.0, 0.0), (5.0, 0.0), (5.0, 1.0)),
                              2.8284271247461901),
    "sliver": (
        SLIVER, ((5.0, 1.585786437626905), (6.414213562373095, 3.0), (5.0, 4.414213562373095),
                 (3.585786437626905, 3.0)), 1.5857864371269051,
    ),
    "sliver beside sliver": (SLIVER, ((0.0, 1e-06), (10.0, 1e-06), (5.0, 2e-06)), 9.9899999999999995e-7),
    "needle": (((0.0, 0.0), (1000.0, 1e-3), (0.0, 1e-6)), ((500.0, 1e-3), (501.0, 1.0), (499.0, 1.0)), None),
    "ten nanometres": (scaled(SQUARE, 1e-8), scaled(DIAMOND, 1e-8), None),
    "a hundred kilometres": (scaled(SQUARE, 1e8), scaled(DIAMOND, 1e8), None),
    "tiny beside huge": (scaled(SQUARE, 1e-8), shifted(scaled(SQUARE, 1e8), 1.5e8, 0.0), None),
    "a thousand kilometres off": (
        shifted(SQUARE, 1e6, -1e6), shifted(DIAMOND, 1e6, -1e6), 0.58578643761575222,
    ),
    "a hundred thousand kilometres off": (shifted(SQUARE, 1e8, 1e8), shifted(DIAMOND, 1e8, 1e8), None),
    "64 corners": (gon(64), gon(64, 0.01, 3.0, 0.7), 1.0821482438968492),
    "a short edge": (box(-0.5, -0.0016, 1.0, 0.0032), ((0.505, 0.0),), 0.0050000000000000044),
    "clockwise": (tuple(reversed(SQUARE)), DIAMOND, 0.58578643762690508),
    "in a corner's region": (
        ((0.0, 0.0), (2.0, 0.0), (1.0, 2.0)), ((-1.0, -1.0), (-3.0, -0.9999999999999998), (-2.0, -3.0)),
        1.414213562373095,
    ),
    "behind an edge": (SQUARE, box(-0.5, -9.0, 1.0, 1.0), 7.0),
}  # fmt: skip
FAR_OFF = {"a hundred thousand kilometres off"}  # coordinates whose doubles are 1.5e-8 apart

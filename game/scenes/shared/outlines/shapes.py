"""Outlines made by rule: coasts, gears, hands, arcs, spirals, stars, combs. Metres, about the origin."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise
from game.physics.particles.random_numbers import uniform_pair

HARMONICS = 48  # of a coast
SMOOTH = 7  # harmonics that make bays; those above make it rough


def coast(seed: int, segments: int, size: float, bays: float, roughness: float) -> Floats:
    """A closed coast (segments, 2): a radius of ``size`` with waves of random height and phase.

    bays: share of the radius that the long waves take; roughness: the same of the short ones.
    """
    angle = 2.0 * np.pi * np.arange(segments) / segments
    radius = np.ones(segments)
    for k in range(2, HARMONICS + 1):
        height, phase = uniform_pair(seed, k, 0)
        share = roughness * (0.3 + height) * SMOOTH / k
        if k <= SMOOTH:
            share = bays * (0.35 + height) / elementary.pow(k, 0.7)
        radius += share * elementwise.sin(k * angle + 2.0 * np.pi * phase)
    radius = size * np.maximum(radius, 0.12)
    return np.column_stack((radius * elementwise.cos(angle), radius * elementwise.sin(angle)))


def gear(teeth: int, radius: float, depth: float, steps: int) -> Floats:
    """A closed gear with so many teeth, their tips at ``radius``, each arc of so many segments."""
    pitch = 2.0 * math.pi / teeth
    points = []
    for i in range(teeth):
        for near, far, r in ((0.02, 0.30, radius - depth), (0.44, 0.74, radius)):
            for k in range(steps + 1):
                angle = pitch * (i + near + (far - near) * k / steps)
                points.append((r * elementary.cos(angle), r * elementary.sin(angle)))
    return np.array(points)


# of a hand 1 high: foot of a finger on the palm, direction (degrees), length, breadth
FINGERS = (
    (-0.20, -0.10, 142.0, 0.36, 0.125),
    (-0.17, 0.14, 104.0, 0.44, 0.105),
    (-0.045, 0.185, 93.0, 0.50, 0.108),
    (0.075, 0.17, 82.0, 0.45, 0.102),
    (0.18, 0.115, 66.0, 0.35, 0.09),
)


def hand(size: float, mirrored: bool, spread: float, steps: int) -> Floats:
    """A closed hand, thumb to the left unless mirrored; ``spread``: 1 as it is, more with fingers apart."""
    points = [(-0.13, -0.52), (-0.145, -0.36)]
    for x, y, degrees, length, breadth in FINGERS:
        angle = math.radians(90.0 + spread * (degrees - 90.0))
        c, s = elementary.cos(angle), elementary.sin(angle)
        half = 0.5 * breadth
        points.append((x - s * half, y + c * half))
        for k in range(steps + 1):
            turn = 0.5 * math.pi - math.pi * k / steps
            u, v = length - half + half * elementary.cos(turn), half * elementary.sin(turn)
            points.append((x + c * u - s * v, y + s * u + c * v))
        points.append((x + s * half, y - c * half))
    points += [(0.215, -0.12), (0.15, -0.36), (0.13, -0.52)]
    outline = size * np.array(points)
    if mirrored:
        outline = outline[::-1] * (-1.0, 1.0)
    return outline


def arc(radius: float, start: float, sweep: float, segments: int) -> Floats:
    """An open arc about the origin from one angle on, degrees."""
    angle = np.radians(start + sweep * np.arange(segments + 1) / segments)
    return radius * np.column_stack((elementwise.cos(angle), elementwise.sin(angle)))


def spiral(inner: float, outer: float, turns: float, segments: int) -> Floats:
    """An open spiral of Archimedes."""
    share = np.arange(segments + 1) / segments
    angle, radius = 2.0 * np.pi * turns * share, inner + (outer - inner) * share
    return np.column_stack((radius * elementwise.cos(angle), radius * elementwise.sin(angle)))


def star(points: int, outer: float, inner: float) -> Floats:
    """A closed star."""
    angle = np.pi * (0.5 + np.arange(2 * points) / points)
    radius = np.where(np.arange(2 * points) % 2 == 0, outer, inner)
    return np.column_stack((radius * elementwise.cos(angle), radius * elementwise.sin(angle)))


def comb(teeth: int, width: float, height: float) -> Floats:
    """A closed comb whose teeth point down, half as broad as their pitch."""
    pitch = width / (teeth - 0.5)
    left, back = -0.5 * width, 0.5 * height
    points = [(left + width, back), (left, back)]
    for i in range(teeth):
        x = left + i * pitch
        points += [(x, -0.5 * height), (x + 0.5 * pitch, -0.5 * height)]
        if i < teeth - 1:
            points += [(x + 0.5 * pitch, 0.25 * height), (x + pitch, 0.25 * height)]
    return np.array(points)

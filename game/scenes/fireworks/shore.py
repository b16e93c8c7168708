"""What stands round the water: pontoons with mortars, firs and a crowd on the near bank. Outlines as seen."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pygame

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise
from game.scenes.fireworks.eye import AWAY, EYE, Seen, on_circle, projected
from game.stage.declarations import Frame
from game.ui.canvas.canvas import Canvas

FIRS_AT, BANK_AT = 150.0, 205.0  # m from the fleet to the trees and to the crowd on the near bank
BANK_TOP = -11.5  # m, where the crowd stands: the bank falls away to the water
PONTOONS = tuple(20.0 * i for i in range(-6, 7))  # m along the fleet
LINES = (0.0, 70.0)  # m, depths of the two lines of pontoons
DECK, TUBE = (7.0, 0.9), (0.45, 1.9)  # m, half of the length and the height of a deck, of a tube
TUBES = (-5.0, -3.0, -1.0, 1.0, 3.0, 5.0)  # m on a deck
FLEET_LAMPS = 0xFF7038
WATCHING = 170


def draw_fleet(canvas: Canvas, seen: Seen, ink: pygame.Color) -> Floats:
    """Draw the pontoons; (n, 2) m, their lamps."""
    lamps = []
    for depth in reversed(LINES):
        for along in PONTOONS:
            x, y, near = projected(seen, along, 0.0, depth)
            half, tall = near * DECK[0], near * DECK[1]
            y = max(y, 0.0)
            canvas.polygon(
                [(x - half, y), (x + half, y), (x + half, y + tall), (x - half, y + tall)], fill=ink
            )
            wide, high = near * TUBE[0], y + tall + near * TUBE[1]
            for tube in TUBES:
                at = x + near * tube
                canvas.polygon(
                    [(at - wide, y), (at + wide, y), (at + wide, high), (at - wide, high)], fill=ink
                )
            lamps.append((x + 0.9 * half, y + tall + 0.8 * near))
    return np.array(lamps)


@lru_cache(maxsize=1)
def _fir_shapes() -> tuple[tuple[float, float, Floats], ...]:
    """Azimuth, radius m, and outline (n, 2) m of each fir, its foot at the origin."""
    chance = np.random.default_rng(5)
    made = []
    turn = 0.0
    while turn < math.tau:
        tall, rows = float(chance.uniform(14.0, 30.0)), 9
        left, right = [], []
        for row in range(rows):
            share = row / rows
            wide = 0.20 * tall * (1.0 - share) ** 1.15 * chance.uniform(0.85, 1.12)
            foot = tall * (0.07 + 0.93 * share)
            left += [(-wide, foot), (-0.42 * wide, foot + 0.055 * tall)]
            right += [(wide * chance.uniform(0.85, 1.1), foot), (0.42 * wide, foot + 0.055 * tall)]
        trunk = 0.018 * tall
        shape = [(-trunk, -30.0), (-trunk, left[0][1]), *left, (0.0, 1.04 * tall), *right[::-1]]
        shape += [(trunk, right[0][1]), (trunk, -30.0)]
        made.append((turn, FIRS_AT + float(chance.uniform(-14.0, 24.0)), np.array(shape)))
        grove = chance.random() < 0.6
        turn += float(chance.uniform(0.06, 0.12) if grove else chance.uniform(0.75, 1.15))
    return tuple(made)


def firs(seen: Seen) -> list[Floats]:
    """Outlines (n, 2) m of the firs on the near bank, the farther first."""
    found = []
    for azimuth, radius, shape in _fir_shapes():
        x, near, along = on_circle(seen, radius, np.array((math.pi + azimuth,)))
        if along[0] < -100.0:
            foot = EYE + near[0] * (BANK_TOP - 14.0 - EYE)
            found.append((float(along[0]), shape * near[0] + (x[0], foot)))
    return [shape for _, shape in sorted(found, key=lambda one: -one[0])]


def bank(seen: Seen) -> Floats:
    """Outline (n, 2) m of the bank that the crowd stands on."""
    azimuths = math.pi + np.linspace(-0.9, 0.9, 61)
    own = azimuths - elementary.atan2(seen.sine, seen.cosine)  # those before the eye, from wherever it looks
    x, near, _ = on_circle(seen, BANK_AT, own)
    y = EYE + near * (
        BANK_TOP + 0.5 * elementwise.sin(9.0 * azimuths) + 0.25 * elementwise.sin(31.0 * azimuths) - EYE
    )
    points = np.stack((x, y), axis=1)[np.argsort(x, kind="stable")]
    low = -4.0 * AWAY
    return np.concatenate((points, ((points[-1, 0], low), (points[0, 0], low))))


@lru_cache(maxsize=1)
def _people() -> tuple[tuple[float, Floats], ...]:
    """Azimuth and outline (n, 2) m, from the feet up, of each who watches: in groups; a few point upwards."""
    chance = np.random.default_rng(12)
    head = np.linspace(-0.6, math.pi + 0.6, 9)
    made, turn = [], 0.0
    for _ in range(WATCHING):
        tall = float(chance.uniform(1.45, 1.9) if chance.random() < 0.8 else chance.uniform(0.95, 1.25))
        wide, r = 0.145 * tall, 0.075 * tall
        skull = [(r * elementary.cos(a), tall - r + r * elementary.sin(a)) for a in head]
        right = [(wide, 0.45 * tall), (1.05 * wide, 0.72 * tall), (0.8 * wide, 0.81 * tall)]
        left = [(-x, y) for x, y in right[::-1]]
        if chance.random() < 0.12:
            right[1:] = [(2.2 * wide, 1.12 * tall), (2.0 * wide, 1.14 * tall), (0.8 * wide, 0.81 * tall)]
        shape = [(0.7 * wide, -1.5), *right, *skull, *left, (-0.7 * wide, -1.5)]
        made.append((turn, np.array(shape)))
        turn += float(chance.uniform(0.003, 0.009) if chance.random() < 0.8 else chance.uniform(0.03, 0.12))
    return tuple((at * math.tau / turn, shape) for at, shape in made)


def crowd(seen: Seen, view: Frame) -> list[Floats]:
    """Outlines (n, 2) m of those on the near bank who are in view."""
    people = _people()
    azimuths = np.array([at for at, _ in people])
    x, near, along = on_circle(seen, BANK_AT, azimuths)
    inside = (along < -120.0) & (x > view.left - 10.0) & (x < view.right + 10.0)
    foot = EYE + near * (
        BANK_TOP + 0.5 * elementwise.sin(9.0 * azimuths) + 0.25 * elementwise.sin(31.0 * azimuths) - EYE
    )
    return [people[i][1] * near[i] * 1.25 + (x[i], foot[i]) for i in np.flatnonzero(inside).tolist()]

"""One step of the lecture's table: the order of things, and the small kernels in between.

Move, take what is over a pocket, turn round what is beyond a wall, separate what overlaps: substep by substep
within one call. Slow down: once, at the end, as the lecture does once a frame.

Arrays are those of state.py: offsets, velocities and rolled (n, 2) m and m/s, orientations (n, 4),
radii (n,) m.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from game.billiards.laws.joint import ContactGraph, JointScratch
from game.billiards.lecture import settings as se
from game.billiards.lecture.contacts import collide_in_index_order, collide_jointly
from game.billiards.lecture.settings import read_settings
from game.billiards.lecture.state import (
    BALL_COLLISIONS,
    FRICTION,
    LECTURE,
    MINIMUM_SPEED,
    NOT_FINITE,
    POCKETS,
    ROLLING,
    SUBSTEPS,
    WALLS,
    ContactList,
    Journal,
    LectureGeometry,
    LectureState,
)
from game.billiards.lecture.walls import bounce_off_walls, swallow
from game.compiler.decorator import kernel
from game.physics.kernels import elementary

_WALLS, _BALLS, _FRICTION = (LECTURE.bit(effect) for effect in (WALLS, BALL_COLLISIONS, FRICTION))
_MINIMUM, _POCKETS, _ROLLING = (LECTURE.bit(effect) for effect in (MINIMUM_SPEED, POCKETS, ROLLING))


@kernel
def count_substeps(state, settings, dt):
    """Number of substeps: as set, or so many that no ball moves over half of the least radius in one."""
    if settings.substeps != se.AUTOMATIC:
        return settings.substeps
    fastest = 0.0
    smallest = 1e300
    for i in range(state.radii.shape[0]):
        if state.in_play[i]:
            vx = state.velocities[i, 0]
            vy = state.velocities[i, 1]
            fastest = max(fastest, vx * vx + vy * vy)
            smallest = min(smallest, state.radii[i])
    needed = math.sqrt(fastest) * dt / (0.5 * smallest)
    if not needed < se.MAX_SUBSTEPS:
        return se.MAX_SUBSTEPS
    return max(1, math.ceil(needed))


@kernel
def roll(orientations, radii, rolled):
    """Turn each ball about the horizontal axis across its path, by distance / radius; then forget it."""
    for i in range(radii.shape[0]):
        distance = math.sqrt(rolled[i, 0] * rolled[i, 0] + rolled[i, 1] * rolled[i, 1])
        if distance > 0.0:
            half = 0.5 * distance / radii[i]
            w = elementary.cos(half)
            s = elementary.sin(half) / distance
            x = -s * rolled[i, 1]  # axis = z cross displacement
            y = s * rolled[i, 0]
            q = orientations[i]
            a = w * q[0] - x * q[1] - y * q[2]
            b = w * q[1] + x * q[0] + y * q[3]
            c = w * q[2] + y * q[0] - x * q[3]
            d = w * q[3] + x * q[2] - y * q[1]
            scale = 1.0 / math.sqrt(a * a + b * b + c * c + d * d)
            q[0] = a * scale
            q[1] = b * scale
            q[2] = c * scale
            q[3] = d * scale
        rolled[i, 0] = 0.0
        rolled[i, 1] = 0.0


@kernel
def slow_down(velocities, factor, minimum_speed):
    """Multiply velocities by a factor; what is slower than the minimum then stops."""
    for i in range(velocities.shape[0]):
        vx = velocities[i, 0] * factor
        vy = velocities[i, 1] * factor
        if vx * vx + vy * vy < minimum_speed * minimum_speed:
            vx = 0.0
            vy = 0.0
        velocities[i, 0] = vx
        velocities[i, 1] = vy


@kernel
def first_not_finite(offsets, velocities):
    """Row of the first ball whose position or velocity is not finite, or -1."""
    for i in range(offsets.shape[0]):
        total = offsets[i, 0] + offsets[i, 1] + velocities[i, 0] + velocities[i, 1]
        if not math.isfinite(total):
            return i
    return -1


@cache
def step_kernel(mask: int, order: int) -> Callable[..., Any]:
    """The step for the effects of a mask and an order of contacts; what is not in it is not compiled in.

    Its arguments are the fields of LectureState, the settings as numbers, and the half width and length with
    cushions, jaws and pockets. Then come the fields of LectureScratch, the number of steps and their length:
    plain arrays, because handing over a NamedTuple from Python takes four times as long.
    """

    @kernel
    def step_table(
        offsets, velocities, orientations, in_play, pocketed_by, radii, inverse_masses,
        numbers, half, cushions, jaws, pockets,
        events, counters, rolled, links, columns, normals, work, sums, steps, dt,
    ):  # fmt: skip
        state = LectureState(offsets, velocities, orientations, in_play, pocketed_by, radii, inverse_masses)
        geometry = LectureGeometry(half[0], half[1], cushions, jaws, pockets)
        settings = read_settings(numbers)
        journal = Journal(events, counters)
        graph = ContactGraph(links[0], links[1], normals)
        contacts = ContactList(graph, columns[0], columns[1], columns[2], JointScratch(work, sums))
        counters[:] = 0
        factor = 1.0
        if mask & _FRICTION:
            consistent = settings.friction_law == se.CONSISTENT
            factor = (
                elementary.pow(settings.friction, se.FRAME_RATE * dt) if consistent else settings.friction
            )
        for number in range(steps):
            substeps = count_substeps(state, settings, dt)
            counters[SUBSTEPS] += substeps
            h = dt / substeps
            for k in range(substeps):
                time = number * dt + k * h
                for i in range(radii.shape[0]):
                    for axis in range(2):
                        moved = velocities[i, axis] * h
                        offsets[i, axis] += moved
                        if mask & _ROLLING:
                            rolled[i, axis] += moved
                if mask & _POCKETS:
                    swallow(state, geometry, journal, h, time)
                if mask & _WALLS:
                    bounce_off_walls(state, geometry, settings, journal, np.bool_(False), time)
                if mask & _BALLS and order == se.JOINT:
                    collide_jointly(state, geometry, settings, contacts, journal, time)
                    if mask & _WALLS and settings.walls_again:
                        bounce_off_walls(state, geometry, settings, journal, np.bool_(True), time)
                elif mask & _BALLS:
                    collide_in_index_order(state, geometry, settings, journal, time)
            if mask & (_FRICTION | _MINIMUM):
                slow_down(velocities, factor, settings.minimum_speed if mask & _MINIMUM else 0.0)
            if mask & _ROLLING:
                roll(orientations, radii, rolled)
        counters[NOT_FINITE] = first_not_finite(offsets, velocities)

    return step_table

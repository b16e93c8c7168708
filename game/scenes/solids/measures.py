"""What is measured of a world of solids: energies, momentum, contacts with their forces, islands."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary, elementwise
from game.physics.solids import SolidWorld
from game.physics.solids.joints.layout import BROKEN, DISTANCE, HERTZ, JOINT_NAMES, LENGTH, NO_JOINT
from game.physics.solids.state import (
    DYNAMIC,
    FIRST_POINT,
    GAP,
    IN_B_X,
    NORMAL_IMPULSE,
    NORMAL_X,
    POINT_WIDTH,
    POINTS,
    TANGENT_IMPULSE,
    TOUCHING,
    USED,
)
from game.scenes.solids.bodies import place_of
from game.worlds.hearing import REMEMBERED_S

Floats = NDArray[np.float64]
SPRING = JOINT_NAMES.index("spring")


class Energies(NamedTuple):
    """J; momentum N s, (2,). elastic: of springs, and of soft contacts what they give back."""

    moving: float
    turning: float
    height: float
    elastic: float
    momentum: Floats

    @property
    def total(self) -> float:
        """All together."""
        return self.moving + self.turning + self.height + self.elastic


def energies(world: SolidWorld) -> Energies:
    """Of all dynamic bodies; heights above y = 0."""
    rows = world.bodies
    there = np.flatnonzero(rows.flags & DYNAMIC)
    mass, inertia = 1.0 / rows.inverse_masses[there], 1.0 / rows.inverse_inertias[there]
    velocities, places = rows.velocities[there], rows.positions[there]
    gx, gy = world.settings.gravity if "gravity" in world.settings.effects.names else (0.0, 0.0)
    weights = mass * rows.gravity_scales[there]
    return Energies(
        float(0.5 * (mass * (velocities * velocities).sum(axis=1)).sum()),
        float(0.5 * (inertia * (rows.spins[there] * rows.spins[there])).sum()),
        float(-(weights * (gx * places[:, 0] + gy * places[:, 1])).sum()),
        _elastic(world) + float(rows.stored[there].sum()),
        (mass[:, None] * velocities).sum(axis=0),
    )


def _elastic(world: SolidWorld) -> float:
    """Of joints, J: half of k times the squared excess; k by their frequency on the masses they join."""
    rows, total = world.joints, 0.0
    soft = ((rows.kinds == DISTANCE) | (rows.kinds == SPRING)) & (rows.flags & BROKEN == 0)
    for k in np.flatnonzero(soft & (rows.parameters[:, HERTZ] > 0.0)).tolist():
        ends = np.array([place_of(world, k, 0), place_of(world, k, 1)])
        apart = ends[1] - ends[0]
        length = float(elementwise.hypot(*apart))
        if length == 0.0:
            continue
        weight = 0.0
        for end, body in zip(ends, rows.bodies[k].tolist(), strict=True):
            arm = end - world.bodies.positions[body]
            cross = float(arm[0] * apart[1] - arm[1] * apart[0]) / length
            weight += float(
                world.bodies.inverse_masses[body] + world.bodies.inverse_inertias[body] * (cross * cross)
            )
        if weight > 0.0:
            stiffness = elementary.square(2.0 * math.pi * float(rows.parameters[k, HERTZ])) / weight
            total += 0.5 * stiffness * elementary.square(length - float(rows.parameters[k, LENGTH]))
    return total


class ContactPoints(NamedTuple):
    """Points where shapes touch: places (k, 2) m, normals (k, 2) from a to b, impulses N s, overlap m."""

    places: Floats
    normals: Floats
    pushes: Floats
    rubs: Floats
    depths: Floats


def contact_points(world: SolidWorld) -> ContactPoints:
    """All of the last step."""
    contacts, rows = world.contacts, world.bodies
    touching = contacts.marks[:, TOUCHING] == 1
    marks, manifolds = contacts.marks[touching], contacts.manifolds[touching]
    a = contacts.bodies[touching, 0]
    c, s = rows.rotations[a, 0], rows.rotations[a, 1]
    nx, ny = manifolds[:, NORMAL_X], manifolds[:, NORMAL_X + 1]
    normals = np.stack([c * nx - s * ny, s * nx + c * ny], axis=1)
    found: list[tuple[Floats, ...]] = []
    for k in range(2):
        here, at = marks[:, POINTS] > k, FIRST_POINT + k * POINT_WIDTH
        x, y = manifolds[here, at], manifolds[here, at + 1]
        cos, sin = c[here], s[here]
        places = np.stack([cos * x - sin * y, sin * x + cos * y], axis=1) + rows.positions[a[here]]
        own, b = manifolds[here], contacts.bodies[touching, 1][here]
        cos_b, sin_b = rows.rotations[b, 0], rows.rotations[b, 1]
        bx, by = own[:, at + IN_B_X], own[:, at + IN_B_X + 1]
        others = np.stack([cos_b * bx - sin_b * by, sin_b * bx + cos_b * by], axis=1) + rows.positions[b]
        gaps = own[:, at + GAP] + ((others - places) * normals[here]).sum(axis=1)
        found.append(
            (
                places,
                normals[here],
                own[:, at + NORMAL_IMPULSE],
                own[:, at + TANGENT_IMPULSE],
                -gaps,
            )
        )
    return ContactPoints(*(np.concatenate([part[i] for part in found]) for i in range(5)))


HEARD_TIME, HEARD_KIND, HEARD_SPEED, HEARD_X, HEARD_WIDTH = range(5)  # columns of what is heard: s, m/s, m
THUD, WOOD, STONE, STEEL, SNAP = range(5)  # sounds, of impacts from the softest; and of a joint that breaks
SNAP_SPEED = 3.0  # m/s: as loud as an impact at that
LEAST_HEARD = 0.3  # m/s of approach; what leans and slides is silent
MOST_HEARD = 24  # the latest
USUAL_MASS = 0.5  # kg that meet; what is heavier sounds as if it were faster, by the cube root


def heard_now(world: SolidWorld, heard: Floats, began: float, kinds: NDArray[np.int64]) -> Floats:
    """Impacts (k, HEARD_WIDTH) of the last moments, those of a step that began at ``began`` (s) among them.

    kinds: of the sound of each body; of two, the lower one is heard: the softer body says how long they meet.
    """
    shapes, places = world.contacts_begun()
    if len(heard):
        heard = heard[heard[:, HEARD_TIME] > began - REMEMBERED_S]
    loud, broken = np.flatnonzero(places[:, 3] > LEAST_HEARD), world.joints_broken().tolist()
    if not (len(loud) or broken):
        return heard
    rows = places[loud]
    pairs = world.shapes.bodies[shapes[loud]]
    found = kinds[pairs].min(axis=1).astype(np.float64)
    # speed times the mass that meets: the impulse of the step in which a contact begins is only a part of it
    lightness = world.bodies.inverse_masses[pairs].sum(axis=1)
    speeds = rows[:, 3] * np.clip(elementwise.cbrt(1.0 / np.maximum(USUAL_MASS * lightness, 1e-12)), 0.3, 3.0)
    hits = np.stack([began + rows[:, 4], found, speeds, rows[:, 0]], axis=1)
    snaps = [(began, SNAP, SNAP_SPEED, place_of(world, joint, 0)[0]) for joint in broken]
    added = np.concatenate([hits, np.array(snaps).reshape(-1, HEARD_WIDTH)])
    return np.concatenate([heard, added[np.lexsort((added[:, 3], added[:, 0]))]])[-MOST_HEARD:]


def islands(world: SolidWorld) -> NDArray[np.int64]:
    """Least id of the island of each body (n,); -1 for what is not dynamic."""
    flags, contacts, joints = world.bodies.flags, world.contacts, world.joints
    dynamic = flags & (USED | DYNAMIC) == USED | DYNAMIC
    held = (joints.kinds != NO_JOINT) & (joints.flags & BROKEN == 0)
    pairs = np.concatenate([contacts.bodies[contacts.marks[:, TOUCHING] == 1], joints.bodies[held]])
    pairs = pairs[dynamic[pairs].all(axis=1)]
    names = np.where(dynamic, np.arange(len(flags)), -1)
    while True:
        least = names[pairs].min(axis=1)
        after = names.copy()
        for column in (0, 1):
            np.minimum.at(after, pairs[:, column], least)
        after = np.where(after >= 0, after[after], -1)
        if np.array_equal(after, names):
            return names.astype(np.int64)
        names = after

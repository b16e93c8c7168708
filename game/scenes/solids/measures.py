"""What is measured of a world of solids: energies, momentum, contacts with their forces, islands."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.kernels import elementary, elementwise
from game.physics.solids import SolidWorld
from game.physics.solids.arrays import layout
from game.physics.solids.arrays import state as s
from game.physics.solids.arrays.layout import JOINT_NAMES
from game.scenes.solids.bodies import place_of
from game.worlds.hearing import HEARD_WIDTH, impacts

SPRING = JOINT_NAMES.index("spring")


class Energies(NamedTuple):
    """J; momentum N s, (2,); spin N m s about the origin. elastic: of springs, and of soft contacts what they
    give back.
    """

    moving: float
    turning: float
    height: float
    elastic: float
    momentum: Floats
    spin: float

    @property
    def total(self) -> float:
        """All together."""
        return self.moving + self.turning + self.height + self.elastic


def energies(world: SolidWorld) -> Energies:
    """Of all dynamic bodies; heights above y = 0."""
    rows = world.bodies
    there = np.flatnonzero(rows.flags & s.DYNAMIC)
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
        float((mass * (places[:, 0] * velocities[:, 1] - places[:, 1] * velocities[:, 0])).sum())
        + float((inertia * rows.spins[there]).sum()),
    )


def _elastic(world: SolidWorld) -> float:
    """Of joints, J: half of k times the squared excess; k by their frequency on the masses they join."""
    rows, total = world.joints, 0.0
    soft = ((rows.kinds == layout.DISTANCE) | (rows.kinds == SPRING)) & (rows.flags & layout.BROKEN == 0)
    for k in np.flatnonzero(soft & (rows.parameters[:, layout.HERTZ] > 0.0)).tolist():
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
            stiffness = elementary.square(2.0 * math.pi * float(rows.parameters[k, layout.HERTZ])) / weight
            total += 0.5 * stiffness * elementary.square(length - float(rows.parameters[k, layout.LENGTH]))
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
    touching = contacts.marks[:, s.TOUCHING] == 1
    marks, manifolds = contacts.marks[touching], contacts.manifolds[touching]
    a = contacts.bodies[touching, 0]
    c, sine = rows.rotations[a, 0], rows.rotations[a, 1]
    nx, ny = manifolds[:, s.NORMAL_X], manifolds[:, s.NORMAL_X + 1]
    normals = np.stack([c * nx - sine * ny, sine * nx + c * ny], axis=1)
    found: list[tuple[Floats, ...]] = []
    for k in range(2):
        here, at = marks[:, s.POINTS] > k, s.FIRST_POINT + k * s.POINT_WIDTH
        x, y = manifolds[here, at], manifolds[here, at + 1]
        cos, sin = c[here], sine[here]
        places = np.stack([cos * x - sin * y, sin * x + cos * y], axis=1) + rows.positions[a[here]]
        own, b = manifolds[here], contacts.bodies[touching, 1][here]
        cos_b, sin_b = rows.rotations[b, 0], rows.rotations[b, 1]
        bx, by = own[:, at + s.IN_B_X], own[:, at + s.IN_B_X + 1]
        others = np.stack([cos_b * bx - sin_b * by, sin_b * bx + cos_b * by], axis=1) + rows.positions[b]
        gaps = own[:, at + s.GAP] + ((others - places) * normals[here]).sum(axis=1)
        pushes, rubs = own[:, at + s.NORMAL_IMPULSE], own[:, at + s.TANGENT_IMPULSE]
        found.append((places, normals[here], pushes, rubs, -gaps))
    return ContactPoints(*(np.concatenate([part[i] for part in found]) for i in range(5)))


THUD, WOOD, STONE, STEEL, SNAP = range(5)  # sounds, of impacts from the softest; and of a joint that breaks
SNAP_SPEED = 3.0  # m/s: as loud as an impact at that
LEAST_HEARD = 0.3  # m/s of approach; what leans and slides is silent
USUAL_MASS = 0.5  # kg that meet; what is heavier sounds as if it were faster, by the cube root


def sounds_now(world: SolidWorld, began: float, kinds: Longs) -> Floats:
    """Impacts and snaps (k, HEARD_WIDTH) of a step that began at ``began`` (s).

    kinds: of the sound of each body; of two, the lower one is heard: the softer body says how long they meet.
    """
    found, broken = impacts(world, LEAST_HEARD), world.joints_broken().tolist()
    if not (len(found.rows) or broken):
        return np.zeros((0, HEARD_WIDTH))
    # speed times the mass that meets: the impulse of the step in which a contact begins is only a part of it
    lightness = world.bodies.inverse_masses[found.bodies].sum(axis=1)
    heavier = elementwise.cbrt(1.0 / np.maximum(USUAL_MASS * lightness, 1e-12))
    speeds = found.rows[:, 3] * np.clip(heavier, 0.3, 3.0)
    hits = found.heard(began, kinds[found.bodies].min(axis=1), speeds)
    snaps = [(began, SNAP, SNAP_SPEED, place_of(world, joint, 0)[0]) for joint in broken]
    return np.concatenate([hits, np.array(snaps).reshape(-1, HEARD_WIDTH)])


def islands(world: SolidWorld) -> Longs:
    """Least id of the island of each body (n,); -1 for what is not dynamic."""
    flags, contacts, joints = world.bodies.flags, world.contacts, world.joints
    dynamic = flags & (s.USED | s.DYNAMIC) == s.USED | s.DYNAMIC
    held = (joints.kinds != layout.NO_JOINT) & (joints.flags & layout.BROKEN == 0)
    pairs = np.concatenate([contacts.bodies[contacts.marks[:, s.TOUCHING] == 1], joints.bodies[held]])
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

"""What the tests of solids share: slopes, floors, columns."""

from __future__ import annotations

import math

from game.physics.solids import Material, SolidSettings, SolidWorld, box

G = 9.81


def floor_world(material=None, degrees=0.0, **settings):
    """A world with a floor whose top is y = 0, tilted by turning gravity: downhill is +x. (world, floor)."""
    turn = math.radians(degrees)
    settings.setdefault("gravity", (G * math.sin(turn), -G * math.cos(turn)))
    world = SolidWorld(SolidSettings(**settings))
    floor = world.add_body(box(400.0, 1.0, material=material or Material()), (0.0, -0.5), kind="fixed")
    return world, floor


def run(world, seconds, dt=1.0 / 60.0):
    """Steps for so many seconds."""
    for _ in range(round(seconds / dt)):
        world.step(dt)


def column(world, count, x=0.0):
    """Unit boxes on top of each other; their ids."""
    return [world.add_body(box(1.0, 1.0), (x, 0.5 + k)) for k in range(count)]


def energy(world, g=G):
    """Kinetic and potential energy of all dynamic bodies, J."""
    rows = world.bodies
    moving = rows.inverse_masses > 0.0
    mass, inertia = 1.0 / rows.inverse_masses[moving], 1.0 / rows.inverse_inertias[moving]
    kinetic = (
        0.5 * mass * (rows.velocities[moving] ** 2).sum(axis=1) + 0.5 * inertia * rows.spins[moving] ** 2
    )
    return float(kinetic.sum() + (mass * g * rows.positions[moving, 1]).sum())

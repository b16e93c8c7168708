"""Adding and taking away particles and links while the rest goes on.

Nothing is changed in place: each function gives a new system with what was left as it was.
"""

from __future__ import annotations

import dataclasses
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.constraints import motion
from game.physics.constraints.graph import Links
from game.physics.constraints.system import PositionBasedDynamics


class Topology(NamedTuple):
    """What is linked to what, in the order given, as plain arrays."""

    pairs: Longs  # (m, 2)
    rest: Floats  # (m,) m
    stiffness: Floats  # (m,)
    compliance: Floats  # (m,) m/N
    torn: Longs  # (m,)
    corners: Longs  # of all outlines
    starts: Longs  # (k + 1,)
    areas: Floats  # (5, k)
    contacts: Longs  # (c, 2)
    distances: Floats  # (c,) m


def topology_of(system: PositionBasedDynamics) -> Topology:
    """Copies of what holds a system together."""
    links, outlines, contacts = system.links, system.outlines, system.contacts
    return Topology(
        links.pairs.copy(),
        links.rest.copy(),
        links.stiffness.copy(),
        links.compliance.copy(),
        system.torn.copy(),
        outlines.corners.copy(),
        outlines.starts.copy(),
        outlines.rows.copy(),
        contacts.pairs.copy(),
        contacts.rest.copy(),
    )


def outlines_of(topology: Topology) -> list[Longs]:
    """The corners (k,) of each outline."""
    return [topology.corners[a:b] for a, b in pairwise(topology.starts.tolist())]


def assemble(system: PositionBasedDynamics, fields: Floats, topology: Topology) -> PositionBasedDynamics:
    """A system with the settings of another, and these particles (FIELD_ROWS, n) and links."""
    settings = {
        field.name: getattr(system.settings, field.name) for field in dataclasses.fields(system.settings)
    }
    outlines = [outline.tolist() for outline in outlines_of(topology)]
    made = PositionBasedDynamics(
        fields[motion.X : motion.Y + 1].T,
        fields[motion.INVERSE_MASS],
        topology.pairs,
        topology.stiffness,
        rest_lengths=topology.rest,
        compliances=topology.compliance,
        areas=outlines,
        contacts=topology.contacts,
        distances=topology.distances,
        order=system.order,
        **settings,
    )
    made.fields[: motion.AIM_X, : made.count] = fields[: motion.AIM_X]
    made.fields[motion.FRESH] = 1.0
    made.outlines.rows[:] = topology.areas
    made.torn[:] = topology.torn
    return made


def particles_of(system: PositionBasedDynamics) -> Floats:
    """A copy (FIELD_ROWS, n) of the particles' numbers."""
    return system.fields[:, : system.count].copy()


def with_particle(
    system: PositionBasedDynamics, position: tuple[float, float], inverse_mass: float
) -> PositionBasedDynamics:
    """One more particle, at rest, with the last number."""
    new = np.zeros((motion.FIELD_ROWS, 1))
    new[motion.X, 0], new[motion.Y, 0] = position
    new[motion.INVERSE_MASS] = inverse_mass
    return assemble(system, np.hstack([particles_of(system), new]), topology_of(system))


def without_particle(system: PositionBasedDynamics, index: int) -> PositionBasedDynamics:
    """One particle less, with its links and outlines; those after it move up. ValueError for the last one."""
    if system.count == 1:
        raise ValueError("the last particle stays")
    topology = topology_of(system)
    kept = np.all(topology.pairs != index, axis=1)
    met = np.all(topology.contacts != index, axis=1)
    outlines = outlines_of(topology)
    whole = [index not in outline for outline in outlines]
    left = [outline for outline, stays in zip(outlines, whole, strict=True) if stays]
    return assemble(
        system,
        np.delete(particles_of(system), index, axis=1),
        Topology(
            _renumbered(topology.pairs[kept], index),
            topology.rest[kept],
            topology.stiffness[kept],
            topology.compliance[kept],
            topology.torn[kept],
            _renumbered(np.concatenate(left) if left else np.zeros(0, dtype=np.int64), index),
            np.cumsum([0, *(len(outline) for outline in left)]).astype(np.int64),
            topology.areas[:, whole],
            _renumbered(topology.contacts[met], index),
            topology.distances[met],
        ),
    )


def _renumbered(numbers: Longs, gone: int) -> Longs:
    return numbers - (numbers > gone)


def with_link(
    system: PositionBasedDynamics, a: int, b: int, stiffness: float = 1.0, compliance: float = 0.0
) -> PositionBasedDynamics:
    """One more link, as long as the two are apart now. ValueError if they are linked already."""
    pair = np.sort(np.array([[a, b]], dtype=np.int64), axis=1)
    topology = topology_of(system)
    if np.any(np.all(topology.pairs == pair, axis=1) & (topology.torn == 0)):
        raise ValueError(f"particles {a} and {b} are linked already")
    new = Links.between(system.positions, pair, None, stiffness, compliance)
    return assemble(
        system,
        particles_of(system),
        topology._replace(
            pairs=np.vstack([topology.pairs, new.pairs]),
            rest=np.append(topology.rest, new.rest),
            stiffness=np.append(topology.stiffness, new.stiffness),
            compliance=np.append(topology.compliance, new.compliance),
            torn=np.append(topology.torn, 0),
        ),
    )


def nearest_particle(system: PositionBasedDynamics, point: tuple[float, float], reach: float) -> int:
    """The particle nearest to a point (m) within reach (m); -1 if there is none."""
    dx = system.fields[motion.X, : system.count] - point[0]
    dy = system.fields[motion.Y, : system.count] - point[1]
    squares = dx * dx + dy * dy
    best = int(np.argmin(squares))
    return best if squares[best] <= reach * reach else -1


def links_across(
    system: PositionBasedDynamics, start: tuple[float, float], end: tuple[float, float]
) -> list[int]:
    """Whole links that a straight cut from start to end (m) crosses."""
    x, y = system.fields[motion.X], system.fields[motion.Y]
    a, b = system.links.pairs[:, 0], system.links.pairs[:, 1]

    def side(px: float, py: float, qx: Floats, qy: Floats, rx: Floats, ry: Floats) -> Floats:
        return (qx - px) * (ry - py) - (qy - py) * (rx - px)

    cut_x, cut_y = end[0] - start[0], end[1] - start[1]
    over_a = cut_x * (y[a] - start[1]) - cut_y * (x[a] - start[0])
    over_b = cut_x * (y[b] - start[1]) - cut_y * (x[b] - start[0])
    over_start = side(*start, x[a], y[a], x[b], y[b])
    over_end = side(*end, x[a], y[a], x[b], y[b])
    # half open, so that a cut that is made piece by piece misses no link that lies on a joint
    crossed = ((over_a < 0.0) != (over_b < 0.0)) & ((over_start < 0.0) != (over_end < 0.0))
    crossed &= system.torn == 0
    return np.flatnonzero(crossed).tolist()


def speeds_of(system: PositionBasedDynamics) -> Floats:
    """(n,) m/s."""
    vx, vy = system.fields[motion.VX, : system.count], system.fields[motion.VY, : system.count]
    return np.sqrt(vx * vx + vy * vy)

"""A network as it stands, as the content of a level file."""

from __future__ import annotations

from itertools import pairwise

from game.physics.constraints.areas import INTACT
from game.physics.constraints.editing import topology_of
from game.scenes.springs.level import MOST_WRITTEN, LinkEntry, ParticleEntry, SpringContent
from game.scenes.springs.model import SpringModel
from game.scenes.springs.network import NOT_OWN


def content_of(model: SpringModel) -> SpringContent:
    """The network particle by particle; one too large for that as its level has it."""
    system = model.system
    if system.count > MOST_WRITTEN or len(system.torn) > 4 * MOST_WRITTEN:
        return model.content
    topology = topology_of(system)
    weights = system.own_inverse_masses().tolist()
    rows = zip(system.positions.tolist(), system.velocities.tolist(), weights, strict=True)
    whole = topology.torn == 0
    links = zip(
        topology.pairs[whole].tolist(), topology.rest[whole].tolist(), model.own[whole].tolist(), strict=True
    )
    outlines = zip(pairwise(topology.starts.tolist()), topology.areas[INTACT].tolist(), strict=True)
    return SpringContent(
        particles=tuple(
            ParticleEntry(position=(x, y), velocity=(vx, vy), inverse_mass=weight)
            for (x, y), (vx, vy), weight in rows
        ),
        links=tuple(
            LinkEntry(ends=(a, b), rest=rest, stiffness=None if own == NOT_OWN else own)
            for (a, b), rest, own in links
        ),
        areas=tuple(tuple(topology.corners[a:b].tolist()) for (a, b), intact in outlines if intact),
        contacts=tuple((a, b) for a, b in topology.contacts.tolist()),
        floor=model.content.floor,
        walls=model.content.walls,
        body_distance=model.content.body_distance,
        expected=model.content.expected,
        sheet=model.content.sheet,
        label=model.content.label,
        beside=model.content.beside if model.beside else (),
        pendulum=model.content.pendulum and not model.edited,
        reference=model.content.reference,
        view=model.content.view,
    )

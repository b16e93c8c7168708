"""A level's particles and links, from what its file lists and from the shapes that it names."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.constraints import shapes
from game.physics.kernels import elementwise
from game.physics.kernels.limits import LimitError
from game.scenes.springs.level import (
    BlockEntry,
    BridgeEntry,
    ClothEntry,
    CradleEntry,
    RingEntry,
    RopeEntry,
    SpringContent,
)

Slack = float | NDArray[np.float64]  # length at rest over the length at first

MOST_PARTICLES = 200_000  # of a level with all its shapes: the largest net and some more; 0.4 GB
NOT_OWN = -1.0  # a link without a stiffness of its own has the panel's


class Network(NamedTuple):
    """A level's particles and what holds them, ready for a system."""

    shape: shapes.Shape
    velocities: NDArray[np.float64]  # (n, 2) m/s
    rest: NDArray[np.float64]  # (m,) m
    own: NDArray[np.float64]  # (m,) stiffness of a link's own, or NOT_OWN
    pressures: NDArray[np.float64]  # (k,)


def build_network(content: SpringContent) -> Network:
    """The network that a content describes. ValueError, naming the entry, for what makes no sense.

    LimitError, before any is made, for more than MOST_PARTICLES.
    """
    _bound_particles(content)
    if content.walls is not None and content.walls[0] >= content.walls[1]:
        raise ValueError(f"walls: expected the left one first, not {list(content.walls)}")
    listed = _listed(content)
    parts = [listed[0]] if len(listed[0].positions) else []
    slacks = [listed[1]] if parts else []
    makers: tuple[tuple[str, Sequence[Any], Callable[[Any], tuple[shapes.Shape, Any]]], ...] = (
        ("ropes", content.ropes, _rope),
        ("cloths", content.cloths, _cloth),
        ("blocks", content.blocks, _block),
        ("bridges", content.bridges, _bridge),
        ("rings", content.rings, _ring),
        ("cradles", content.cradles, _cradle),
    )
    for name, entries, make in makers:
        for i, entry in enumerate(entries):
            try:
                shape, slack = make(entry)
            except ValueError as error:
                raise ValueError(f"{name}[{i}]: {error}") from None
            parts.append(shape)
            slacks.append(np.full(len(shape.links), 1.0) * slack)
    if not parts:
        raise ValueError("particles: expected at least one")
    whole = shapes.joined(parts)
    rest = _lengths(whole) * np.concatenate(slacks)
    own = np.full(len(whole.links), NOT_OWN)
    velocities = np.zeros_like(whole.positions)
    for i, particle in enumerate(content.particles):
        velocities[i] = particle.velocity
    for i, link in enumerate(content.links):
        if link.rest is not None:
            rest[i] = link.rest
        if link.stiffness is not None:
            own[i] = link.stiffness
    pressures = np.ones(len(whole.areas))
    if content.rings:
        first = len(whole.areas) - len(content.rings)
        pressures[first:] = [ring.pressure for ring in content.rings]
    return Network(whole, velocities, rest, own, pressures)


def _bound_particles(content: SpringContent) -> None:
    """LimitError, naming the entry with which there are too many particles."""
    count = len(content.particles)
    nets: tuple[tuple[str, Sequence[ClothEntry | BlockEntry]], ...] = (
        ("cloths", content.cloths), ("blocks", content.blocks)
    )  # fmt: skip
    for name, entries in nets:
        for i, entry in enumerate(entries):
            count += entry.columns * entry.rows
            if count > MOST_PARTICLES:
                raise LimitError(
                    f"{name}[{i}]: with its {entry.columns} x {entry.rows} particles there are {count}, "
                    f"{MOST_PARTICLES} at most"
                )


def _listed(content: SpringContent) -> tuple[shapes.Shape, NDArray[np.float64]]:
    """The particles and links that are listed one by one."""
    count = len(content.particles)
    for name, groups in (
        ("links", [link.ends for link in content.links]),
        ("areas", content.areas),
        ("contacts", content.contacts),
    ):
        for i, group in enumerate(groups):
            if max(group, default=0) >= count:
                raise ValueError(f"{name}[{i}]: particles 0 to {count - 1} are listed, not {max(group)}")
    positions = np.array([particle.position for particle in content.particles]).reshape(-1, 2)
    pairs = np.array(content.contacts, dtype=np.int64).reshape(-1, 2)
    offsets = positions[pairs[:, 1]] - positions[pairs[:, 0]] if len(pairs) else np.zeros((0, 2))
    shape = shapes.Shape(
        positions,
        np.array([particle.inverse_mass for particle in content.particles]),
        np.array([link.ends for link in content.links], dtype=np.int64).reshape(-1, 2),
        [list(outline) for outline in content.areas],
        pairs,
        np.sqrt((offsets * offsets).sum(axis=1)),
    )
    return shape, np.ones(len(content.links))


def _rope(entry: RopeEntry) -> tuple[shapes.Shape, Slack]:
    if entry.pins not in ("first", "both", "none"):
        raise ValueError(f'pins: expected "first", "both" or "none", not {entry.pins!r}')
    shape = shapes.rope(entry.start, entry.end, entry.links, entry.mass, entry.pins)
    if entry.end_mass is not None and entry.pins != "both":
        shape.inverse_masses[-1] = 1.0 / entry.end_mass
    if entry.slack > 1.0:
        # a little off the straight line: a rope that is too long could else not choose a side
        bend = elementwise.sin(np.linspace(0.0, np.pi, entry.links + 1))
        shape.positions[:, 1] -= 1e-3 * bend
    return shape, entry.slack


def _cloth(entry: ClothEntry) -> tuple[shapes.Shape, Slack]:
    shape = shapes.cloth(
        entry.corner, entry.columns, entry.rows, entry.spacing, entry.mass, entry.pins, entry.shear
    )
    if entry.gather == 1.0:
        return shape, 1.0
    x = shape.positions[:, 0]
    before = _lengths(shape)
    x[:] = entry.corner[0] + entry.gather * (x - entry.corner[0])
    return shape, before / _lengths(shape)


def _lengths(shape: shapes.Shape) -> NDArray[np.float64]:
    offsets = shape.positions[shape.links[:, 1]] - shape.positions[shape.links[:, 0]]
    return np.sqrt((offsets * offsets).sum(axis=1))


def _block(entry: BlockEntry) -> tuple[shapes.Shape, Slack]:
    return shapes.block(entry.corner, entry.columns, entry.rows, entry.spacing, entry.mass), 1.0


def _bridge(entry: BridgeEntry) -> tuple[shapes.Shape, Slack]:
    shape = shapes.bridge(
        entry.start, entry.end, entry.planks, entry.height, entry.mass, entry.lamps, entry.lamp_mass
    )
    slack = np.ones(len(shape.links))
    slack[: 2 * entry.planks] = entry.slack
    return shape, slack


def _ring(entry: RingEntry) -> tuple[shapes.Shape, Slack]:
    return shapes.ring(entry.centre, entry.radius, entry.corners, entry.mass), 1.0


def _cradle(entry: CradleEntry) -> tuple[shapes.Shape, Slack]:
    swing = float(np.radians(entry.swing))
    return shapes.cradle(entry.top, entry.balls, entry.spacing, entry.length, swing), 1.0

"""Ropes, bridges, cloths, jellies and rings, as particles and links ready for a system.

All raise ValueError, naming what it is, for a number of parts or a mass that makes no sense.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary, elementwise

Pairs = list[tuple[int, int]]
SMALLEST, LARGEST_SIDE = 2, 400  # particles along a side


class Shape(NamedTuple):
    """Particles and what holds them together."""

    positions: NDArray[np.float64]  # (n, 2) m
    inverse_masses: NDArray[np.float64]  # (n,) 1/kg
    links: NDArray[np.int64]  # (m, 2)
    areas: list[list[int]]  # outlines, counter-clockwise
    contacts: NDArray[np.int64] = np.zeros((0, 2), dtype=np.int64)  # pairs that bounce off each other
    distances: NDArray[np.float64] = np.zeros(0)  # (c,) m, between their centres


def _side(name: str, count: int, least: int = SMALLEST, most: int = LARGEST_SIDE) -> int:
    if isinstance(count, bool) or not isinstance(count, int) or not least <= count <= most:
        raise ValueError(f"{name} = {count!r}: expected a whole number, {least} to {most}")
    return count


def _inverse(name: str, mass: float) -> float:
    """1/kg of a mass, kg."""
    if not 0.0 < mass < math.inf:
        raise ValueError(f"{name} = {mass!r}: expected a finite number above 0 kg")
    return 1.0 / mass


def _links(pairs: Pairs) -> NDArray[np.int64]:
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def rope(
    start: tuple[float, float], end: tuple[float, float], links: int, mass: float = 1.0, pins: str = "first"
) -> Shape:
    """A straight row of links (so many) from start to end (m), each particle of ``mass`` (kg).

    pins: "first", "both" or "none": which ends are fixed.
    """
    _side("links", links, 1, LARGEST_SIDE - 1)
    if pins not in ("first", "both", "none"):
        raise ValueError(f"pins = {pins!r}: expected first, both or none")
    part = np.linspace(0.0, 1.0, links + 1)[:, None]
    weights = np.full(links + 1, _inverse("mass", mass))
    if pins in ("first", "both"):
        weights[0] = 0.0
    if pins == "both":
        weights[-1] = 0.0
    return Shape(
        np.asarray(start) * (1 - part) + np.asarray(end) * part,
        weights,
        _links([(i, i + 1) for i in range(links)]),
        [],
    )


def cloth(
    corner: tuple[float, float],
    columns: int,
    rows: int,
    spacing: float,
    mass: float = 1.0,
    pins: str = "row",
    shear: bool = False,
) -> Shape:
    """A net of columns x rows hanging from its top left corner (m), each particle of ``mass`` (kg).

    pins: "row" fixes the whole top row, "corners" its ends, "fourths" and "eighths" every fourth or eighth of
    it, "none" nothing. shear: with diagonals. In a row of particles those of even columns are numbered before
    those of odd ones. So all links of a colour lie in long runs. `cloth_index` says which is where.
    """
    index = cloth_index(_side("columns", columns), _side("rows", rows))
    positions = np.empty((columns * rows, 2))
    c, r = np.meshgrid(np.arange(columns), np.arange(rows))
    positions[index, 0] = corner[0] + spacing * c
    positions[index, 1] = corner[1] - spacing * r
    weights = np.full(columns * rows, _inverse("mass", mass))
    fixed = {
        "row": range(columns),
        "corners": (0, columns - 1),
        "fourths": sorted({*range(0, columns, 4), columns - 1}),
        "eighths": sorted({*range(0, columns, 8), columns - 1}),
        "none": (),
    }
    if pins not in fixed:
        raise ValueError(f"pins = {pins!r}: expected one of {', '.join(fixed)}")
    weights[index[0, list(fixed[pins])]] = 0.0
    families = [(index[:, 0:-1:2], index[:, 1::2]), (index[:, 1:-1:2], index[:, 2::2])]
    families += [(index[0:-1:2], index[1::2]), (index[1:-1:2], index[2::2])]
    if shear:
        for first in (0, 1):
            upper, lower = index[first:-1:2], index[first + 1 :: 2]
            families += [(upper[:, :-1], lower[:, 1:]), (upper[:, 1:], lower[:, :-1])]
    pairs = [np.stack([a[: len(b)].ravel(), b.ravel()], axis=1) for a, b in families]
    return Shape(positions, weights, np.sort(np.concatenate(pairs), axis=1), [])


def cloth_index(columns: int, rows: int) -> NDArray[np.int64]:
    """(rows, columns): the number of the particle at each place of a `cloth`."""
    place = np.empty(columns, dtype=np.int64)
    place[np.concatenate([np.arange(0, columns, 2), np.arange(1, columns, 2)])] = np.arange(columns)
    return place[None, :] + columns * np.arange(rows)[:, None]


def block(corner: tuple[float, float], columns: int, rows: int, spacing: float, mass: float = 1.0) -> Shape:
    """A jelly: a free net with both diagonals, each mesh of which keeps its area; corner: bottom left (m)."""
    top = (corner[0], corner[1] + spacing * (rows - 1))
    net = cloth(top, columns, rows, spacing, mass, "none", shear=True)
    index = cloth_index(columns, rows)
    meshes = np.stack([index[1:, :-1], index[1:, 1:], index[:-1, 1:], index[:-1, :-1]], axis=-1)
    return net._replace(areas=meshes.reshape(-1, 4).tolist())


def bridge(
    start: tuple[float, float],
    end: tuple[float, float],
    planks: int,
    height: float,
    mass: float = 1.0,
    lamps: int = 0,
    lamp_mass: float = 5.0,
) -> Shape:
    """A rope bridge: a deck of so many planks between two pins, a hand rope above it, posts between them.

    start, end: of the deck; height: of the rope above it, m. mass: kg of a particle of the deck; one of the
    rope has half of it. lamps: so many of ``lamp_mass`` (kg) on three links each, evenly below the deck.
    """
    _side("planks", planks, 1, LARGEST_SIDE - 1)
    _side("lamps", lamps, 0)
    light = _inverse("mass", mass)
    deck = rope(start, end, planks, mass, "both")
    rail = rope((start[0], start[1] + height), (end[0], end[1] + height), planks, mass, "both")
    n = planks + 1
    posts = [(i, n + i) for i in range(1, planks)]
    positions = [deck.positions, rail.positions]
    weights = [deck.inverse_masses, 2.0 * rail.inverse_masses]
    links = [deck.links, rail.links + n, _links(posts)]
    for lamp in range(lamps):
        plank = round((lamp + 1) * planks / (lamps + 1))
        first = 2 * n + 3 * lamp
        below = np.arange(1, 4)[:, None] * np.array([[0.0, -0.3 * height]])
        positions.append(deck.positions[plank] + below)
        weights.append(np.array([light, light, _inverse("lamp_mass", lamp_mass)]))
        links.append(_links([(plank, first), (first, first + 1), (first + 1, first + 2)]))
    return Shape(np.concatenate(positions), np.concatenate(weights), np.concatenate(links), [])


def ring(centre: tuple[float, float], radius: float, corners: int, mass: float = 1.0) -> Shape:
    """A closed skin of so many links, 3 at least, that keeps the area within; centre, radius m; mass kg."""
    _side("corners", corners, 3)
    angle = 2.0 * math.pi * np.arange(corners) / corners
    positions = np.asarray(centre) + radius * np.stack(
        [elementwise.cos(angle), elementwise.sin(angle)], axis=1
    )
    pairs = [(i, (i + 1) % corners) for i in range(corners)]
    return Shape(positions, np.full(corners, _inverse("mass", mass)), _links(pairs), [list(range(corners))])


def cradle(top: tuple[float, float], balls: int, spacing: float, length: float, swing: float) -> Shape:
    """Balls of 1 kg that touch, side by side on links of ``length`` (m), the first drawn aside by ``swing``.

    top: the first pin, m; spacing: of pins, and diameter of the balls, m; swing: rad.
    """
    _side("balls", balls)
    x = top[0] + spacing * np.arange(balls)
    pins = np.stack([x, np.full(balls, top[1])], axis=1)
    hanging = pins - np.array([0.0, length])
    hanging[0] = pins[0] + length * np.array([-elementary.sin(swing), -elementary.cos(swing)])
    return Shape(
        np.concatenate([pins, hanging]),
        np.concatenate([np.zeros(balls), np.ones(balls)]),
        _links([(i, balls + i) for i in range(balls)]),
        [],
        _links([(balls + i, balls + i + 1) for i in range(balls - 1)]),
        np.full(balls - 1, spacing),
    )


def joined(shapes: list[Shape]) -> Shape:
    """Several shapes as one, numbered one after the other; ValueError if there is none."""
    if not shapes:
        raise ValueError("shapes: expected one or more")
    first = np.cumsum([0, *(len(shape.positions) for shape in shapes)])
    return Shape(
        np.concatenate([shape.positions for shape in shapes]),
        np.concatenate([shape.inverse_masses for shape in shapes]),
        np.concatenate([shape.links + start for shape, start in zip(shapes, first, strict=False)]),
        [
            [start + i for i in outline]
            for shape, start in zip(shapes, first.tolist(), strict=False)
            for outline in shape.areas
        ],
        np.concatenate([shape.contacts + start for shape, start in zip(shapes, first, strict=False)]),
        np.concatenate([shape.distances for shape in shapes]),
    )

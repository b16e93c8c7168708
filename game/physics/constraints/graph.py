"""What is linked to what: the part of a network that stays the same while it moves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.physics.constraints import areas
from game.physics.constraints.areas import outline_area
from game.physics.constraints.settings import LARGEST

MAX_PARTICLES = 1_000_000


class Arms(NamedTuple):
    """The links at each particle: those of particle i are first[i] to first[i + 1]."""

    first: Longs  # (n + 1,)
    links: Longs  # (2 m,) in the order of solving
    others: Longs  # (2 m,) the particle at the other end


def arms_of(links: Longs, count: int) -> Arms:
    """`Arms` of links (m, 2) between ``count`` particles."""
    ends = np.concatenate([links[:, 0], links[:, 1]])
    others = np.concatenate([links[:, 1], links[:, 0]])
    which = np.tile(np.arange(len(links)), 2)
    places = np.argsort(ends, kind="stable")
    first = np.zeros(count + 1, dtype=np.int64)
    np.cumsum(np.bincount(ends, minlength=count), out=first[1:])
    return Arms(first, which[places], others[places])


@dataclass(frozen=True, slots=True)
class Links:
    """Links as they were given. ValueError, naming the field and the link, for nonsense.

    pairs: (m, 2) particles. rest: (m,) m. stiffness: (m,) 0 to 1. compliance: (m,) m/N.
    """

    pairs: Longs
    rest: Floats
    stiffness: Floats
    compliance: Floats

    @classmethod
    def between(
        cls,
        positions: Floats,
        pairs: ArrayLike,
        rest: ArrayLike | None = None,
        stiffness: ArrayLike = 1.0,
        compliance: ArrayLike = 0.0,
    ) -> Links:
        """Links of particles at positions (n, 2) m; at rest as long as they are there, if nothing is said.

        ValueError, naming the link, for ends that there are not, twice the same end, or numbers out of range.
        """
        given = np.asarray(pairs)
        if given.size == 0:
            given = given.reshape(0, 2).astype(np.int64)
        if given.ndim != 2 or given.shape[1] != 2 or not np.issubdtype(given.dtype, np.integer):
            raise ValueError("links: expected pairs of whole numbers")
        both = np.sort(given.astype(np.int64), axis=1)
        count = len(positions)
        for e in np.flatnonzero((both[:, 0] < 0) | (both[:, 1] >= count))[:1]:
            raise ValueError(f"links[{e}] = {given[e].tolist()}: there are particles 0 to {count - 1}")
        for e in np.flatnonzero(both[:, 0] == both[:, 1])[:1]:
            raise ValueError(f"links[{e}] = {given[e].tolist()}: expected two different particles")
        if rest is None:
            way = positions[both[:, 1]] - positions[both[:, 0]]
            rest = np.sqrt(way[:, 0] * way[:, 0] + way[:, 1] * way[:, 1])
        m = len(both)
        return cls(
            both,
            checked("rest", rest, m, 0.0, LARGEST),
            checked("stiffness", stiffness, m, 0.0, 1.0),
            checked("compliance", compliance, m, 0.0, 1e15),
        )


@dataclass(frozen=True, slots=True)
class Outlines:
    """Closed outlines that keep their area. corners: indices; starts: (k + 1,); rows: (AREA_ROWS, k)."""

    corners: Longs
    starts: Longs
    rows: Floats

    @classmethod
    def around(
        cls,
        positions: Floats,
        outlines: list[list[int]] | tuple[tuple[int, ...], ...] = (),
        area: ArrayLike | None = None,
        stiffness: ArrayLike = 1.0,
        compliance: ArrayLike = 0.0,
    ) -> Outlines:
        """Outlines of particles at positions (n, 2) m; at rest they enclose what they enclose there.

        area: (k,) m², if something else. ValueError, naming the outline, for corners that there are not,
        fewer than three, or twice the same.
        """
        for j, outline in enumerate(outlines):
            if len(outline) < 3 or len(set(outline)) != len(outline):
                raise ValueError(f"areas[{j}]: expected three or more different particles")
            if not all(isinstance(i, (int, np.integer)) and 0 <= i < len(positions) for i in outline):
                raise ValueError(f"areas[{j}]: there are particles 0 to {len(positions) - 1}")
        k = len(outlines)
        starts = np.zeros(k + 1, dtype=np.int64)
        np.cumsum([len(outline) for outline in outlines], out=starts[1:])
        corners = np.array([i for outline in outlines for i in outline], dtype=np.int64)
        rows = np.zeros((areas.AREA_ROWS, k))
        rows[areas.INTACT] = 1.0
        rows[areas.STIFFNESS] = checked("area stiffness", stiffness, k, 0.0, 1.0)
        rows[areas.COMPLIANCE] = checked("area compliance", compliance, k, 0.0, 1e15)
        if area is None:
            x, y = np.ascontiguousarray(positions[:, 0]), np.ascontiguousarray(positions[:, 1])
            for j in range(k):
                rows[areas.AREA, j] = outline_area(x, y, corners[starts[j] : starts[j + 1]])
        else:
            rows[areas.AREA] = checked("area", area, k, -(LARGEST * LARGEST), LARGEST * LARGEST)
        return cls(corners, starts, rows)


def checked(name: str, values: ArrayLike, count: int, least: float, most: float) -> Floats:
    """(count,) finite numbers in a range, from one or so many; ValueError naming the first bad one."""
    given = np.asarray(values, dtype=np.float64)
    if given.shape not in ((), (count,)):
        raise ValueError(f"{name}: expected {count} numbers, got shape {given.shape}")
    numbers = np.array(np.broadcast_to(given, (count,)))
    for i in np.flatnonzero(~((numbers >= least) & (numbers <= most)))[:1]:
        raise ValueError(
            f"{name}[{i}] = {numbers[i]!r}: expected {least:g} to {most:g}".replace("np.float64", "")
        )
    return numbers


def checked_pairs(name: str, values: ArrayLike, count: int | None = None) -> Floats:
    """(n, 2) numbers within the world, of one pair or several; ValueError if they are not, or not so many."""
    pairs = np.array(values, dtype=np.float64)
    pairs = pairs.reshape(1, 2) if pairs.shape == (2,) else pairs
    if pairs.ndim != 2 or pairs.shape[1] != 2 or not 1 <= len(pairs) <= MAX_PARTICLES:
        raise ValueError(f"{name}: expected pairs of numbers, 1 to {MAX_PARTICLES} of them")
    if count is not None and len(pairs) != count:
        raise ValueError(f"{name}: expected {count} pairs, got {len(pairs)}")
    if not np.all(np.abs(pairs) <= LARGEST):
        raise ValueError(f"{name}: expected finite numbers up to {LARGEST:g}")
    return pairs

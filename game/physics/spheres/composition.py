"""What bodies of spheres are made of: masses, inertias, radii and materials, checked as they come in."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats, Longs
from game.physics.kernels import linear

MAX_SPHERES = 1_000_000
LARGEST = 1e6  # m and m/s: far enough for any window, near enough for squares
SOLID = 0.4  # of m r², inertia of a solid ball about its centre
SKEW = 1e-9  # of the largest entry: how far an inertia tensor may be from symmetric
INERTIAS = ("unit", "solid")


class Composition(NamedTuple):
    """What bodies are made of: all that does not change."""

    masses: Floats  # (n,) kg, infinite for what nothing moves
    inverse_inertias: Floats  # (n, 6) 1/(kg m²) in the body's frame: xx yy zz xy xz yz
    round_bodies: NDArray[np.uint8]  # (n,) 1 where inertia is the same about all axes
    radii: Floats  # (s,) m
    owners: Longs  # (s,) body of each sphere
    offsets: Floats  # (s, 3) m from the body's centre, in its frame
    kinds: Longs  # (s,) material


def symmetric(six: ArrayLike) -> Floats:
    """(3, 3) from xx, yy, zz, xy, xz, yz."""
    xx, yy, zz, xy, xz, yz = np.asarray(six, dtype=np.float64).tolist()
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def join_spheres(places: Floats, weights: Floats, owners: Longs, n: int) -> tuple[Floats, Floats]:
    """Mass (n,) kg and centre of mass (n, 3) m of each body of spheres at places (s, 3) m, weights (s,) kg.

    ValueError if a sphere that is joined to others is infinitely heavy.
    """
    if len(places) == n:
        return weights.copy(), places.copy()
    mass, centre = np.zeros(n), np.zeros((n, 3))
    for i in range(n):
        mine = owners == i
        own = weights[mine]
        if np.isinf(own).any():
            raise ValueError("masses: spheres joined to a body must have a finite mass")
        mass[i] = math.fsum(own.tolist())
        first = places[mine][0]
        centre[i] = first + (own[:, None] * (places[mine] - first)).sum(axis=0) / mass[i]
    return mass, centre


def invert_inertias(
    inertias: Any, offsets: Floats, radii: Floats, weights: Floats, owners: Longs, mass: Floats
) -> tuple[Floats, NDArray[np.uint8]]:
    """Inverse inertia (n, 6) 1/(kg m²) in the bodies' frames, and (n,) which are the same about all axes.

    inertias: as for `SphereBodies`. offsets (s, 3) m, radii (s,) m, weights (s,) kg, owners (s,): spheres.
    mass: (n,) kg. ValueError for inertias that no body has.
    """
    n = len(mass)
    if isinstance(inertias, str):
        if inertias not in INERTIAS:
            raise ValueError(f"inertias = {inertias!r}: one of {', '.join(INERTIAS)}, or numbers")
        if inertias == "unit":
            inertias = np.ones(n)
        elif n == len(radii):
            inertias = SOLID * weights * radii * radii
        else:
            inertias = _inertias_by_offsets(offsets, radii, weights, owners, n)
    given = np.array(inertias, dtype=np.float64)
    if given.ndim < 2:
        given = np.broadcast_to(given, (n,))
        if not (given > 0.0).all():
            raise ValueError("inertias: expected numbers above 0 kg m²")
        moments = np.where(np.isinf(mass), math.inf, given)
        six = np.zeros((n, 6))
        six[:, :3] = (1.0 / moments)[:, None]
        return six, np.ones(n, dtype=np.uint8)
    if given.shape != (n, 3, 3) or not np.isfinite(given).all():
        raise ValueError(f"inertias: expected one number or finite tensor for each of {n} bodies")
    six = np.zeros((n, 6))
    for i in range(n):
        off = float(np.abs(given[i] - given[i].T).max())
        if off > SKEW * float(np.abs(given[i]).max()) or linear.eigenvectors(given[i])[0][0] <= 0.0:
            raise ValueError(f"inertias[{i}]: must be symmetric and positive definite")
        inverse = linear.inverse(given[i])
        six[i] = inverse[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    even = (six[:, 0] == six[:, 1]) & (six[:, 0] == six[:, 2]) & ~six[:, 3:].any(axis=1)
    return six, even.astype(np.uint8)


def _inertias_by_offsets(offsets: Floats, radii: Floats, weights: Floats, owners: Longs, n: int) -> Floats:
    """Inertia tensors (n, 3, 3) of joined solid spheres by the offset theorem (Huygens and Steiner)."""
    tensors = np.zeros((n, 3, 3))
    for s, i in enumerate(owners.tolist()):
        d = offsets[s]
        tensors[i] += weights[s] * (
            (SOLID * (radii[s] * radii[s]) + linear.product(d, d)) * np.eye(3) - np.outer(d, d)
        )
    return tensors


def checked_owners(owners: ArrayLike, s: int) -> Longs:
    """(s,) a body for each sphere, numbered without gaps, or ValueError."""
    who = whole_numbers("owners", owners).reshape(-1)
    if who.shape != (s,) or not np.array_equal(np.unique(who), np.arange(who.max(initial=-1) + 1)):
        raise ValueError(f"owners: expected a body 0, 1, ... for each of {s} spheres, none left out")
    return who


def checked_kinds(kinds: ArrayLike, s: int) -> Longs:
    """(s,) materials from one number or (s,), or ValueError."""
    given = whole_numbers("kinds", kinds)
    if given.shape not in ((), (1,), (s,)) or (given < 0).any():
        raise ValueError(f"kinds: expected whole numbers from 0, one for all or for each of {s}")
    return np.array(np.broadcast_to(given, (s,)))


def whole_numbers(name: str, values: ArrayLike) -> Longs:
    """Whole numbers as an array of the same shape, or ValueError: none is rounded."""
    given = np.array(values)
    whole = given.astype(np.int64) if given.dtype.kind in "iuf" and np.isfinite(given).all() else None
    if whole is None or not np.array_equal(whole, given):
        raise ValueError(f"{name}: expected whole numbers")
    return whole


def checked_turns(orientations: ArrayLike | None, n: int) -> Floats:
    """Unit quaternions (n, 4) along those given; no turn for None. ValueError for what is none."""
    if orientations is None:
        return np.tile((1.0, 0.0, 0.0, 0.0), (n, 1))
    q = np.array(orientations, dtype=np.float64)
    if q.shape != (n, 4) or not np.isfinite(q).all():
        raise ValueError(f"orientations: expected {n} quaternions of finite numbers")
    largest = np.abs(q).max(axis=1, initial=0.0)
    if not (largest > 1e-150).all():
        raise ValueError("orientations: a quaternion without length is no turn")
    scaled = np.ldexp(q, -np.frexp(largest)[1][:, None])  # exact; now the square of the length is a number
    turned: Floats = scaled / np.sqrt((scaled * scaled).sum(axis=1))[:, None]
    return turned


def checked_vectors(name: str, values: ArrayLike, count: int | None) -> Floats:
    """(n, 3) finite numbers within the world from (n, 3) or (n, 2), or ValueError."""
    given = np.array(values, dtype=np.float64)
    if given.size == 0 and count in (None, 0):
        if count is None:
            raise ValueError(f"{name}: expected at least one")
        return np.zeros((0, 3))
    if given.ndim != 2 or given.shape[1] not in (2, 3) or len(given) > MAX_SPHERES:
        raise ValueError(f"{name}: expected rows of two or three numbers, at most {MAX_SPHERES}")
    if count is not None and len(given) != count:
        raise ValueError(f"{name}: expected {count} rows, got {len(given)}")
    if not np.isfinite(given).all() or np.abs(given).max() > LARGEST:
        raise ValueError(f"{name}: expected finite numbers up to {LARGEST:g}")
    vectors = np.zeros((len(given), 3))
    vectors[:, : given.shape[1]] = given
    return vectors


def checked_numbers(name: str, values: ArrayLike, count: int, least: float, most: float) -> Floats:
    """(count,) numbers from least to most, from one number or (count,), or ValueError."""
    given = np.array(values, dtype=np.float64)
    if given.size not in (1, count) or given.ndim > 1:
        raise ValueError(f"{name}: expected one number, or one for each of {count}")
    if not ((given >= least) & (given <= most)).all():
        raise ValueError(f"{name}: expected {least:g} to {most:g}")
    return np.array(np.broadcast_to(given, (count,)))

"""Mass, centre of mass and inertia tensor of spheres joined to one body, and its principal axes.

A sphere of radius r has the volume 4/3 π r³ and, about its own centre, the tensor 2/5 m r² E. The offset
theorem (Huygens 1673, Steiner 1840) moves it to the body's centre of mass, d away: I += m (d·d E - d dᵀ).
Where spheres overlap, both count: the body is the sum of its spheres, as the course has it.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats

THINNEST = 1e-12  # principal moments below this part of the largest count as none: nothing turns about them
SWEEPS = 16  # of Jacobi's method; a 3 x 3 matrix takes five or six
MAX_SPHERES = 100_000


def sphere_masses(radii: ArrayLike, density: ArrayLike) -> tuple[Floats, Floats]:
    """Volumes (n,) m³ and masses (n,) kg of spheres of these radii (n,) m and density, kg/m³, one or (n,).

    ValueError unless all are above 0 and finite, the masses too.
    """
    radii = _checked("radii", radii, None)
    density = _checked("density", density, radii.size)
    with np.errstate(over="ignore", under="ignore"):
        volumes = 4.0 / 3.0 * math.pi * radii * radii * radii
        masses = density * volumes
    if not (np.isfinite(masses).all() and (masses > 0.0).all()):
        raise ValueError("radii, density: the mass of a sphere is too large or too small for a number")
    return volumes, masses


def mass_properties(
    positions: ArrayLike, radii: ArrayLike, density: ArrayLike
) -> tuple[float, Floats, Floats]:
    """Mass (kg), centre of mass (3,) m and inertia tensor (3, 3) kg m² about it, of spheres.

    positions: (n, 3) m, or (n, 2) in the plane z = 0. radii: (n,) m. density: kg/m³, one number or (n,).
    ValueError if there is no sphere, if a number is not finite, or if a radius or density is not above 0.
    Offsets are taken from the first sphere before anything is summed, and sums are rounded once (fsum). So a
    far origin or unequal masses cost no digits.
    """
    places = sphere_positions(positions)
    _, masses = sphere_masses(radii, density)
    radii = np.array(radii, dtype=np.float64).reshape(-1)
    if len(masses) != len(places):
        raise ValueError(f"radii: expected {len(places)}, one for each position, got {len(masses)}")
    with np.errstate(over="ignore", under="ignore", invalid="ignore"):
        shifted = places - places[0]
        total = _sum(masses)
        shift = np.array([_sum(masses * shifted[:, k]) for k in range(3)]) / total
        x, y, z = (shifted - shift).T
        own = 0.4 * masses * radii * radii
        diagonal = (y * y + z * z, x * x + z * z, x * x + y * y)
        inertia = np.empty((3, 3))
        for k in range(3):
            inertia[k, k] = _sum(own) + _sum(masses * diagonal[k])
        inertia[0, 1] = inertia[1, 0] = -_sum(masses * x * y)
        inertia[0, 2] = inertia[2, 0] = -_sum(masses * x * z)
        inertia[1, 2] = inertia[2, 1] = -_sum(masses * y * z)
        center = places[0] + shift
    if not (np.isfinite(inertia).all() and np.isfinite(center).all() and inertia.trace() > 0.0):
        raise ValueError("positions, radii: the inertia is too large or too small for a number")
    return total, center, inertia


def principal_axes(inertia: ArrayLike) -> tuple[Floats, Floats]:
    """Principal moments (3,), ascending, and axes (3, 3), the columns, a right-handed frame.

    Jacobi 1846: plane rotations until nothing is left off the diagonal; small moments keep all their
    digits, and no library's rounding enters. A tensor that is diagonal already keeps its axes, but for their
    order. ValueError unless the tensor is finite, symmetric (to 1e-9) and not negative.
    """
    a = np.array(inertia, dtype=np.float64)
    a = np.diag(a) if a.shape == (3,) else a
    if a.shape != (3, 3) or not np.isfinite(a).all():
        raise ValueError("inertia: expected (3, 3) or (3,) finite numbers")
    size = float(np.abs(a).max())
    if not np.abs(a - a.T).max() <= 1e-9 * size:
        raise ValueError("inertia: is not symmetric")
    if not size > 0.0:
        raise ValueError("inertia: is zero")
    scale = math.ldexp(1.0, math.frexp(size)[1])
    a = 0.5 * (a / scale + a.T / scale)
    axes = np.eye(3)
    for _ in range(SWEEPS):
        if a[0, 1] == a[0, 2] == a[1, 2] == 0.0:
            break
        for p, q in ((0, 1), (0, 2), (1, 2)):
            _annul(a, axes, p, q)
    moments = np.diag(a) * scale
    if moments.min() < -1e-9 * size:
        raise ValueError("inertia: a principal moment is negative")
    order = np.argsort(moments, kind="stable")
    axes = axes[:, order]
    if _determinant(axes) < 0.0:
        axes[:, 2] *= -1.0
    return np.maximum(moments[order], 0.0), axes


def inverse_moments(moments: ArrayLike) -> Floats:
    """1 / I of principal moments (3,); 0 for one that is next to nothing beside the largest (THINNEST).

    So a row of spheres next to points, whose tensor has no inverse, does not turn about its own line, rather
    than without bounds: the pseudo-inverse (Penrose 1955).
    """
    moments = np.array(moments, dtype=np.float64)
    thin = moments <= THINNEST * moments.max()
    return np.where(thin, 0.0, 1.0 / np.where(thin, 1.0, moments))


def sphere_positions(positions: ArrayLike) -> Floats:
    """(n, 3) finite numbers from (n, 3) or (n, 2), or ValueError."""
    places = np.array(positions, dtype=np.float64)
    if places.ndim != 2 or places.shape[1] not in (2, 3) or not 1 <= len(places) <= MAX_SPHERES:
        raise ValueError(f"positions: expected 1 to {MAX_SPHERES} points of two or three numbers")
    if not np.isfinite(places).all():
        raise ValueError("positions: must be finite")
    if places.shape[1] == 2:
        places = np.column_stack((places, np.zeros(len(places))))
    return places


def _annul(a: Floats, axes: Floats, p: int, q: int) -> None:
    """Turn the plane (p, q) so that a[p, q] becomes 0 (Golub and Van Loan, 8.5.2)."""
    off = float(a[p, q])
    small = 1e-3 * np.finfo(np.float64).eps
    if abs(off) <= small * math.sqrt(max(float(a[p, p] * a[q, q]), 0.0)):
        a[p, q] = a[q, p] = 0.0
        return
    half = (float(a[q, q]) - float(a[p, p])) / (2.0 * off)
    t = math.copysign(1.0, half) / (abs(half) + math.sqrt(1.0 + half * half))
    c = 1.0 / math.sqrt(1.0 + t * t)
    s = t * c
    a[p, p] -= t * off
    a[q, q] += t * off
    a[p, q] = a[q, p] = 0.0
    r = 3 - p - q
    first, second = float(a[p, r]), float(a[q, r])
    a[p, r] = a[r, p] = c * first - s * second
    a[q, r] = a[r, q] = s * first + c * second
    columns = axes[:, p].copy(), axes[:, q].copy()
    axes[:, p] = c * columns[0] - s * columns[1]
    axes[:, q] = s * columns[0] + c * columns[1]


def _determinant(m: Floats) -> float:
    return float(
        m[0, 0] * (m[1, 1] * m[2, 2] - m[1, 2] * m[2, 1])
        - m[0, 1] * (m[1, 0] * m[2, 2] - m[1, 2] * m[2, 0])
        + m[0, 2] * (m[1, 0] * m[2, 1] - m[1, 1] * m[2, 0])
    )


def _sum(terms: Floats) -> float:
    """The sum, rounded once; inf or nan if a term is."""
    try:
        return math.fsum(terms.tolist())
    except (OverflowError, ValueError):
        return math.inf


def _checked(name: str, values: ArrayLike, count: int | None) -> Floats:
    """Finite numbers above 0, as an array (n,), or ValueError."""
    array = np.array(values, dtype=np.float64).reshape(-1)
    if count is not None and array.size == 1:
        array = np.full(count, array[0])
    if array.size < 1 or (count is not None and array.size != count):
        raise ValueError(f"{name}: expected {count or 'some'} numbers, got {array.size}")
    if not (np.isfinite(array).all() and (array > 0.0).all()):
        raise ValueError(f"{name}: must be finite and above 0")
    return array

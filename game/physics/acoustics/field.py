"""The sound field of point transducers, its gradient, and Gor'kov's potential for a small sphere.

A transducer at r_j with axis n_j, in air of wave number k, adds

    p_j(r) = A_j D(w) exp(i (k d + phi_j)) / d,   d = |r - r_j|,   w = (k a sin theta)²

where D(w) = 2 J1(sqrt w) / sqrt w is the directivity of a piston of radius a (Rayleigh 1877; O'Neil 1949),
as a power series. On a sphere much smaller than the wave acts F = -grad U (Gor'kov 1962; Bruus 2012):

    U = V (f1 <p²> / (2 rho c²) - 3/4 f2 rho <v²>),   <p²> = |p|² / 2,   <v²> = |grad p|² / (2 rho² omega²)

with V its volume, f1 = 1 - kappa_p / kappa and f2 = 2 (rho_p - rho) / (2 rho_p + rho).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.physics.kernels import elementary, elementwise

# Columns of a transducer: its place (m), its axis, pressure times distance on the axis (Pa m), phase (rad).
SX, SY, AXIS_X, AXIS_Y, STRENGTH, PHASE = range(6)
COLUMNS = 6
NEAREST = 1e-3  # m; nearer to a transducer the field is taken as at this distance


class Wave(NamedTuple):
    """Sound in air, and what of a grain its force depends on."""

    number: float  # k, 1/m
    piston: float  # k a, without unit
    monopole: float  # V f1 / (4 rho c²), m³/Pa: for |p|²
    dipole: float  # 3 V f2 / (8 rho omega²), m⁵/Pa: for |grad p|²


@inner_kernel
def _directivity(w):
    """D(w), dD/dw and d²D/dw² of a piston; w = (k a sin theta)² up to about 16, to 1e-9."""
    value, slope, bend = 0.0, 0.0, 0.0
    for m in range(TERMS - 1, -1, -1):  # Horner, from the highest power down
        bend = bend * w + slope
        slope = slope * w + value
        value = value * w + SERIES[m]
    return value, slope, 2.0 * bend


TERMS = 14
SERIES = tuple(elementary.pow(-0.25, m) / (math.factorial(m) * math.factorial(m + 1)) for m in range(TERMS))


@inner_kernel
def pressure_at(sources, wave, x, y):
    """p, its gradient and its second derivatives at a place: p, px, py, pxx, pxy, pyy, complex.

    With u the direction from a transducer, c = u n, q = n - c u: grad c = q / d, grad u = (1 - u u) / d, and
    grad of exp(i k d) / d along u; products of these give the rest.
    """
    p, px, py, pxx, pxy, pyy = 0j, 0j, 0j, 0j, 0j, 0j
    spread, k = wave.piston * wave.piston, wave.number
    for j in range(sources.shape[0]):
        dx, dy = x - sources[j, SX], y - sources[j, SY]
        d = max(math.sqrt(dx * dx + dy * dy), NEAREST)
        near = 1.0 / d
        ux, uy = dx * near, dy * near
        c = ux * sources[j, AXIS_X] + uy * sources[j, AXIS_Y]
        if c <= 0.0:
            continue  # nothing goes backwards
        f, slope, bend = _directivity(spread * (1.0 - c * c))
        f1 = -2.0 * spread * c * slope  # by c
        f2 = 4.0 * spread * spread * c * c * bend - 2.0 * spread * slope
        qx, qy = (sources[j, AXIS_X] - c * ux) * near, (sources[j, AXIS_Y] - c * uy) * near
        turn = k * d + sources[j, PHASE]
        g = sources[j, STRENGTH] * near * complex(elementary.cos(turn), elementary.sin(turn))
        along = complex(-near, k)  # of exp(i k d) / d: first derivative, divided by itself
        twice = complex(2.0 * near * near - k * k, -2.0 * k * near)  # second
        p += g * f
        px += g * (along * (f * ux) + f1 * qx)
        py += g * (along * (f * uy) + f1 * qy)
        xx, xy, yy = near * (1.0 - ux * ux), -near * ux * uy, near * (1.0 - uy * uy)
        flat = along * f - f1 * c * near
        cross = (along - near) * f1
        pxx += g * (twice * (f * ux * ux) + flat * xx + 2.0 * cross * (ux * qx) + f2 * qx * qx)
        pxy += g * (twice * (f * ux * uy) + flat * xy + cross * (ux * qy + uy * qx) + f2 * qx * qy)
        pyy += g * (twice * (f * uy * uy) + flat * yy + 2.0 * cross * (uy * qy) + f2 * qy * qy)
    return p, px, py, pxx, pxy, pyy


@inner_kernel
def _product(a, b):
    """The real part of a* b."""
    return a.real * b.real + a.imag * b.imag


@inner_kernel
def force_at(sources, wave, x, y):
    """The force (N) on a grain: minus the slope of Gor'kov's potential."""
    p, px, py, pxx, pxy, pyy = pressure_at(sources, wave, x, y)
    fx = 2.0 * (wave.dipole * (_product(px, pxx) + _product(py, pxy)) - wave.monopole * _product(p, px))
    fy = 2.0 * (wave.dipole * (_product(px, pxy) + _product(py, pyy)) - wave.monopole * _product(p, py))
    return fx, fy


@kernel
def sample_field(sources, wave, places, out):
    """p (real, imaginary), |grad p|, U and the force (2) at places (n, 2), into out (n, 6)."""
    for i in range(places.shape[0]):
        x, y = places[i, 0], places[i, 1]
        p, px, py, _, _, _ = pressure_at(sources, wave, x, y)
        steep = _product(px, px) + _product(py, py)
        out[i, 0], out[i, 1] = p.real, p.imag
        out[i, 2] = math.sqrt(steep)
        out[i, 3] = wave.monopole * _product(p, p) - wave.dipole * steep
        out[i, 4], out[i, 5] = force_at(sources, wave, x, y)


@lean_kernel
def aim(sources, number, focus_x, focus_y, offsets):
    """Give all transducers the phases that make their sound arrive together at a place, plus offsets (n,)."""
    for j in range(sources.shape[0]):
        dx, dy = focus_x - sources[j, SX], focus_y - sources[j, SY]
        sources[j, PHASE] = offsets[j] - number * math.sqrt(dx * dx + dy * dy)


def transfer(sources, wave, places):
    """Pressure (Pa) of each transducer at phase 0 at places (n, 2) m: complex64 (n, transducers)."""
    away = places[:, None, :] - sources[None, :, SX : SY + 1]
    distance = np.maximum(np.sqrt(np.sum(away * away, axis=2)), NEAREST)
    cosine = np.sum(away * sources[None, :, AXIS_X : AXIS_Y + 1], axis=2) / distance
    w = (wave.piston * wave.piston) * (1.0 - np.minimum(cosine * cosine, 1.0))
    shape = np.polynomial.polynomial.polyval(w, SERIES)
    heard = np.where(cosine > 0.0, sources[None, :, STRENGTH] * shape / distance, 0.0)
    return (heard * elementwise.turned(wave.number * distance)).astype(np.complex64)

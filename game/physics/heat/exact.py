"""Closed forms of heat, to be put beside what is measured."""

from __future__ import annotations

import math
from collections.abc import Callable

from game.physics.kernels import elementary

LEAST_ROOT = 1e-12
LEAST_BEYOND = 1e-16  # of 1 - erf, which is no more than rounding there; only a sign is asked for so far out


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    """Where an increasing function crosses 0, by halving."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)


def stefan_number(stefan: float) -> float:
    """λ of a front s = 2 λ √(α t) that melts from a wall: λ exp(λ²) erf λ = Ste / √π (Stefan 1891)."""
    return _root(
        lambda x: x * elementary.exp(x * x) * elementary.erf(x) - stefan / math.sqrt(math.pi), LEAST_ROOT, 5.0
    )


def neumann_number(
    wall: float, start: float, melting: float, frozen: tuple[float, float], molten: tuple[float, float],
    latent: float,
) -> float:  # fmt: skip
    """λ of a front that freezes from a cold wall (Neumann; Carslaw and Jaeger 1959, 11.2).

    wall, start, melting: K. frozen, molten: conductivity W/(m K) and diffusivity m²/s. latent: J/m³.
    """
    (k1, a1), (k2, a2) = frozen, molten
    ratio = math.sqrt(a1 / a2)

    def excess(x: float) -> float:
        gain = k1 * (melting - wall) * elementary.exp(-x * x) / (math.sqrt(math.pi * a1) * elementary.erf(x))
        loss = k2 * (start - melting) * elementary.exp(-(elementary.square(x * ratio)))
        beyond = max(1.0 - elementary.erf(x * ratio), LEAST_BEYOND)
        loss /= math.sqrt(math.pi * a2) * beyond
        return latent * x * math.sqrt(a1) - gain + loss

    return _root(excess, LEAST_ROOT, 5.0)


def slab_centre(fourier: float) -> float:
    """Temperature in the middle of a slab -L to L that was 1, its surfaces at 0, at Fo = α t / L²."""
    terms = ((2 * n + 1, 1 - 2 * (n % 2)) for n in range(200))
    return sum(
        4.0 * s / (math.pi * n) * elementary.exp(-(elementary.square(n * math.pi / 2.0)) * fourier)
        for n, s in terms
    )


def flux_rise(flux: float, conductivity: float, capacity: float, time: float) -> float:
    """Rise (K) of a half space's surface under a flux W/m² after a time s: 2 q √(α t / π) / k; capacity J/(m³
    K).
    """
    return 2.0 * flux * math.sqrt(conductivity / capacity * time / math.pi) / conductivity


def ignition_time(flux: float, conductivity: float, capacity: float, rise: float) -> float:
    """Time (s) until a thick solid's surface has risen so many K under a flux: π/4 k C (ΔT / q)² (Quintiere
    2006).
    """
    return 0.25 * math.pi * conductivity * capacity * elementary.square(rise / flux)


def fisher_speed(diffusivity: float, rate: float) -> float:
    """Speed 2 √(D k) (m/s) of the front of u_t = D u_xx + k u (1 - u) after a long time (Fisher 1937)."""
    return 2.0 * math.sqrt(diffusivity * rate)


def fisher_speed_on_grid(diffusivity: float, rate: float, cell: float, dt: float) -> float:
    """Speed (m/s) of that front on a grid by explicit Euler: the least ln(1 + dt (k + 2 D (cosh q h - 1) /
    h²)) / q dt over q (a pulled front; van Saarloos 2003), which is found by thirds.
    """

    def speed(q: float) -> float:
        growth = rate + diffusivity * (elementary.expm1(q * cell) + elementary.expm1(-q * cell)) / (
            cell * cell
        )
        return elementary.log1p(dt * growth) / (q * dt)

    wide = math.sqrt(rate / diffusivity)
    low, high = 0.05 * wide, 20.0 * wide
    high = min(high, 300.0 / cell)
    for _ in range(200):
        a, b = low + (high - low) / 3.0, high - (high - low) / 3.0
        low, high = (low, b) if speed(a) < speed(b) else (a, high)
    return speed(0.5 * (low + high))


def ignition_speed(diffusivity: float, rate: float, threshold: float) -> float:
    """Speed √(D k / 2) (1 - 2 a) (m/s) of the front of u_t = D u_xx + k u (1 - u)(u - a) (Nagumo and others
    1962).
    """
    return math.sqrt(0.5 * diffusivity * rate) * (1.0 - 2.0 * threshold)


def self_heating_limit(shape: str) -> float:
    """Critical δ of T'' + δ exp T = 0 (Frank-Kamenetskii 1939): "slab" of half width 1, "disc" of radius
    1.
    """
    if shape == "disc":
        return 2.0
    if shape != "slab":
        raise ValueError(f"shape = {shape!r}: expected slab or disc")
    steepest = _root(lambda x: x * elementary.tanh(x) - 1.0, 0.5, 2.0)  # of 2 (y / cosh y)²
    return 2.0 * elementary.square(2.0 * steepest / (elementary.exp(steepest) + elementary.exp(-steepest)))

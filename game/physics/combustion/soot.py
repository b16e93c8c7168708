"""How soot burns off in hot gas with oxygen: the rate of Nagle and Strickland-Constable."""

from __future__ import annotations

from typing import Any

from game.compiler.decorator import lean_kernel
from game.physics.kernels import elementary

GAS_CONSTANT = 8.314462618  # J/(mol K)
CALORIES = 1.98720425864  # cal/(mol K), the same constant as the law of 1962 has it
MOLAR, ATMOSPHERE = 0.031999, 101325.0  # kg/mol of oxygen; Pa
CARBON, DENSITY = 120.11, 1800.0  # kg/(m² s) for a mol/(cm² s); kg/m³ of soot


@lean_kernel
def soot_loss(kelvin: Any, pressure: Any) -> Any:
    """Carbon in kg/(m² s) that burns off a surface of soot (Nagle and Strickland-Constable 1962).

    kelvin K; pressure: partial pressure of oxygen, atm. Of the surface, sites A react by kA p / (1 + kZ p),
    the others by kB p; heat turns A into B at a rate kT.
    """
    if pressure <= 0.0:
        return 0.0
    heat = CALORIES * kelvin
    ka, kb = 20.0 * elementary.exp(-30000.0 / heat), 4.46e-3 * elementary.exp(-15200.0 / heat)
    kt, kz = 1.51e5 * elementary.exp(-97000.0 / heat), 21.3 * elementary.exp(4100.0 / heat)
    active = kb * pressure / (kb * pressure + kt)
    return CARBON * (ka * pressure / (1.0 + kz * pressure) * active + kb * pressure * (1.0 - active))


@lean_kernel
def soot_rate_of(kelvin: Any, oxygen: Any, size: Any) -> Any:
    """1/s at which balls of soot of a diameter (m) lose mass at a temperature (K), in oxygen kg/m³."""
    pressure = oxygen * GAS_CONSTANT * kelvin / (MOLAR * ATMOSPHERE)
    return soot_loss(kelvin, pressure) * 6.0 / (DENSITY * size)

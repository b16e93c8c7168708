"""Melting and boiling by enthalpy: what is stored is heat per volume, and temperature follows from it.

A solid warms with capacity C_s up to T_m, takes the latent heat L_m there, warms on as a liquid with C_l up
to T_b, takes L_b, and warms with C_g beyond (Voller and Cross 1981). Heat moves by fluxes between the
temperatures of cells. So the sum of heat is kept whatever melts, and no temperature passes a plateau before
its heat is paid.
"""

from __future__ import annotations

from typing import NamedTuple

from game.compiler.decorator import inner_kernel, lean_kernel


class Phases(NamedTuple):
    """A material in three phases; J/(m³ K), J/m³, K, W/(m K). Heat is counted from 0 K."""

    solid: float
    liquid: float
    gas: float
    melting: float
    boiling: float
    melting_heat: float
    boiling_heat: float
    solid_k: float
    liquid_k: float
    gas_k: float


@inner_kernel
def _temperature(heat, m):
    """Temperature K, share that is no longer solid, share that has boiled, of a heat J/m³."""
    solid = m.solid * m.melting
    if heat <= solid:
        return heat / m.solid, 0.0, 0.0
    molten = solid + m.melting_heat
    if heat < molten:
        return m.melting, (heat - solid) / m.melting_heat, 0.0
    hot = molten + m.liquid * (m.boiling - m.melting)
    if heat <= hot:
        return m.melting + (heat - molten) / m.liquid, 1.0, 0.0
    if heat < hot + m.boiling_heat:
        return m.boiling, 1.0, (heat - hot) / m.boiling_heat
    return m.boiling + (heat - hot - m.boiling_heat) / m.gas, 1.0, 1.0


@lean_kernel
def temperatures_of(heat, m, temperature, molten, boiled):
    """Write temperature and the shares of both changes of phase for heat (ny, nx) J/m³."""
    for j in range(heat.shape[0]):
        for i in range(heat.shape[1]):
            temperature[j, i], molten[j, i], boiled[j, i] = _temperature(heat[j, i], m)


@inner_kernel
def _conductivity(molten, boiled, m):
    """By share, the phases in a row one behind the other: their resistances add."""
    return 1.0 / ((1.0 - molten) / m.solid_k + (molten - boiled) / m.liquid_k + boiled / m.gas_k)


@inner_kernel
def _face(j, i, jj, ii, molten, boiled, m):
    """W/(m K) between two cells, the harmonic mean of theirs; one that changes its phase counts as its
    neighbour does: the front lies somewhere in it, and up to there is nothing else.
    """
    a = _conductivity(molten[j, i], boiled[j, i], m)
    b = _conductivity(molten[jj, ii], boiled[jj, ii], m)
    first = 0.0 < molten[j, i] < 1.0 or 0.0 < boiled[j, i] < 1.0
    second = 0.0 < molten[jj, ii] < 1.0 or 0.0 < boiled[jj, ii] < 1.0
    if first != second:
        return b if first else a
    return 2.0 * a * b / (a + b)


@lean_kernel
def join_phases(molten, boiled, m, part, is_held, gx, gy):
    """Write face conductances W/(m³ K); part: 1 / cell². Edges that are held: see `conduction`."""
    ny, nx = molten.shape
    for j in range(ny):
        gx[j, 0] = 2.0 * part * is_held[0] * _conductivity(molten[j, 0], boiled[j, 0], m)
        gx[j, nx] = 2.0 * part * is_held[1] * _conductivity(molten[j, nx - 1], boiled[j, nx - 1], m)
        for i in range(1, nx):
            gx[j, i] = part * _face(j, i - 1, j, i, molten, boiled, m)
    for i in range(nx):
        gy[0, i] = 2.0 * part * is_held[2] * _conductivity(molten[0, i], boiled[0, i], m)
        gy[ny, i] = 2.0 * part * is_held[3] * _conductivity(molten[ny - 1, i], boiled[ny - 1, i], m)
        for j in range(1, ny):
            gy[j, i] = part * _face(j - 1, i, j, i, molten, boiled, m)


@lean_kernel
def add_flow(heat, flow, dt):
    """Heat (ny, nx) J/m³ takes a flow W/m³ for dt s."""
    for j in range(heat.shape[0]):
        for i in range(heat.shape[1]):
            heat[j, i] += dt * flow[j, i]

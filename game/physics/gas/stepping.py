"""One step of a gas, in the order of Stam 1999: carry, diffuse, push, drag, project.

Scalars diffuse for half of the step before they are carried, and for half after it (Strang 1968).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.gas import ledger as le
from game.physics.gas.arrays import SETTLED, GasState, Room
from game.physics.gas.carrying import (
    CUBIC,
    LIMITED,
    LINEAR,
    carry_beside_walls,
    carry_scalars,
    carry_u,
    carry_v,
)
from game.physics.gas.densities import carry_in_flux_form
from game.physics.gas.diffusion import STABLE, diffuse
from game.physics.gas.effects import (
    ADVECTION,
    BUOYANCY,
    CONFINEMENT,
    DIFFUSION,
    EXPANSION,
    PRESSURE,
    VISCOSITY,
)
from game.physics.gas.forces import Pushed, cell_forces, confine, face_forces, push, push_cells
from game.physics.gas.ledger import Ledger
from game.physics.gas.maccormack import correct_face, correct_scalars
from game.physics.gas.padding import extend, pad_field, pad_scalars, pad_u, pad_v
from game.physics.gas.projection import (
    pressure_ghosts,
    right_side,
    right_side_free,
    set_closed_faces,
    subtract_gradient,
)
from game.physics.gas.settings import GasSettings
from game.physics.gas.solids import GasSolids
from game.physics.gas.tracing import centre_velocities, largest_speed, stop_at_walls, trace
from game.physics.gas.viscosity import add_laplacian, diffuse_velocity, steepest, turns_for
from game.physics.grid import Edges
from game.physics.grid.borders import INFLOW, NO_SLIP, WALL
from game.physics.grid.ghosts import X, Y, fill_scalar_ghosts, fill_velocity_ghosts, set_side_velocities
from game.physics.grid.obstacles import LAYERS
from game.physics.multigrid import Found, PressureSolver

FAR, FARTHER = 8.0, 16.0  # cells in a step from which on q grows, and at which it is 1


class Step(NamedTuple):
    """What a step is made with."""

    h: float  # m, cell
    dt: float  # s
    settings: GasSettings
    edges: Edges
    held: NDArray[np.bool_]  # (4, fields) whether a side holds the value
    values: Floats  # (4, fields)
    fields: tuple[str, ...]
    ambient: Floats  # (fields,)
    ledger: Ledger | None = None


def advance(
    s: GasState, room: Room, solver: PressureSolver, solids: GasSolids, sources: tuple[Floats, Floats,
    Floats], step: Step,
) -> tuple[Found, float]:  # fmt: skip
    """One step; sources: expansion, force, rates. What the pressure solver did, and the centring q."""
    chosen = step.settings
    centred = chosen.advection == "time-centred"
    settled = s.clock[SETTLED] > 0.0
    if centred and chosen.prime and not settled and PRESSURE in chosen.effects:
        _prime(s, room, solver, solids, sources, step)
        settled = True
    q = _centring(s, step) if centred and settled else 1.0
    return _advance(s, room, solver, solids, sources, step, q, 0.5 if centred and settled else 0.0)


def _centring(s: GasState, step: Step) -> float:
    """q for this step: as chosen, but towards 1 where gas would go very far in it.

    A way of many cells is straight where the gas turns, so the old pressure is carried to where it does not
    belong: past a disc the time-centred step then drives a wind of 5 m/s to 32.
    """
    q, way = step.settings.centring, largest_speed(s.u, s.v) * step.dt / step.h
    far = min(max((way - FAR) / (FARTHER - FAR), 0.0), 1.0)
    return q + (1.0 - q) * far


def _prime(s, room, solver, solids, sources, step):
    """A step whose pressure and forces alone are kept."""
    kept = [array.copy() for array in (s.u, s.v, s.scalars)]
    _advance(s, room, solver, solids, sources, step._replace(ledger=None), 1.0, 0.0)
    for array, old in zip((s.u, s.v, s.scalars), kept, strict=True):
        array[:] = old
    s.before_u[:], s.before_v[:] = s.u, s.v


def _advance(s, room, solver, solids, sources, step, q, ahead):
    expansion, force, rates = sources
    effects, dt, book = step.settings.effects, step.dt, step.ledger
    if book is not None:
        book.begin(s.u, s.v, s.scalars, solids.faces, _kept(step) | (not step.settings.carries_fields))
    if ADVECTION in effects:
        _find_ways(s, room, solids, step, ahead)
    carries = step.settings.carries_fields and ADVECTION in effects
    keeps = bool(step.settings.conservative) and carries
    spreads = DIFFUSION in effects
    if spreads:
        _diffuse(s, room, solids, step, 0.5 * dt)
    if book is not None:
        book.see_fields(le.LADEN, s.scalars)
    conserved = _conserve(s, room, solids, step, rates) if keeps else None
    _carry_velocity(s, room, solids, step, (1.0 - q) * dt, ADVECTION in effects)
    _carry_scalars(s, room, solids, step, rates, carries)
    if conserved is not None:
        s.scalars[:, :, _kept(step)] = conserved
    if book is not None:
        book.see(le.CARRIED, s.u, s.v)
        book.see_fields(le.CARRIED, s.scalars)
        book.source(dt, rates)
    if spreads:
        _diffuse(s, room, solids, step, 0.5 * dt)
    _push(s, room, step, force, q * dt)
    if book is not None:
        book.force(q * dt, s.force_u, s.force_v)
        book.see(le.PUSHED, s.u, s.v)
    if VISCOSITY in effects and step.settings.viscosity > 0.0:
        _drag(s, room, solids, step, q)
    if book is not None:
        book.see(le.DRAGGED, s.u, s.v)
    set_side_velocities(s.u, s.v, step.edges)
    if solids.present:
        set_closed_faces(s.u, s.v, solids.faces)
    if book is not None:
        book.see(le.STOPPED, s.u, s.v)
    found = Found(0, 0.0, 0.0)
    if PRESSURE in effects:
        grows = expansion if EXPANSION in effects else np.zeros_like(expansion)
        found = _project(s, solver, solids, step, grows, q)
    if VISCOSITY in effects and step.settings.viscosity > 0.0:
        _add_drag(s, room, solids, step)
    if book is not None:
        book.close(s.u, s.v, s.scalars)
    return found, q


def _find_ways(s: GasState, room: Room, solids: GasSolids, step: Step, ahead: float) -> None:
    """Displacements of all cells, by the velocity half a step ahead if ahead is 0.5."""
    scale, kinds = step.dt / step.h, step.edges.kinds
    centre_velocities(s.u, s.v, s.before_u, s.before_v, ahead, room.centre)
    straight = step.settings.advection == "stam-1999"
    trace(room.centre, scale, kinds, straight, room.shift)
    if step.settings.advection == "maccormack":
        trace(room.centre, -scale, kinds, straight, room.back)
    if solids.present:
        stop_at_walls(room.shift, solids.faces.clear, solids.faces.ax, solids.faces.ay, kinds)
        if step.settings.advection == "maccormack":
            stop_at_walls(room.back, solids.faces.clear, solids.faces.ax, solids.faces.ay, kinds)


def _carry_velocity(
    s: GasState, room: Room, solids: GasSolids, step: Step, part: float, carried: bool
) -> None:
    """Velocities with the explicit part of the step, from where the gas comes."""
    edges, faces, slip = step.edges, solids.faces, step.settings.slip
    slope = part / step.h
    pressure_ghosts(s.pressure, edges.kinds, True)
    pad_u(s.u, s.force_u, s.pressure, part, slope, s.before_u, room.pad_u)
    pad_v(s.v, s.force_v, s.pressure, part, slope, s.before_v, room.pad_v)
    if step.ledger is not None:
        step.ledger.force(part, s.force_u, s.force_v)
        step.ledger.press(part, s.pressure)
        step.ledger.see(le.LADEN, room.pad_u[2:-2, 2:-2], room.pad_v[2:-2, 2:-2])
    if solids.present:
        _set_padded_solids(room, faces, slip)
    fill_velocity_ghosts(room.pad_u, X, edges)
    fill_velocity_ghosts(room.pad_v, Y, edges)
    inner_u, inner_v = room.pad_u[2:-2, 2:-2], room.pad_v[2:-2, 2:-2]
    if not carried:
        s.u[:], s.v[:] = inner_u, inner_v
        return
    how = {"time-centred": CUBIC, "cubic": LIMITED}.get(step.settings.advection, LINEAR)
    carry_u(room.pad_u, room.shift, 1.0, edges.kinds, how, s.u)
    carry_v(room.pad_v, room.shift, 1.0, edges.kinds, how, s.v)
    if step.settings.advection == "maccormack":
        pad_field(s.u, room.other_u)
        pad_field(s.v, room.other_v)
        fill_velocity_ghosts(room.other_u, X, edges)
        fill_velocity_ghosts(room.other_v, Y, edges)
        carry_u(room.other_u, room.back, 1.0, edges.kinds, LINEAR, room.way_u)
        carry_v(room.other_v, room.back, 1.0, edges.kinds, LINEAR, room.way_v)
        correct_face(room.pad_u, room.shift, edges.kinds, 0, room.way_u, s.u)
        correct_face(room.pad_v, room.shift, edges.kinds, 1, room.way_v, s.v)


def _set_padded_solids(room: Room, faces, slip: bool) -> None:
    """In closed faces the gas's own velocity goes on if it slips, else the solid's is there."""
    closed_u, closed_v = faces.layer_u > 0, faces.layer_v > 0
    room.pad_u[2:-2, 2:-2][closed_u] = faces.u[closed_u]
    room.pad_v[2:-2, 2:-2][closed_v] = faces.v[closed_v]
    if slip:
        extend(room.pad_u, faces.layer_u, LAYERS)
        extend(room.pad_v, faces.layer_v, LAYERS)


def _carry_scalars(
    s: GasState, room: Room, solids: GasSolids, step: Step, rates: Floats, carried: bool
) -> None:
    """Scalars with their sources, from where the gas comes."""
    kinds, faces = step.edges.kinds, solids.faces
    pad_scalars(s.scalars, rates, step.dt, room.pad_s)
    fill_scalar_ghosts(room.pad_s, kinds, step.held, step.values)
    if ADVECTION in step.settings.effects and step.ledger is not None:
        step.ledger.flow(step.dt, s.before_u, s.before_v, room.pad_s)
    if not carried:
        s.scalars[:] = room.pad_s[2:-2, 2:-2]
        return
    plain = step.settings.advection in ("stam-1999", "linear", "maccormack")
    how = LINEAR if plain else LIMITED
    carry_scalars(room.pad_s, room.shift, 1.0, kinds, how, s.scalars)
    if step.settings.advection == "maccormack":
        room.other_s[2:-2, 2:-2] = s.scalars
        fill_scalar_ghosts(room.other_s, kinds, step.held, step.values)
        carry_scalars(room.other_s, room.back, 1.0, kinds, LINEAR, room.way_s)
        correct_scalars(room.pad_s, room.shift, kinds, room.way_s, s.scalars)
    if solids.present:
        carry_beside_walls(room.pad_s, room.shift, 1.0, kinds, faces.clear, faces.ax, faces.ay, s.scalars)


def _conserve(s: GasState, room: Room, solids: GasSolids, step: Step, rates: Floats) -> Floats:
    """Fields that are kept, carried in flux form by the velocity that the step begins with (free of
    divergence), with their sources: (ny, nx, kept fields).
    """
    kept, book = _kept(step), step.ledger
    inner = room.pad_s[2:-2, 2:-2]
    inner[:] = s.scalars

    def see(padded: Floats, count: int) -> None:
        if book is not None:
            book.flux(0.5 * step.dt / count, s.u, s.v, padded)

    sides = step.edges.kinds, step.held, step.values
    rooms = room.pad_s, room.way_s, room.stage_s
    carry_in_flux_form(rooms, (s.u, s.v, solids.faces), sides, kept, step.dt / step.h, see)
    return np.asarray(inner[:, :, kept] + step.dt * rates[:, :, kept])


def _kept(step: Step) -> NDArray[np.bool_]:
    return np.array([name in step.settings.conservative for name in step.fields])


def _diffuse(s: GasState, room: Room, solids: GasSolids, step: Step, dt: float) -> None:
    """Scalars spread for dt, by Heun's rule in substeps that are stable.

    Half of it comes before what is carried and half after (Strang 1968). In one piece, heat that rises would
    have spread a step too far. A layer heated from below would begin to turn too late by a first order in the
    step.
    """
    given = step.settings.diffusivity
    if isinstance(given, Mapping):
        each = np.array([given.get(name, 0.0) for name in step.fields])
    else:
        each = np.full(len(step.fields), given)
    largest = float(np.max(each)) * dt / (step.h * step.h)
    if largest <= 0.0:
        return
    substeps = math.ceil(largest / STABLE)
    strength = each * (dt / (step.h * step.h) / substeps)
    for _ in range(substeps):
        begun = s.scalars.copy()
        for _ in range(2):
            room.pad_s[2:-2, 2:-2] = s.scalars
            fill_scalar_ghosts(room.pad_s, step.edges.kinds, step.held, step.values)
            if step.ledger is not None:
                step.ledger.spread(0.5 * strength, room.pad_s)
            diffuse(s.scalars, room.pad_s, solids.faces.ax, solids.faces.ay, strength)
        s.scalars[:] = 0.5 * (begun + s.scalars)


def _push(s: GasState, room: Room, step: Step, force: Floats, dt: float) -> None:
    """Forces on faces, from the fields as they are now, and what they do in dt."""
    chosen, names, kinds = step.settings, step.fields, step.edges.kinds
    lifts = BUOYANCY in chosen.effects
    weights = np.array([
        float(names.index("temperature")) if lifts and "temperature" in names else -1.0,
        float(names.index("smoke")) if lifts and "smoke" in names else -1.0,
    ])  # fmt: skip
    gravity = np.array([*chosen.gravity, chosen.smoke_weight, chosen.ambient])
    if CONFINEMENT in chosen.effects and chosen.confinement > 0.0:
        cell_forces(s.scalars, force, weights, gravity, room.centre)
        confine(s.u, s.v, chosen.confinement, kinds, room.curl, room.centre)
        face_forces(room.centre, kinds, s.force_u, s.force_v)
        push(s.u, s.v, s.force_u, s.force_v, dt)
    else:
        moves = Pushed(s.u, s.v, s.force_u, s.force_v)
        push_cells(s.scalars, force, weights, gravity, room.centre, kinds, moves, dt)


def _free_sides(free_u: Floats, free_v: Floats, edges: Edges) -> None:
    """Velocities through sides that are given do not change by drag."""
    fixed = [kind in (WALL, NO_SLIP, INFLOW) for kind in edges.kinds]
    for side, view in enumerate((free_u[:, 0], free_u[:, -1], free_v[0], free_v[-1])):
        if fixed[side]:
            view[:] = 0.0


def _drag(s: GasState, room: Room, solids: GasSolids, step: Step, q: float) -> None:
    """The implicit part of viscosity."""
    drag, edges = solids.drag, step.edges
    strength = q * step.settings.viscosity * step.dt / (step.h * step.h)
    set_side_velocities(s.u, s.v, edges)
    if solids.present:
        set_closed_faces(s.u, s.v, solids.faces)
        solids.set_slip(step.settings.slip)
    _free_sides(drag.free_u, drag.free_v, edges)
    steep = steepest(edges.kinds)
    numbers = np.array([strength, turns_for(strength, steep), steep])
    diffuse_velocity(s.u, room.pad_u, room.other_u, room.way_u, drag.gain_u, drag.free_u, X, edges, numbers)
    diffuse_velocity(s.v, room.pad_v, room.other_v, room.way_v, drag.gain_v, drag.free_v, Y, edges, numbers)


def _add_drag(s: GasState, room: Room, solids: GasSolids, step: Step) -> None:
    """Viscosity's force at the end of the step belongs to the forces that the next one carries."""
    part = step.settings.viscosity / (step.h * step.h)
    pad_field(s.u, room.pad_u)
    pad_field(s.v, room.pad_v)
    fill_velocity_ghosts(room.pad_u, X, step.edges)
    fill_velocity_ghosts(room.pad_v, Y, step.edges)
    add_laplacian(room.pad_u, solids.drag.gain_u, part, s.force_u)
    add_laplacian(room.pad_v, solids.drag.gain_v, part, s.force_v)
    np.multiply(s.force_u, solids.drag.free_u, out=s.force_u)
    np.multiply(s.force_v, solids.drag.free_v, out=s.force_v)


def _project(
    s: GasState, solver: PressureSolver, solids: GasSolids, step: Step, expansion: Floats, q: float
) -> Found:
    """The pressure that leaves only the divergence asked for, and its gradient taken out."""
    h, dt, chosen = step.h, step.dt, step.settings
    scale = h / (q * dt)
    if solids.present:
        right_side(s.u, s.v, solids.faces, expansion, h, scale, solver.equation.b)
    else:
        right_side_free(s.u, s.v, expansion, h, scale, solver.equation.b)
    pressure_ghosts(s.pressure, step.edges.kinds, False)
    found = solver.solve(chosen.pressure, chosen.turns, chosen.tolerance * h * h / (q * dt * dt))
    pressure_ghosts(s.pressure, step.edges.kinds, True)
    subtract_gradient(s.u, s.v, s.pressure, q * dt / h)
    if step.ledger is not None:
        step.ledger.press(q * dt, s.pressure)
    set_side_velocities(s.u, s.v, step.edges)
    if solids.present:
        set_closed_faces(s.u, s.v, solids.faces)
    return found

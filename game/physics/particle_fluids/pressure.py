"""Pressures that leave no liquid squeezed: DFSPH with warm start (Bender and Koschier 2015, 2017).

Two systems share a matrix. One asks for velocities under which no density grows beyond rest. The other asks
for densities that are at most those of rest after the step. Pressures pull nowhere, so both are problems of
complementarity. Here they are solved by projected Jacobi steps with momentum (Nesterov 1983). It is dropped
whenever it points uphill (O'Donoghue and Candès 2015). Of a column of 40 layers, 25 of these come as near as
160 plain ones. The first system begins with the pressures of the step before. The second only moves places
here: in the print it changes velocities, and errors of packing become motion.

Two things are ours, and liquids of very different densities need both. Steps are divided by a bound of the
matrix, not by its diagonal. Walls stop velocities within the iterations: what is stopped only afterwards
lets a light particle be pressed into a wall, as that relieves heavy ones at the least cost.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.physics.particle_fluids.sums import fill_rates, push_by_pressure
from game.physics.particle_fluids.walls import stop_at_walls

LEAST_MADE = 2
LOOSE, CLOSING = 0.2, 0.1  # lack of density up to which gaps close in steps, share of them in a step
EASED = 0.05  # of an excess of density that a step takes away: places move by more than is linear otherwise


class Work(NamedTuple):
    """Scratch arrays of n rows: two of vectors, four of numbers."""

    pushed: Floats
    total: Floats
    rate: Floats
    response: Floats
    density: Floats
    last: Floats


@lean_kernel
def relieve(pairs, felt, body, contacts, velocity, pressure, work, rules):
    """Change velocities (n, 2) so that no density grows beyond 1; pressures (n,) Pa stay for the next step.

    contacts: walls that stop velocities; work.response: the bound of the matrix, as `fill_bound` has it.
    rules: (dt, error, iterations, growth). error: root mean square excess of density at which it ends.
    growth: 0 asks besides that a share of what is above 1 goes. Returns iterations made and the error left.
    """
    dt, allowed, most, growth = rules
    count, made, error = len(pressure), 0, 0.0
    density, response = work.density, work.response
    wanted = 0
    for i in range(count):
        wanted += body.light[i] > 0.0
    for i in range(count):
        work.last[i] = pressure[i]
    speed = 1.0
    while True:
        push_by_pressure(pairs, felt, body, pressure, work.pushed)
        for i in range(count):
            work.total[i, 0] = velocity[i, 0] + dt * work.pushed[i, 0]
            work.total[i, 1] = velocity[i, 1] + dt * work.pushed[i, 1]
        stop_at_walls(work.total, contacts, dt)
        fill_rates(pairs, felt, body, work.total, work.rate)
        error = 0.0
        for i in range(count):
            loose = min(density[i] - 1.0, 0.0)
            excess = dt * work.rate[i] + min(CLOSING * loose, loose + LOOSE)
            if growth == 0:
                excess += EASED * max(density[i] - 1.0, 0.0)
            if body.light[i] > 0.0:
                error += max(excess, 0.0) * max(excess, 0.0)
            work.rate[i] = excess
        error = math.sqrt(error / max(wanted, 1))
        if made >= most or (made >= LEAST_MADE and error <= allowed):
            break
        uphill = 0.0
        for i in range(count):  # the pressure here is ahead of the iterate by the momentum
            if body.light[i] > 0.0 and response[i] > 0.0:
                next_one = max(pressure[i] + work.rate[i] / (dt * dt * response[i]), 0.0)
                uphill += (pressure[i] - next_one) * (next_one - work.last[i]) * response[i]
                work.rate[i] = next_one
        faster = 0.5 * (1.0 + math.sqrt(1.0 + 4.0 * speed * speed))
        ahead = (speed - 1.0) / faster
        speed = faster
        if uphill > 0.0:
            speed, ahead = 1.0, 0.0
        for i in range(count):
            if body.light[i] > 0.0 and response[i] > 0.0:
                pressure[i] = max(work.rate[i] + ahead * (work.rate[i] - work.last[i]), 0.0)
                work.last[i] = work.rate[i]
        made += 1
    for i in range(count):
        if body.light[i] > 0.0:
            velocity[i, 0], velocity[i, 1] = work.total[i, 0], work.total[i, 1]
    return made, error

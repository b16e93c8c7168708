"""Resting contacts: after the forces have acted, impulses that stop what still approaches.

Accumulated and clamped, so that they only push and friction stays within mu times that, and warm started
(Catto 2005, "Iterative dynamics with temporal coherence"). Arrays as in contact_rows.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.spheres import contact_rows
from game.physics.spheres import contacts as c
from game.physics.spheres.contact_rows import (  # fmt: skip
    normal_speed,
    push_along,
    push_bodies,
    rest_speed,
    slip_of,
)

STRIDE = 4  # contacts are swept in strides, so that one need not wait for the result of the one before


@inner_kernel
def pass_over(work, contacts, count, rows, numbers):
    """After the collisions: a gap that is closing too fast to be borne takes no part until it has closed."""
    for m in range(count):
        contact, row = contacts.normals[m], rows[m]
        if contact[c.GAP] > 0.0 and row[contact_rows.BIAS] < 0.0:
            speed = normal_speed(
                work, row, contact, contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
            )
            if speed < -rest_speed(row[contact_rows.REBOUND], numbers):
                contact[c.GAP] = c.FAR
                row[contact_rows.BIAS] = -c.FAR / numbers.h
                row[contact_rows.JN] = row[contact_rows.JTX] = row[contact_rows.JTY] = row[
                    contact_rows.JTZ
                ] = 0.0


@inner_kernel
def start_warm(work, contacts, count, rows):
    """Begin with the impulses of the last step."""
    for m in range(count):
        row = rows[m]
        a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
        if row[contact_rows.JN] > 0.0:
            push_along(work, row, contacts.normals[m], a, b, row[contact_rows.JN])
            push_bodies(work, row, a, b, row[contact_rows.JTX], row[contact_rows.JTY], row[contact_rows.JTZ])


@inner_kernel
def sweep_rows(work, contacts, count, rows):
    """One sweep over all contacts: normal impulses that only push, friction within mu times that."""
    for first in range(STRIDE):
        for m in range(first, count, STRIDE):
            contact, row = contacts.normals[m], rows[m]
            a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
            speed = normal_speed(work, row, contact, a, b)
            j = max(
                row[contact_rows.JN]
                - (speed - row[contact_rows.BIAS]) * row[contact_rows.MASS]
                - row[contact_rows.SOFT] * row[contact_rows.JN],
                0.0,
            )
            if j != row[contact_rows.JN]:
                push_along(work, row, contact, a, b, j - row[contact_rows.JN])
                row[contact_rows.JN] = j
            if row[contact_rows.MU] <= 0.0:
                continue
            ux, uy, uz, slip, mass = slip_of(work, row, contact, a, b)
            x, y, z = (
                row[contact_rows.JTX] - mass * ux,
                row[contact_rows.JTY] - mass * uy,
                row[contact_rows.JTZ] - mass * uz,
            )
            size = math.sqrt(x * x + y * y + z * z)
            most = row[contact_rows.MU] * j
            if size > most:
                x *= most / size
                y *= most / size
                z *= most / size
            if slip > 0.0 or size > most:
                push_bodies(
                    work,
                    row,
                    a,
                    b,
                    x - row[contact_rows.JTX],
                    y - row[contact_rows.JTY],
                    z - row[contact_rows.JTZ],
                )
                row[contact_rows.JTX], row[contact_rows.JTY], row[contact_rows.JTZ] = x, y, z


@inner_kernel
def harden_rows(count, rows):
    """Take softness and push back out of the rows: what follows removes the speed they gave."""
    for m in range(count):
        row = rows[m]
        row[contact_rows.MASS] /= 1.0 - row[contact_rows.SOFT]
        row[contact_rows.SOFT] = 0.0
        row[contact_rows.BIAS] = min(row[contact_rows.BIAS], 0.0)


@inner_kernel
def keep_impulses(contacts, count, rows):
    """Impulses for the next step."""
    for m in range(count):
        for column in range(4):
            contacts.impulses[m, column] = rows[m, contact_rows.JN + column]

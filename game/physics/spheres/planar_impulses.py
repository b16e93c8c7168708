"""The same impulses for single spheres that move in a plane: a few times quicker, for thousands of discs.

A sphere's normal impulse does not turn it, and friction has one direction in the plane, so a contact takes
three velocities of each body. All that a contact needs of a body lies in one line of the cache.

Arrays: flat (n + 1, FLAT_COLUMNS), rows (count, PLANAR_COLUMNS); positions, momenta, spins (n, 3); contacts:
`Contacts`.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.spheres import contacts as c
from game.physics.spheres.contact_rows import STILL, STRING, TOUCHING, rest_speed
from game.physics.spheres.resting_contacts import STRIDE

# columns of a body: velocity, turning, inverse mass, radius, radius times inverse inertia, displacement
VX, VY, TURN, WEIGHT, RADIUS, LEVER, WAY_X, WAY_Y = range(8)
FLAT_COLUMNS = 8
# columns of a row: normal, least separating speed to reach, effective masses along and across the normal,
# softness, friction, impulses along and across, arms over radii, restitution, impulses of collisions
PX, PY, BIAS, MASS, SLIDE, SOFT, MU, JN, JT, ARMS, REBOUND, HIT, HIT_T = range(13)
PLANAR_COLUMNS = 13


@lean_kernel
def lies_in_plane(positions, momenta, spins):
    """True if nothing leaves the plane z = constant or turns but about its normal."""
    if positions.shape[0] == 0:
        return False
    z = positions[0, 2]
    out = 0
    for i in range(positions.shape[0]):
        out += (positions[i, 2] != z) | (momenta[i, 2] != 0.0) | (spins[i, 0] != 0.0) | (spins[i, 1] != 0.0)
    return out == 0


@inner_kernel
def flatten_bodies(state, composition, flat):
    """What contacts need of bodies, (n + 1, FLAT_COLUMNS) written; the last one is what nothing moves."""
    n = composition.masses.shape[0]
    flat[n, :] = 0.0
    for i in range(n):
        weight = 1.0 / composition.masses[i]
        inverse = composition.inverse_inertias[i, 0]
        flat[i, VX] = state.momenta[i, 0] * weight
        flat[i, VY] = state.momenta[i, 1] * weight
        flat[i, TURN] = state.spins[i, 2] * inverse
        flat[i, WEIGHT] = weight
        flat[i, RADIUS] = composition.radii[i]
        flat[i, LEVER] = composition.radii[i] * inverse


@inner_kernel
def keep_motion(state, composition, flat):
    """Momenta from what velocities have become."""
    for i in range(composition.masses.shape[0]):
        if flat[i, WEIGHT] > 0.0:
            state.momenta[i, 0] = composition.masses[i] * flat[i, VX]
            state.momenta[i, 1] = composition.masses[i] * flat[i, VY]
            state.spins[i, 2] = flat[i, TURN] / composition.inverse_inertias[i, 0]


@inner_kernel
def turn_flat(orientations, flat, h):
    """Orientations after h (s) of Euler's step about the normal, at length 1."""
    for i in range(orientations.shape[0]):
        k = 0.5 * h * flat[i, TURN]
        w, x, y, z = orientations[i, 0], orientations[i, 1], orientations[i, 2], orientations[i, 3]
        w, x, y, z = w - k * z, x - k * y, y + k * x, z + k * w
        scale = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
        orientations[i, 0] = w * scale
        orientations[i, 1] = x * scale
        orientations[i, 2] = y * scale
        orientations[i, 3] = z * scale


@inner_kernel
def prepare_planar(world, flat, contacts, count, rows, numbers):
    """Rows of contacts (count, PLANAR_COLUMNS) written; returns the fastest approach that bounces, m/s."""
    composition, tables, held = world.composition, world.tables, contacts.impulses
    fastest = 0.0
    last = tables.restitution.shape[0] - 1
    for m in range(count):
        a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
        nx, ny, gap = contacts.normals[m, c.NX], contacts.normals[m, c.NY], contacts.normals[m, c.GAP]
        other = contacts.spheres[m, c.SECOND]
        mine = composition.kinds[contacts.spheres[m, c.FIRST]]
        kind = composition.kinds[other] if other >= 0 else last
        real = 0.0 if other == STRING else 1.0
        e = tables.restitution[mine, kind] * real
        weight = flat[a, WEIGHT] + flat[b, WEIGHT]
        spin = flat[a, RADIUS] * flat[a, LEVER] + flat[b, RADIUS] * flat[b, LEVER]
        arms = 1.0 + min(gap, 0.0) / (flat[a, RADIUS] + flat[b, RADIUS])
        soft = 0.0
        bias = -gap / numbers.h
        speed = (flat[b, VX] - flat[a, VX]) * nx + (flat[b, VY] - flat[a, VY]) * ny
        if speed < 0.0 and gap <= TOUCHING * composition.radii[a] and speed < -rest_speed(e, numbers):
            fastest = max(fastest, -speed)
        if gap <= 0.0:
            bias = min(numbers.push * max(-gap - numbers.slop, 0.0), numbers.push_limit)
            soft = numbers.softness
        rows[m, PX] = nx
        rows[m, PY] = ny
        rows[m, BIAS] = bias
        rows[m, MASS] = (1.0 - soft) / weight if weight > 0.0 else 0.0
        rows[m, SLIDE] = 1.0 / (weight + arms * arms * spin) if weight > 0.0 else 0.0
        rows[m, SOFT] = soft
        rows[m, MU] = tables.friction[mine, kind] * numbers.rough * real
        rows[m, JN] = held[m, 0] * numbers.carry
        rows[m, JT] = (held[m, 2] * nx - held[m, 1] * ny) * numbers.carry
        rows[m, ARMS] = arms
        rows[m, REBOUND] = e
        rows[m, HIT] = 0.0
        rows[m, HIT_T] = 0.0
    return fastest


@inner_kernel
def push_flat(flat, rows, m, a, b, j, jt):
    """An impulse j along the normal and jt across it, on b, and the opposite on a."""
    nx, ny = rows[m, PX], rows[m, PY]
    x = j * nx - jt * ny
    y = j * ny + jt * nx
    flat[a, VX] -= flat[a, WEIGHT] * x
    flat[a, VY] -= flat[a, WEIGHT] * y
    flat[b, VX] += flat[b, WEIGHT] * x
    flat[b, VY] += flat[b, WEIGHT] * y
    flat[a, TURN] -= flat[a, LEVER] * rows[m, ARMS] * jt
    flat[b, TURN] -= flat[b, LEVER] * rows[m, ARMS] * jt


@inner_kernel
def speeds_of(flat, rows, m, a, b):
    """Speeds along and across the normal of contact m, of b over a, m/s."""
    x, y = flat[b, VX] - flat[a, VX], flat[b, VY] - flat[a, VY]
    rim = flat[a, RADIUS] * flat[a, TURN] + flat[b, RADIUS] * flat[b, TURN]
    nx, ny = rows[m, PX], rows[m, PY]
    return x * nx + y * ny, y * nx - x * ny - rows[m, ARMS] * rim


@inner_kernel
def collide_flat(flat, composition, contacts, count, rows, fastest, numbers):
    """Collisions one after the other, in rounds, until none approaches. Returns rounds and impulses made."""
    made = 0
    for turn in range(numbers.rounds):
        changed = False
        for m in range(count):
            a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
            x, y = flat[b, VX] - flat[a, VX], flat[b, VY] - flat[a, VY]
            speed = x * rows[m, PX] + y * rows[m, PY]
            if speed >= -STILL * fastest or contacts.normals[m, c.GAP] > TOUCHING * composition.radii[a]:
                continue
            if speed < -rest_speed(rows[m, REBOUND], numbers) and rows[m, MASS] > 0.0:
                j = -(1.0 + rows[m, REBOUND]) * speed * rows[m, MASS] / (1.0 - rows[m, SOFT])
                rim = flat[a, RADIUS] * flat[a, TURN] + flat[b, RADIUS] * flat[b, TURN]
                slip = y * rows[m, PX] - x * rows[m, PY] - rows[m, ARMS] * rim
                most = rows[m, MU] * j
                jt = min(max(-slip * rows[m, SLIDE], -most), most)
                push_flat(flat, rows, m, a, b, j, jt)
                rows[m, HIT] += j
                rows[m, HIT_T] += jt
                made += 1
                changed = True
        if not changed:
            return turn, made
    return numbers.rounds, made


@inner_kernel
def pass_over_flat(flat, contacts, count, rows, numbers):
    """As `impulses.pass_over`."""
    for m in range(count):
        if contacts.normals[m, c.GAP] > 0.0:
            a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
            speed = (flat[b, VX] - flat[a, VX]) * rows[m, PX] + (flat[b, VY] - flat[a, VY]) * rows[m, PY]
            if speed < 0.0 and speed < -rest_speed(rows[m, REBOUND], numbers):
                contacts.normals[m, c.GAP] = c.FAR
                rows[m, BIAS] = -c.FAR / numbers.h
                rows[m, JN] = 0.0
                rows[m, JT] = 0.0


@inner_kernel
def start_flat(flat, contacts, count, rows):
    """Begin with the impulses of the last step."""
    for m in range(count):
        if rows[m, JN] > 0.0:
            a, b = contacts.bodies[m, c.FIRST], contacts.bodies[m, c.SECOND]
            push_flat(flat, rows, m, a, b, rows[m, JN], rows[m, JT])


@inner_kernel
def sweep_flat(flat, contacts, count, rows):
    """One sweep over all contacts, as `impulses.sweep_rows`."""
    for first in range(STRIDE):
        for m in range(first, count, STRIDE):
            a = contacts.bodies[m, c.FIRST]
            b = contacts.bodies[m, c.SECOND]
            nx = rows[m, PX]
            ny = rows[m, PY]
            ax, ay, spin_a, weight_a = flat[a, VX], flat[a, VY], flat[a, TURN], flat[a, WEIGHT]
            bx, by, spin_b, weight_b = flat[b, VX], flat[b, VY], flat[b, TURN], flat[b, WEIGHT]
            x = bx - ax
            y = by - ay
            arms = rows[m, ARMS]
            slip = y * nx - x * ny - arms * (flat[a, RADIUS] * spin_a + flat[b, RADIUS] * spin_b)
            old, old_t = rows[m, JN], rows[m, JT]
            short = (x * nx + y * ny - rows[m, BIAS]) * rows[m, MASS] + rows[m, SOFT] * old
            total = max(old - short, 0.0)
            most = rows[m, MU] * total
            total_t = min(max(old_t - slip * rows[m, SLIDE], -most), most)
            rows[m, JN] = total
            rows[m, JT] = total_t
            j = total - old
            jt = total_t - old_t
            x = j * nx - jt * ny
            y = j * ny + jt * nx
            jt *= arms
            flat[a, VX] = ax - weight_a * x
            flat[a, VY] = ay - weight_a * y
            flat[a, TURN] = spin_a - flat[a, LEVER] * jt
            flat[b, VX] = bx + weight_b * x
            flat[b, VY] = by + weight_b * y
            flat[b, TURN] = spin_b - flat[b, LEVER] * jt


@inner_kernel
def harden_flat(count, rows):
    """Take softness and push back out of the rows."""
    for m in range(count):
        rows[m, MASS] /= 1.0 - rows[m, SOFT]
        rows[m, SOFT] = 0.0
        rows[m, BIAS] = min(rows[m, BIAS], 0.0)


@inner_kernel
def keep_flat(contacts, count, rows):
    """Impulses for the next step: along the normal, and the vector of friction."""
    held = contacts.impulses
    for m in range(count):
        held[m, 0] = rows[m, JN]
        held[m, 1] = -rows[m, JT] * rows[m, PY]
        held[m, 2] = rows[m, JT] * rows[m, PX]
        held[m, 3] = 0.0


@inner_kernel
def split_flat(flat, contacts, count, rows, numbers):
    """`position_correction.split_apart` in the plane."""
    pushes = contacts.pushes
    for first in range(STRIDE):
        for m in range(first, count, STRIDE):
            a = contacts.bodies[m, c.FIRST]
            b = contacts.bodies[m, c.SECOND]
            nx, ny = rows[m, PX], rows[m, PY]
            ax, ay, bx, by = flat[a, WAY_X], flat[a, WAY_Y], flat[b, WAY_X], flat[b, WAY_Y]
            lack = min(numbers.share * (-numbers.slop - contacts.normals[m, c.GAP]), numbers.most_shift)
            lack -= (bx - ax) * nx + (by - ay) * ny
            old = pushes[m]
            total = max(old + lack * rows[m, MASS], 0.0)
            pushes[m] = total
            x, y = (total - old) * nx, (total - old) * ny
            flat[a, WAY_X] = ax - flat[a, WEIGHT] * x
            flat[a, WAY_Y] = ay - flat[a, WEIGHT] * y
            flat[b, WAY_X] = bx + flat[b, WEIGHT] * x
            flat[b, WAY_Y] = by + flat[b, WEIGHT] * y


@inner_kernel
def project_flat(positions, flat, contacts, count, numbers):
    """`position_correction.project_apart` in the plane."""
    n = positions.shape[0]
    for first in range(STRIDE):
        for m in range(first, count, STRIDE):
            a = contacts.bodies[m, c.FIRST]
            b = contacts.bodies[m, c.SECOND]
            ax, ay, bx, by = flat[a, WAY_X], flat[a, WAY_Y], flat[b, WAY_X], flat[b, WAY_Y]
            x, y = bx - ax, by - ay
            gap = contacts.normals[m, c.GAP]
            if b < n and gap < c.FAR:
                x += positions[b, 0] - positions[a, 0]
                y += positions[b, 1] - positions[a, 1]
                reach = flat[a, RADIUS] + flat[b, RADIUS] - numbers.slop
                square = x * x + y * y
                if square >= reach * reach or not square > 0.0:
                    continue
                length = math.sqrt(square)
                lack = min(numbers.share * (reach - length), numbers.most_shift) / length
            else:
                nx, ny = contacts.normals[m, c.NX], contacts.normals[m, c.NY]
                lack = min(numbers.share * (-numbers.slop - gap - x * nx - y * ny), numbers.most_shift)
                x, y = nx, ny
                if lack <= 0.0:
                    continue
            weight_a, weight_b = flat[a, WEIGHT], flat[b, WEIGHT]
            part = lack / (weight_a + weight_b) if weight_a + weight_b > 0.0 else 0.0
            flat[a, WAY_X] = ax - weight_a * part * x
            flat[a, WAY_Y] = ay - weight_a * part * y
            flat[b, WAY_X] = bx + weight_b * part * x
            flat[b, WAY_Y] = by + weight_b * part * y

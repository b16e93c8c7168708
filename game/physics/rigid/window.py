"""A body of spheres kept inside a box.

"mirror", as the course has it: where a sphere is beyond a wall the body is moved back, and if it moved
outwards the velocity of its centre is mirrored. Its spin stays. "impulse": the wall strikes the point that is
farthest out, so that the spin changes as well, by j = -(1 + e) v·n / (1/m + (r x n)·J⁻¹ (r x n)), r from the
centre of mass to that point (Baraff 1997). Points equally far out are struck in their middle.

Arrays: row (13,), a state (see `motion`); places (k, 3) m; radii (k,) m.
"""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.rigid.quaternion import normalize, rotate
from game.physics.rigid.turning import spin_of

WALLS = ("mirror", "impulse")
MIRROR, IMPULSE = range(2)
EQUALLY_DEEP = 1e-9  # m


@kernel
def place_spheres(row, offsets, places):
    """Write the centres (k, 3) m of spheres with these offsets (k, 3) in the principal frame of a state."""
    q = normalize((row[3], row[4], row[5], row[6]))
    for s in range(offsets.shape[0]):
        arm = rotate(q, (offsets[s, 0], offsets[s, 1], offsets[s, 2]))
        for k in range(3):
            places[s, k] = row[k] + arm[k]


@kernel
def extent(places, radii, axis):
    """From where to where (m) spheres reach along an axis."""
    low, high = 1e300, -1e300
    for s in range(places.shape[0]):
        low = min(low, places[s, axis] - radii[s])
        high = max(high, places[s, axis] + radii[s])
    return low, high


@kernel
def point_at(places, radii, axis, side, reach):
    """Middle (m) of the points that reach so far along an axis, upwards (side 1.0) or downwards (-1.0)."""
    x, y, z, count = 0.0, 0.0, 0.0, 0
    for s in range(places.shape[0]):
        if side * (places[s, axis] - reach) + radii[s] >= -EQUALLY_DEEP:
            x += places[s, 0]
            y += places[s, 1]
            z += places[s, 2]
            count += 1
    x, y, z = x / count, y / count, z / count
    return (reach if axis == 0 else x, reach if axis == 1 else y, reach if axis == 2 else z)


@kernel
def cross(a, b):
    """a x b."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


@kernel
def strike(row, body, axis, side, point, restitution):
    """Impulse of a wall on a point (m) of a body; 1 if the point moved outwards, else 0 and nothing."""
    q, angular = normalize((row[3], row[4], row[5], row[6])), (row[10], row[11], row[12])
    inverses = (body[4], body[5], body[6])
    n = (side if axis == 0 else 0.0, side if axis == 1 else 0.0, side if axis == 2 else 0.0)
    arm = (point[0] - row[0], point[1] - row[1], point[2] - row[2])
    lever = cross(arm, n)
    turn = spin_of(q, lever, inverses)
    w = spin_of(q, angular, inverses)
    outwards = body[0] * side * row[7 + axis] + lever[0] * w[0] + lever[1] * w[1] + lever[2] * w[2]
    if not outwards > 0.0:
        return 0
    ease = body[0] + lever[0] * turn[0] + lever[1] * turn[1] + lever[2] * turn[2]
    j = -(1.0 + restitution) * outwards / ease
    row[7 + axis] += j * side
    for k in range(3):
        row[10 + k] += j * lever[k]
    return 1


@kernel
def keep_inside(row, body, offsets, radii, lower, upper, restitution, wall_law, places):
    """Bring a body back into the box from lower (3,) to upper (3,) m; gives how many walls threw it back.

    row (13,) its state, body (7,) its constants: see motion; offsets (k, 3), radii (k,);
    wall_law: MIRROR or IMPULSE. row and places (k, 3) are written. A body larger than the box comes to its
    middle.
    """
    bounces = 0
    place_spheres(row, offsets, places)
    for axis in range(3):
        low, high = extent(places, radii, axis)
        if high - low >= upper[axis] - lower[axis]:
            row[axis] += 0.5 * (lower[axis] + upper[axis] - low - high)
            continue
        if low >= lower[axis] and high <= upper[axis]:
            continue
        side, reach, wall = (1.0, high, upper[axis]) if high > upper[axis] else (-1.0, low, lower[axis])
        if wall_law == IMPULSE:
            point = point_at(places, radii, axis, side, reach)
            bounces += strike(row, body, axis, side, point, restitution)
        elif side * row[7 + axis] > 0.0:
            row[7 + axis] *= -restitution
            bounces += 1
        row[axis] += wall - reach
        for s in range(places.shape[0]):
            places[s, axis] += wall - reach
    return bounces

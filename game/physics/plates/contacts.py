"""Where plates touch: the ground, fixed walls, one another.

A plate is three points (its left end, its middle, its right end) and the two straight halves between them,
rounded by its half thickness. Points of one are tested against the halves of the other and the other way
round, those near enough to meet within the step. Each contact lets its points come together no faster than
their gap allows, so that nothing passes (speculative contacts: Catto 2013). Impulses act on what is moved in
truth: the plate with the air that it takes along, and its bend. Its mass along the chord is another than
across it.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.plates import law

NOBODY = -1  # the ground or a wall
FEATURES, PARTNERS = 8, 65_536  # of a plate: three points, two ends of a wall; the ground, plates, walls
WALLS = 8_192  # number of the first wall among partners
POINTS, PER_POINT = 3, 4  # of a plate: offset from its place (m), and how it moves with the bend (m/rad)
BELOW = 0.5 * (1.0 - law.HEAVY)  # of a half chord times sin q that the midrib lies below the centre of mass
START_X, START_Y, END_X, END_Y, WALL_RADIUS, WALL_FRICTION = range(6)
WALL = 6
GAP, FRICTION, NORMAL_X, NORMAL_Y, PUSH, RUB, HEIGHT, YIELDS, YIELDS_ACROSS = range(9)
ARMS = 9  # where the levers of the first body begin, those of the second follow: see `lever`
LEVERS = 12
ROW = ARMS + 2 * LEVERS
RICHER = 1e-3  # m, beyond what is crossed in a step, within which contacts are looked for


@inner_kernel
def shape(state, laws, points, i):
    """Write the three points of a plate: (x, y) from its place, and how they move with the bend."""
    a, q, theta = laws[law.HALF, i], state[law.BEND, i], state[law.THETA, i]
    c, s, level, up = elementary.cos(theta), elementary.sin(theta), elementary.cos(q), elementary.sin(q)
    for k in range(POINTS):
        side = k - 1.0
        far = 1.0 if k != 1 else 0.0
        px, py = side * a * level, (far - BELOW) * a * up
        bx, by = -side * a * up, (far - BELOW) * a * level
        points[i, k, 0], points[i, k, 1] = c * px - s * py, s * px + c * py
        points[i, k, 2], points[i, k, 3] = c * bx - s * by, s * bx + c * by


@inner_kernel
def lever(row, first, state, laws, i, arm, normal, sign, bends):
    """Write what an impulse along the normal and across it does to a body, by 1/(N s); how much it yields.

    Levers: along, across: each spin arm, bend arm, then what it changes: vx, vy, spin, bend rate.
    """
    total_n, total_t = 0.0, 0.0
    gives = bends if laws[law.STIFF, i] > 0.0 else 0.0
    c, s = elementary.cos(state[law.THETA, i]), elementary.sin(state[law.THETA, i])
    mass = laws[law.MASS, i]
    for k in range(2):
        dx, dy = (normal[0], normal[1]) if k == 0 else (-normal[1], normal[0])
        dx, dy = sign * dx, sign * dy
        turn, bend = arm[0] * dy - arm[1] * dx, gives * (arm[2] * dx + arm[3] * dy)
        ux, uy = (c * dx + s * dy) / laws[law.MASS_X, i], (c * dy - s * dx) / laws[law.MASS_Y, i]
        at = first + 6 * k
        row[at], row[at + 1] = turn, bend
        row[at + 2], row[at + 3] = (c * ux - s * uy) / mass, (s * ux + c * uy) / mass
        row[at + 4], row[at + 5] = (
            turn / (mass * laws[law.INERTIA, i]),
            bend / (mass * laws[law.BEND_INERTIA, i]),
        )
        total = row[at + 2] * dx + row[at + 3] * dy + turn * row[at + 4] + bend * row[at + 5]
        if k == 0:
            total_n = total
        else:
            total_t = total
    return total_n, total_t


@inner_kernel
def add(found, count, world, i, feature, j, other, normal, limits):
    """One more contact: plate i at ``feature`` (number, lever), j or NOBODY at ``other`` (number, lever).

    found: rows, ids, keys, 1 if plates bend; world: state, laws, points; limits: gap (m), friction.
    """
    rows, ids, keys, bends = found
    state, laws, _ = world
    if count >= len(rows):
        return count
    row = rows[count]
    number, arm = feature
    partner, far_arm = other
    ids[count, 0], ids[count, 1] = i, j
    keys[count] = float((i * FEATURES + number) * PARTNERS + partner)
    row[:] = 0.0
    along, across = lever(row, ARMS, state, laws, i, arm, normal, 1.0, bends)
    if j != NOBODY:
        more, off = lever(row, ARMS + LEVERS, state, laws, j, far_arm, normal, -1.0, bends)
        along, across = along + more, across + off
    row[GAP], row[FRICTION], row[NORMAL_X], row[NORMAL_Y] = limits[0], limits[1], normal[0], normal[1]
    row[HEIGHT], row[YIELDS], row[YIELDS_ACROSS] = state[law.Y, i] + arm[1], along, across
    return count + 1


@inner_kernel
def nearest(px, py, ax, ay, bx, by):
    """Share along a segment at which it is nearest to a point, and the way from there to the point."""
    dx, dy = bx - ax, by - ay
    squared = dx * dx + dy * dy
    share = ((px - ax) * dx + (py - ay) * dy) / squared if squared > 0.0 else 0.0
    share = min(max(share, 0.0), 1.0)
    return share, px - ax - share * dx, py - ay - share * dy


@inner_kernel
def between(points, j, side, share):
    """The lever of a place on half of a plate: ``side`` 0 or 2, ``share`` of the way outwards."""
    return (
        points[j, 1, 0] + share * (points[j, side, 0] - points[j, 1, 0]),
        points[j, 1, 1] + share * (points[j, side, 1] - points[j, 1, 1]),
        points[j, 1, 2] + share * (points[j, side, 2] - points[j, 1, 2]),
        points[j, 1, 3] + share * (points[j, side, 3] - points[j, 1, 3]),
    )


@inner_kernel
def point_on_plate(state, points, px, py, j):
    """Of the halves of plate j the nearest place to a point: its half, share, and the way to the point."""
    x, y = state[law.X, j], state[law.Y, j]
    best, side, share, wx, wy = math.inf, 0, 0.0, 0.0, 0.0
    for k in range(0, POINTS, 2):
        at, dx, dy = nearest(
            px, py, x + points[j, 1, 0], y + points[j, 1, 1], x + points[j, k, 0], y + points[j, k, 1]
        )
        if dx * dx + dy * dy < best:
            best, side, share, wx, wy = dx * dx + dy * dy, k, at, dx, dy
    return side, share, wx, wy


@inner_kernel
def point(points, i, k):
    """The lever of one of the three points of a plate."""
    return points[i, k, 0], points[i, k, 1], points[i, k, 2], points[i, k, 3]


@inner_kernel
def points_on_plate(world, found, count, i, j, reach, friction):
    """Contacts of the three points of plate i with the halves of plate j."""
    state, laws, points = world
    for k in range(POINTS):
        px, py = state[law.X, i] + points[i, k, 0], state[law.Y, i] + points[i, k, 1]
        side, share, dx, dy = point_on_plate(state, points, px, py, j)
        far = math.sqrt(dx * dx + dy * dy)
        gap = far - laws[law.RADIUS, i] - laws[law.RADIUS, j]
        if gap < reach and far > 0.0:
            other = (1 + j, between(points, j, side, share))
            count = add(
                found,
                count,
                world,
                i,
                (k, point(points, i, k)),
                j,
                other,
                (dx / far, dy / far),
                (gap, friction),
            )
    return count


@inner_kernel
def with_wall(world, found, count, i, walls, w, reach):
    """Contacts of plate i with a wall: its points, and the wall's ends on its halves."""
    state, laws, points = world
    other = (WALLS + w, (0.0, 0.0, 0.0, 0.0))
    friction, thick = walls[w, WALL_FRICTION], laws[law.RADIUS, i] + walls[w, WALL_RADIUS]
    for k in range(POINTS):
        px, py = state[law.X, i] + points[i, k, 0], state[law.Y, i] + points[i, k, 1]
        _, dx, dy = nearest(px, py, walls[w, START_X], walls[w, START_Y], walls[w, END_X], walls[w, END_Y])
        far = math.sqrt(dx * dx + dy * dy)
        if far - thick < reach and far > 0.0:
            count = add(
                found, count, world, i, (k, point(points, i, k)), NOBODY, other, (dx / far, dy / far),
                (far - thick, friction),
            )  # fmt: skip
    for end in range(2):
        side, share, dx, dy = point_on_plate(state, points, walls[w, 2 * end], walls[w, 2 * end + 1], i)
        far = math.sqrt(dx * dx + dy * dy)
        if far - thick < reach and far > 0.0 and 0.02 < share < 0.98:
            feature = (POINTS + end, between(points, i, side, share))
            count = add(
                found,
                count,
                world,
                i,
                feature,
                NOBODY,
                other,
                (-dx / far, -dy / far),
                (far - thick, friction),
            )
    return count


@inner_kernel
def crossed(state, laws, i, gravity, dt):
    """How far (m) a point of a plate may go in a step, and a little more."""
    a = laws[law.HALF, i]
    speed = (
        math.sqrt(state[law.VX, i] * state[law.VX, i] + state[law.VY, i] * state[law.VY, i])
        + abs(state[law.SPIN, i]) * a
    )
    return 1.5 * dt * (speed + abs(state[law.BEND_RATE, i]) * a + abs(gravity) * dt) + RICHER


@lean_kernel
def find_contacts(world, found, walls, order, settings, dt):
    """Write all contacts; how many.

    world: state (STATE, n), laws (COLUMNS, n), points (n, POINTS, PER_POINT), which are written. found:
    rows (k, ROW), ids (k, 2), keys (k,), 1 if plates bend. walls (m, WALL); order (n,): kept, plates from
    left to right. settings: gravity m/s²; 1 if there is ground, and its height m; 1 if plates touch one
    another; friction.
    """
    gravity, ground, floor, pairs, friction = settings
    state, laws, points = world
    count, none = 0, (0, (0.0, 0.0, 0.0, 0.0))
    for i in range(state.shape[1]):
        shape(state, laws, points, i)
    for i in range(state.shape[1]):
        far = crossed(state, laws, i, gravity, dt)
        reach = laws[law.HALF, i] + laws[law.RADIUS, i] + far
        x, y = state[law.X, i], state[law.Y, i]
        if ground > 0.5 and y - reach < floor:
            for k in range(POINTS):
                gap = y + points[i, k, 1] - floor - laws[law.RADIUS, i]
                if gap < far:
                    count = add(
                        found,
                        count,
                        world,
                        i,
                        (k, point(points, i, k)),
                        NOBODY,
                        none,
                        (0.0, 1.0),
                        (gap, friction),
                    )
        for w in range(walls.shape[0]):
            near = reach + walls[w, WALL_RADIUS]
            if (
                x + near > min(walls[w, START_X], walls[w, END_X])
                and x - near < max(walls[w, START_X], walls[w, END_X])
                and y + near > min(walls[w, START_Y], walls[w, END_Y])
                and y - near < max(walls[w, START_Y], walls[w, END_Y])
            ):
                count = with_wall(world, found, count, i, walls, w, far)
    if pairs > 0.5:
        count = find_pairs(world, found, count, order, (gravity, friction), dt)
    return count


@inner_kernel
def find_pairs(world, found, count, order, settings, dt):
    """Contacts of plates with one another, by a sweep from left to right."""
    gravity, friction = settings
    state, laws, _ = world
    n = state.shape[1]
    sort(state, order)
    widest = 0.0
    for i in range(n):
        widest = max(widest, laws[law.HALF, i] + laws[law.RADIUS, i] + crossed(state, laws, i, gravity, dt))
    for k in range(n):
        i = order[k]
        far = crossed(state, laws, i, gravity, dt)
        own = laws[law.HALF, i] + laws[law.RADIUS, i]
        for m in range(k + 1, n):
            j = order[m]
            dx, dy = state[law.X, j] - state[law.X, i], state[law.Y, j] - state[law.Y, i]
            if dx > own + far + widest:
                break
            away = far + crossed(state, laws, j, gravity, dt)
            near = own + laws[law.HALF, j] + laws[law.RADIUS, j] + away
            if dx * dx + dy * dy < near * near:
                count = points_on_plate(world, found, count, i, j, away, friction)
                count = points_on_plate(world, found, count, j, i, away, friction)
    return count


@inner_kernel
def sort(state, order):
    """Plates from left to right, those at one place by number: an insertion sort of what is nearly sorted."""
    for k in range(1, len(order)):
        i = order[k]
        x = state[law.X, i]
        m = k - 1
        while m >= 0 and (state[law.X, order[m]] > x or (state[law.X, order[m]] == x and order[m] > i)):
            order[m + 1] = order[m]
            m -= 1
        order[m + 1] = i

"""Kernels of motion: a ball rolls or slides on its track, lifts off, flies, meets a track, rests between two.

On a track a ball has one coordinate, the way of its centre, so smooth curves cost it nothing: position by the
velocity Verlet method, and while nothing slips the speed by its energy. Flight is a parabola. Lifting off,
landing, beginning and ceasing to slip are found within the substep.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.solids.tracks import curves
from game.physics.solids.tracks.places import FAR, along, nearest_on, place_on, walk

# columns of a ball: place m, velocity m/s, angle rad, spin rad/s, radius m, mass kg, k = I/(m r²), friction,
# restitution, t on its piece, speed of its centre along the track m/s
X, Y, VX, VY, ANGLE, SPIN, RADIUS, MASS, SHARE, FRICTION, BOUNCE, PLACE, SPEED = range(13)
BALL_WIDTH = 13
FREE = -1
PIECE, WEDGE = 0, 1  # columns of Balls.pieces: that it rolls on, or FREE; a second one that holds it, or FREE
SLIPLESS = 1e-9  # m/s for each m/s: slower is no slip
TOUCH = 1e-10  # m, of rounding
SEEN_BEFORE = 1e-7  # m: what was deeper already is not met
# cosine of the angle of two normals beyond which their places face each other
FACING = -(math.pi * math.pi - 1.0) / (math.pi * math.pi + 1.0)
EVENTS = 24  # in a substep
HALVINGS = 45
LEAST_REBOUND = 0.02  # m/s; slower impacts do not bounce
STILL = 1e-4  # m/s


@inner_kernel
def is_far(rows, i, t, j, tj, radius):
    """Whether two places are far along one curve: a ball that rides a branch passes through the others."""
    if rows[i, curves.TRACK] != rows[j, curves.TRACK]:
        return False
    apart = abs(along(rows, i, t) - along(rows, j, tj))
    if rows[i, curves.AROUND] > 0.0:
        apart = min(apart, rows[i, curves.AROUND] - apart)
    return apart > 2.0 * math.pi * radius


@inner_kernel
def _faces(rows, i, t, j, tj):
    """Whether two places on one side of a curve look at each other as the flanks of a corner do: of less than
    35 degrees, 2 atan(1 / pi).
    """
    if (rows[i, curves.TO] - rows[i, curves.FROM]) * (rows[j, curves.TO] - rows[j, curves.FROM]) <= 0.0:
        return False
    _, _, ax, ay, _, _ = place_on(rows, i, t, 0.0)
    _, _, bx, by, _, _ = place_on(rows, j, tj, 0.0)
    return ax * bx + ay * by < FACING


@inner_kernel
def first_hit(pieces, grid, x0, y0, x1, y1, r, own, t):
    """The piece that a ball met on its way from one place to the other, or FREE; own, t: where it rolls."""
    frame, shape = grid.frame, grid.shape
    deepest, found = -TOUCH * (1.0 + r), FREE
    if shape[0] == 0:
        return found
    size = frame[2]
    low_x, high_x = min(x0, x1) - r, max(x0, x1) + r
    low_y, high_y = min(y0, y1) - r, max(y0, y1) + r
    first_c, last_c = math.floor((low_x - frame[0]) / size), math.floor((high_x - frame[0]) / size)
    first_r, last_r = math.floor((low_y - frame[1]) / size), math.floor((high_y - frame[1]) / size)
    for row in range(max(first_r, 0), min(last_r, shape[1] - 1) + 1):
        for column in range(max(first_c, 0), min(last_c, shape[0] - 1) + 1):
            cell = row * shape[0] + column
            for at in range(grid.starts[cell], grid.starts[cell + 1]):
                j = grid.members[at]
                box = pieces.boxes
                if (
                    j == own
                    or box[j, 0] > high_x
                    or box[j, 2] < low_x
                    or box[j, 1] > high_y
                    or box[j, 3] < low_y
                ):
                    continue
                distance, tj, _, _ = nearest_on(pieces.rows, j, x1, y1)
                if distance - r >= deepest:
                    continue
                rows = pieces.rows
                if own != FREE and is_far(rows, own, t, j, tj, r) and not _faces(rows, own, t, j, tj):
                    continue
                if nearest_on(pieces.rows, j, x0, y0)[0] - r < -SEEN_BEFORE * (1.0 + r):
                    continue
                deepest, found = distance - r, j
    return found


@inner_kernel
def hit_by(ball, b, nx, ny):
    """Velocity and spin after an impact with what stands still (Routh 1905). True: it bounced."""
    normal = ball[b, VX] * nx + ball[b, VY] * ny
    tangent = ball[b, VX] * ny - ball[b, VY] * nx
    if normal >= 0.0:
        return False
    bounce = ball[b, BOUNCE] if -normal > LEAST_REBOUND else 0.0
    push = -(1.0 + bounce) * normal
    r, k = ball[b, RADIUS], ball[b, SHARE]
    rub = -(tangent + r * ball[b, SPIN]) * k / (1.0 + k)
    most = ball[b, FRICTION] * push
    rub = min(max(rub, -most), most)
    ball[b, VX] += push * nx + rub * ny
    ball[b, VY] += push * ny - rub * nx
    ball[b, SPIN] += rub / (k * r)
    return bounce > 0.0


@inner_kernel
def fly(pieces, grid, balls, b, rest, gravity):
    """Part of a flight; s that are left."""
    ball = balls.rows
    r = ball[b, RADIUS]
    vx, vy, x, y = ball[b, VX], ball[b, VY], ball[b, X], ball[b, Y]
    gx, gy = gravity[0], gravity[1]
    fastest = math.sqrt(vx * vx + vy * vy) + math.sqrt(gx * gx + gy * gy) * rest
    dt = min(rest, max(0.5 * r / fastest if fastest > 0.0 else rest, rest / 64.0))
    x1, y1 = x + dt * (vx + 0.5 * dt * gx), y + dt * (vy + 0.5 * dt * gy)
    j = first_hit(pieces, grid, x, y, x1, y1, r, FREE, 0.0)
    if j != FREE:
        low, high = 0.0, dt
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            mx, my = x + middle * (vx + 0.5 * middle * gx), y + middle * (vy + 0.5 * middle * gy)
            if nearest_on(pieces.rows, j, mx, my)[0] - r > 0.0:
                low = middle
            else:
                high = middle
        dt = high
        x1, y1 = x + dt * (vx + 0.5 * dt * gx), y + dt * (vy + 0.5 * dt * gy)
    ball[b, X], ball[b, Y] = x1, y1
    ball[b, VX], ball[b, VY] = vx + dt * gx, vy + dt * gy
    ball[b, ANGLE] += dt * ball[b, SPIN]
    if j != FREE:
        _, t, nx, ny = nearest_on(pieces.rows, j, x1, y1)
        if not hit_by(ball, b, nx, ny):
            balls.pieces[b, PIECE], ball[b, PLACE] = j, t
            ball[b, SPEED] = ball[b, VX] * ny - ball[b, VY] * nx
    return rest - dt


@inner_kernel
def try_roll(pieces, ball, b, i, gravity, dt):
    """Where a ball on piece i would be after dt: piece, t, speed, spin, push (N/kg) before and after,
    slip before and after; nothing is changed.
    """
    r, k, mu = ball[b, RADIUS], ball[b, SHARE], ball[b, FRICTION]
    t, v, w = ball[b, PLACE], ball[b, SPEED], ball[b, SPIN]
    x0, y0, nx, ny, kc, _ = place_on(pieces.rows, i, t, r)
    pull, press = gravity[0] * ny - gravity[1] * nx, gravity[0] * nx + gravity[1] * ny
    push0 = v * v * kc - press
    slip0 = v + r * w
    most = mu * max(push0, 0.0)
    holds = abs(slip0) <= SLIPLESS * (1.0 + abs(v)) and k * abs(pull) <= (1.0 + k) * most
    kept = holds or mu == 0.0
    share = k if holds else 0.0
    rub = 0.0
    if not kept:
        way = slip0 if abs(slip0) > SLIPLESS * (1.0 + abs(v)) else pull
        rub = -most if way > 0.0 else most
    a0 = (pull + rub) / (1.0 + share)
    i1, t1 = walk(pieces.rows, pieces.links, i, t, r, dt * (v + 0.5 * dt * a0))
    x1, y1, nx, ny, kc, _ = place_on(pieces.rows, i1, t1, r)
    pull, press = gravity[0] * ny - gravity[1] * nx, gravity[0] * nx + gravity[1] * ny
    ahead = v + dt * a0
    rub1 = 0.0
    if not kept:
        rub1 = math.copysign(mu * max(ahead * ahead * kc - press, 0.0), rub)
    a1 = (pull + rub1) / (1.0 + share)
    v1 = v + 0.5 * dt * (a0 + a1)
    if kept:
        square = v * v + 2.0 * (gravity[0] * (x1 - x0) + gravity[1] * (y1 - y0)) / (1.0 + share)
        slow = 3.0 * dt * (abs(a0) + abs(a1))
        if square > slow * slow:
            v1 = math.copysign(math.sqrt(square), v1)
    w1 = -v1 / r if holds else w + 0.5 * dt * (rub + rub1) / (k * r)
    return i1, t1, v1, w1, push0, v1 * v1 * kc - press, slip0, v1 + r * w1


@inner_kernel
def put_on(pieces, balls, b, i, t, v, w):
    """Set a ball that rolls: piece, t, speed and spin; and what follows from these."""
    ball = balls.rows
    x, y, nx, ny, _, _ = place_on(pieces.rows, i, t, ball[b, RADIUS])
    ball[b, X], ball[b, Y], ball[b, VX], ball[b, VY] = x, y, v * ny, -v * nx
    ball[b, SPIN], ball[b, PLACE], ball[b, SPEED] = w, t, v
    balls.pieces[b, PIECE] = i


@inner_kernel
def roll(pieces, grid, balls, b, rest, gravity):
    """Part of a way along a track, up to what happens next; s that are left."""
    ball, i = balls.rows, balls.pieces[b, PIECE]
    r, v, w, dt = ball[b, RADIUS], ball[b, SPEED], ball[b, SPIN], rest
    x0, y0, t0 = ball[b, X], ball[b, Y], ball[b, PLACE]
    i1, t1, v1, w1, push0, push1, slip0, slip1 = try_roll(pieces, ball, b, i, gravity, dt)
    if push0 < 0.0:
        balls.pieces[b, PIECE] = FREE
        return rest
    grips, leaves = False, False
    if ball[b, FRICTION] > 0.0 and slip0 * slip1 < 0.0 and abs(slip0) > SLIPLESS * (1.0 + abs(v)):
        grips, dt = True, dt * slip0 / (slip0 - slip1)
        i1, t1, v1, w1, push0, push1, slip0, slip1 = try_roll(pieces, ball, b, i, gravity, dt)
    if push1 < 0.0:
        low, high = 0.0, dt
        for _ in range(30):
            middle = 0.5 * (low + high)
            if try_roll(pieces, ball, b, i, gravity, middle)[5] < 0.0:
                high = middle
            else:
                low = middle
        grips, leaves, dt = False, True, high
        i1, t1, v1, w1, push0, push1, slip0, slip1 = try_roll(pieces, ball, b, i, gravity, dt)
    x1, y1, _, _, _, _ = place_on(pieces.rows, i1, t1, r)
    j = first_hit(pieces, grid, x0, y0, x1, y1, r, i1, t1)
    if j != FREE and j != i:
        low, high = 0.0, dt
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            im, tm, _, _, _, _, _, _ = try_roll(pieces, ball, b, i, gravity, middle)
            mx, my, _, _, _, _ = place_on(pieces.rows, im, tm, r)
            if nearest_on(pieces.rows, j, mx, my)[0] - r > 0.0:
                low = middle
            else:
                high = middle
        grips, leaves, dt = False, False, high
        i1, t1, v1, w1, push0, push1, slip0, slip1 = try_roll(pieces, ball, b, i, gravity, dt)
    else:
        j = FREE
    if grips:
        w1 = -v1 / r
    ball[b, ANGLE] += 0.5 * dt * (w + w1)
    put_on(pieces, balls, b, i1, t1, v1, w1)
    if leaves:
        balls.pieces[b, PIECE] = FREE
    if j != FREE:
        meet_second(pieces, balls, b, i1, j)
    if dt == 0.0 and not leaves and j == FREE and t1 == t0:
        return 0.0
    return rest - dt


@inner_kernel
def meet_second(pieces, balls, b, i, j):
    """A ball on piece i has met piece j: it goes on along one of them, off both, or rests between them."""
    ball = balls.rows
    r = ball[b, RADIUS]
    _, _, ax, ay, _, _ = place_on(pieces.rows, i, ball[b, PLACE], r)
    distance, t, bx, by = nearest_on(pieces.rows, j, ball[b, X], ball[b, Y])
    if distance == FAR:
        return
    for _ in range(60):  # each impact may drive it into the other one
        hit_by(ball, b, bx, by)
        if ball[b, VX] * ax + ball[b, VY] * ay >= -STILL * STILL:
            break
        hit_by(ball, b, ax, ay)
    from_a, from_b = ball[b, VX] * ax + ball[b, VY] * ay, ball[b, VX] * bx + ball[b, VY] * by
    if ball[b, VX] * ball[b, VX] + ball[b, VY] * ball[b, VY] < STILL * STILL:
        balls.pieces[b, WEDGE] = j
        ball[b, VX], ball[b, VY], ball[b, SPEED], ball[b, SPIN] = 0.0, 0.0, 0.0, 0.0
    elif from_b < STILL:
        balls.pieces[b, PIECE], ball[b, PLACE] = j, t
        ball[b, SPEED] = ball[b, VX] * by - ball[b, VY] * bx
    elif from_a < STILL:
        ball[b, SPEED] = ball[b, VX] * ay - ball[b, VY] * ax
    else:
        balls.pieces[b, PIECE] = FREE


@inner_kernel
def rest_between(pieces, balls, b, gravity):
    """A ball between two pieces stays while gravity presses it on both; else it goes on along one."""
    ball = balls.rows
    i, j = balls.pieces[b, PIECE], balls.pieces[b, WEDGE]
    _, _, ax, ay, _, _ = place_on(pieces.rows, i, ball[b, PLACE], ball[b, RADIUS])
    _, t, bx, by = nearest_on(pieces.rows, j, ball[b, X], ball[b, Y])
    area = ax * by - ay * bx
    if abs(area) < 1e-12:
        return
    on_a = (-gravity[0] * by + gravity[1] * bx) / area
    on_b = (-gravity[1] * ax + gravity[0] * ay) / area
    if on_b < 0.0:
        balls.pieces[b, WEDGE] = FREE
    elif on_a < 0.0:
        balls.pieces[b, PIECE], balls.pieces[b, WEDGE], ball[b, PLACE] = j, FREE, t


@lean_kernel
def step_balls(pieces, grid, balls, gravity, h, substeps):
    """All balls by ``substeps`` of h s; each by itself. Returns the first that is not finite, or FREE."""
    wrong = FREE
    for b in range(balls.rows.shape[0]):
        for _ in range(substeps):
            rest = h
            for _ in range(EVENTS):
                if balls.pieces[b, WEDGE] != FREE:
                    rest_between(pieces, balls, b, gravity)
                    if balls.pieces[b, WEDGE] != FREE:
                        break
                if balls.pieces[b, PIECE] == FREE:
                    rest = fly(pieces, grid, balls, b, rest, gravity)
                else:
                    rest = roll(pieces, grid, balls, b, rest, gravity)
                if rest <= 1e-12 * h:
                    break
        if not math.isfinite(balls.rows[b, X] + balls.rows[b, Y] + balls.rows[b, SPIN]) and wrong == FREE:
            wrong = b
    return wrong


@lean_kernel
def settle_balls(pieces, balls, tracks, margin):
    """After tracks have changed: each ball that rolled on tracks[b] is put on its nearest place, as fast as
    it was along it. What is within a track is put outside. margin: m, how far it may be moved.
    """
    ball = balls.rows
    for b in range(ball.shape[0]):
        best, found, place = margin, FREE, 0.0
        for j in range(pieces.rows.shape[0]):
            distance, t, _, _ = nearest_on(pieces.rows, j, ball[b, X], ball[b, Y])
            if distance == FAR:
                continue
            gap = distance - ball[b, RADIUS]
            rolled = tracks[b] >= 0 and pieces.rows[j, curves.TRACK] == tracks[b]
            if (rolled and abs(gap) < best) or (gap < 0.0 and -gap < min(best, ball[b, RADIUS])):
                best, found, place = abs(gap), j, t
        balls.pieces[b, PIECE], balls.pieces[b, WEDGE] = FREE, FREE
        if found != FREE:
            _, _, nx, ny, _, _ = place_on(pieces.rows, found, place, ball[b, RADIUS])
            along_it = ball[b, VX] * ny - ball[b, VY] * nx
            if tracks[b] >= 0:
                put_on(pieces, balls, b, found, place, along_it, ball[b, SPIN])
            else:
                x, y, _, _, _, _ = place_on(pieces.rows, found, place, ball[b, RADIUS])
                ball[b, X], ball[b, Y] = x, y

"""A step of many plates in the air: Runge-Kutta of fourth order, LANES of them at a time.

The kernel copies LANES plates into a small buffer whose rows lie LANES numbers apart. So the compiler can
prove them apart and computes as many lanes at once as the machine has. It calls nothing in there.

Each plate has as many substeps as its own rates ask for, so a light, fast or spinning one takes no other's
time. In still air what a substep has added to the energy is taken back from its motion: the law only takes,
and what Runge-Kutta errs by (fifth order in a step) may not add.

The wind comes as arrays, from wherever it is: at each plate its velocity, gradient and rate at the
beginning of the step. Within the step it is linear in place and time: fourth order in all in still air and
in such a wind, second where the wind is curved.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.plates import law as la
from game.physics.plates.law import cosine, half_drag, sine

WX, WY, WX_X, WX_Y, WY_X, WY_Y, WX_T, WY_T = range(8)  # wind m/s, its gradient 1/s, its rate m/s²
WIND = 8
LANES = 16
LAW = la.STATE  # rows of the buffer
AIR = LAW + la.COLUMNS
COS, SIN, FROM_X, FROM_Y, TIME, LENGTH, PER_X, PER_Y, PER_TURN, PER_BEND = (AIR + WIND + k for k in range(10))
SLOPE = AIR + WIND + 10  # slopes of the stage before, in the order of the state
COS_SLOPE, SIN_SLOPE = SLOPE + la.STATE, SLOPE + la.STATE + 1
SUM = SLOPE + la.STATE + 2
COS_SUM, SIN_SUM = SUM + la.STATE, SUM + la.STATE + 1
ROWS = SUM + la.STATE + 2
METHODS = ("explicit-euler", "midpoint", "rk4")
MIDPOINT, RK4 = 1.0, 2.0  # places in METHODS
MOST_SUBSTEPS = 4096
PART = 0.6  # of the fastest rate that a substep may be long
CAMBER = 2.0 / math.pi  # circulation of a kinked wing beside C_T's, for each sin q (Glauert 1926)


@inner_kernel(forceinline=True)
def law_at(b, i):
    """The law's 16 numbers of the lane i, in the order of the columns."""
    return (
        b[(LAW + la.HALF) * LANES + i],
        b[(LAW + la.MASS_X) * LANES + i],
        b[(LAW + la.MASS_Y) * LANES + i],
        b[(LAW + la.INERTIA) * LANES + i],
        b[(LAW + la.WEIGHT) * LANES + i],
        b[(LAW + la.TURN) * LANES + i],
        b[(LAW + la.GLIDE) * LANES + i],
        b[(LAW + la.DRAG) * LANES + i],
        b[(LAW + la.DRAG_TURN) * LANES + i],
        b[(LAW + la.TORQUE) * LANES + i],
        b[(LAW + la.TORQUE_2) * LANES + i],
        b[(LAW + la.BEND_INERTIA) * LANES + i],
        b[(LAW + la.STIFF) * LANES + i],
        b[(LAW + la.DAMP) * LANES + i],
        b[(LAW + la.CURL) * LANES + i],
        b[(LAW + la.OFFSET) * LANES + i],
    )


@inner_kernel(forceinline=True)
def rates(motion, wind, fall, law, per, bent):
    """Accelerations (x, y, spin, bend) of a plate.

    motion: cos and sin of its angle, vx, vy, spin, bend and its rate; wind: its velocity, and its rate
    along the way; law: see `law_at`; per: one over its four inertias. bent: False only if the bend is 0.
    """
    c, s, vx, vy, spin, q, rate = motion
    wx, wy, dwx, dwy = wind
    (half, mass_x, mass_y, _, weight, turn, glide, drag, drag_turn, torque, torque_2, _,
     stiff, damp, curl, offset) = law  # fmt: skip
    per_x, per_y, per_turn, per_bend = per
    rx, ry = vx - wx, vy - wy
    ux, uy = c * rx + s * ry, c * ry - s * rx
    py = uy + spin * offset  # of the middle, which the air pushes
    gx, gy = -dwx, -fall - dwy
    bx, by = c * gx + s * gy, c * gy - s * gx
    # of no bend they have these very bits, and the quotients of the series are most of a stage's time
    up, level = (sine(q), cosine(q)) if bent else (q, 1.0)
    slow = 1.0 / (math.sqrt(ux * ux + py * py) + 1e-300)
    lift = turn * spin - glide * (ux * py * slow + CAMBER * up * ux)
    # the halves: where their middles are, how these move with the bend, and how much each is on its own
    apart = q * q / (q * q + la.HALF_BEND * la.HALF_BEND) if bent else 0.0
    arm, rise = 0.5 * half * level, 0.5 * half * la.HEAVY * up
    arm_q, rise_q = -0.5 * half * up, 0.5 * half * la.HEAVY * level
    turned = apart * spin
    mx, my = ux - turned * rise, py + rate * rise_q
    swing, spread = turned * arm, rate * arm_q
    fx1, fy1 = half_drag(mx + spread, my + swing, level, up, drag, drag_turn)
    fx2, fy2 = half_drag(mx - spread, my - swing, level, -up, drag, drag_turn)
    fx, fy = fx1 + fx2, fy1 + fy2
    by_halves = apart * (arm * (fy1 - fy2) - rise * fx)
    ax = (mass_y * spin * uy - lift * py + weight * bx - fx) * per_x - spin * uy
    ay = (lift * ux - mass_x * spin * ux + weight * by - fy) * per_y + spin * ux
    moment = (mass_x - mass_y) * ux * uy - (torque + torque_2 * abs(spin)) * spin - by_halves
    moment += offset * (lift * ux - fy)
    opening = -stiff * (q - curl) - damp * rate - arm_q * (fx1 - fx2) - rise_q * fy
    return c * ax - s * ay + dwx, s * ax + c * ay + dwy, moment * per_turn, opening * per_bend


@inner_kernel(forceinline=True)
def energy(motion, y, fall, law):
    """Energy of motion, and of bend and height, of a plate in still air, added mass counted, by pi rho a²."""
    c, s, vx, vy, spin, q, rate = motion
    ux, uy = c * vx + s * vy, c * vy - s * vx
    moving = 0.5 * (law[1] * ux * ux + law[2] * uy * uy + law[3] * spin * spin + law[11] * rate * rate)
    return moving, 0.5 * law[12] * (q - law[14]) * (q - law[14]) + law[4] * fall * y


@inner_kernel(forceinline=True)
def stage_of(b, i, part, weight, rules, bent):
    """`stage` of the lane i."""
    fall, inertia, bends, _, _ = rules
    law = law_at(b, i)
    per = b[PER_X * LANES + i], b[PER_Y * LANES + i], b[PER_TURN * LANES + i], b[PER_BEND * LANES + i]
    h = part * b[LENGTH * LANES + i]
    x, y = (
        b[la.X * LANES + i] + h * b[(SLOPE + la.X) * LANES + i],
        b[la.Y * LANES + i] + h * b[(SLOPE + la.Y) * LANES + i],
    )
    vx, vy = (
        b[la.VX * LANES + i] + h * b[(SLOPE + la.VX) * LANES + i],
        b[la.VY * LANES + i] + h * b[(SLOPE + la.VY) * LANES + i],
    )
    spin = b[la.SPIN * LANES + i] + h * b[(SLOPE + la.SPIN) * LANES + i]
    q = b[la.BEND * LANES + i] + h * b[(SLOPE + la.BEND) * LANES + i]
    rate = bends * (b[la.BEND_RATE * LANES + i] + h * b[(SLOPE + la.BEND_RATE) * LANES + i])
    c, s = (
        b[COS * LANES + i] + h * b[COS_SLOPE * LANES + i],
        b[SIN * LANES + i] + h * b[SIN_SLOPE * LANES + i],
    )
    dx, dy, dt = x - b[FROM_X * LANES + i], y - b[FROM_Y * LANES + i], b[TIME * LANES + i] + h
    xx, xy, xt = b[(AIR + WX_X) * LANES + i], b[(AIR + WX_Y) * LANES + i], b[(AIR + WX_T) * LANES + i]
    yx, yy, yt = b[(AIR + WY_X) * LANES + i], b[(AIR + WY_Y) * LANES + i], b[(AIR + WY_T) * LANES + i]
    wx = b[(AIR + WX) * LANES + i] + xx * dx + xy * dy + xt * dt
    wy = b[(AIR + WY) * LANES + i] + yx * dx + yy * dy + yt * dt
    dwx, dwy = inertia * (xt + xx * vx + xy * vy), inertia * (yt + yx * vx + yy * vy)
    ax, ay, turning, opening = rates((c, s, vx, vy, spin, q, rate), (wx, wy, dwx, dwy), fall, law, per, bent)
    opening = opening * bends
    b[(SLOPE + la.X) * LANES + i], b[(SLOPE + la.Y) * LANES + i] = vx, vy
    b[(SLOPE + la.THETA) * LANES + i], b[(SLOPE + la.SPIN) * LANES + i] = spin, turning
    b[(SLOPE + la.VX) * LANES + i], b[(SLOPE + la.VY) * LANES + i] = ax, ay
    b[(SLOPE + la.BEND) * LANES + i], b[(SLOPE + la.BEND_RATE) * LANES + i] = rate, opening
    b[COS_SLOPE * LANES + i], b[SIN_SLOPE * LANES + i] = -spin * s, spin * c
    b[(SUM + la.X) * LANES + i] += weight * vx
    b[(SUM + la.Y) * LANES + i] += weight * vy
    b[(SUM + la.THETA) * LANES + i] += weight * spin
    b[(SUM + la.VX) * LANES + i] += weight * ax
    b[(SUM + la.VY) * LANES + i] += weight * ay
    b[(SUM + la.SPIN) * LANES + i] += weight * turning
    b[(SUM + la.BEND) * LANES + i] += weight * rate
    b[(SUM + la.BEND_RATE) * LANES + i] += weight * opening
    b[COS_SUM * LANES + i] += weight * -spin * s
    b[SIN_SUM * LANES + i] += weight * spin * c


@inner_kernel
def stage(b, part, weight, rules, bent):
    """A stage of Runge-Kutta of all lanes: slopes ``part`` of the substep on, weighed into sums.

    Two loops, as a loop that asks does not come in vectors.
    """
    if bent:
        for i in range(LANES):
            stage_of(b, i, part, weight, rules, True)
    else:
        for i in range(LANES):
            stage_of(b, i, part, weight, rules, False)


@inner_kernel
def finish(b, rules):
    """End a substep of all lanes by the sums of its slopes; energy does not rise in still air."""
    fall, _, _, still, _ = rules
    for i in range(LANES):
        law = law_at(b, i)
        going = b[LENGTH * LANES + i] > 0.0
        sixth = b[LENGTH * LANES + i] / 6.0
        c, s, y = b[COS * LANES + i], b[SIN * LANES + i], b[la.Y * LANES + i]
        vx, vy, spin = b[la.VX * LANES + i], b[la.VY * LANES + i], b[la.SPIN * LANES + i]
        q, rate = b[la.BEND * LANES + i], b[la.BEND_RATE * LANES + i]
        moving, lying = energy((c, s, vx, vy, spin, q, rate), y, fall, law)
        c, s = c + sixth * b[COS_SUM * LANES + i], s + sixth * b[SIN_SUM * LANES + i]
        length = 1.0 / math.sqrt(c * c + s * s) if going else 1.0
        c, s = c * length, s * length
        y = y + sixth * b[(SUM + la.Y) * LANES + i]
        vx, vy = vx + sixth * b[(SUM + la.VX) * LANES + i], vy + sixth * b[(SUM + la.VY) * LANES + i]
        spin = spin + sixth * b[(SUM + la.SPIN) * LANES + i]
        q, rate = (
            q + sixth * b[(SUM + la.BEND) * LANES + i],
            rate + sixth * b[(SUM + la.BEND_RATE) * LANES + i],
        )
        rate = 0.0 if (q > la.MOST_BEND) | (q < -la.MOST_BEND) else rate
        q = min(max(q, -la.MOST_BEND), la.MOST_BEND)
        now, low = energy((c, s, vx, vy, spin, q, rate), y, fall, law)
        spare = max(moving + lying - low, 0.0)
        ratio = math.sqrt(spare / (now + 1e-300))
        keep = ratio if (still > 0.5) & (now > spare) & going else 1.0
        b[la.X * LANES + i] += sixth * b[(SUM + la.X) * LANES + i]
        b[la.THETA * LANES + i] += sixth * b[(SUM + la.THETA) * LANES + i]
        b[TIME * LANES + i] += b[LENGTH * LANES + i]
        b[COS * LANES + i], b[SIN * LANES + i], b[la.Y * LANES + i] = c, s, y
        b[la.VX * LANES + i], b[la.VY * LANES + i], b[la.SPIN * LANES + i] = keep * vx, keep * vy, keep * spin
        b[la.BEND * LANES + i], b[la.BEND_RATE * LANES + i] = q, keep * rate


@inner_kernel
def substep(b, rules, bent):
    """One substep of all lanes of the buffer b, as long as each says; a length of 0 changes nothing.

    bent: see `any_bent`.
    """
    for k in range(SLOPE, ROWS):
        for i in range(LANES):
            b[k * LANES + i] = 0.0
    method = rules[4]
    if method == RK4:
        stage(b, 0.0, 1.0, rules, bent)
        stage(b, 0.5, 2.0, rules, bent)
        stage(b, 0.5, 2.0, rules, bent)
        stage(b, 1.0, 1.0, rules, bent)
    elif method == MIDPOINT:
        stage(b, 0.0, 0.0, rules, bent)
        stage(b, 0.5, 6.0, rules, bent)
    else:
        stage(b, 0.0, 6.0, rules, bent)
    finish(b, rules)


@inner_kernel(forceinline=True)
def parts_of(b, i, fall, dt):
    """How many of the substeps that the lane i bears are in dt (s)."""
    rx, ry = (
        b[la.VX * LANES + i] - b[(AIR + WX) * LANES + i],
        b[la.VY * LANES + i] - b[(AIR + WY) * LANES + i],
    )
    light = b[(LAW + la.MASS_X) * LANES + i]
    speed = math.sqrt(rx * rx + ry * ry) + math.sqrt(fall * b[(LAW + la.HALF) * LANES + i] * light) + 1e-9
    spin = abs(b[la.SPIN * LANES + i])
    heavy = b[(LAW + la.MASS_Y) * LANES + i]
    pushes = (b[(LAW + la.DRAG) * LANES + i] + abs(b[(LAW + la.GLIDE) * LANES + i])) * speed
    pushes += abs(b[(LAW + la.TURN) * LANES + i]) * spin
    turning = b[(LAW + la.TORQUE) * LANES + i] + 2.0 * b[(LAW + la.TORQUE_2) * LANES + i] * spin
    along = (2.0 * pushes + heavy * spin) / light
    about = turning / b[(LAW + la.INERTIA) * LANES + i]
    bending = b[(LAW + la.STIFF) * LANES + i] / b[(LAW + la.BEND_INERTIA) * LANES + i]
    swing = math.sqrt(heavy * speed * speed / (light * b[(LAW + la.INERTIA) * LANES + i]))
    fastest = max(max(along, about), max(math.sqrt(bending), swing))
    return fastest * dt / PART


@inner_kernel
def any_bent(b):
    """Whether a lane is bent or can be."""
    bent = False
    for i in range(LANES):
        bent |= (b[la.BEND * LANES + i] != 0.0) | (b[la.BEND_RATE * LANES + i] != 0.0)
        bent |= b[PER_BEND * LANES + i] != 0.0
    return bent


@inner_kernel
def load(b, row, rows, first, many):
    """Copy ``many`` columns of rows (k, n) from ``first`` on; lanes without one get the first of them."""
    if many == LANES:  # in vectors
        for k in range(rows.shape[0]):
            for i in range(LANES):
                b[(row + k) * LANES + i] = rows[k, first + i]
        return
    for k in range(rows.shape[0]):
        for i in range(many):
            b[(row + k) * LANES + i] = rows[k, first + i]
        for i in range(many, LANES):
            b[(row + k) * LANES + i] = rows[k, first]


@inner_kernel
def prepare(b, counts, fall, dt):
    """What a step needs of each lane, and how many substeps: in loops apart, for some come in vectors."""
    for i in range(LANES):
        theta = b[la.THETA * LANES + i]
        b[COS * LANES + i], b[SIN * LANES + i] = elementary.cos(theta), elementary.sin(theta)
    for i in range(LANES):
        b[FROM_X * LANES + i], b[FROM_Y * LANES + i] = b[la.X * LANES + i], b[la.Y * LANES + i]
        b[TIME * LANES + i] = 0.0
        b[PER_X * LANES + i] = 1.0 / b[(LAW + la.MASS_X) * LANES + i]
        b[PER_Y * LANES + i] = 1.0 / b[(LAW + la.MASS_Y) * LANES + i]
        b[PER_TURN * LANES + i] = 1.0 / b[(LAW + la.INERTIA) * LANES + i]
        gives = b[(LAW + la.STIFF) * LANES + i] > 0.0
        b[PER_BEND * LANES + i] = 1.0 / b[(LAW + la.BEND_INERTIA) * LANES + i] if gives else 0.0
        b[LENGTH * LANES + i] = parts_of(b, i, fall, dt)
    for i in range(LANES):
        parts = b[LENGTH * LANES + i]
        counts[i] = int(parts) + 1 if parts < MOST_SUBSTEPS else MOST_SUBSTEPS
        b[LENGTH * LANES + i] = dt / counts[i]


@lean_kernel
def fly(state, laws, air, buffer, counts, settings, dt):
    """Go on by dt (s).

    state (STATE, n), laws (COLUMNS, n), air (WIND, n); buffer (ROWS LANES,); counts (LANES,): scratch;
    settings: gravity (m/s²), 1 if a changing wind pushes, 1 if plates bend, 1 if the air is still, the
    method's place in METHODS.
    """
    n = state.shape[1]
    for first in range(0, n, LANES):
        many = min(LANES, n - first)
        load(buffer, 0, state, first, many)
        load(buffer, LAW, laws, first, many)
        load(buffer, AIR, air, first, many)
        prepare(buffer, counts, settings[0], dt)
        bent = any_bent(buffer)
        most = 1
        for i in range(LANES):
            most = max(most, counts[i])
        for k in range(most):
            if k:
                for i in range(LANES):
                    if k >= counts[i]:
                        buffer[LENGTH * LANES + i] = 0.0
            substep(buffer, settings, bent)
        for k in range(la.STATE):
            for i in range(many):
                state[k, first + i] = buffer[k * LANES + i]

"""Impacts at their moments: what two bodies do to each other when they meet within a substep.

Between impacts bodies go straight on: at the time t of a substep of h a body with velocity V at its end is at
X + t (V - (h - t) a), with a the acceleration of its forces. Where a gap closes faster than what rests, its
moment is found. The levers of both bodies are taken to the one point where they meet then, and `impact_law`
says the impulse. Velocity changes by dV, and X by -t dV, so that the body has gone with the old one until the
moment and with the new one after it. Both bodies feel the impulse at one point and at one time: momentum, and
spin about any point, are kept to rounding; and what comes back has the energy of its law.

Impacts follow each other in sweeps until none is left, or for `MOST_SWEEPS`: a heavy ball lifts a light one
only after it has met the floor itself. Contacts then stop what still closes, without a bounce. Two points of
a face that meet at once are solved together, by Newton's law. What does not bounce and meets several others
in one substep, or touches already, is left to contacts, where these can hold all together.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.arrays import state
from game.physics.solids.joints.sweeps import solve_three
from game.physics.solids.rows import FIRST, RESTLESS, SECOND
from game.physics.solids.solvers.impact_law import impact_impulse
from game.physics.solids.solvers.impulses import gap_now, gap_speed
from game.physics.solids.solvers.motion import cosine_sine

MOST_SWEEPS = 32
# bounces only; those too that do not bounce, of bodies that meet nothing else in the substep; all, by turns
BOUNCES, ALONE, ALL = range(3)
MOST_LOOKS = 8  # at where two are, until their moment is found
EXACT = 1e-14  # of a substep, by which the moment is known
AT_ONCE = 1e-6  # of a substep: two points of a face that meet within that meet at once
SLOW = 0.5  # of what is calm: slower by the levers of the step, it is not looked at
AT_CENTRE = 1e-12  # m: a disc's core is its body's centre


@inner_kernel
def pose_at(scratch, i, t, h):
    """Of body i at the time t (s) of a substep: way since the step began, turn; velocity and spin."""
    motion, pulls, left = scratch.motion, scratch.accelerations, h - t
    vx, vy = motion[i, state.VX] - left * pulls[i, 0], motion[i, state.VY] - left * pulls[i, 1]
    w = motion[i, state.W] - left * pulls[i, 2]
    return motion[i, state.DX] + t * vx, motion[i, state.DY] + t * vy, motion[i, state.DA] + t * w, vx, vy, w


@inner_kernel
def turned(cross, dot, rounding, turn):
    """Lever of a point (r x n, r . n) when its body has turned; rounding does not turn with it."""
    if turn == 0.0:
        return cross, dot
    c, s = cosine_sine(turn)
    core = dot + rounding
    return cross * c - core * s, core * c + cross * s - rounding


@inner_kernel
def where_they_meet(row, c, at, pose_a, pose_b):
    """Of the point at column ``at``, with both bodies there: normal, levers (r x n of both, r . n of both) of
    the one point where they meet, and its gap.

    That point is midway, or on the one that moves where the other cannot. Of two discs, the normal joins the
    centres.
    """
    nx, ny = row[c, state.ROW_NX], row[c, state.ROW_NY]
    ca, da = turned(row[c, at + state.CROSS_A], row[c, at + state.DOT_A], row[c, state.ROUND_A], pose_a[2])
    cb, db = turned(row[c, at + state.CROSS_B], row[c, at + state.DOT_B], row[c, state.ROUND_B], pose_b[2])
    x, y = pose_b[0] - pose_a[0], pose_b[1] - pose_a[1]
    gap, slid = x * nx + y * ny, x * ny - y * nx
    gap += row[c, at + state.SEP] + db - row[c, at + state.DOT_B] - da + row[c, at + state.DOT_A]
    slid += cb - row[c, at + state.CROSS_B] - ca + row[c, at + state.CROSS_A]
    round_a, round_b = -row[c, state.ROUND_A], row[c, state.ROUND_B]
    if max(abs(ca), abs(cb), abs(da - round_a), abs(db + round_b)) <= AT_CENTRE:
        far = row[c, at + state.SEP] + round_a + round_b + x * nx + y * ny
        length = math.sqrt(far * far + slid * slid)
        if length > 0.0:
            gap = length - round_a - round_b
            nx, ny = (far * nx + slid * ny) / length, (far * ny - slid * nx) / length
            return nx, ny, 0.0, 0.0, round_a + 0.5 * gap, -round_b - 0.5 * gap, gap
    share = 0.5
    if row[c, state.ROW_IMA] == 0.0:
        share = 1.0
    elif row[c, state.ROW_IMB] == 0.0:
        share = 0.0
    apart = gap - min(row[c, at + state.SEP], 0.0)  # of what overlapped, both levers ended at one point
    ca, da = ca + share * slid, da + share * apart
    cb, db = cb - (1.0 - share) * slid, db - (1.0 - share) * apart
    return nx, ny, ca, cb, da, db, gap


@inner_kernel
def speeds_there(pose_a, pose_b, place):
    """Of b's surface against a's where they meet: along the normal, along the tangent, m/s."""
    nx, ny, ca, cb, da, db, _ = place
    x, y, wa, wb = pose_b[3] - pose_a[3], pose_b[4] - pose_a[4], pose_a[5], pose_b[5]
    return x * nx + y * ny + wb * cb - wa * ca, x * ny - y * nx - wb * db + wa * da


@inner_kernel
def moment(row, c, at, ends, scratch, h):
    """When (s) the gap of a point that closes is 0; 0 if it overlaps, infinite: not in this substep."""
    a, b = ends[c, state.END_A], ends[c, state.END_B]
    t = 0.0
    for _ in range(MOST_LOOKS):
        pose_a, pose_b = pose_at(scratch, a, t, h), pose_at(scratch, b, t, h)
        place = where_they_meet(row, c, at, pose_a, pose_b)
        vn, _ = speeds_there(pose_a, pose_b, place)
        if t == 0.0 and place[6] <= 0.0:
            return 0.0
        if vn >= 0.0:
            return math.inf
        step = -place[6] / vn
        t += step
        if t > h:
            return math.inf
        if t < 0.0:
            return 0.0
        if abs(step) <= EXACT * h:
            break
    return t


@inner_kernel
def coupling_there(row, c, first, second):
    """Entries of K between impulses at two places: knn, knt, ktt (the same place twice: of one point)."""
    both, iia, iib = (
        row[c, state.ROW_IMA] + row[c, state.ROW_IMB],
        row[c, state.ROW_IIA],
        row[c, state.ROW_IIB],
    )
    _, _, ca, cb, da, db, _ = first
    _, _, ga, gb, ea, eb, _ = second
    return (
        both + iia * ca * ga + iib * cb * gb,
        -iia * ca * ea - iib * cb * eb,
        both + iia * da * ea + iib * db * eb,
    )


@inner_kernel
def hit(rows, c, scratch, t, h, place, impulse):
    """Give both bodies of a row an impulse (normal, tangential) at one place, at the time t of a substep."""
    row, (nx, ny, ca, cb, da, db, _), (jn, jt) = rows.rows, place, impulse
    x, y, a, b = jn * nx + jt * ny, jn * ny - jt * nx, rows.ends[c, state.END_A], rows.ends[c, state.END_B]
    kick(
        scratch,
        a,
        t,
        h,
        -row[c, state.ROW_IMA] * x,
        -row[c, state.ROW_IMA] * y,
        -row[c, state.ROW_IIA] * (ca * jn - da * jt),
    )
    kick(
        scratch,
        b,
        t,
        h,
        row[c, state.ROW_IMB] * x,
        row[c, state.ROW_IMB] * y,
        row[c, state.ROW_IIB] * (cb * jn - db * jt),
    )


@inner_kernel
def kick(scratch, i, t, h, x, y, turn):
    """Change velocity and spin of body i at the time t of a substep: it has gone with the old ones so far."""
    motion, going = scratch.motion, scratch.going
    motion[i, state.VX] += x
    motion[i, state.VY] += y
    motion[i, state.W] += turn
    if t > 0.0:
        motion[i, state.DX] -= t * x
        motion[i, state.DY] -= t * y
        if turn != 0.0:
            motion[i, state.DA] -= t * turn
            motion[i, state.DC], motion[i, state.DS] = cosine_sine(motion[i, state.DA])
        going[i, 0] -= t * x / h
        going[i, 1] -= t * y / h
        going[i, 2] -= t * turn / h


@inner_kernel
def restitution_at(rare, c, vn, numbers):
    """Of what closes at vn (negative, m/s): slow impacts do not bounce."""
    return rare[c, state.RESTITUTION] if vn <= -numbers.bounce else 0.0


@inner_kernel
def note_impact(row, rare, c, k, jn):
    """An impulse is remembered for events, and is no guess for the next substep."""
    at = FIRST + k * state.ROW_POINT_WIDTH
    rare[c, state.MOST_0 + k] = max(rare[c, state.MOST_0 + k], jn)
    row[c, at + state.JN], row[c, at + state.JT] = 0.0, 0.0


@inner_kernel
def strike_point(rows, c, k, scratch, t, numbers, calm):
    """The impact of one point at the time t; False if it does not close faster than calm there."""
    row, a, b, h = rows.rows, rows.ends[c, state.END_A], rows.ends[c, state.END_B], numbers.h
    pose_a, pose_b = pose_at(scratch, a, t, h), pose_at(scratch, b, t, h)
    place = where_they_meet(row, c, FIRST + k * state.ROW_POINT_WIDTH, pose_a, pose_b)
    speeds = speeds_there(pose_a, pose_b, place)
    if speeds[0] >= -calm:
        return False
    e = restitution_at(rows.rare, c, speeds[0], numbers)
    if e == 0.0 and t == 0.0:  # they touch already: to hold them is for contacts
        return False
    jn, jt = impact_impulse(
        coupling_there(row, c, place, place), speeds, row[c, state.ROW_MU], e, numbers.impact_law
    )
    hit(rows, c, scratch, t, h, place, (jn, jt))
    note_impact(row, rows.rare, c, k, jn)
    return True


@inner_kernel
def face_impulses(matrix, speeds, wanted, mu):
    """Normal impulses of both points, and their tangential one together; (-1, -1, 0) if one would pull.

    matrix: k11, k12, k22, k1t, k2t, ktt. speeds: v1, v2, vt before. wanted: v1 and v2 after.
    """
    k11, k12, k22, k1t, k2t, ktt = matrix
    v1, v2, vt = speeds
    r1, r2 = wanted[0] - v1, wanted[1] - v2
    j1, j2, jt = solve_three(k11, k12, k1t, k22, k2t, ktt, r1, r2, -vt)
    if j1 >= 0.0 and j2 >= 0.0 and abs(jt) <= mu * (j1 + j2):
        return j1, j2, jt
    share = -mu if vt > 0.0 or (vt == 0.0 and jt < 0.0) else mu
    a11, a12, a21, a22 = k11 + share * k1t, k12 + share * k1t, k12 + share * k2t, k22 + share * k2t
    under = a11 * a22 - a12 * a21
    if not under > 0.0:
        return -1.0, -1.0, 0.0
    j1, j2 = (r1 * a22 - r2 * a12) / under, (r2 * a11 - r1 * a21) / under
    if j1 < 0.0 or j2 < 0.0:
        return -1.0, -1.0, 0.0
    return j1, j2, share * (j1 + j2)


@inner_kernel
def strike_face(rows, c, scratch, t, numbers, calm):
    """The impact of both points of a row at once; False if they are better taken one after the other."""
    row, a, b, h = rows.rows, rows.ends[c, state.END_A], rows.ends[c, state.END_B], numbers.h
    pose_a, pose_b = pose_at(scratch, a, t, h), pose_at(scratch, b, t, h)
    one = where_they_meet(row, c, FIRST, pose_a, pose_b)
    two = where_they_meet(row, c, SECOND, pose_a, pose_b)
    v1, vt = speeds_there(pose_a, pose_b, one)
    v2, ut = speeds_there(pose_a, pose_b, two)
    if max(v1, v2) >= 0.0 or min(v1, v2) >= -calm:
        return False
    if t == 0.0 and restitution_at(rows.rare, c, min(v1, v2), numbers) == 0.0:
        return False
    k11, k1t, ktt = coupling_there(row, c, one, one)
    k12, k12t, kttt = coupling_there(row, c, one, two)
    k22, k2t, utt = coupling_there(row, c, two, two)
    _, k21t, _ = coupling_there(row, c, two, one)
    most = 0.98 * math.sqrt(k11 * k22)
    wanted = -restitution_at(rows.rare, c, v1, numbers) * v1, -restitution_at(rows.rare, c, v2, numbers) * v2
    matrix = (
        k11, max(-most, min(most, k12)), k22, 0.5 * (k1t + k12t), 0.5 * (k2t + k21t),
        0.25 * (ktt + utt) + 0.5 * kttt,
    )  # fmt: skip
    j1, j2, jt = face_impulses(matrix, (v1, v2, 0.5 * (vt + ut)), wanted, row[c, state.ROW_MU])
    if j1 < 0.0:
        return False
    energy = j1 * v1 + j2 * v2 + 0.5 * jt * (vt + ut)
    own = 0.5 * (k11 * j1 * j1 + k22 * j2 * j2) + k12 * j1 * j2
    own += jt * (matrix[3] * j1 + matrix[4] * j2) + 0.5 * matrix[5] * jt * jt
    if energy + own > 0.0 and own > 0.0:  # a shorter impulse gives none: friction that would turn the slide
        part = max(0.0, -energy / own)
        j1, j2, jt = part * j1, part * j2, part * jt
    hit(rows, c, scratch, t, h, one, (j1, 0.5 * jt))
    hit(rows, c, scratch, t, h, two, (j2, 0.5 * jt))
    note_impact(row, rows.rare, c, 0, j1)
    note_impact(row, rows.rare, c, 1, j2)
    return True


@inner_kernel
def strike_row(rows, c, scratch, numbers, calm):
    """The next impact of a row in this substep; False if there is none."""
    row, a, b, h = rows.rows, rows.ends[c, state.END_A], rows.ends[c, state.END_B], numbers.h
    motion, t1, t2 = scratch.motion, math.inf, math.inf
    if gap_speed(row, c, FIRST, motion, a, b) < -SLOW * calm:
        t1 = moment(row, c, FIRST, rows.ends, scratch, h)
    if rows.ends[c, state.END_POINTS] == 2 and gap_speed(row, c, SECOND, motion, a, b) < -SLOW * calm:
        t2 = moment(row, c, SECOND, rows.ends, scratch, h)
    if t1 == math.inf and t2 == math.inf:
        return False
    if abs(t1 - t2) <= AT_ONCE * h and strike_face(rows, c, scratch, 0.5 * (t1 + t2), numbers, calm):
        return True
    if t1 <= t2:
        return strike_point(rows, c, 0, scratch, t1, numbers, calm) or (
            t2 < math.inf and strike_point(rows, c, 1, scratch, t2, numbers, calm)
        )
    return strike_point(rows, c, 1, scratch, t2, numbers, calm) or (
        t1 < math.inf and strike_point(rows, c, 0, scratch, t1, numbers, calm)
    )


@inner_kernel
def closes_within(row, c, at, motion, a, b, h, calm):
    """True if the gap of a point closes within h (s), faster than calm (m/s), by the levers of the step."""
    speed = gap_speed(row, c, at, motion, a, b)
    return speed < -SLOW * calm and gap_now(row, c, at, motion, a, b) + h * speed < 0.0


@inner_kernel
def count_meetings(rows, scratch, h, calm):
    """How many others each body will meet in this substep, to ``meetings``; True if any meets one."""
    row, motion, meetings, any_meets = rows.rows, scratch.motion, scratch.meetings, False
    meetings[:] = 0
    for c in range(rows.count[0]):
        a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
        meets = closes_within(row, c, FIRST, motion, a, b, h, calm)
        if not meets and rows.ends[c, state.END_POINTS] == 2:
            meets = closes_within(row, c, SECOND, motion, a, b, h, calm)
        if meets:
            meetings[a] += 1
            meetings[b] += 1
            any_meets = True
    return any_meets


@inner_kernel
def is_crowded(rows, c, scratch):
    """True if one of the two of a row meets others at the same time, too."""
    a, b = rows.ends[c, state.END_A], rows.ends[c, state.END_B]
    many = scratch.meetings[a] if rows.rows[c, state.ROW_IMA] > 0.0 else 0
    return max(many, scratch.meetings[b] if rows.rows[c, state.ROW_IMB] > 0.0 else 0) > 1


@inner_kernel
def resolve_impacts(rows, scratch, numbers, which):
    """All impacts of a substep whose forces are in the velocities, but whose way is not gone yet; True if
    there was any. which: `BOUNCES`, `ALONE` or `ALL`.
    """
    calm, any_found = RESTLESS * numbers.dt, False
    if not count_meetings(rows, scratch, numbers.h, calm):
        return False
    for _ in range(MOST_SWEEPS):
        found = False
        for c in range(rows.count[0]):
            if (
                rows.rare[c, state.RESTITUTION] == 0.0
                and which < ALL
                and (which < ALONE or is_crowded(rows, c, scratch))
            ):
                continue
            found = strike_row(rows, c, scratch, numbers, calm) or found
        any_found = any_found or found
        if not found:
            break
    return any_found

"""Which impulse an impact of two rigid bodies at one point has, with friction: three named laws.

Normal and tangential motion go on together while the normal impulse p grows: dv/dp = (knn + knt f, knt + ktt
f), where f is the friction of one unit of p: -mu sign(vt) while the point slides. What holds it once it
sticks, if mu is enough for that. Else mu the other way, and it slides back (Routh 1905, "Dynamics of a System
of Rigid Bodies", I, 179 to 198; Keller 1986). Compression ends where vn is 0. The laws differ in when the
impact ends:

newton: vn is -e times its first value. With friction that may give energy (Kane, Levinson 1985).
poisson: p is 1 + e times that of compression.
energetic: the work of p in restitution is e² of that in compression (Stronge 1990). No energy is ever won.

Without friction, or without coupling of normal and tangent (discs, spheres), all three are the same.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel

NEWTON, POISSON, ENERGETIC = range(3)
IMPACT_LAWS = ("newton", "poisson", "energetic")
MOST_PIECES = 4  # sliding, sticking or sliding back, and the end of compression within one of them


@inner_kernel
def friction_share(knt, ktt, vt, mu):
    """Tangential impulse of one unit of normal impulse."""
    if vt > 0.0:
        return -mu
    if vt < 0.0:
        return mu
    return max(-mu, min(mu, -knt / ktt))


@inner_kernel
def way_to_work(speed, rate, work):
    """The p after which speed p + rate p²/2 is work; infinite if it never is. Only rate may be negative."""
    under = speed * speed + 2.0 * rate * work
    if under < 0.0:
        return math.inf
    below = speed + math.sqrt(under)
    return 2.0 * work / below if below > 0.0 else math.inf


@inner_kernel
def way_to_end(law, e, first, speed, rate, spent, done):
    """The p that is left of restitution, from where vn = speed changes at this rate; infinite: not by it.

    first: vn when the impact began. spent: impulse and work of compression, done: of restitution so far.
    """
    if law == POISSON:
        return max(0.0, e * spent[0] - done[0])
    if law == ENERGETIC:
        return way_to_work(speed, rate, max(0.0, -e * e * spent[1] - done[1]))
    missing = -e * first - speed
    if missing <= 0.0:
        return 0.0
    return missing / rate if rate > 0.0 else math.inf


@inner_kernel
def impact_impulse(coupling, speeds, mu, e, law):
    """Normal and tangential impulse, N s, of an impact; 0 of two that do not close.

    coupling: knn, knt, ktt, 1/kg, by which impulses change the speeds. speeds: vn (negative: closing) and vt,
    m/s, of one body against the other at the point. law: `NEWTON`, `POISSON` or `ENERGETIC`.
    """
    knn, knt, ktt = coupling
    vn, vt = speeds
    jn, jt, first = 0.0, 0.0, vn
    spent, done, closing = (0.0, 0.0), (0.0, 0.0), True
    if vn >= 0.0:
        return 0.0, 0.0
    for _ in range(MOST_PIECES):
        share = friction_share(knt, ktt, vt, mu)
        rate, slide_rate = knn + knt * share, knt + ktt * share
        stops = -vt / slide_rate if vt * slide_rate < 0.0 else math.inf
        ends = math.inf
        if not closing:
            ends = way_to_end(law, e, first, vn, rate, spent, done)
        elif rate > 0.0:
            ends = -vn / rate
        p = min(stops, ends)
        if p == math.inf:  # no end is near: a positive definite coupling does not come here but by rounding
            break
        jn, jt = jn + p, jt + share * p
        work = p * (vn + 0.5 * rate * p)
        vn, vt = vn + rate * p, 0.0 if stops <= ends else vt + slide_rate * p
        if not closing:
            done = (done[0] + p, done[1] + work)
        else:
            spent = (spent[0] + p, spent[1] + work)
        if ends <= stops:
            if not closing or e == 0.0:
                break
            closing, vn = False, 0.0
    return jn, jt

"""Ways to pot a ball, from geometry alone: direct, cut, bank, kick, combination.

Balls go straight and cushions are mirrors here. How far the truth may lie from it is a candidate's spread,
which is then searched with exact strokes. Mirror images: Smith 2007, PickPocket.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.search import lanes
from game.billiards.search.lanes import chance_within, lane_is_free, pocket_window
from game.physics.kernels import elementary

# columns of candidates (c, 8): row of the ball to be potted; pocket; kind; row of the ball in between (-1:
# none); azimuth of the stroke and how far to search on both sides of it, rad; half the window that it has for
# a pot, rad; estimated chance
BALL, INTO, KIND, VIA, AIM, SPREAD, WINDOW, CHANCE = range(8)
COLUMNS = 8

DIRECT, BANK, KICK, COMBINATION = range(4)
KINDS = ("direct", "bank", "kick", "combination")
NO_POT = len(KINDS)  # kind of a stroke that means to pot nothing
CUT_FROM = math.radians(30.0)  # a direct shot with at least this cut is called a cut

THROW = 0.09  # rad; most that friction turns the path of an object ball
BANK_ERROR = 0.2  # rad; how far a bank is from a mirror image
KICK_ERROR = 0.12  # rad; the same for a cue ball, which slides
BANK_UNSURE = 0.03  # rad; unsteadiness that a cushion adds
MOUTH = 0.035  # m; so far beyond the circle of capture there is no cushion
MOST = 512  # candidates


class Candidate(NamedTuple):
    """A candidate before it is stored: the columns of its row, as above."""

    ball: int
    pocket: int
    kind: int
    via: int
    aim: float
    spread: float
    window: float
    chance: float


@inner_kernel(inline="always")
def _store(found, count, candidate):
    """Write a candidate; the least likely one gives way when `found` is full. Returns the number stored."""
    row = count
    if count >= found.shape[0]:
        row = 0
        for k in range(1, count):
            row = k if found[k, CHANCE] < found[row, CHANCE] else row
        if candidate.chance <= found[row, CHANCE]:
            return count
        count -= 1
    found[row, BALL] = candidate.ball
    found[row, INTO] = candidate.pocket
    found[row, KIND] = candidate.kind
    found[row, VIA] = candidate.via
    found[row, AIM] = candidate.aim
    found[row, SPREAD] = candidate.spread
    found[row, WINDOW] = candidate.window
    found[row, CHANCE] = candidate.chance
    return count + 1


@inner_kernel
def _aim_at_ghost(places, geometry, first, from_x, from_y, ball, direction):
    """How ball `first` at `from` must run to send `ball` off in a direction (rad).

    Returns (azimuth rad, gain, x, y m): the last two are its place at the contact, the ghost ball's.
    gain: by how much an error of the azimuth turns the ball's path; 0: it cannot be. Lanes are not looked at.
    """
    radii, bed = geometry.radii, geometry.bed
    reach = 2.0 * math.sqrt(radii[first] * radii[ball])
    ux = elementary.cos(direction)
    uy = elementary.sin(direction)
    ghost_x = places[ball, 0] - reach * ux
    ghost_y = places[ball, 1] - reach * uy
    margin = radii[first] - 0.002
    if not (bed[0] + margin <= ghost_x <= bed[1] - margin and bed[2] + margin <= ghost_y <= bed[3] - margin):
        return 0.0, 0.0, ghost_x, ghost_y
    dx = ghost_x - from_x
    dy = ghost_y - from_y
    distance = math.sqrt(dx * dx + dy * dy)
    if distance < 1e-9:
        return direction, 1.0, ghost_x, ghost_y
    cosine = (dx * ux + dy * uy) / distance
    if cosine < lanes.LEAST_COSINE:
        return 0.0, 0.0, ghost_x, ghost_y
    return elementary.atan2(dy, dx), distance / (reach * cosine) + 1.0, ghost_x, ghost_y


@inner_kernel
def _reaches(places, geometry, x, y, ball):
    """True if the path of the cue ball to its place at the contact with `ball` is free."""
    radii, cue = geometry.radii, geometry.cue
    return lane_is_free(places, radii, places[cue, 0], places[cue, 1], x, y, radii[cue], cue, ball)


@inner_kernel
def _in_mouth(gates, x, y):
    """True if a ball that would bounce at (x, y) m finds no cushion there, but the mouth of a pocket."""
    for p in range(gates.shape[0]):
        dx = x - gates[p, lanes.GATE_X]
        dy = y - gates[p, lanes.GATE_Y]
        reach = gates[p, lanes.GATE_RADIUS] + MOUTH
        if dx * dx + dy * dy < reach * reach:
            return True
    return False


@inner_kernel
def _list_direct(places, geometry, ball, p, found, count):
    """The direct pot of a ball into pocket p."""
    radii, gates, _, cue, sight = geometry
    direction, half = pocket_window(gates, p, places[ball, 0], places[ball, 1], radii[ball])
    if half <= 0.0:
        return count
    aim, gain, x, y = _aim_at_ghost(places, geometry, cue, places[cue, 0], places[cue, 1], ball, direction)
    if gain == 0.0 or not _reaches(places, geometry, x, y, ball):
        return count
    if not lane_is_free(
        places, radii, places[ball, 0], places[ball, 1], gates[p, lanes.GATE_X], gates[p, lanes.GATE_Y],
        radii[ball], ball, cue,
    ):  # fmt: skip
        return count
    chance = chance_within(half, sight * gain + lanes.RUB)
    spread = (min(half, 0.2) + THROW) / gain
    return _store(found, count, Candidate(ball, p, DIRECT, -1, aim, spread, half / gain, chance))


@inner_kernel
def _list_bank(places, geometry, ball, p, side, found, count):
    """The pot of a ball into pocket p off a straight rail (side: 0 left, 1 right, 2 lower, 3 upper)."""
    radii, gates, bed, cue, sight = geometry
    axis = side // 2
    radius = radii[ball]
    line = bed[side] + (radius if side % 2 == 0 else -radius)
    to_x = gates[p, lanes.GATE_X]
    to_y = gates[p, lanes.GATE_Y]
    if axis == 0:
        to_x = 2.0 * line - to_x
    else:
        to_y = 2.0 * line - to_y
    x = places[ball, 0]
    y = places[ball, 1]
    dx = to_x - x
    dy = to_y - y
    away = math.sqrt(dx * dx + dy * dy)
    gap = line - (x if axis == 0 else y)
    run = dx if axis == 0 else dy
    if run * gap <= 0.0:
        return count
    share = gap / run
    if not 0.02 < share < 0.95:
        return count
    bounce_x = x + share * dx
    bounce_y = y + share * dy
    if _in_mouth(gates, bounce_x, bounce_y):
        return count
    aim, gain, ghost_x, ghost_y = _aim_at_ghost(
        places, geometry, cue, places[cue, 0], places[cue, 1], ball, elementary.atan2(dy, dx)
    )
    if gain == 0.0 or not _reaches(places, geometry, ghost_x, ghost_y, ball):
        return count
    if not lane_is_free(places, radii, x, y, bounce_x, bounce_y, radius, ball, cue):
        return count
    if not lane_is_free(
        places, radii, bounce_x, bounce_y, gates[p, lanes.GATE_X], gates[p, lanes.GATE_Y], radius, ball, cue
    ):
        return count
    half = 0.03 / away
    chance = chance_within(half, sight * gain + BANK_UNSURE)
    return _store(found, count, Candidate(ball, p, BANK, -1, aim, BANK_ERROR / gain, half / gain, chance))


@inner_kernel
def _list_kick(places, geometry, ball, p, side, found, count):
    """The pot of a ball into pocket p by a cue ball that comes off a rail: it is seen in the mirror."""
    radii, gates, bed, cue, sight = geometry
    direction, half = pocket_window(gates, p, places[ball, 0], places[ball, 1], radii[ball])
    if half <= 0.0:
        return count
    axis = side // 2
    line = bed[side] + (radii[cue] if side % 2 == 0 else -radii[cue])
    from_x = 2.0 * line - places[cue, 0] if axis == 0 else places[cue, 0]
    from_y = 2.0 * line - places[cue, 1] if axis == 1 else places[cue, 1]
    aim, gain, x, y = _aim_at_ghost(places, geometry, cue, from_x, from_y, ball, direction)
    if gain == 0.0:
        return count
    run = (x - from_x) if axis == 0 else (y - from_y)
    gap = (line - from_x) if axis == 0 else (line - from_y)
    if run * gap <= 0.0 or not 0.0 < gap / run < 1.0:
        return count
    bounce_x = from_x + gap / run * (x - from_x)
    bounce_y = from_y + gap / run * (y - from_y)
    if _in_mouth(gates, bounce_x, bounce_y):
        return count
    if not lane_is_free(
        places, radii, places[cue, 0], places[cue, 1], bounce_x, bounce_y, radii[cue], cue, cue
    ) or not lane_is_free(places, radii, bounce_x, bounce_y, x, y, radii[cue], cue, ball):
        return count
    if not lane_is_free(
        places, radii, places[ball, 0], places[ball, 1], gates[p, lanes.GATE_X], gates[p, lanes.GATE_Y],
        radii[ball], ball, cue,
    ):  # fmt: skip
        return count
    mirrored = math.pi - aim if axis == 0 else -aim
    chance = chance_within(half, (sight + 0.5 * BANK_UNSURE) * gain + lanes.RUB)
    return _store(found, count, Candidate(ball, p, KICK, -1, mirrored, KICK_ERROR, half / gain, chance))


@inner_kernel
def _list_combination(places, geometry, ball, p, via, found, count):
    """The pot of a ball into pocket p through another, that the cue ball strikes."""
    radii, gates, _, cue, sight = geometry
    direction, half = pocket_window(gates, p, places[ball, 0], places[ball, 1], radii[ball])
    if half <= 0.0:
        return count
    second, gain_b, x, y = _aim_at_ghost(
        places, geometry, via, places[via, 0], places[via, 1], ball, direction
    )
    if gain_b == 0.0:
        return count
    aim, gain_a, ghost_x, ghost_y = _aim_at_ghost(
        places, geometry, cue, places[cue, 0], places[cue, 1], via, second
    )
    gain = gain_a * gain_b
    if gain == 0.0:
        return count
    chance = chance_within(half, (sight * gain_a + lanes.RUB) * gain_b + lanes.RUB)
    if count >= found.shape[0] and chance < 0.01:
        return count
    if not lane_is_free(places, radii, places[via, 0], places[via, 1], x, y, radii[via], via, ball):
        return count
    if not lane_is_free(
        places, radii, places[ball, 0], places[ball, 1], gates[p, lanes.GATE_X], gates[p, lanes.GATE_Y],
        radii[ball], ball, via,
    ):  # fmt: skip
        return count
    if not _reaches(places, geometry, ghost_x, ghost_y, via):
        return count
    spread = (min(half, 0.2) + THROW + THROW * gain_b) / gain
    return _store(found, count, Candidate(ball, p, COMBINATION, via, aim, spread, half / gain, chance))


@lean_kernel
def list_candidates(places, geometry, first, score, kinds, found):
    """All candidates that geometry allows, to found (c, 8). Returns how many.

    places (n, 2) m. first, score: balls that may be hit first, and that count (bits of their rows). kinds:
    bits of DIRECT to COMBINATION.
    """
    n = places.shape[0]
    count = n - n  # not a literal, for which the callees would be compiled once more
    for ball in range(n):
        if score & (1 << ball) == 0 or ball == geometry.cue:
            continue
        for p in range(geometry.gates.shape[0]):
            if first & (1 << ball) != 0:
                if kinds & (1 << DIRECT) != 0:
                    count = _list_direct(places, geometry, ball, p, found, count)
                for side in range(4):
                    if kinds & (1 << BANK) != 0:
                        count = _list_bank(places, geometry, ball, p, side, found, count)
                    if kinds & (1 << KICK) != 0:
                        count = _list_kick(places, geometry, ball, p, side, found, count)
            if kinds & (1 << COMBINATION) == 0:
                continue
            for via in range(n):
                if via != ball and via != geometry.cue and first & (1 << via) != 0:
                    count = _list_combination(places, geometry, ball, p, via, found, count)
    return count

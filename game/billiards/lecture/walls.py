"""Walls and pockets of the lecture's table.

A ball that has gone too far is found by its overshoot and put back. The normal part of its velocity is turned
round and shortened by the bounce factor e. Where it is put:

    clamp     on the wall (the lecture's printed code)
    mirror    as far inside as it was outside
    exact     e times as far inside: where it would be, had it turned round in time

Rows of cushions are (6,): both ends and the normal; of jaws (3,): centre and radius, m.
"""

from __future__ import annotations

import math

import numpy as np

from game.billiards.lecture import state as s
from game.billiards.lecture.settings import EXACT, MIRROR
from game.compiler.decorator import kernel

MAX_BOUNCES = 64  # off walls in one substep; a ball that needs more is put on the nearest wall


@kernel
def report(journal, kind, first, second, time, speed, impulse, x, y):
    """Append an event, or count it as lost when the list is full."""
    row = journal.counters[s.EVENTS]
    if row >= journal.events.shape[0]:
        journal.counters[s.EVENTS_LOST] += 1
        return
    event = journal.events[row]
    event[s.KIND] = kind
    event[s.FIRST] = first
    event[s.SECOND] = second
    event[s.TIME] = time
    event[s.SPEED] = speed
    event[s.IMPULSE] = impulse
    event[s.EVENT_X] = x
    event[s.EVENT_Y] = y
    journal.counters[s.EVENTS] = row + 1


@kernel
def cushion_gap(cushions, k, x, y, radius):
    """Distance of a ball at x, y from cushion k, m, negative by the overshoot; 1e300 where none is possible.

    A nose (along the table) catches a ball however far it went. A facing only one whose centre has not passed
    it by more than a radius, as behind it there is wood.
    """
    normal_x = cushions[k, 4]
    normal_y = cushions[k, 5]
    from_x = x - cushions[k, 0]
    from_y = y - cushions[k, 1]
    to_x = cushions[k, 2] - x
    to_y = cushions[k, 3] - y
    # the normal turned by a right angle, in either sense, is the cushion's direction
    along_x = cushions[k, 2] - cushions[k, 0]
    along_y = cushions[k, 3] - cushions[k, 1]
    if from_x * along_x + from_y * along_y < 0.0 or to_x * along_x + to_y * along_y < 0.0:
        return 1e300
    height = from_x * normal_x + from_y * normal_y
    if height < -radius and normal_x != 0.0 and normal_y != 0.0:
        return 1e300
    return height - radius


@kernel
def jaw_gap(jaws, k, x, y, radius):
    """Distance of a ball at x, y from jaw k, m, negative where they overlap, and the normal to the ball."""
    dx = x - jaws[k, 0]
    dy = y - jaws[k, 1]
    distance = math.sqrt(dx * dx + dy * dy)
    if distance == 0.0:
        return -(jaws[k, 2] + radius), 1.0, 0.0
    return distance - jaws[k, 2] - radius, dx / distance, dy / distance


@kernel
def deepest_wall(geometry, x, y, radius):
    """Gap, normal and row of the cushion or jaw (rows after the cushions) that a ball overlaps most.

    The deepest first, not the first by row: so a mirrored ball meets mirrored walls in the same order.
    """
    gap = 1e300
    normal_x = 0.0
    normal_y = 0.0
    element = -1
    for k in range(geometry.cushions.shape[0]):
        other = cushion_gap(geometry.cushions, k, x, y, radius)
        if other < gap:
            gap = other
            normal_x = geometry.cushions[k, 4]
            normal_y = geometry.cushions[k, 5]
            element = k
    for k in range(geometry.jaws.shape[0]):
        other, jaw_x, jaw_y = jaw_gap(geometry.jaws, k, x, y, radius)
        if other < gap:
            gap = other
            normal_x = jaw_x
            normal_y = jaw_y
            element = geometry.cushions.shape[0] + k
    return gap, normal_x, normal_y, element


@kernel
def bounce(state, geometry, settings, journal, i, clamp, time):
    """Put ball i back from the wall it overlaps most, and turn it round; False if there is none."""
    x = state.offsets[i, 0]
    y = state.offsets[i, 1]
    gap, normal_x, normal_y, element = deepest_wall(geometry, x, y, state.radii[i])
    if gap >= 0.0:
        return False
    shift = -gap
    normal_speed = state.velocities[i, 0] * normal_x + state.velocities[i, 1] * normal_y
    if normal_speed < 0.0:  # a ball that is already leaving is not turned round again
        change = -(1.0 + settings.bounce) * normal_speed
        state.velocities[i, 0] += change * normal_x
        state.velocities[i, 1] += change * normal_y
        if settings.repositioning == MIRROR and not clamp:
            shift *= 2.0
        elif settings.repositioning == EXACT and not clamp:
            shift *= 1.0 + settings.bounce
        mass = 1.0 / state.inverse_masses[i] if state.inverse_masses[i] > 0.0 else 0.0
        jaw = element - geometry.cushions.shape[0]
        kind = s.BALL_CUSHION if jaw < 0 else s.BALL_JAW
        report(journal, kind, i, element if jaw < 0 else jaw, time, -normal_speed, mass * change, x, y)
    state.offsets[i, 0] = x + shift * normal_x
    state.offsets[i, 1] = y + shift * normal_y
    return True


@kernel
def bounce_off_walls(state, geometry, settings, journal, clamp, time):
    """Put every ball that overshot back and turn it round; a corner, or a very fast ball, takes several.

    With `clamp` balls are put on the wall, whatever the settings say. A ball that was too fast for what
    surrounds a pocket is still far out then. It is put on the edge of the bed, moving inwards.
    """
    if geometry.cushions.shape[0] == 0:
        return
    for i in range(state.radii.shape[0]):
        r = state.radii[i]
        wide = geometry.half_width - r
        long = geometry.half_length - r
        if not state.in_play[i] or (abs(state.offsets[i, 0]) < wide and abs(state.offsets[i, 1]) < long):
            continue
        bounces = 0
        while bounces < MAX_BOUNCES and bounce(state, geometry, settings, journal, i, clamp, time):
            bounces += 1
        for axis in range(2):
            limit = max(0.0, wide if axis == 0 else long)
            place = state.offsets[i, axis]
            if abs(place) > limit and (bounces == MAX_BOUNCES or abs(place) > limit + 3.0 * r):
                state.offsets[i, axis] = math.copysign(limit, place)
                state.velocities[i, axis] = -math.copysign(state.velocities[i, axis], place)


@kernel
def swallow(state, geometry, journal, h, time):
    """Take every ball out of play whose path in the last h seconds led over a pocket.

    The pocket takes a ball when its centre comes within the capture radius. The ball lies in the middle of
    the hole then, at rest.
    """
    for i in range(state.radii.shape[0]):
        x = state.offsets[i, 0]
        y = state.offsets[i, 1]
        r = state.radii[i]
        inside = abs(x) < geometry.half_width - r and abs(y) < geometry.half_length - r
        if inside or not state.in_play[i]:
            continue
        path_x = state.velocities[i, 0] * h
        path_y = state.velocities[i, 1] * h
        squared = path_x * path_x + path_y * path_y
        for k in range(geometry.pockets.shape[0]):
            dx = x - geometry.pockets[k, 0]
            dy = y - geometry.pockets[k, 1]
            # how far back along the path the ball was nearest, 0 at its end to 1 at its beginning
            back = (dx * path_x + dy * path_y) / squared if squared > 0.0 else 0.0
            back = min(1.0, max(0.0, back))
            dx -= back * path_x
            dy -= back * path_y
            radius = geometry.pockets[k, 2]
            if dx * dx + dy * dy < radius * radius:
                speed = math.sqrt(squared) / h
                x -= back * path_x
                y -= back * path_y
                report(journal, np.int64(s.BALL_POCKET), i, k, time, speed, 0.0, x, y)
                state.in_play[i] = False
                state.pocketed_by[i] = k
                state.velocities[i, 0] = 0.0
                state.velocities[i, 1] = 0.0
                state.offsets[i, 0] = geometry.pockets[k, 0]
                state.offsets[i, 1] = geometry.pockets[k, 1]
                break

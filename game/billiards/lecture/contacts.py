"""Balls against balls on the lecture's table: pair after pair by index, or all contacts jointly.

Balls are in contact when their centres are nearer than the sum of their radii: seen from above, also where
radii differ, as in the lecture.
"""

from __future__ import annotations

import math

import numpy as np

from game.billiards.laws.joint import DEMAND, SPEED, STEP, solve_complementarity, solve_joint_impulses
from game.billiards.lecture import state as s
from game.billiards.lecture.settings import AT_ONCE, CONSERVING, SCALED
from game.billiards.lecture.walls import bounce_off_walls, cushion_gap, jaw_gap, report
from game.compiler.decorator import kernel

IN_CONTACT = 1e-9  # of the distance of centres; nearer counts as contact in the joint order
NEARBY = 0.25  # of a radius; separating balls may bring so near ones into contact
SEPARATED = 1e-13  # of a radius; smaller overlaps are left as they are, so that what rests stays where it is
MAX_SEPARATING = 400  # iterations; a contradiction (ball in too narrow a gap) is not solved further


@kernel
def exchange_as_lectured(vx1, vy1, vx2, vy2, cosa, sina, loss, printed):
    """Velocities of two balls after the lecture's exchange; cosa, sina: line of centres, from 2 to 1.

    Normal parts are exchanged, tangential parts kept, then both whole velocities are shortened by `loss`:
    the total momentum comes out multiplied by it. `printed`: the listing to the letter, with its three slips
    (game.billiards.lecture.slips tells them).
    """
    px1 = cosa * vx1 + sina * vy1
    px2 = cosa * vx2 + sina * vy2
    if printed:
        py1 = cosa * vx1 - sina * vy1
        py2 = cosa * vx2 - sina * vy2
        return (
            (cosa * px2 - sina * py2) * loss,
            (cosa * px2 + sina * py2) * loss,
            (cosa * px1 - sina * py1) * loss,
            (cosa * px1 + sina * py1) * loss,
        )
    py1 = cosa * vy1 - sina * vx1
    py2 = cosa * vy2 - sina * vx2
    return (
        (cosa * px2 - sina * py1) * loss,
        (cosa * py1 + sina * px2) * loss,
        (cosa * px1 - sina * py2) * loss,
        (cosa * py2 + sina * px1) * loss,
    )


@kernel
def collide_pair(state, settings, journal, i, j, time):
    """The lecture's handlecollision for balls i and j that overlap: separate them, change their velocities.

    The conserving rule shares both moves and the impulse by mass, with Newton's restitution on the normal
    part. By the lecture's rules each moves by half of the overlap, as if masses were equal.
    """
    offsets = state.offsets
    v = state.velocities
    dx = offsets[i, 0] - offsets[j, 0]
    dy = offsets[i, 1] - offsets[j, 1]
    distance = math.sqrt(dx * dx + dy * dy)
    cosa = dx / distance if distance > 0.0 else 1.0
    sina = dy / distance if distance > 0.0 else 0.0
    overlap = state.radii[i] + state.radii[j] - distance
    w1 = state.inverse_masses[i]
    w2 = state.inverse_masses[j]
    if w1 + w2 == 0.0:
        return
    share = w1 / (w1 + w2) if settings.rule == CONSERVING else 0.5
    offsets[i, 0] += overlap * share * cosa
    offsets[i, 1] += overlap * share * sina
    offsets[j, 0] -= overlap * (1.0 - share) * cosa
    offsets[j, 1] -= overlap * (1.0 - share) * sina
    approach = (v[j, 0] - v[i, 0]) * cosa + (v[j, 1] - v[i, 1]) * sina
    impulse = (1.0 + settings.restitution) * abs(approach) / (w1 + w2)
    if settings.rule == CONSERVING:
        if approach <= 0.0:
            return
        v[i, 0] += w1 * impulse * cosa
        v[i, 1] += w1 * impulse * sina
        v[j, 0] -= w2 * impulse * cosa
        v[j, 1] -= w2 * impulse * sina
    elif settings.rule != SCALED or approach > 0.0:  # the printed listing does not ask for it
        printed = settings.rule != SCALED
        v[i, 0], v[i, 1], v[j, 0], v[j, 1] = exchange_as_lectured(
            v[i, 0], v[i, 1], v[j, 0], v[j, 1], cosa, sina, settings.restitution, printed
        )
    x = offsets[j, 0] + state.radii[j] * cosa
    y = offsets[j, 1] + state.radii[j] * sina
    report(journal, np.int64(s.BALL_BALL), i, j, time, abs(approach), impulse, x, y)


@kernel
def collide_in_index_order(state, geometry, settings, journal, time):
    """Pair after pair, lower index first, as in the lecture; repeated while any pair overlaps.

    The printed listing does not ask whether two balls separate already: a second pass would find what
    rounding left of an overlap and exchange the velocities back. So that rule has one pass.
    """
    offsets = state.offsets
    radii = state.radii
    in_play = state.in_play
    n = radii.shape[0]
    for _ in range(settings.passes if settings.rule <= SCALED else 1):
        found = False
        for i in range(n - 1):
            if not in_play[i]:
                continue
            for j in range(i + 1, n):
                dx = offsets[i, 0] - offsets[j, 0]
                dy = offsets[i, 1] - offsets[j, 1]
                reach = radii[i] + radii[j]
                if dx * dx + dy * dy < reach * reach and in_play[j]:
                    collide_pair(state, settings, journal, i, j, time)
                    found = True
        journal.counters[s.PAIR_TESTS] += n * (n - 1) // 2
        if not found:
            return
        if settings.walls_again:
            bounce_off_walls(state, geometry, settings, journal, np.bool_(True), time)


@kernel
def _add_contact(contacts, count, first, second, normal_x, normal_y, gap, restitution):
    """Append a contact to the list if there is capacity; returns the new length."""
    if count >= contacts.gaps.shape[0]:
        return count
    contacts.graph.first[count] = first
    contacts.graph.second[count] = second
    contacts.graph.normals[count, 0] = normal_x
    contacts.graph.normals[count, 1] = normal_y
    contacts.gaps[count] = gap
    contacts.restitutions[count] = restitution
    return count + 1


@kernel
def _list_ball_contacts(state, settings, contacts):
    """List pairs of balls in contact or nearby; returns their number, and the smallest gap / radius."""
    offsets = state.offsets
    radii = state.radii
    in_play = state.in_play
    n = radii.shape[0]
    count = np.int64(0)
    least = 1e300
    for i in range(n - 1):
        if not in_play[i]:
            continue
        x = offsets[i, 0]
        y = offsets[i, 1]
        r = radii[i]
        for j in range(i + 1, n):
            dx = offsets[j, 0] - x
            dy = offsets[j, 1] - y
            reach = r + radii[j]
            far = reach + NEARBY * min(r, radii[j])
            squared = dx * dx + dy * dy
            if squared < far * far and in_play[j]:
                distance = math.sqrt(squared)
                nx = dx / distance if distance > 0.0 else 1.0
                ny = dy / distance if distance > 0.0 else 0.0
                gap = distance - reach
                least = min(least, gap / reach)
                count = _add_contact(contacts, count, i, j, nx, ny, gap, settings.restitution)
    return count, least


@kernel
def _list_wall_contacts(state, geometry, settings, contacts, count):
    """Append contacts of balls with walls that are in contact or nearby; returns the length of the list."""
    cushions = geometry.cushions
    for i in range(state.radii.shape[0]):
        x = state.offsets[i, 0]
        y = state.offsets[i, 1]
        r = state.radii[i]
        nearby = NEARBY * r
        wide = geometry.half_width - r - nearby
        long = geometry.half_length - r - nearby
        if not state.in_play[i] or (abs(x) < wide and abs(y) < long):
            continue
        for k in range(cushions.shape[0] + geometry.jaws.shape[0]):
            if k < cushions.shape[0]:
                gap = cushion_gap(cushions, k, x, y, r)
                nx = cushions[k, 4]
                ny = cushions[k, 5]
            else:
                gap, nx, ny = jaw_gap(geometry.jaws, k - cushions.shape[0], x, y, r)
            if gap < nearby:
                count = _add_contact(contacts, count, i, -1 - k, -nx, -ny, gap, settings.bounce)
    return count


@kernel
def _report_impulses(state, geometry, contacts, journal, count, time):
    """One event for each contact that took an impulse, at the point of contact."""
    cushions = geometry.cushions.shape[0]
    for c in range(count):
        if contacts.impulses[c] > 0.0:
            i = contacts.graph.first[c]
            x = state.offsets[i, 0] + state.radii[i] * contacts.graph.normals[c, 0]
            y = state.offsets[i, 1] + state.radii[i] * contacts.graph.normals[c, 1]
            kind = s.BALL_BALL
            other = contacts.graph.second[c]
            if other < 0:
                other = -1 - other
                kind = s.BALL_CUSHION if other < cushions else s.BALL_JAW
                other -= 0 if other < cushions else cushions
            speed = contacts.scratch.contacts[c, SPEED]
            if speed <= 0.0:  # it closed only because of other impacts of this instant
                second = contacts.graph.second[c]
                yielding = state.inverse_masses[i]
                yielding += state.inverse_masses[second] if second >= 0 else 0.0
                speed = contacts.impulses[c] * yielding / (1.0 + contacts.restitutions[c])
            report(journal, kind, i, other, time, speed, contacts.impulses[c], x, y)


@kernel
def _separate(state, contacts, count):
    """Move the listed balls apart, all at once and as little as possible (by mass); returns iterations."""
    for c in range(count):
        contacts.scratch.contacts[c, DEMAND] = -contacts.gaps[c]
        contacts.scratch.contacts[c, STEP] = 1.0
    return solve_complementarity(
        count,
        contacts.graph,
        state.inverse_masses,
        state.offsets,
        contacts.impulses,
        contacts.scratch,
        np.int64(MAX_SEPARATING),
    )


@kernel
def collide_jointly(state, geometry, settings, contacts, journal, time):
    """All contacts of this substep at once: impulses first, then the balls are separated.

    The numbering of the balls has no influence, and a mirrored table stays mirrored, to the last bit.
    """
    n = state.radii.shape[0]
    for attempt in range(settings.passes + 1):
        count, least = _list_ball_contacts(state, settings, contacts)
        journal.counters[s.PAIR_TESTS] += n * (n - 1) // 2
        if not least < (IN_CONTACT if attempt == 0 else -SEPARATED):
            return
        if settings.walls_again:
            count = _list_wall_contacts(state, geometry, settings, contacts, count)
        if attempt > 0:
            journal.counters[s.ITERATIONS] += _separate(state, contacts, count)
            continue
        for c in range(count):
            if not contacts.gaps[c] < IN_CONTACT * state.radii[contacts.graph.first[c]]:
                contacts.graph.normals[c, 0] = 0.0  # only nearby: no part in the impacts
                contacts.graph.normals[c, 1] = 0.0
            else:
                journal.counters[s.CONTACTS] += 1
        journal.counters[s.ROUNDS] += solve_joint_impulses(
            count,
            contacts.graph,
            contacts.restitutions,
            state.inverse_masses,
            state.velocities,
            contacts.impulses,
            settings.propagation == AT_ONCE,
            contacts.scratch,
        )
        _report_impulses(state, geometry, contacts, journal, count, time)

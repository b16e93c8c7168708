"""Contacts: of sphere and sphere, window, ledge and string, as a list.

A contact has a normal from the first body to the second, a gap (negative: overlap) and a key by which it is
known again in the next step. Walls, ledges and strings belong to a second body that nothing moves. A taut
string is a contact like any other: a wall around its anchor, of the string's length.

Arrays: places, before (s, 3) m; radii (s,) m; pairs (p, 2).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.spheres.effects import COLLISIONS_BIT, LEDGES_BIT, STRINGS_BIT, WINDOW_BIT

NX, NY, NZ, GAP = range(4)  # columns of a contact
WALLS = 4  # of the window: left, right, bottom, top
FAR = 1e9  # m, a gap that never closes: a contact that takes no part
COINCIDENT = 1e-300  # m², below which centres count as one place
FALLBACK = (1.0, 0.0, 0.0)  # normal of spheres whose centres coincide

FIRST, SECOND = range(2)  # columns of spheres and bodies


class Contacts(NamedTuple):
    """The contacts of a step, by ascending key, in arrays with space for so many; their number goes along."""

    normals: NDArray[np.float64]  # (capacity, 4) unit normal from the first body to the second, gap m
    spheres: NDArray[np.int32]  # (capacity, 2), the second one -1 for walls and -2 for strings
    bodies: NDArray[np.uint32]  # (capacity, 2) of these, the second one n for what nothing moves
    keys: NDArray[np.int64]  # (capacity,) by which a contact is known again
    impulses: NDArray[np.float64]  # (capacity, 4) of resting contacts: normal, friction x y z, kg m/s
    pushes: NDArray[np.float64]  # (capacity,) kg m, of position correction


class PastContacts(NamedTuple):
    """What is remembered of the m contacts of the last step: keys (m,), ascending; impulses (m, 4) kg m/s."""

    keys: NDArray[np.int64]
    impulses: NDArray[np.float64]


@inner_kernel
def separation(places, radii, a, b):
    """Normal from sphere a to b and the gap between them."""
    dx = places[b, 0] - places[a, 0]
    dy = places[b, 1] - places[a, 1]
    dz = places[b, 2] - places[a, 2]
    square = dx * dx + dy * dy + dz * dz
    reach = radii[a] + radii[b]
    if not square > COINCIDENT:
        return FALLBACK[0], FALLBACK[1], FALLBACK[2], -reach
    length = math.sqrt(square)
    return dx / length, dy / length, dz / length, length - reach


@inner_kernel
def ledge_separation(places, radii, a, ledge):
    """Normal from sphere a to the nearest point of a ledge (x0, y0, x1, y1 m) and the gap between."""
    x0, y0 = ledge[0], ledge[1]
    ex, ey = ledge[2] - x0, ledge[3] - y0
    dx, dy = places[a, 0] - x0, places[a, 1] - y0
    share = min(max((dx * ex + dy * ey) / (ex * ex + ey * ey), 0.0), 1.0)
    dx, dy = share * ex - dx, share * ey - dy
    square = dx * dx + dy * dy
    if not square > COINCIDENT:
        length = math.sqrt(ex * ex + ey * ey)
        return ey / length, -ex / length, -radii[a]
    length = math.sqrt(square)
    return dx / length, dy / length, length - radii[a]


@inner_kernel
def write_contact(contacts, m, key, spheres, bodies, normal, gap):
    """One contact at place m of the list, if there is capacity. spheres, bodies: pairs; normal: (x, y, z)."""
    if m < contacts.keys.shape[0]:
        contacts.normals[m, NX], contacts.normals[m, NY], contacts.normals[m, NZ] = normal
        contacts.normals[m, GAP] = gap
        contacts.spheres[m, FIRST], contacts.spheres[m, SECOND] = spheres
        contacts.bodies[m, FIRST], contacts.bodies[m, SECOND] = bodies
        contacts.keys[m] = key


@lean_kernel
def find_contacts(places, composition, pairs, surroundings, mask, margin, contacts):
    """All contacts with a gap up to ``margin`` (m), by ascending key; returns their number.

    pairs: (p, 2) candidates a < b, sorted. contacts: `Contacts`, all but impulses and pushes are written; if
    the number is above the capacity, only so many are.
    """
    radii, owners = composition.radii, composition.owners
    s, n = radii.shape[0], composition.masses.shape[0]
    m = 0
    if mask & COLLISIONS_BIT:
        for p in range(pairs.shape[0]):
            a, b = pairs[p, 0], pairs[p, 1]
            dx = places[b, 0] - places[a, 0]
            dy = places[b, 1] - places[a, 1]
            dz = places[b, 2] - places[a, 2]
            reach = radii[a] + radii[b] + margin
            if dx * dx + dy * dy + dz * dz <= reach * reach and owners[a] != owners[b]:
                nx, ny, nz, gap = separation(places, radii, a, b)
                bodies = owners[a], owners[b]
                write_contact(contacts, m, a * s + b, (a, b), bodies, (nx, ny, nz), gap)
                m += 1
    first = s * s
    if mask & WINDOW_BIT:
        box = surroundings.window
        for wall in range(WALLS):
            axis = wall // 2
            side = 1.0 if wall % 2 else -1.0
            edge = box[axis + 2] if wall % 2 else box[axis]
            nx = side if axis == 0 else 0.0
            ny = side if axis == 1 else 0.0
            for a in range(s):
                gap = side * (edge - places[a, axis]) - radii[a]
                if gap <= margin:
                    key = first + wall * s + a
                    write_contact(contacts, m, key, (a, -1), (owners[a], n), (nx, ny, 0.0), gap)
                    m += 1
    first += WALLS * s
    if mask & LEDGES_BIT:
        m = find_at_ledges(places, composition, surroundings.ledges, first, margin, contacts, m)
    first += surroundings.ledges.shape[0] * s
    if mask & STRINGS_BIT:
        m = find_strings(places, composition, surroundings, first, margin, contacts, m)
    return m


@inner_kernel
def find_at_ledges(places, composition, ledges, first, margin, contacts, m):
    """Contacts of spheres and ledges, from place m of the list on; returns the next place."""
    radii, owners = composition.radii, composition.owners
    s, n = radii.shape[0], composition.masses.shape[0]
    for k in range(ledges.shape[0]):
        left, right = min(ledges[k, 0], ledges[k, 2]), max(ledges[k, 0], ledges[k, 2])
        low, high = min(ledges[k, 1], ledges[k, 3]), max(ledges[k, 1], ledges[k, 3])
        for a in range(s):
            reach = radii[a] + margin
            x, y = places[a, 0], places[a, 1]
            if (x + reach < left) | (x - reach > right) | (y + reach < low) | (y - reach > high):
                continue
            nx, ny, gap = ledge_separation(places, radii, a, ledges[k])
            if gap <= margin:
                key = first + k * s + a
                write_contact(contacts, m, key, (a, -1), (owners[a], n), (nx, ny, 0.0), gap)
                m += 1
    return m


@inner_kernel
def find_strings(places, composition, surroundings, first, margin, contacts, m):
    """Strings that are taut, or nearly: see `surroundings`. From place m on; returns the next place."""
    s, n = composition.radii.shape[0], composition.masses.shape[0]
    for k in range(surroundings.hung.shape[0]):
        a = surroundings.hung[k]
        dx = places[a, 0] - surroundings.strings[k, 0]
        dy = places[a, 1] - surroundings.strings[k, 1]
        dz = places[a, 2] - surroundings.strings[k, 2]
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        gap = surroundings.strings[k, 3] - length
        if gap <= margin and length > 0.0:
            key = first + k * s + a
            normal = dx / length, dy / length, dz / length
            write_contact(contacts, m, key, (a, -2), (composition.owners[a], n), normal, gap)
            m += 1
    return m


@lean_kernel
def near_pairs(places, radii, skin, pairs):
    """Brute force: every sphere against every other. Pairs a < b nearer than ``skin`` (m), sorted.

    pairs (capacity, 2) is written up to its capacity; returns how many there are.
    """
    m = 0
    for a in range(radii.shape[0]):
        x, y, z, r = places[a, 0], places[a, 1], places[a, 2], radii[a] + skin
        for b in range(a + 1, radii.shape[0]):
            dx, dy, dz = places[b, 0] - x, places[b, 1] - y, places[b, 2] - z
            reach = r + radii[b]
            if dx * dx + dy * dy + dz * dz <= reach * reach:
                if m < pairs.shape[0]:
                    pairs[m, 0] = a
                    pairs[m, 1] = b
                m += 1
    return m


@lean_kernel
def farthest_moved(places, before):
    """Greatest distance (m) of a sphere from where it was."""
    most = 0.0
    for a in range(places.shape[0]):
        dx = places[a, 0] - before[a, 0]
        dy = places[a, 1] - before[a, 1]
        dz = places[a, 2] - before[a, 2]
        most = max(most, dx * dx + dy * dy + dz * dz)
    return math.sqrt(most)


@inner_kernel
def recall_impulses(contacts, count, past):
    """Impulses of the contacts that there were in the last step (past: `PastContacts`); 0 for the others."""
    p = 0
    for m in range(count):
        key = contacts.keys[m]
        while p < past.keys.shape[0] and past.keys[p] < key:
            p += 1
        known = p < past.keys.shape[0] and past.keys[p] == key
        for column in range(4):
            contacts.impulses[m, column] = past.impulses[p, column] if known else 0.0


def boxes_of(places: np.ndarray, radii: np.ndarray, skin: float) -> tuple[np.ndarray, np.ndarray]:
    """Lower and upper corners (s, 2) m of boxes around the spheres, wider by half of ``skin`` all round."""
    reach = (radii + 0.5 * skin)[:, None]
    return places[:, :2] - reach, places[:, :2] + reach

"""The table of a pair manager: pairs in a dense list, and an index that tells their places there.

The index is either a full triangular matrix over all ids, with one look, but memory n^2 / 2. Or it is an
open-addressed hash table (a few looks, memory in proportion to the pairs). Because of the list neither is
ever scanned: listing, events and clearing cost the number of pairs.

Kernels call each other for every single pair, so they count no references to their arrays (``_nrt``): an
array that is counted in and out costs ten times what the look-up does. They must not make arrays, then.

Source of the hash table: Knuth, The Art of Computer Programming 3, 6.4, algorithms L and R.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import kernel

NOW = 1  # flag: the pair overlaps
BEFORE = 2  # flag: it did when events were last taken
KEEP = 4  # flag while a whole set is taken over: it is in the new set

FIRST, SECOND, FLAGS, HASH = 0, 1, 2, 3  # columns of PairTable.slots
ROWS, MASK, SLOTS, PRESENT, LEAST, GREATEST = 0, 1, 2, 3, 4, 5  # places in PairTable.numbers
MAX_ID = (1 << 31) - 1
ID_FIELD = (1 << 32) - 1  # the second id in a key, two's complement
FIELD = (1 << 62) - 1  # hashes are of 62 bits: positive in machine code and in plain Python
MIX_A, MIX_B, MIX_C = 0x1E3779B97F4A7C15, 0x3F58476D1CE4E5B9, 0x14D049BB133111EB


class PairTable(NamedTuple):
    """Arrays of a pair manager.

    ``where``: index, 0 for none or 1 + slot. ``slots``: (capacity, 4) first and second id of a pair, first <
    second, its flags, and its hash (0 in a matrix). ``numbers``: rows of the matrix (0: hashed), hash mask,
    slots in use, pairs that overlap now, and the least and greatest id that ``list_pairs`` met.
    """

    where: NDArray[np.int32]
    slots: NDArray[np.int32]
    numbers: NDArray[np.int64]


@kernel(_nrt=False)
def triangular_index(i, j, n):
    """Place of the pair i < j < n in the strict upper triangle of an n x n matrix, read row by row.

    In 64 bits: i * n leaves 32 bits from n = 46 341 on.
    """
    return int(i) * (2 * int(n) - int(i) - 1) // 2 + int(j) - int(i) - 1


@kernel(_nrt=False)
def hash_pair(a, b):
    """A 31 bit hash of an ordered pair of integers, negative ones too."""
    mixed = (int(a) * MIX_A + int(b) * MIX_B) & FIELD
    mixed ^= mixed >> 32
    mixed = (mixed * MIX_C) & FIELD
    return mixed >> 31


@kernel(_nrt=False)
def find_place(where, slots, numbers, a, b):
    """Place in the index where the pair a < b is, or would be put."""
    if numbers[ROWS] > 0:
        return triangular_index(a, b, numbers[ROWS])
    mask = numbers[MASK]
    place = hash_pair(a, b) & mask
    slot = where[place] - 1
    while slot >= 0 and (slots[slot, FIRST] != a or slots[slot, SECOND] != b):
        place = (place + 1) & mask
        slot = where[place] - 1
    return place


@kernel(_nrt=False)
def enter_pair(where, slots, numbers, place, a, b):
    """Put the pair a < b, which is not there, into a free place. Returns its slot, or -1 without space."""
    slot = numbers[SLOTS]
    if slot == len(slots) or (numbers[ROWS] == 0 and 2 * (slot + 1) > len(where)):
        return -1
    where[place] = slot + 1
    slots[slot, FIRST] = a
    slots[slot, SECOND] = b
    slots[slot, FLAGS] = 0
    slots[slot, HASH] = hash_pair(a, b) if numbers[ROWS] == 0 else 0
    numbers[SLOTS] = slot + 1
    return slot


@kernel(_nrt=False)
def vacate(where, slots, numbers, place):
    """Empty a place of the index. In a hash table, pairs that were pushed past it move back (algorithm R)."""
    where[place] = 0
    if numbers[ROWS] > 0:
        return
    mask = numbers[MASK]
    hole = place
    place = (place + 1) & mask
    while where[place] > 0:
        home = slots[where[place] - 1, HASH] & mask
        if ((place - home) & mask) >= ((place - hole) & mask):
            where[hole] = where[place]
            where[place] = 0
            hole = place
        place = (place + 1) & mask


@kernel(_nrt=False)
def drop_slot(where, slots, numbers, slot):
    """Forget the pair in a slot; the last one of the list takes its slot."""
    vacate(where, slots, numbers, find_place(where, slots, numbers, slots[slot, FIRST], slots[slot, SECOND]))
    last = numbers[SLOTS] - 1
    if slot != last:
        where[find_place(where, slots, numbers, slots[last, FIRST], slots[last, SECOND])] = slot + 1
        for column in range(4):
            slots[slot, column] = slots[last, column]
    numbers[SLOTS] = last


@kernel(_nrt=False)
def end_slot(where, slots, numbers, slot):
    """The pair in a slot overlaps no more: kept until its end event is taken, if it had a begin event."""
    numbers[PRESENT] -= 1
    if slots[slot, FLAGS] & BEFORE:
        slots[slot, FLAGS] = BEFORE
    else:
        drop_slot(where, slots, numbers, slot)


@kernel(_nrt=False)
def put_pair(where, slots, numbers, a, b):
    """Add the pair a < b if it is not there. Returns 1 if it is new, 0 if not, -1 if there is no space."""
    place = find_place(where, slots, numbers, a, b)
    slot = where[place] - 1
    if slot < 0:
        slot = enter_pair(where, slots, numbers, place, a, b)
        if slot < 0:
            return -1
    new = 1 - (slots[slot, FLAGS] & NOW)
    numbers[PRESENT] += new
    slots[slot, FLAGS] |= NOW
    return new


@kernel(_nrt=False)
def cut_pair(where, slots, numbers, a, b):
    """Remove the pair a < b. Returns 1 if it was there, else 0."""
    slot = where[find_place(where, slots, numbers, a, b)] - 1
    if slot < 0 or slots[slot, FLAGS] & NOW == 0:
        return 0
    end_slot(where, slots, numbers, slot)
    return 1


@kernel(_nrt=False)
def cut_pairs(where, slots, numbers, pairs):
    """Remove pairs, (m, 2); those that are not there are passed over."""
    for i in range(len(pairs)):
        a, b = pairs[i, 0], pairs[i, 1]
        cut_pair(where, slots, numbers, min(a, b), max(a, b))


@kernel(_nrt=False)
def first_bad_pair(pairs, least, greatest):
    """Index of the first row of (m, 2) that is no pair of distinct ids within the bounds, or -1."""
    for i in range(len(pairs)):
        a, b = pairs[i, 0], pairs[i, 1]
        if a == b or min(a, b) < least or max(a, b) > greatest:
            return i
    return -1


@kernel(_nrt=False)
def put_pairs(where, slots, numbers, pairs, start, mark):
    """Add pairs, (m, 2), from ``start`` on, with a further flag ``mark`` (0: none).

    Returns the index of the first for which there is no space, or their number.
    """
    for i in range(start, len(pairs)):
        a, b = min(pairs[i, 0], pairs[i, 1]), max(pairs[i, 0], pairs[i, 1])
        place = find_place(where, slots, numbers, a, b)
        slot = int(where[place]) - 1
        if slot < 0:
            slot = enter_pair(where, slots, numbers, place, a, b)
            if slot < 0:
                return i
        flags = slots[slot, FLAGS]
        numbers[PRESENT] += 1 - (flags & NOW)
        slots[slot, FLAGS] = flags | (NOW | mark)
    return len(pairs)


@kernel(_nrt=False)
def change_pairs(where, slots, numbers, changes, count, start):
    """Add or remove pairs from ``start`` on: a key ``a << 32 | b`` adds, its bitwise complement removes.

    ``changes``: (>= count,), ids below 2^31, a < b. Returns the index of the first pair for which there is no
    space, or ``count``.
    """
    for i in range(start, count):
        adds = changes[i] >= 0
        key = changes[i] if adds else ~changes[i]
        a, b = key >> 32, key & MAX_ID
        place = find_place(where, slots, numbers, a, b)
        slot = int(where[place]) - 1
        if adds:
            if slot < 0:
                slot = enter_pair(where, slots, numbers, place, a, b)
                if slot < 0:
                    return i
            numbers[PRESENT] += 1 - (slots[slot, FLAGS] & NOW)
            slots[slot, FLAGS] |= NOW
        elif slot >= 0 and slots[slot, FLAGS] & NOW:
            end_slot(where, slots, numbers, slot)
    return count


@kernel(_nrt=False)
def sweep_unkept(where, slots, numbers):
    """End all pairs that are not marked KEEP, and take the marks off."""
    for slot in range(numbers[SLOTS] - 1, -1, -1):
        flags = slots[slot, FLAGS]
        if flags & KEEP:
            slots[slot, FLAGS] = flags & (NOW | BEFORE)
        elif flags & NOW:
            end_slot(where, slots, numbers, slot)


@kernel(_nrt=False)
def cut_box(where, slots, numbers, box):
    """Remove all pairs of a box."""
    for slot in range(numbers[SLOTS] - 1, -1, -1):
        if (slots[slot, FIRST] == box or slots[slot, SECOND] == box) and slots[slot, FLAGS] & NOW:
            end_slot(where, slots, numbers, slot)


@kernel(_nrt=False)
def cut_gone(where, slots, numbers, alive):
    """Remove all pairs that have a box no longer in use. ``alive``: (capacity,) 1 where an id is in use."""
    for slot in range(numbers[SLOTS] - 1, -1, -1):
        gone = alive[slots[slot, FIRST]] == 0 or alive[slots[slot, SECOND]] == 0
        if gone and slots[slot, FLAGS] & NOW:
            end_slot(where, slots, numbers, slot)


@kernel(_nrt=False)
def list_pairs(slots, numbers, keys, wanted, unwanted):
    """Write keys ``first << 32 | second`` of pairs with flags ``wanted``, none ``unwanted``; their number."""
    count = 0
    least = 0
    greatest = 0
    for slot in range(numbers[SLOTS]):
        flags = slots[slot, FLAGS]
        if flags & wanted == wanted and flags & unwanted == 0:
            a, b = int(slots[slot, FIRST]), int(slots[slot, SECOND])
            least = min(least, a)
            greatest = max(greatest, b)
            keys[count] = (a << 32) | (b & ID_FIELD)
            count += 1
    numbers[LEAST] = least
    numbers[GREATEST] = greatest
    return count


@kernel(_nrt=False)
def settle(where, slots, numbers):
    """After the events are taken: what overlaps now did before, and what has ended is forgotten."""
    for slot in range(numbers[SLOTS] - 1, -1, -1):
        if slots[slot, FLAGS] & NOW:
            slots[slot, FLAGS] = NOW | BEFORE
        else:
            drop_slot(where, slots, numbers, slot)


@kernel(_nrt=False)
def index_all(where, slots, numbers):
    """Enter all slots into an empty index."""
    for slot in range(numbers[SLOTS]):
        where[find_place(where, slots, numbers, slots[slot, FIRST], slots[slot, SECOND])] = slot + 1


@kernel(_nrt=False)
def sum_of_probes(where, slots, numbers, count):
    """Number of places looked at to find each of the first ``count`` pairs of a hash table once."""
    mask = numbers[MASK]
    total = 0
    for slot in range(count):
        place = find_place(where, slots, numbers, slots[slot, FIRST], slots[slot, SECOND])
        total += ((place - slots[slot, HASH]) & mask) + 1
    return total

"""What a table is worth to the player at turn: a quick estimate for very many tables.

The chance to clear it: the best pot now, times how open each of the other balls is that must go down. If that
fails, both players are in a race: how far each is from clearing the table, as the logarithm of the chance,
says who wins it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.search import outcomes
from game.billiards.search.lanes import openness, pot_chance
from game.billiards.search.outcomes import is_foul
from game.physics.kernels import elementary

# what a stroke led to, for the shooter
MISSED, SCORED, WON, FOULED, LOST = range(5)

BLOCKED = 0.25  # openness of a ball to which no pocket is open
FAR = 0.03  # chance of a pot that stands for none, in the race
RACE = 0.4  # by how much the odds to win a race change with the distance
TURN = 0.3  # advantage in the race of who is at turn, in the same measure
IN_HAND = 0.97  # chance of a pot with the cue ball in hand, of one that is open


class Aims(NamedTuple):
    """What the shooter is after; sets of balls as bits of their rows.

    first: may be touched first. score: keep the turn when they go down. needed: must go down for the rack to
    be won, now or later. win, lose: end the rack. other: what the opponent needs. called: only the ball and
    pocket that were meant count. rotation: the lowest ball must be played first, and a foul with a winning
    ball is a foul only. solo: there is no other player, so that a miss or a foul is worth nothing. chain: so
    many balls, the cue ball and itself among them, must have sent a ball on for it to count.
    """

    first: int
    score: int
    needed: int
    win: int = 0
    lose: int = 0
    other: int = 0
    called: bool = True
    rotation: bool = False
    solo: bool = False
    chain: int = 0


FIRST_AIM, SCORE_AIM, NEEDED_AIM, WIN_AIM, LOSE_AIM, OTHER_AIM = range(6)
CALLED_AIM, ROTATION_AIM, SOLO_AIM, CHAIN_AIM = range(6, 10)


def packed(aims: Aims) -> NDArray[np.int64]:
    """Aims as the kernels read them, (10,)."""
    return np.array([int(field) for field in aims], dtype=np.int64)


@inner_kernel
def clearing_chance(places, geometry, playable, needed, open_chances):
    """Estimated chance to pot all `needed` balls in one visit, beginning with one of `playable` (bits).

    places (n, 2) m; open_chances (n,): scratch buffer. Returns 1 if nothing is needed.
    """
    n = places.shape[0]
    product = 1.0
    count = 0
    for i in range(n):
        open_chances[i] = 1.0
        if needed & (1 << i) != 0 and places[i, 0] > 0.5 * outcomes.NOWHERE:
            open_chances[i] = max(openness(places, geometry, i), BLOCKED)
            product *= open_chances[i]
            count += 1
    if count == 0:
        return 1.0
    best = 0.0
    for i in range(n):
        if playable & needed & (1 << i) == 0 or places[i, 0] <= 0.5 * outcomes.NOWHERE:
            continue
        others = product / open_chances[i]
        if others <= best:
            continue
        for p in range(geometry.gates.shape[0]):
            chance = pot_chance(places, geometry, i, p) * others
            best = max(best, chance)
    return best


@inner_kernel
def next_playable(aims, places, needed):
    """Of the `needed` balls (bits) those that may be played at next: in rotation the lowest, else those that
    do not end the rack, as long as there are any."""
    left = 0
    for i in range(places.shape[0]):
        if needed & (1 << i) != 0 and places[i, 0] > 0.5 * outcomes.NOWHERE:
            left |= 1 << i
            if aims[ROTATION_AIM] != 0:
                return left
    before = left & ~(aims[WIN_AIM] | aims[LOSE_AIM])
    return before if before != 0 else left


@inner_kernel(inline="always")
def _is_sent_by(chain, least):
    """True if a chain has at least so many balls."""
    count = 0
    for i in range(16):
        count += (chain >> i) & 1
    return count >= least


@inner_kernel
def classify(facts, histories, aims, ball, pocket):
    """What a stroke led to (MISSED to LOST), whose shooter meant to pot `ball` into `pocket` (-1: any)."""
    down = facts[outcomes.DOWN]
    foul = is_foul(facts, aims[FIRST_AIM])
    if down & aims[LOSE_AIM] != 0:
        return LOST
    if down & aims[WIN_AIM] != 0:
        meant = aims[CALLED_AIM] == 0 or (
            ball >= 0 and aims[WIN_AIM] & (1 << ball) != 0 and histories[ball, outcomes.POCKET] == pocket
        )
        if foul or not meant:
            return FOULED if aims[ROTATION_AIM] != 0 else LOST
        return WON
    if foul:
        return FOULED
    if aims[CALLED_AIM] != 0:
        hit = (
            ball >= 0
            and histories[ball, outcomes.POCKET] >= 0
            and (pocket < 0 or histories[ball, outcomes.POCKET] == pocket)
        )
        return SCORED if hit and _is_sent_by(histories[ball, outcomes.CHAIN], aims[CHAIN_AIM]) else MISSED
    for i in range(histories.shape[0]):
        if down & aims[SCORE_AIM] & (1 << i) != 0 and _is_sent_by(
            histories[i, outcomes.CHAIN], aims[CHAIN_AIM]
        ):
            return SCORED
    return MISSED


@lean_kernel
def classify_all(facts, histories, aims, meant, kinds):
    """Class of each stroke (m,). meant (m, 2): ball and pocket (-1: none)."""
    for s in range(facts.shape[0]):
        kinds[s] = classify(facts[s], histories[s], aims, meant[s, 0], meant[s, 1])


@lean_kernel
def rate_all(kinds, places, geometry, aims, scratch, worth):
    """Worth (m,) of what strokes of these classes left: the estimated chance to win.

    places (m, n, 2) m; geometry: see `lanes`; scratch (n,). With `solo` it is the chance to clear the table.
    """
    solo = aims[SOLO_AIM] != 0
    for s in range(kinds.shape[0]):
        kind = kinds[s]
        if kind == WON:
            worth[s] = 1.0
        elif kind == LOST or (solo and kind != SCORED):
            worth[s] = 0.0
        elif kind == SCORED:
            worth[s] = worth_on_turn(places[s], geometry, aims, scratch)
        else:
            worth[s] = worth_off_turn(places[s], geometry, aims, scratch, kind == FOULED)


@inner_kernel
def open_product(places, geometry, needed):
    """How open a player's balls are, all together."""
    product = 1.0
    for i in range(places.shape[0]):
        if needed & (1 << i) != 0 and places[i, 0] > 0.5 * outcomes.NOWHERE:
            product *= max(openness(places, geometry, i), BLOCKED)
    return product


@inner_kernel(inline="always")
def _win_chance(run, mine, other):
    """Chance to win for the player at turn: by clearing the table, else in the race.

    run: chance to clear it. mine, other: how open the balls of both are, with the next pot in it.
    """
    ahead = RACE * (elementary.log(max(mine, 1e-9)) - elementary.log(max(other, 1e-9))) + TURN
    return run + (1.0 - run) / (1.0 + elementary.exp(-ahead))


@inner_kernel
def worth_on_turn(places, geometry, aims, scratch):
    """Chance to win for the player at turn."""
    needed = aims[NEEDED_AIM]
    playable = next_playable(aims, places, needed)
    run = clearing_chance(places, geometry, playable, needed, scratch)
    if aims[SOLO_AIM] != 0:
        return run
    mine = max(run, FAR * open_product(places, geometry, needed))
    other = open_product(places, geometry, aims[OTHER_AIM])
    return _win_chance(run, mine, other)


@inner_kernel
def worth_off_turn(places, geometry, aims, scratch, in_hand):
    """Chance to win for a player whose opponent comes to the table."""
    needed = aims[OTHER_AIM]
    other = open_product(places, geometry, needed)
    if in_hand:
        run = IN_HAND * other
    else:
        playable = next_playable(aims, places, needed)
        run = clearing_chance(places, geometry, playable, needed, scratch)
    mine = open_product(places, geometry, aims[NEEDED_AIM])
    return 1.0 - _win_chance(run, max(run, FAR * other), mine)

"""How good the best pot is that very many tables offer."""

from __future__ import annotations

from game.billiards.laws.lean import lean_kernel
from game.billiards.search.lanes import pot_chance
from game.billiards.search.outcomes import NOWHERE


@lean_kernel
def best_chances(places, geometry, playable, found):
    """Chance (m,) of the likeliest direct pot on each of m tables; 0 without one, or without the cue ball.

    places (m, n, 2) m; geometry: see `lanes`; playable (m,): balls that may be potted, as bits of their rows.
    """
    cue = geometry.cue
    for s in range(places.shape[0]):
        best = 0.0
        if places[s, cue, 0] > 0.5 * NOWHERE:
            for ball in range(places.shape[1]):
                if playable[s] & (1 << ball) == 0 or places[s, ball, 0] <= 0.5 * NOWHERE:
                    continue
                for p in range(geometry.gates.shape[0]):
                    best = max(best, pot_chance(places[s], geometry, ball, p))
        found[s] = best

"""What a stroke leaves: how good the next one is from where the balls end, and where they end."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.billiards.map.carom import GLANCE, SEED, Group, Position, whole_map
from game.billiards.search.strokes import Noise
from game.billiards.table.carom import CAROM_LENGTH, CAROM_WIDTH, fits


def next_chance(position: Position, places: Floats, noise: Noise, seed: int = SEED) -> float:
    """How often a hand scores with the best stroke of a quick map at other places (3, 2) m; 0 without one."""
    if not fits(places):
        return 0.0
    groups = whole_map(position.moved(places), noise, GLANCE, seed).groups
    return groups[0].chance if groups else 0.0


def leaving(position: Position, group: Group, noise: Noise, ends: int = 3, seed: int = SEED) -> float:
    """Mean of `next_chance` over the first few ends of a group's scoring strokes; 0 if there are none."""
    chosen = group.ends[:ends]
    if not len(chosen):
        return 0.0
    return float(np.mean([next_chance(position, places, noise, seed) for places in chosen]))


def heat(
    ends: Floats, columns: int, rows: int, width: float = CAROM_WIDTH, length: float = CAROM_LENGTH
) -> Floats:
    """Where a ball ends: share of ends (k, 2) m in each cell, (rows, columns); rows along the table from
    its lower end, columns across it from the left. All 0 without ends.
    """
    if not len(ends):
        return np.zeros((rows, columns))
    counts, _, _ = np.histogram2d(ends[:, 1], ends[:, 0], (rows, columns), ((0.0, length), (0.0, width)))
    return counts / len(ends)

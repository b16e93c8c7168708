"""What leaves are seen to do in a flight: swing from side to side, turn over, glide, or none of these yet.

The regimes of the plates' law are those of the long run (`plates.regimes`), and a fall from two metres is
short. So what is counted here is what the eye can count, from the moment a leaf leaves the ground:

- it tumbles while it has turned by a whole turn or more since its spin last changed sign;
- it glides while it has gone FAR half chords or more to one side through the air, GLIDING m or more for each
  m down;
- it flutters once it has changed sides SIDES times, each way shorter than that.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.plates import law, watch
from game.physics.plates.flight import WX, WY

TURNED, CHANGES, ACROSS, DOWN, TOOK = range(5)
WAY = 5  # rad since the spin changed sign; changes of side; m across, m down and s since the last of them
FAR = 12.0  # half chords
SIDES = 3
LOST_S = 1.5  # without a change of side for so long a leaf does not swing


def follow_ways(ways: Floats, rows: Floats, air: Floats, aloft: NDArray[np.bool_], dt: float) -> None:
    """Bring ways (n, WAY) a step of dt (s) on; those not ``aloft`` (n,) begin anew.

    rows (STATE, n), air (WIND, n): of the plates after the step.
    """
    spin, across, down = rows[law.SPIN], rows[law.VX] - air[WX], air[WY] - rows[law.VY]
    stopped = ways[:, TURNED] * spin < 0.0
    ways[stopped, TURNED] = 0.0
    ways[:, TURNED] += dt * spin
    changed = ways[:, ACROSS] * across < 0.0
    ways[changed, CHANGES] += 1.0
    ways[changed, ACROSS:] = 0.0
    ways[:, ACROSS] += dt * across
    ways[:, DOWN] += dt * down
    ways[:, TOOK] += dt
    ways[~aloft] = 0.0


def seen_of(ways: Floats, laws: Floats) -> NDArray[np.int64]:
    """(n,) of NOTHING, FLUTTER, TUMBLE, GLIDE: what each leaf is seen to do; laws (COLUMNS, n)."""
    far = np.abs(ways[:, ACROSS])
    glides = (far > FAR * laws[law.HALF]) & (far > watch.GLIDING * np.maximum(ways[:, DOWN], 0.0))
    flutters = (ways[:, CHANGES] >= SIDES) & (ways[:, TOOK] < LOST_S)
    tumbles = np.abs(ways[:, TURNED]) >= math.tau
    return np.select(
        [tumbles, glides, flutters], [watch.TUMBLE, watch.GLIDE, watch.FLUTTER], watch.NOTHING
    ).astype(np.int64)

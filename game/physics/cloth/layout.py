"""How a cloth lies in arrays: nodes with threads between them, meshes, and two by two patches in each mesh.

nodes   (NODE_ROWS, ny + 1, nx + 1)   where the threads cross; row 0 is the upper edge
whole   (ny, nx)                      meshes that still hold: 1, or 0 once burnt through or torn out
patches (PATCH_ROWS, 2 ny, 2 nx)      what is hot and burns, in the cloth's own coordinates
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats

# rows of nodes: place m, velocity m/s, where a substep began m, inverse mass 1/kg, whether it is there
X, Y, Z, VX, VY, VZ, WAS_X, WAS_Y, WAS_Z, INVERSE, THERE = range(11)
NODE_ROWS = 11
# rows of patches: K; kg/m² of what can burn, of char, of water; share of saltpetre, 0 to 1; s at which a
# quarter of its fuel had burnt (below 0: not yet); and a buffer
HOT, FUEL, CHAR, WATER, SALT, BEGAN, FLOW = range(7)
PATCH_ROWS = 7
PER = 2  # patches along a side of a mesh
NOT_YET = -1.0


class Ties(NamedTuple):
    """What holds what: 1 or 0."""

    across: Floats  # (ny + 1, nx) threads from left to right
    along: Floats  # (ny, nx + 1) threads downwards
    whole: Floats  # (ny, nx) meshes
    reach: Floats  # (2, ny + 1, nx + 1) m to either hook along the cloth; infinite: no longer joined to it


def make_ties(ny: int, nx: int) -> Ties:
    """All is whole; nothing is known of the hooks yet."""
    return Ties(
        np.ones((ny + 1, nx)), np.ones((ny, nx + 1)), np.ones((ny, nx)),
        np.full((2, ny + 1, nx + 1), np.inf),
    )  # fmt: skip

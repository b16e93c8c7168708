"""Ball on cushion, normal speed only: `mirror` (e = 1) and `restitution`; the spin does not change."""

from __future__ import annotations

from game.billiards.laws.lean import inner_kernel
from game.billiards.laws.state import VX, VY


@inner_kernel(inline="always")
def bounce(state, i, nx, ny, restitution):
    """v -= (1 + e) (v . n) n, with n the unit vector from the cushion to the ball."""
    change = (1.0 + restitution) * (state[VX, i] * nx + state[VY, i] * ny)
    state[VX, i] -= change * nx
    state[VY, i] -= change * ny

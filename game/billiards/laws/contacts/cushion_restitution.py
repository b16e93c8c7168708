"""Ball on cushion, normal speed only: `mirror` (e = 1) and `restitution`; the spin does not change.

And for all models, how the restitution falls with the closing speed v: e = e0 - alpha v, at least 0. (Hunt
and Crossley 1975, Coefficient of restitution interpreted as damping in vibroimpact, J. Appl. Mech. 42, 440.)
"""

from __future__ import annotations

from game.billiards.laws import state as s
from game.billiards.laws.lean import inner_kernel


@inner_kernel(inline="always")
def restitution_at(closing, physics):
    """Restitution of the cushion for a ball that closes on it at so many m/s along the bed."""
    return max(physics[s.CUSHION_RESTITUTION] - physics[s.RESTITUTION_FALL] * closing, 0.0)


@inner_kernel(inline="always")
def bounce(state, i, nx, ny, restitution):
    """v -= (1 + e) (v . n) n, with n the unit vector from the cushion to the ball."""
    change = (1.0 + restitution) * (state[s.VX, i] * nx + state[s.VY, i] * ny)
    state[s.VX, i] -= change * nx
    state[s.VY, i] -= change * ny

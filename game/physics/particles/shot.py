"""Single particles flown through many steps at once: for studies, where only the steps are to cost time."""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.particles.contacts import fly_among_solids


@kernel
def shoot(rules, law, solids, states, steps, impulses):
    """``steps`` steps of ``rules.h`` (s) of each particle; returns how many of these had an impact.

    states (n, 4): x, y (m), vx, vy (m/s), written. impulses (k, 2) is scratch.
    """
    impacts = 0
    for i in range(states.shape[0]):
        x, y, vx, vy = states[i, 0], states[i, 1], states[i, 2], states[i, 3]
        for _ in range(steps):
            x, y, vx, vy, change, _, _ = fly_among_solids(
                rules, law, solids, (x, y, vx, vy), 0.0, rules.h, impulses
            )
            impacts += change > 0.0
        states[i, 0] = x
        states[i, 1] = y
        states[i, 2] = vx
        states[i, 3] = vy
    return impacts

"""Conditions of carom and snooker tables: what cloth and cushions do to the balls.

Numbers lie within the ranges that Alciatore gives for billiard equipment ("Physical properties", billiards.
colostate.edu): sliding friction 0.15 to 0.4, rolling resistance 0.005 to 0.015, a spin about the vertical
that falls by 5 to 15 rad/s each second, cushions of restitution 0.6 to 0.9. A heated cloth is dry and fast,
at the low end of friction; the cloth of a club is slower. The cushion is that of Han (2005), measured on
carom tables.

Of snooker: restitution and friction of the cushion are those that Mathavan, Jackson and Parkin (2010) found
on a snooker table, with their law of it. Friction of cloth and balls, and the balls' restitution, are from
memory those of their `Numerical simulations of the frictional collisions of solid balls on a rough surface`
(2014).
"""

from __future__ import annotations

from game.billiards.shot.physics import Physics

HEATED = "heated"
CLUB = "club"

CLOTHS: dict[str, Physics] = {
    HEATED: Physics(sliding=0.16, rolling=0.0055, spinning=0.0088, cushion_friction=0.15),
    CLUB: Physics(
        sliding=0.20, rolling=0.0095, spinning=0.0125, cushion_friction=0.20, cushion_restitution=0.82
    ),
}  # fmt: skip
CLOTH_LABELS = {HEATED: "Heated cloth", CLUB: "Club cloth"}


def faster(physics: Physics) -> Physics:
    """The same table with a fast cloth: friction falls as from the club's cloth to the heated one."""
    fast, slow = CLOTHS[HEATED], CLOTHS[CLUB]
    return physics._replace(
        sliding=physics.sliding * fast.sliding / slow.sliding,
        rolling=physics.rolling * fast.rolling / slow.rolling,
        spinning=physics.spinning * fast.spinning / slow.spinning,
    )


SNOOKER_CLOTH = Physics(
    cushion="mathavan-2010", sliding=0.21, rolling=0.01, ball_restitution=0.89,
    cushion_friction=0.14, cushion_restitution=0.98,
)  # fmt: skip

"""What a step of particles may compute: the fields that act on them, and what they may meet."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import ATTRACTOR, DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WHIRL, WIND

OBSTACLES = declare_effect("obstacles", "Stones", "Round solids that particles bounce off.")
REPORTS = declare_effect("reports", "Reports", "Deaths and impacts are listed for others to use.")

PARTICLES = Room(
    "particles",
    GRAVITY | DRAG | WIND | QUADRATIC_DRAG | WHIRL | ATTRACTOR | GROUND | OBSTACLES | REPORTS,
)
GRAVITY_BIT = PARTICLES.bit(GRAVITY)
DRAG_BIT = PARTICLES.bit(DRAG)
WIND_BIT = PARTICLES.bit(WIND)
QUADRATIC_BIT = PARTICLES.bit(QUADRATIC_DRAG)
WHIRL_BIT = PARTICLES.bit(WHIRL)
ATTRACTOR_BIT = PARTICLES.bit(ATTRACTOR)
GROUND_BIT = PARTICLES.bit(GROUND)
OBSTACLES_BIT = PARTICLES.bit(OBSTACLES)
REPORTS_BIT = PARTICLES.bit(REPORTS)

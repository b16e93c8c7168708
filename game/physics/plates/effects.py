"""What a step of plates in air may compute."""

from __future__ import annotations

from game.physics.constraints.effects import CONTACTS
from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY, GROUND, QUADRATIC_DRAG, WIND

CIRCULATION = declare_effect(
    "circulation", "Circulation", "The air turns about a plate that glides or spins, and lifts it."
)
BENDING = declare_effect("bending", "Bending", "Plates bend about their middle, as leaves about the midrib.")
GUST_INERTIA = declare_effect(
    "gust-inertia", "Gust inertia", "Wind that changes pushes by the air that it takes along (added mass)."
)

PLATES = Room(
    "plates", GRAVITY | QUADRATIC_DRAG | CIRCULATION | WIND | GUST_INERTIA | BENDING | GROUND | CONTACTS
)

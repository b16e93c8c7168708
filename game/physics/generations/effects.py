"""What a step of stars may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WIND

BURNING = declare_effect("burning", "Burning away", "Stars lose mass as they burn, and feel the air more.")
THRUST = declare_effect("thrust", "Thrust", "Rockets are driven by the gas that they throw out.")
TRAILS = declare_effect("trails", "Trails", "Stars leave sparks along their way.")

GENERATIONS = Room("stars", GRAVITY | DRAG | QUADRATIC_DRAG | WIND | GROUND | BURNING | THRUST | TRAILS)
GRAVITY_BIT = GENERATIONS.bit(GRAVITY)
DRAG_BIT = GENERATIONS.bit(DRAG)
QUADRATIC_BIT = GENERATIONS.bit(QUADRATIC_DRAG)
WIND_BIT = GENERATIONS.bit(WIND)
GROUND_BIT = GENERATIONS.bit(GROUND)
BURNING_BIT = GENERATIONS.bit(BURNING)
THRUST_BIT = GENERATIONS.bit(THRUST)
TRAILS_BIT = GENERATIONS.bit(TRAILS)

"""What a step of shallow water may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY, WIND

BED_FRICTION = declare_effect("bed-friction", "Bed friction", "The bed slows water, thin water most.")
RAIN = declare_effect("rain", "Rain", "Water falls on all of it, evenly.")
SPLITTING = declare_effect("splitting", "Splitting", "A wave particle that is alone becomes three.")
FADING = declare_effect("wave-fading", "Fading", "Waves sink with time.")
FLOATS = declare_effect("floats", "Floats", "Waves lift and push what floats, and what floats makes waves.")
BOAT = declare_effect("boat", "Boat", "The boat goes, and pushes the water aside.")
SEA_WAVES = declare_effect("sea-waves", "Waves", "The sea has waves; without them it is flat.")
ADDED_MASS = declare_effect("added-mass", "Added mass", "Water swings along with a hull, and strikes it.")
SPRAY = declare_effect("spray", "Spray", "Where a hull strikes the water, drops fly.")

WAVES = Room("waves", GRAVITY | BED_FRICTION | RAIN)
POND = Room("pond", GRAVITY | SPLITTING | FADING | FLOATS | BOAT)
SEA = Room("sea", GRAVITY | WIND | RAIN | SEA_WAVES | ADDED_MASS | SPRAY)

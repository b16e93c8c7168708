"""What a step of grains in a sound field may compute."""

from __future__ import annotations

from game.physics.constraints.effects import CONTACTS
from game.physics.effects import Room, declare_effect
from game.physics.fields import DRAG, GRAVITY, GROUND

SOUND = declare_effect("sound", "Sound", "The force of the sound field on the grains.")

GRAINS = Room("grains", SOUND | GRAVITY | DRAG | GROUND | CONTACTS)
SOUND_BIT = GRAINS.bit(SOUND)
GRAVITY_BIT = GRAINS.bit(GRAVITY)
DRAG_BIT = GRAINS.bit(DRAG)
GROUND_BIT = GRAINS.bit(GROUND)
CONTACTS_BIT = GRAINS.bit(CONTACTS)

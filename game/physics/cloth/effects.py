"""What a step of a hanging cloth may compute besides its heat."""

from __future__ import annotations

from game.physics.constraints.effects import ATTACHMENTS, LINKS, TEARING
from game.physics.effects import Room, declare_effect
from game.physics.fields import GRAVITY, GROUND, WIND

SHEAR = declare_effect("shear", "Shear", "A cloth holds its right angles, if softly.")
FOLDS = declare_effect("folds", "Stiff folds", "A cloth does not fold flat: it holds against being folded.")

CLOTH = Room("cloth", GRAVITY | GROUND | WIND | LINKS | ATTACHMENTS | TEARING | SHEAR | FOLDS)
GRAVITY_BIT = CLOTH.bit(GRAVITY)
GROUND_BIT = CLOTH.bit(GROUND)
WIND_BIT = CLOTH.bit(WIND)
LINKS_BIT = CLOTH.bit(LINKS)
ATTACHMENTS_BIT = CLOTH.bit(ATTACHMENTS)
TEARING_BIT = CLOTH.bit(TEARING)
SHEAR_BIT = CLOTH.bit(SHEAR)
FOLDS_BIT = CLOTH.bit(FOLDS)

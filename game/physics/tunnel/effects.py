"""What a step of the tunnel and of the flights may compute."""

from __future__ import annotations

from game.physics.effects import Room
from game.physics.fields import GRAVITY, QUADRATIC_DRAG
from game.physics.gas.effects import ADVECTION, PRESSURE, VISCOSITY
from game.physics.plates.effects import CIRCULATION

TUNNEL = Room("wind tunnel", ADVECTION | PRESSURE | VISCOSITY | GRAVITY | QUADRATIC_DRAG | CIRCULATION)

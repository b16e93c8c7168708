"""What a step of burning gas may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect
from game.physics.gas.effects import EXPANSION
from game.physics.heat.effects import RADIATION

FLAMES = declare_effect("flames", "Flames", "Fuel and oxygen burn where the gas is hot enough.")
SOOT_LOSS = declare_effect("soot-loss", "Soot burns off", "Soot burns where it is hot and there is oxygen.")

COMBUSTION = Room("burning gas", FLAMES | EXPANSION | RADIATION | SOOT_LOSS)
FLAMES_BIT = COMBUSTION.bit(FLAMES)
EXPANSION_BIT = COMBUSTION.bit(EXPANSION)
RADIATION_BIT = COMBUSTION.bit(RADIATION)
SOOT_LOSS_BIT = COMBUSTION.bit(SOOT_LOSS)

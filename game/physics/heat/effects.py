"""What a step of heat may compute."""

from __future__ import annotations

from game.physics.effects import Room, declare_effect

CONDUCTION = declare_effect("conduction", "Conduction", "Heat flows from warm to cold where things touch.")
RADIATION = declare_effect("radiation", "Radiation", "What is hot shines, and cools as T⁴ minus that around.")
CONVECTION = declare_effect("convection", "Convection", "Heat passes between a body and the gas at it.")
SMOULDERING = declare_effect("smouldering", "Burning solids", "Above its ignition temperature a solid burns.")

HEAT = Room("heated things", CONDUCTION | RADIATION | CONVECTION | SMOULDERING)
CONDUCTION_BIT = HEAT.bit(CONDUCTION)
RADIATION_BIT = HEAT.bit(RADIATION)
CONVECTION_BIT = HEAT.bit(CONVECTION)
SMOULDERING_BIT = HEAT.bit(SMOULDERING)

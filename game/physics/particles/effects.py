"""What a particle may meet besides the fields of `game.physics.fields`."""

from __future__ import annotations

from game.physics.effects import declare_effect
from game.physics.fields import GROUND

OBSTACLES = declare_effect("particles", "obstacles", 20, "Stones", "Round solids that particles bounce off.")
REPORTS = declare_effect(
    "particles", "reports", 21, "Reports", "Deaths and impacts are listed for others to use."
)

GROUND_BIT = GROUND.mask
OBSTACLES_BIT = OBSTACLES.mask
REPORTS_BIT = REPORTS.mask

"""What of the tower can be switched beside what its rooms compute."""

from __future__ import annotations

from game.physics.effects import declare_effect

AIR = declare_effect("air", "Air", "What falls drives the air out from under it, and the air carries dust.")

"""What can be set: how the search goes about it."""

from __future__ import annotations

from game.stage import Param, Parameters


class BeatParameters(Parameters):
    """Parameters of the search; the physics is that of the exact table."""

    rounds = Param(40, 0, 400, whole=True, group="Search", help="of varying, once a ball lies for every beat")
    seed = Param(0, 0, 9999, whole=True, group="Search", label="Seed", help="another finds another shot")
    rest = Param(1.2, 0.5, 5.0, unit="s", group="Tapping", help="of silence that ends a beat")

"""What level files of tables have in common: one ball."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.billiards.table.rack import BALL_MASS, BALL_RADIUS

Radius = Annotated[float, msgspec.Meta(ge=0.002, le=0.3)]  # m
Mass = Annotated[float, msgspec.Meta(ge=1e-6, le=1e6)]  # kg
Coordinate = Annotated[float, msgspec.Meta(ge=-25.0, le=25.0)]  # m
Speed = Annotated[float, msgspec.Meta(ge=-1e4, le=1e4)]  # m/s


class BallEntry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """One ball: its number (0 is the cue ball), place and velocity; pool measures unless said otherwise."""

    number: Annotated[int, msgspec.Meta(ge=0, le=15)]
    position: tuple[Coordinate, Coordinate]
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    radius: Radius = BALL_RADIUS
    mass: Mass = BALL_MASS

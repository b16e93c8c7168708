"""What a level of the three tables says."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.scenes.shared.tables.level import BallEntry


class ThreeTablesContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a level: balls (else a rack), and the stroke that it begins with."""

    balls: Annotated[list[BallEntry], msgspec.Meta(max_length=22)] = []
    speed: Annotated[float, msgspec.Meta(ge=0.0, le=15.0)] = 0.0  # m/s of the cue ball; 0: no stroke
    angle_deg: Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)] = 90.0
    bare: bool = False
    plays_itself: bool = False

"""What a level of the real table says: where its tracks come from."""

from __future__ import annotations

from typing import Annotated

import msgspec


class MadeTracks(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """Tracks that the program makes: shots at random on a table that is known, with noise in x and y."""

    shots: Annotated[int, msgspec.Meta(ge=1, le=20)] = 6
    noise_mm: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 1.0
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**31)] = 3


class RealTableContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a level: how its tracks are made. What is filmed is opened from the folder for tracks."""

    made: MadeTracks = MadeTracks()

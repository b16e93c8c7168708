"""What all that stands in a level's [content] has in common, and numbers as several scenes bound them."""

from __future__ import annotations

from typing import Annotated

import msgspec

Metre = Annotated[float, msgspec.Meta(ge=-1e5, le=1e5)]
Length = Annotated[float, msgspec.Meta(ge=1e-6, le=1e4)]
Point = tuple[Metre, Metre]
Density = Annotated[float, msgspec.Meta(ge=1e-3, le=1e5)]  # kg/m² of a slice, water being 1
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Degrees = Annotated[float, msgspec.Meta(ge=-80.0, le=80.0)]
Index = Annotated[int, msgspec.Meta(ge=0, le=1_000)]


class LevelEntry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True, omit_defaults=True):
    """Strict: a field that it does not know is refused; what is as by default is not written."""


class View(LevelEntry, frozen=True, kw_only=True):
    """The part of the world in view, m."""

    left: Metre
    bottom: Metre
    right: Metre
    top: Metre

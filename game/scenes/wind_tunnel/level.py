"""What a level of the wind tunnel may say."""

from __future__ import annotations

from typing import Annotated, Literal

import msgspec

from game.worlds.entries.entry import LevelEntry
from game.worlds.expectations import Expectations

Metre = Annotated[float, msgspec.Meta(ge=-50.0, le=50.0)]
Points = Annotated[tuple[tuple[Metre, Metre], ...], msgspec.Meta(max_length=400)]


class WindTunnelContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. Its tunnel is as high as the parameter says.

    width: m, 0 for twice the height; at: m, of the shape's middle, by default three tenths along, halfway up;
    profile: of the wind; nudge: share of the wind that blows across at the start. outline: a shape of its own
    (m). strokes: shapes drawn one after another, as by hand; one that cannot be is refused and counted.
    sweep: begin with a sweep over the angle.
    """

    width: Annotated[float, msgspec.Meta(ge=0.0, le=50.0)] = 0.0
    at: tuple[Metre, Metre] | None = None
    profile: Literal["even", "parabolic"] = "even"
    nudge: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] = 0.05
    outline: Points = ()
    strokes: Annotated[tuple[Points, ...], msgspec.Meta(max_length=12)] = ()
    sweep: bool = False
    expected: Expectations = ()


DEFAULT = WindTunnelContent()

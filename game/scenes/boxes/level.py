"""What a level file of a broad-phase scene may say: the very boxes it begins with."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.levels import Unbounded
from game.worlds.expectations import Expectations

WIDTH, HEIGHT = 11.2, 8.0  # m, the world in which boxes move
MOST_LISTED = 5_000  # boxes in a file
FARTHEST = 1e300  # m: sums and differences of corners are finite numbers, too

Corner = Unbounded
Speed = Annotated[float, msgspec.Meta(ge=-1e6, le=1e6)]  # m/s


class BoxEntry(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """A box: corners in m (at most FARTHEST from 0, or infinite outwards), velocity and growth in m/s.

    ``growth`` is that of each side.
    """

    lower: tuple[Corner, Corner]
    upper: tuple[Corner, Corner]
    velocity: tuple[Speed, Speed] = (0.0, 0.0)
    growth: Speed = 0.0


class BoxesContent(msgspec.Struct, forbid_unknown_fields=True, frozen=True, kw_only=True):
    """[content] of a level. Without boxes, random ones are made as the parameters say.

    expected: of readouts; "pairs missed" is measured where it is expected.
    """

    boxes: Annotated[tuple[BoxEntry, ...], msgspec.Meta(max_length=MOST_LISTED)] = ()
    expected: Expectations = ()

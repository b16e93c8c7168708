"""What a level of floating bodies may say. Places are from the lower left corner of the liquid's tank, m."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations

Place = Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)]
Size = Annotated[float, msgspec.Meta(ge=0.005, le=10.0)]
Weight = Annotated[float, msgspec.Meta(ge=0.001, le=20.0)]
CHART, MARGIN, GAP = 0.62, 0.07, 0.12  # of a tank's height: the chart below it; m; m between the tanks


class OtherEntry(LevelEntry, frozen=True, kw_only=True):
    """A box, or a ball where ``radius`` is given, in the liquid alone; density beside water's."""

    at: tuple[Place, Place]
    size: tuple[Size, Size] = (0.1, 0.1)
    radius: Annotated[float, msgspec.Meta(ge=0.0, le=10.0)] = 0.0
    density: Weight = 0.5


class FloatingContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. tank: width and height; depth: of the water, m; outline: of the drawn body;
    lift: its centre over where it would float, m; ballast_at: from the outline's centre of area, m.
    """

    tank: tuple[Size, Size] = (1.7, 1.0)
    depth: Size = 0.52
    outline: Annotated[tuple[tuple[Place, Place], ...], msgspec.Meta(max_length=64)] = ()
    lift: Place = 0.0
    ballast_at: tuple[Place, Place] | None = None
    others: Annotated[tuple[OtherEntry, ...], msgspec.Meta(max_length=128)] = ()
    expected: Expectations = ()

    @property
    def apart(self) -> float:
        """m from one tank's left side to the other's."""
        return self.tank[0] + GAP

    @property
    def view(self) -> View:
        """Both tanks, and the chart below."""
        width, height = self.apart + self.tank[0], self.tank[1]
        return View(
            left=-MARGIN,
            bottom=-CHART * height - 3.4 * MARGIN,
            right=width + MARGIN,
            top=height + 1.3 * MARGIN,
        )

    @property
    def chart(self) -> tuple[float, float, float, float]:
        """Left, low, right and high end of the stability curve, m."""
        return 0.0, -CHART * self.tank[1] - MARGIN, self.apart + self.tank[0], -1.3 * MARGIN

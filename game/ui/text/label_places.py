"""Places for labels on one picture: none over another, none cut off by the edge.

A label that would cross another is pushed out of it by the shortest way. So it glides along with what it
names instead of leaping. Only where that leads nowhere is the nearest free place around taken.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

PUSHES = 6  # before another place is looked for
RINGS = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)  # heights of the label, radii on which one is looked for
DIRECTIONS = 12
SLACK = 1.0  # px that labels may share: their letters do not fill their boxes


class Box(NamedTuple):
    """A box of a picture, px, y down."""

    left: float
    top: float
    right: float
    bottom: float

    def moved(self, dx: float, dy: float) -> Box:
        return Box(self.left + dx, self.top + dy, self.right + dx, self.bottom + dy)

    def crosses(self, other: Box) -> bool:
        """Whether the boxes share more than the slack, both ways."""
        return (
            self.left < other.right - SLACK
            and other.left < self.right - SLACK
            and self.top < other.bottom - SLACK
            and other.top < self.bottom - SLACK
        )

    def inside(self, view: Box) -> Box:
        """The box shifted into the view as far as it fits; its left and upper ends come first."""
        dx = min(0.0, view.right - self.right)
        dy = min(0.0, view.bottom - self.bottom)
        return self.moved(max(dx, view.left - self.left), max(dy, view.top - self.top))


class LabelPlaces:
    """Boxes of the labels so far. ``clear`` before each picture."""

    def __init__(self) -> None:
        self._taken: list[Box] = []

    def clear(self) -> None:
        """Forget all labels."""
        self._taken.clear()

    def claim(self, box: Box) -> None:
        """A label is there, wherever that is."""
        self._taken.append(box)

    def free(self, wanted: Box, view: Box) -> Box:
        """A box as large as the wanted one, near it, free and inside the view if there is such a place."""
        if not all(math.isfinite(end) for end in wanted):
            return wanted
        wanted = wanted.inside(view)
        pushed = self._pushed(wanted, view)
        if self._hit(pushed) is None:
            return pushed
        for box in _around(wanted):
            if box == box.inside(view) and self._hit(box) is None:
                return box
        return pushed

    def _hit(self, box: Box) -> Box | None:
        return next((other for other in self._taken if box.crosses(other)), None)

    def _pushed(self, box: Box, view: Box) -> Box:
        """Out of one label after the other, each time by the shortest way that stays inside the view."""
        for _ in range(PUSHES):
            other = self._hit(box)
            if other is None:
                break
            ways = (
                (0.0, other.top - box.bottom),
                (0.0, other.bottom - box.top),
                (other.left - box.right, 0.0),
                (other.right - box.left, 0.0),
            )
            exits = [box.moved(*way) for way in sorted(ways, key=lambda way: abs(way[0]) + abs(way[1]))]
            box = next((exit for exit in exits if exit == exit.inside(view)), exits[0])
        return box


def _around(box: Box) -> Iterator[Box]:
    """The box moved to rings about its place, the nearest first."""
    height = box.bottom - box.top
    for ring in RINGS:
        for i in range(DIRECTIONS):
            angle = 2.0 * math.pi * i / DIRECTIONS
            yield box.moved(2.0 * ring * height * math.cos(angle), ring * height * math.sin(angle))

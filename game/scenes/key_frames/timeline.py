"""Where the timeline and the box of the timing curve lie on the stage, in its own metres."""

from __future__ import annotations

from typing import NamedTuple

from game.scenes.key_frames.level import Point, View

REACH = 0.03  # of the height in view: how near to a handle the pointer takes it


class Rect(NamedTuple):
    """A rectangle of the stage, m."""

    left: float
    bottom: float
    right: float
    top: float

    def holds(self, point: Point, margin: float = 0.0) -> bool:
        """Whether a point is inside, or no farther out than the margin."""
        return (
            self.left - margin <= point[0] <= self.right + margin
            and self.bottom - margin <= point[1] <= self.top + margin
        )

    def at(self, x: float, y: float) -> Point:
        """The point at shares of width and height."""
        return self.left + x * (self.right - self.left), self.bottom + y * (self.top - self.bottom)

    def shares(self, point: Point) -> Point:
        """Shares of width and height of a point."""
        width, height = self.right - self.left, self.top - self.bottom
        return (point[0] - self.left) / width, (point[1] - self.bottom) / height


class Places(NamedTuple):
    """What lies where: the band at the foot, the plot of speeds, its axis, the box of the timing curve."""

    band: Rect
    plot: Rect
    axis: float  # height of the line with the keys, m
    timing: Rect
    reach: float  # m


def places_of(view: View) -> Places:
    """The places for a part of the world in view."""
    width, height = view.right - view.left, view.top - view.bottom
    left, right = view.left + 0.05 * width, view.right - 0.05 * width
    axis = view.bottom + 0.032 * height
    band = Rect(view.left, view.bottom - 0.02 * height, view.right, view.bottom + 0.235 * height)
    plot = Rect(left, axis + 0.03 * height, right, view.bottom + 0.19 * height)
    side = 0.2 * height
    right, top = view.right - 0.12 * side, view.top - 0.5 * side
    timing = Rect(right - side, top - side, right, top)
    return Places(band, plot, axis, timing, REACH * height)


def time_at(places: Places, x: float) -> float:
    """Part of the second at a width of the stage, cut to 0 to 1."""
    return min(max((x - places.plot.left) / (places.plot.right - places.plot.left), 0.0), 1.0)


def x_of(places: Places, time: float) -> float:
    """Width of the stage of a part of the second."""
    return places.plot.left + time * (places.plot.right - places.plot.left)

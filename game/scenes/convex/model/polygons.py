"""Convex polygons of outlines, found once for each; and how they drift by themselves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.narrowphase import ConvexPolygon, NonConvexError
from game.scenes.convex.level import View
from game.scenes.shared.outlines.board import Board, places_of, with_places
from game.scenes.shared.outlines.outline import Outline, Point, placed

MOST_KEPT = 64  # outlines whose polygons are kept
ROUND = 1e-6  # m by which corners and sides of a coin may differ


def is_coin(polygon: ConvexPolygon) -> bool:
    """Whether a polygon is a regular one in a circle of 1 m."""
    corners = polygon.vertices
    from_middle = np.linalg.norm(corners - corners.mean(axis=0), axis=1)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1)
    return bool(np.abs(from_middle - 1.0).max() < ROUND and np.ptp(sides) < ROUND)


class KeptPolygons:
    """The polygons of outlines, or why they are none. scale: m to a unit of the level; origin: in units."""

    def __init__(self, scale: float, origin: Point):
        self._scale, self._origin = scale, origin
        self._found: dict[int, tuple[Any, ConvexPolygon | NonConvexError]] = {}
        self._worlds: dict[int, tuple[Outline, ConvexPolygon]] = {}

    def found(self, outline: Outline) -> ConvexPolygon | NonConvexError:
        """The polygon of an outline in its own place, or why there is none."""
        key = id(outline.points)
        kept = self._found.get(key)
        if kept is not None and kept[0] is outline.points:
            return kept[1]
        found: ConvexPolygon | NonConvexError
        try:
            found = ConvexPolygon(outline.points)
        except NonConvexError as error:
            found = error
        if len(self._found) > MOST_KEPT:
            self._found.clear()
        self._found[key] = (outline.points, found)
        return found

    def in_world(self, index: int, outline: Outline) -> ConvexPolygon | None:
        """The polygon of an outline, kept by its index, in the world, m; None if it is refused."""
        kept = self._worlds.get(index)
        if kept is not None and kept[0] is outline:
            return kept[1]
        found = self.found(outline)
        if not isinstance(found, ConvexPolygon):
            return None
        moved = found.moved(*outline.position, outline.angle)
        if self._scale != 1.0 or self._origin != (0.0, 0.0):
            moved = ConvexPolygon((moved.vertices + self._origin) * self._scale)
        self._worlds[index] = (outline, moved)
        return moved

    def corners(self, outline: Outline) -> Floats:
        """Corners (n, 2) of an outline in the level's unit: those that count, or all if it is refused."""
        found = self.found(outline)
        if isinstance(found, ConvexPolygon):
            return found.moved(*outline.position, outline.angle).vertices
        return placed(outline)


def drifted(board: Board, rates: Floats, view: View, dt: float) -> Board:
    """The board a step later: shapes that are not held go on, and turn back at the border of the view.

    rates: (2, 3) unit, unit, rad per s, written where a shape turns back.
    """
    places = places_of(board)
    for k in range(len(places)):
        if board.held and board.chosen == k:
            continue
        places[k] += rates[k] * dt
        places[k, 2] = math.remainder(places[k, 2], 2.0 * math.pi)
        for axis, low, high in ((0, view.left, view.right), (1, view.bottom, view.top)):
            outward = places[k, axis] < low if rates[k, axis] < 0.0 else places[k, axis] > high
            if outward:
                rates[k, axis] = -rates[k, axis]
    return with_places(board, places)

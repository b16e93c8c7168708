"""What a hand does to tracks and to balls on them: tools that draw, bend, and take away."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from game.arrays import Flags
from game.physics.kernels import elementary, elementwise
from game.physics.solids.tracks import Curve
from game.physics.solids.tracks import motion as m
from game.worlds.hands.curves import bent, drawn, nearest_curve
from game.worlds.hands.hand import NOBODY, Hand, Use
from game.worlds.members.tracks import Tracks


class TrackTools:
    """Tools for the tracks of a world, which it gives by ``tracks`` and lays by ``lay``.

    near, most_near: how near to something the pointer takes it, of the height in view, m; dense: of that,
    between two points of a drawn line; most_tracks, most_points: for which there is space.
    """

    def __init__(
        self, near: float, most_near: float, dense: float, most_tracks: int, most_points: int | None = None
    ):
        self.near, self.most_near, self.dense = near, most_near, dense
        self.most_tracks, self.most_points = most_tracks, most_points

    def reach(self, hand: Hand) -> float:
        """How near, m."""
        return hand.reach(self.near, self.most_near)

    def ball_at(self, hand: Hand, there: Flags | None = None) -> int:
        """The ball under the pointer, or NOBODY; there (n,): which of them can be taken."""
        rows = hand.model.tracks.riders.balls.rows
        if not len(rows):
            return NOBODY
        away = elementwise.hypot(*(rows[:, m.X : m.Y + 1] - hand.at).T) - rows[:, m.RADIUS]
        if there is not None:
            away[~there] = np.inf
        return int(away.argmin()) if away.min() < self.reach(hand) else NOBODY

    def track_at(self, hand: Hand) -> int:
        """The track near the pointer, or NOBODY."""
        return nearest_curve(hand.model.tracks.riders.curves, hand.at, 2.0 * self.reach(hand))

    def lay(self, hand: Hand, curves: list[Curve]) -> str:
        """Other tracks; why they cannot be."""
        try:
            hand.model.lay(curves)
        except ValueError as error:
            return f"{str(error)[:1].upper()}{str(error)[1:]}."
        return ""

    def draw(self) -> Use:
        """Draws another track."""
        return Use(move=self._draw, release=self._end_drawing)

    def bend(self) -> Use:
        """Moves the points of a track, the nearer the farther."""
        return Use(self._begin_bending, self._bend)

    def take_away(self, hand: Hand) -> str:
        """The track near the pointer, if there is one."""
        track, tracks = self.track_at(hand), hand.model.tracks
        hand.point = None
        return "" if track == NOBODY else self.lay(hand, _without(tracks, track))

    def delete(self, there: Callable[[Any], Flags | None] = lambda model: None) -> Use:
        """Takes away the ball under the pointer, or else the track near it. there: which balls of a model can
        be taken, as of `ball_at`.
        """

        def press(hand: Hand) -> str:
            ball = self.ball_at(hand, there(hand.model))
            if ball == NOBODY:
                return self.take_away(hand)
            hand.point = None
            hand.model.remove(ball)
            return ""

        return Use(press)

    def _draw(self, hand: Hand) -> str:
        if elementary.dist(hand.at, hand.path[-1]) > self.dense * self.reach(hand):
            hand.path.append(hand.at)
        return ""

    def _end_drawing(self, hand: Hand) -> str:
        curve, curves = drawn(hand.path, self.reach(hand), self.most_points), hand.model.tracks.riders.curves
        if curve is None:
            return "Drag to draw a track."
        if len(curves) >= self.most_tracks:
            return f"There can be at most {self.most_tracks} tracks."
        return self.lay(hand, [*curves, curve])

    def _begin_bending(self, hand: Hand) -> str:
        hand.held = self.track_at(hand)
        return ""

    def _bend(self, hand: Hand) -> str:
        curves = list(hand.model.tracks.riders.curves)
        if not 0 <= hand.held < len(curves):
            return ""
        curves[hand.held] = bent(curves[hand.held], hand.before, hand.at, hand.parameters.values["bending"])
        return self.lay(hand, curves)


def _without(tracks: Tracks, number: int) -> list[Curve]:
    return [curve for k, curve in enumerate(tracks.riders.curves) if k != number]

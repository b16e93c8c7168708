"""The hand in the marble run: moves, makes and sizes balls, bends and draws tracks, while it runs."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementary, elementwise
from game.physics.solids.tracks import Curve
from game.physics.solids.tracks.motion import RADIUS, X, Y
from game.scenes.metal.level import MOST_BALLS, MOST_TRACKS, BallEntry
from game.scenes.metal.model import MetalModel
from game.scenes.metal.tables import FREED, NOT_YET, ROD
from game.scenes.shared.rails.level import Point
from game.scenes.shared.simplify import simplified
from game.stage import Part, Pointer

NEAR = 0.02  # of the height in view
MOST_NEAR = 0.3  # m
FARTHEST = 1e3  # m
NOBODY = -1
LEAST, LARGEST = 0.03, 0.5  # m, of a ball's radius
MOST_POINTS = 400  # of a track that is drawn
LANDING = 0.6  # m: so near to a track a ball that is put down lies on it, in parts of its radius, at most


class MetalHand(Part):
    """held: ball in the hand; sized: ball whose size it changes; bent: track; path: of a new track, m."""

    def __init__(self, model: MetalModel):
        self.model, self.parameters = model, model.parameters
        self.held = self.sized = self.bent = NOBODY
        self.point: Point | None = None
        self.path: list[Point] = []

    @property
    def reach(self) -> float:
        """How near, m."""
        view = self.model.content.view
        return min(NEAR * (view.top - view.bottom), MOST_NEAR)

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST)
        if event.kind == "down" and event.button in (1, 3):
            self.let_go()
            return self._press(point, "delete" if event.button == 3 else self.parameters.tool)
        if event.kind == "move" and self.point is not None:
            return self._move(point)
        if event.kind == "up" and self.point is not None:
            return self._finish()
        if event.kind == "cancel":
            self.let_go()
        return ""

    def let_go(self) -> None:
        """Hold nothing."""
        if self.held != NOBODY:
            self.model.put_down(self.held, 0.0)
        self._forget()

    def _forget(self) -> None:
        self.held = self.sized = self.bent = NOBODY
        self.point, self.path = None, []

    def ball_at(self, point: Point) -> int:
        """The ball under a point, or NOBODY."""
        rows = self.model.riders.balls.rows
        if not len(rows):
            return NOBODY
        away = elementwise.hypot(*(rows[:, X : Y + 1] - point).T) - rows[:, RADIUS]
        away[~self.model.there()] = math.inf
        return int(away.argmin()) if away.min() < self.reach else NOBODY

    def track_at(self, point: Point) -> int:
        """The track near a point, or NOBODY."""
        best, found = 2.0 * self.reach, NOBODY
        for k, curve in enumerate(self.model.riders.curves):
            points = np.asarray(curve.points)
            starts = points if curve.closed else points[:-1]
            along = (np.roll(points, -1, axis=0) if curve.closed else points[1:]) - starts
            at = ((np.array(point) - starts) * along).sum(axis=1) / np.maximum(
                (along * along).sum(axis=1), 1e-300
            )
            near = starts + np.clip(at, 0.0, 1.0)[:, None] * along
            away = float(elementwise.hypot(*(near - point).T).min())
            if away < best:
                best, found = away, k
        return found

    def _press(self, point: Point, tool: str) -> str:
        self.point = point
        ball = self.ball_at(point)
        if tool == "hand":
            self.held = ball
        elif tool == "size":
            if ball != NOBODY and self.model.table[ball, ROD] >= 0.0:
                return "A ball of a cradle keeps its size: its rod is made for it."
            self.sized = ball
        elif tool == "ball":
            return self._make(point)
        elif tool == "draw":
            self.path = [point]
        elif tool == "bend":
            self.bent = self.track_at(point)
        elif tool == "delete":
            return self._delete(point, ball)
        return ""

    def _make(self, point: Point) -> str:
        if len(self.model.table) >= MOST_BALLS:
            return f"There is room for {MOST_BALLS} balls."
        self.model.changed = True
        self.held = self.model.add(BallEntry(at=point, radius=self.parameters.radius))
        return ""

    def _move(self, point: Point) -> str:
        before = self.point or point
        self.point = point
        if self.held != NOBODY:
            self.model.hold(self.held, point)
        elif self.sized != NOBODY:
            centre = self.model.riders.balls.rows[self.sized, X : Y + 1].tolist()
            self.model.resize(self.sized, min(max(elementary.dist(centre, point), LEAST), LARGEST))
        elif self.path and elementary.dist(point, self.path[-1]) > 0.3 * self.reach:
            self.path.append(point)
        elif self.bent != NOBODY:
            return self._bend(before, point)
        return ""

    def _bend(self, before: Point, point: Point) -> str:
        """Move the points of a track, the nearer the farther."""
        curves = list(self.model.riders.curves)
        if self.bent >= len(curves):
            return ""
        curve = curves[self.bent]
        points = np.array(curve.points, dtype=np.float64)
        away = elementwise.hypot(*(points - before).T) / self.parameters.bending
        points += elementwise.exp(-(away * away))[:, None] * (np.array(point) - np.array(before))
        curves[self.bent] = Curve(points, curve.closed, curve.corner)
        return self._lay(curves)

    def _lay(self, curves: list[Curve]) -> str:
        try:
            self.model.lay(curves)
        except ValueError as error:
            return f"{str(error)[:1].upper()}{str(error)[1:]}."
        return ""

    def _finish(self) -> str:
        path, words = self.path, ""
        if self.held != NOBODY:
            radius = float(self.model.riders.balls.rows[self.held, RADIUS])
            self.model.put_down(self.held, LANDING * radius)
        if path:
            points = simplified(np.array(path), 0.12 * self.reach)[:MOST_POINTS]
            if (
                len(points) < 2
                or float(elementwise.hypot(*np.diff(points, axis=0).T).sum()) < 2.0 * self.reach
            ):
                words = "Drag to draw a track."
            elif len(self.model.riders.curves) >= MOST_TRACKS:
                words = f"There is room for {MOST_TRACKS} tracks."
            else:
                words = self._lay([*self.model.riders.curves, Curve(points, corner=50.0)])
        self._forget()
        return words

    def _delete(self, point: Point, ball: int) -> str:
        track = self.track_at(point)
        self.point = None
        if ball != NOBODY:
            self.model.remove(ball)
        elif track != NOBODY:
            curves = list(self.model.riders.curves)
            del curves[track]
            return self._lay(curves)
        return ""

    def is_held(self, ball: int) -> bool:
        """Whether a gate holds a ball."""
        return bool(self.model.table[ball, FREED] == NOT_YET)

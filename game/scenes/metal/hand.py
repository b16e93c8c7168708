"""The hand in the marble run: moves, makes and sizes balls, bends and draws tracks, while it runs."""

from __future__ import annotations

import math

from game.physics.kernels import elementary, elementwise
from game.physics.solids.tracks import Curve
from game.physics.solids.tracks.motion import RADIUS, X, Y
from game.scenes.metal.level import MOST_BALLS, MOST_TRACKS, BallEntry
from game.scenes.metal.model import MetalModel
from game.scenes.metal.tables import ROD
from game.stage import Part, Pointer
from game.worlds.entries.entry import Point
from game.worlds.hands.curves import NOBODY, bent, drawn, nearest_curve

NEAR = 0.02  # of the height in view
MOST_NEAR = 0.3  # m
FARTHEST = 1e3  # m
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
        return nearest_curve(self.model.riders.curves, point, 2.0 * self.reach)

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
        curves[self.bent] = bent(curves[self.bent], before, point, self.parameters.bending)
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
            curve = drawn(path, self.reach, MOST_POINTS)
            if curve is None:
                words = "Drag to draw a track."
            elif len(self.model.riders.curves) >= MOST_TRACKS:
                words = f"There is room for {MOST_TRACKS} tracks."
            else:
                words = self._lay([*self.model.riders.curves, curve])
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

"""The hand on tracks: moves and makes balls, draws, bends and takes away tracks while it runs."""

from __future__ import annotations

from game.physics.kernels import elementary, elementwise
from game.physics.solids.tracks import Curve
from game.physics.solids.tracks.motion import RADIUS, X, Y
from game.scenes.tracks.level import BallEntry
from game.scenes.tracks.model import COLOURS, REACH, TracksModel
from game.stage import Part, Pointer
from game.worlds.entries.entry import Point
from game.worlds.hands.curves import NOBODY, bent, drawn, nearest_curve

NEAR = 0.03  # of the height in view
FARTHEST = 1e4  # m
SHARES = {"disc": 0.5, "sphere": 0.4, "ring": 1.0}
MOST_TRACKS, MOST_BALLS = 40, 2_000


class TrackHand(Part):
    """held: ball in the hand; bent: track in the hand; point: of the hand, m; path: of a new track."""

    def __init__(self, model: TracksModel):
        self.model, self.parameters = model, model.parameters
        self.held = self.bent = NOBODY
        self.point: Point | None = None
        self.path: list[Point] = []

    @property
    def reach(self) -> float:
        """How near, m."""
        view = self.model.content.view
        return NEAR * (view.top - view.bottom)

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST)
        if event.kind == "down" and event.button == 1:
            self.begin_again()
            return self._press(point)
        if event.kind == "move" and self.point is not None:
            return self._move(point)
        if event.kind == "up" and self.point is not None:
            return self._let_go()
        if event.kind == "cancel":
            self.begin_again()
        return ""

    def begin_again(self) -> None:
        """Let go."""
        if self.held != NOBODY and self.held < len(self.model.energies):
            self.model.note_energy(self.held)
        self.held = self.bent = NOBODY
        self.point, self.path = None, []

    def ball_at(self, point: Point) -> int:
        """The ball under a point, or NOBODY."""
        rows = self.model.world.balls.rows
        away = elementwise.hypot(*(rows[:, X : Y + 1] - point).T) - rows[:, RADIUS]
        return int(away.argmin()) if len(rows) and away.min() < self.reach else NOBODY

    def track_at(self, point: Point) -> int:
        """The track with a point near a point, or NOBODY."""
        return nearest_curve(self.model.world.curves, point, 2.0 * self.reach)

    def _press(self, point: Point) -> str:
        tool = self.parameters.tool
        self.point = point
        if tool == "hand":
            self.held = self.ball_at(point)
            if self.held != NOBODY:
                self.model.hold(self.held, point)
        elif tool == "ball":
            return self._make(point)
        elif tool == "draw":
            self.path = [point]
        elif tool == "bend":
            self.bent = self.track_at(point)
        elif tool == "delete":
            return self._delete(point)
        return ""

    def _make(self, point: Point) -> str:
        count = len(self.model.energies)
        if count >= MOST_BALLS:
            return f"There is room for {MOST_BALLS} balls."
        self.held = self.model.add(
            BallEntry(
                position=point, radius=self.parameters.radius, share=SHARES[self.parameters.form],
                colour=COLOURS[count % (len(COLOURS) - 1)], seated=False,  # type: ignore[arg-type]
            )
        )  # fmt: skip
        return ""

    def _move(self, point: Point) -> str:
        before = self.point or point
        self.point = point
        if self.held != NOBODY:
            self.model.hold(self.held, point)
        elif self.path and elementary.dist(point, self.path[-1]) > 0.1 * self.reach:
            self.path.append(point)
        elif self.bent != NOBODY:
            return self._bend(before, point)
        return ""

    def _bend(self, before: Point, point: Point) -> str:
        """Move the points of a track, the nearer the farther."""
        curves = list(self.model.world.curves)
        curves[self.bent] = bent(curves[self.bent], before, point, self.parameters.bending)
        return self._lay(curves)

    def _lay(self, curves: list[Curve]) -> str:
        try:
            self.model.world.set_curves(curves, REACH)
        except ValueError as error:
            return f"{str(error)[:1].upper()}{str(error)[1:]}."
        for ball in range(len(self.model.energies)):
            self.model.note_energy(ball)
        return ""

    def _let_go(self) -> str:
        path, words = self.path, ""
        if self.held != NOBODY:
            self.model.world.put_down(self.held, 0.5 * self.reach)
        if path:
            curve = drawn(path, self.reach)
            if curve is None:
                words = "Drag to draw a track."
            elif len(self.model.world.curves) >= MOST_TRACKS:
                words = f"There is room for {MOST_TRACKS} tracks."
            else:
                words = self._lay([*self.model.world.curves, curve])
        self.begin_again()
        return words

    def _delete(self, point: Point) -> str:
        ball, track = self.ball_at(point), self.track_at(point)
        self.point = None
        if ball != NOBODY:
            self.model.remove(ball)
        elif track != NOBODY:
            curves = list(self.model.world.curves)
            del curves[track]
            # balls of later tracks find theirs again by its place
            self._lay(curves)
        return ""

"""The hand among the dominoes: pushes, drags, adds, removes, while it runs."""

from __future__ import annotations

import numpy as np

from game.physics.kernels import elementary
from game.scenes.domino.course import Standing, height_at
from game.scenes.domino.model import DominoModel
from game.scenes.domino.tables import BODY, TALL, THICK
from game.stage import Part, Pointer

NOBODY = -1
REACH = 0.02  # of the height in view: how near to something the pointer takes it
FARTHEST = 1e4  # m
Point = tuple[float, float]


class DominoHand(Part):
    """held: number of the domino that is dragged; point: where the pointer is, m; ball: that is dragged."""

    def __init__(self, model: DominoModel):
        self.model = model
        self.held = self.ball = NOBODY
        self.point: Point | None = None

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST)
        if event.kind == "down" and event.button in (1, 3):
            tool = "remove" if event.button == 3 else self.model.parameters.tool
            return self._press(point, tool, event.shift)
        if event.kind == "move" and event.button and (self.held != NOBODY or self.ball != NOBODY):
            self._drag(point)
        elif event.kind in ("up", "cancel"):
            self.let_go()
        return ""

    def let_go(self) -> None:
        """Hold nothing."""
        self.held = self.ball = NOBODY
        self.point = None

    def domino_at(self, point: Point) -> int:
        """Number of the domino at a point, or NOBODY."""
        model, view = self.model, self.model.content.view
        table, rows = model.dominoes, model.world.bodies
        there = np.flatnonzero(table[:, BODY] >= 0.0)
        if not len(there):
            return NOBODY
        bodies = table[there, BODY].astype(np.int64)
        away = np.array(point) - rows.positions[bodies]
        c, s = rows.rotations[bodies, 0], rows.rotations[bodies, 1]
        across = np.abs(c * away[:, 0] + s * away[:, 1]) - 0.5 * table[there, THICK]
        along = np.abs(c * away[:, 1] - s * away[:, 0]) - 0.5 * table[there, TALL]
        outside = np.maximum(across, along)
        best = int(np.argmin(outside))
        reach = min(REACH * (view.top - view.bottom), 0.5)
        return int(there[best]) if outside[best] <= reach else NOBODY

    def ball_at(self, point: Point) -> int:
        """Number of the ball at a point, or NOBODY."""
        places = self.model.world.bodies.positions
        for k, (body, entry) in enumerate(zip(self.model.ball_ids, self.model.content.balls, strict=True)):
            if elementary.dist(places[body].tolist(), point) <= entry.radius:
                return k
        return NOBODY

    def floor_below(self, point: Point) -> Standing | None:
        """Where something dropped at a point would stand; None where there is nothing below."""
        best: Standing | None = None
        model = self.model
        for points in model.floors:
            if not points[0, 0] <= point[0] <= points[-1, 0]:
                continue
            y, slope = height_at(points, point[0])
            if y <= point[1] + 0.5 and (best is None or y > best.y):
                best = Standing(point[0], y, slope, 1.0)
        for entry in model.content.planks:
            x, y = entry.at
            over = not entry.seesaw and abs(point[0] - x) <= 0.5 * entry.length
            if over and y <= point[1] + 0.5 and (best is None or y > best.y):
                best = Standing(point[0], y, 0.0, 1.0)
        return best

    def _press(self, point: Point, tool: str, back: bool) -> str:
        self.let_go()
        number = self.domino_at(point)
        if tool == "add":
            place = self.floor_below(point)
            if place is None:
                return "There is no floor below."
            return "" if self.model.add(place) else "There is no room for more dominoes."
        if number == NOBODY:
            self.ball = self.ball_at(point) if tool in ("drag", "push") else NOBODY
            self.point = point if self.ball != NOBODY else None
            return ""
        if tool == "push":
            self.model.push(number, back)
        elif tool == "drag":
            self.held, self.point = number, point
        elif tool == "remove":
            self.model.take_away(number)
        return ""

    def _drag(self, point: Point) -> None:
        self.point = point
        if self.ball != NOBODY:
            body = self.model.ball_ids[self.ball]
            self.model.world.set_pose(body, point, float(self.model.world.bodies.angles[body]))
            self.model.world.set_velocity(body, (0.0, 0.0), 0.0)
            return
        place = self.floor_below(point)
        if place is not None:
            self.model.stand(self.held, place)

"""The hand in the rigid body scene: pushes, spheres added and removed, and the view turned."""

from __future__ import annotations

import numpy as np

from game.physics.kernels import elementary
from game.scenes.rigid_body.bodies import A
from game.scenes.rigid_body.camera import camera_matrix, hit_sphere, on_plane
from game.scenes.rigid_body.edits import Edits
from game.scenes.rigid_body.level import COLORS
from game.scenes.rigid_body.model import Pull, Push, RigidModel, Vector
from game.stage import Part, Pointer

FARTHEST = 1_000.0  # m
LEAST_RADIUS, CLICK_RADIUS, MOST_RADIUS = 0.02, 0.15, 2.0  # m; a click without a drag gives the middle one
NOBODY = -1
TURN_SPEED = 28.0  # degrees for each metre of a drag
Point = tuple[float, float]


class Hand(Part):
    """What the pointer does to a model.

    grip: what is held: "", "push", "sphere" or "view". pane: the body that is held. arm: m, in the body's
    own axes, from its centre of mass; start, target: m, in the world. edits: of its spheres.
    hovered: the sphere under the pointer, of the body in ``pane``, or NOBODY.
    """

    def __init__(self, model: RigidModel):
        self.model, self.edits = model, Edits(model)
        self.grip, self.pane = "", A
        self.arm: Vector = (0.0, 0.0, 0.0)
        self.start: Vector = self.arm
        self.target: Vector = self.arm
        self._last: Point = (0.0, 0.0)
        self.hovered = NOBODY

    def take(self, event: Pointer) -> None:
        """A pointer event in coordinates of the picture."""
        point = (min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST))
        if event.kind == "down":
            if event.button == 3:
                self.grip, self._last = "view", point
            elif event.button == 1:
                self._press(point)
        elif event.kind == "move":
            self._move(point)
        elif event.kind == "up":
            self._move(point)
            self._let_go()
        elif event.kind == "cancel":
            self.grip = ""

    def held(self) -> Pull | None:
        """What the hand pulls the point that it holds with, towards the pointer; None if it does not."""
        parameters = self.model.parameters
        if self.grip != "push" or parameters.pushing != "hold":
            return None
        point = self.model.bodies.point_of(self.pane, self.arm).tolist()
        fx, fy, fz = (parameters.strength * (t - p) for p, t in zip(point, self.target, strict=True))
        return Pull((fx, fy, fz), self.arm)

    def acting(self) -> Pull | None:
        """The pull that acts now: the hand's, or else that of a push that was let go."""
        held, push = self.held(), self.model.push
        return held if held is not None else push.pull if push is not None else None

    def new_radius(self) -> float:
        """Radius (m) of the sphere that is being added."""
        drawn = elementary.dist(self.start, self.target)
        return CLICK_RADIUS if drawn < LEAST_RADIUS else min(drawn, MOST_RADIUS)

    def _view(self) -> np.ndarray:
        return camera_matrix(self.model.parameters.turn, self.model.parameters.tilt)

    def _in_pane(self, pane: int, point: Point) -> Point:
        """A point of the picture as seen in a pane."""
        return point[0] - self.model.panes.shift(pane), point[1]

    def _press(self, point: Point) -> None:
        pane, tool, self.hovered = self.model.panes.at(point[0]), self.model.parameters.tool, NOBODY
        view, seen = self._view(), self._in_pane(pane, point)
        body = self.model.bodies.all[pane]
        hit = hit_sphere(view, body.spheres(), body.radii, seen)
        self._last, self.pane = point, pane
        if tool == "remove":
            if hit is not None:
                self.edits.remove(hit[0])
            return
        if hit is None and tool == "push":
            self.grip = "view"
            return
        place = hit[1] if hit is not None and tool == "push" else on_plane(view, body.position, seen)
        x, y, z = place.tolist()
        self.grip, self.arm = tool, self.model.bodies.arm_of(pane, place)
        self.start = self.target = (x, y, z)

    def _move(self, point: Point) -> None:
        if self.grip == "view":
            parameters = self.model.parameters
            turn = parameters.turn + TURN_SPEED * (point[0] - self._last[0])
            parameters.turn = (turn + 180.0) % 360.0 - 180.0
            tilt = parameters.tilt - TURN_SPEED * (point[1] - self._last[1])
            parameters.tilt = min(max(tilt, -90.0), 90.0)
        elif not self.grip:
            self._hover(point)
        else:
            seen = self._in_pane(self.pane, point)
            x, y, z = on_plane(self._view(), np.array(self.start), seen).tolist()
            self.target = (x, y, z)
        self._last = point

    def _hover(self, point: Point) -> None:
        """Note the sphere under the pointer."""
        self.pane = self.model.panes.at(point[0])
        body = self.model.bodies.all[self.pane]
        hit = hit_sphere(self._view(), body.spheres(), body.radii, self._in_pane(self.pane, point))
        self.hovered = NOBODY if hit is None else hit[0]

    def _let_go(self) -> None:
        grip, self.grip = self.grip, ""
        parameters = self.model.parameters
        if grip == "push" and parameters.pushing == "release":
            drawn = zip(self.start, self.target, strict=True)
            fx, fy, fz = (parameters.strength * (t - s) for s, t in drawn)
            if fx or fy or fz:
                self.model.push = Push(Pull((fx, fy, fz), self.arm), parameters.push_time)
        elif grip == "sphere":
            x, y, z = (self.model.bodies.center + np.array(self.arm)).tolist()
            pink = float(COLORS.index("pink"))
            self.edits.add((x, y, z, self.new_radius(), parameters.new_density, pink))

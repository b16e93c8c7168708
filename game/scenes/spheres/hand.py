"""The hand in C13: forces by click and drag, spheres made and removed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.physics.rigid import PUSHES
from game.scenes.spheres.model import CollisionModel
from game.scenes.spheres.pushes import Place, place_of, point_of
from game.stage import Part, Pointer

FARTHEST = 1e4  # m
NOBODY = -1
Point = tuple[float, float]


class Pressed(NamedTuple):
    """A force that is being drawn: the body, the point pressed in the body's frame, and the pointer."""

    body: int
    place: Place  # m from the body's centre, in its frame
    to_x: float
    to_y: float


class Hand(Part):
    """What the pointer does to a model; ``pressed`` while a force is drawn."""

    def __init__(self, model: CollisionModel):
        self.model = model
        self.pressed: Pressed | None = None

    def forget(self) -> None:
        """Forget what was begun."""
        self.pressed = None

    def take(self, event: Pointer) -> None:
        """A pointer event in world coordinates."""
        point = (min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST))
        tool = self.model.parameters.tool
        if event.kind == "down" and (event.button == 3 or (event.button == 1 and tool == "remove")):
            self._remove(point)
        elif event.kind == "down" and event.button == 1:
            if tool == "sphere":
                self.model.add_sphere(*point)
            else:
                self._press(point)
        elif event.kind == "move" and self.pressed is not None:
            self.pressed = self.pressed._replace(to_x=point[0], to_y=point[1])
        elif event.kind == "up" and event.button == 1 and self.pressed is not None:
            pressed, self.pressed = self.pressed, None
            self._let_go(pressed, point)
        elif event.kind == "cancel":
            self.pressed = None

    def _sphere_at(self, point: Point) -> int:
        """The sphere under a point, or NOBODY; of several the last one."""
        bodies = self.model.world.bodies
        away = bodies.places()[:, :2] - point
        under = np.flatnonzero(
            (away * away).sum(axis=1) <= bodies.composition.radii * bodies.composition.radii
        )
        return int(under[-1]) if len(under) else NOBODY

    def _press(self, point: Point) -> None:
        """Begin to draw a force at a point of a sphere."""
        sphere = self._sphere_at(point)
        if sphere == NOBODY:
            return
        bodies = self.model.world.bodies
        body = int(bodies.composition.owners[sphere])
        place = place_of(bodies, body, np.array((*point, bodies.places()[sphere, 2])))
        self.pressed = Pressed(body, place, *point)

    def _let_go(self, pressed: Pressed, point: Point) -> None:
        """The drawn force begins to act."""
        model = self.model
        if PUSHES not in model.active:
            model.messages.say("Pushes are switched off.")
            return
        strength = model.parameters.push_strength
        start_x, start_y, _ = point_of(model.world.bodies, pressed.body, pressed.place).tolist()
        x, y = strength * (point[0] - start_x), strength * (point[1] - start_y)
        if x != 0.0 or y != 0.0:
            model.push(pressed.body, pressed.place, (x, y, 0.0))

    def _remove(self, point: Point) -> None:
        sphere = self._sphere_at(point)
        if sphere != NOBODY and self.model.remove_body_of(sphere):
            self.pressed = None

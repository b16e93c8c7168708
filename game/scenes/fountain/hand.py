"""The hand in the fountain: stones, their rims, nozzles and the whirl are dragged.

The scene keeps ``hand`` (what is held, and its number), ``target`` and ``grip`` (m) as plain attributes.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from game.physics.fields import GROUND, WHIRL
from game.physics.particles import OBSTACLES
from game.scenes.fountain.level import MOST_STONES
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.fountain.scene import Fountain

REACH = 0.14  # m, how near to a handle the pointer takes it
NEW_RADIUS = 0.25  # m, of a stone put by a click
LEAST_RADIUS, MOST_RADIUS = 0.02, 500.0  # m
FARTHEST = 1000.0  # m
NOTHING = ("", -1)
Point = tuple[float, float]


def rim_handle(x: float, y: float, radius: float) -> Point:
    """Where a stone's handle for its radius is: on the rim, up and to the right."""
    return x + 0.88 * radius, y + 0.475 * radius


def take_pointer(scene: Fountain, event: Pointer) -> None:
    """A pointer event in world coordinates."""
    point = _within_reach(event.x, event.y)
    if event.kind == "down" and event.button == 1:
        _press(scene, point, event.shift)
    elif event.kind == "down" and event.button == 3:
        _remove_stone(scene, point)
    elif event.kind == "move" and scene.hand != NOTHING:
        _drag(scene, point)
    elif event.kind in ("up", "cancel"):
        scene.hand = NOTHING


def _within_reach(x: float, y: float) -> Point:
    """The nearest place (m) that a level file can name."""
    return min(max(x, -FARTHEST), FARTHEST), min(max(y, -FARTHEST), FARTHEST)


def thing_at(scene: Fountain, point: Point) -> tuple[str, int]:
    """What is to be dragged at a point: rim, stone, nozzle or whirl, with its number; or NOTHING."""
    if OBSTACLES in scene.active:
        stones = scene.system.solids.rows[:, :3].tolist()
        for j, (x, y, radius) in enumerate(stones):
            if math.dist(point, rim_handle(x, y, radius)) < REACH:
                return "rim", j
        for j, (x, y, radius) in enumerate(stones):
            if math.dist(point, (x, y)) < max(radius, REACH):
                return "stone", j
    for e, row in enumerate(scene.system.state().emitters.tolist()):
        if math.dist(point, row[:2]) < 2.0 * REACH:
            return "nozzle", e
    if WHIRL in scene.active and math.dist(point, scene.whirl_centre) < 2.0 * REACH:
        return "whirl", 0
    return NOTHING


def _press(scene: Fountain, point: Point, new: bool) -> None:
    scene.hand = thing_at(scene, point)
    if scene.hand != NOTHING:
        x, y = _place_of(scene)
        scene.target = (x, y)
        scene.grip = (x - point[0], y - point[1])
    elif new:
        _add_stone(scene, point)


def _place_of(scene: Fountain) -> Point:
    """Where the point (m) is that follows the hand: of what is held, its centre or the handle on its rim."""
    what, index = scene.hand
    if what == "whirl":
        return scene.whirl_centre
    if what == "nozzle":
        x, y = scene.system.state().emitters[index, :2].tolist()
        return x, y
    x, y, radius = scene.system.solids.rows[index, :3].tolist()
    return rim_handle(x, y, radius) if what == "rim" else (x, y)


def _drag(scene: Fountain, point: Point) -> None:
    what, index = scene.hand
    place = _within_reach(point[0] + scene.grip[0], point[1] + scene.grip[1])
    if what == "stone":
        scene.target = place
    elif what == "rim":
        row = scene.system.solids.rows[index]
        row[2] = min(max(math.dist(place, row[:2].tolist()), LEAST_RADIUS), MOST_RADIUS)
    elif what == "nozzle":
        lowest = scene.content.floor if GROUND in scene.active else -FARTHEST
        scene.system.place_emitter(index, (place[0], max(place[1], lowest)))
        scene.since = scene.system.time_s
    elif what == "whirl":
        scene.whirl_centre = place
        scene.configure()


def _add_stone(scene: Fountain, point: Point) -> None:
    if len(scene.own) == MOST_STONES:
        scene.told.append(f"There is room for {MOST_STONES} stones.")
        return
    index = scene.system.solids.add(point, NEW_RADIUS, scene.restitution)
    scene.own.append(None)
    scene.hand, scene.target, scene.grip = ("stone", index), point, (0.0, 0.0)


def _remove_stone(scene: Fountain, point: Point) -> None:
    what, index = thing_at(scene, point)
    if what in ("stone", "rim"):
        scene.system.solids.remove(index)
        del scene.own[index]
        scene.hand = NOTHING

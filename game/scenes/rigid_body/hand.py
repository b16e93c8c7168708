"""The hand in the rigid body scene: pushes, spheres put on and taken off, and the view turned.

The scene keeps what is held as plain attributes: ``grip`` ("", "push", "sphere" or "view"), ``arm`` (m, in
the body's own axes, from its centre of mass), ``start`` and ``target`` (m, in the world), ``last`` (pointer).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from game.scenes.rigid_body.bodies import A, B
from game.scenes.rigid_body.camera import camera_matrix, hit_sphere, on_plane
from game.scenes.rigid_body.level import COLORS, MOST_SPHERES
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.rigid_body.scene import RigidBodyScene

TOOLS = ("push", "sphere", "remove")
FARTHEST = 1_000.0  # m
LEAST_RADIUS, CLICK_RADIUS, MOST_RADIUS = 0.02, 0.15, 2.0  # m; a click without a drag gives the middle one
TURN_SPEED = 28.0  # degrees for each metre of a drag
MOST_UNDONE = 30
Point = tuple[float, float]
Edit = tuple[bool, int, tuple[float, ...]]  # put on or taken off, place in the list, row of the design


def take_pointer(scene: RigidBodyScene, event: Pointer) -> None:
    """A pointer event in coordinates of the picture."""
    point = (min(max(event.x, -FARTHEST), FARTHEST), min(max(event.y, -FARTHEST), FARTHEST))
    if event.kind == "down":
        if event.button == 3:
            scene.grip, scene.last = "view", point
        elif event.button == 1:
            _press(scene, point)
    elif event.kind == "move":
        _move(scene, point)
    elif event.kind == "up":
        _move(scene, point)
        _let_go(scene)
    elif event.kind == "cancel":
        scene.grip = ""


def pane_of(scene: RigidBodyScene, point: Point) -> int:
    """Which body a point of the picture is beside."""
    return B if scene.twin and point[0] > 0.0 else A


def local(scene: RigidBodyScene, pane: int, point: Point) -> Point:
    """A point of the picture as seen in a pane."""
    return point[0] - scene.pane_shift(pane), point[1]


def _press(scene: RigidBodyScene, point: Point) -> None:
    pane = pane_of(scene, point)
    view, seen = camera_matrix(scene.turn, scene.tilt), local(scene, pane, point)
    body = scene.bodies.all[pane]
    hit = hit_sphere(view, body.spheres(), body.radii, seen)
    scene.last, scene.pane = point, pane
    if scene.tool == "remove":
        if hit is not None:
            remove_sphere(scene, hit[0])
        return
    if hit is None and scene.tool == "push":
        scene.grip = "view"
        return
    place = hit[1] if hit is not None and scene.tool == "push" else on_plane(view, body.position, seen)
    x, y, z = place.tolist()
    scene.grip, scene.arm = scene.tool, scene.bodies.arm_of(pane, place)
    scene.start = scene.target = (x, y, z)


def _move(scene: RigidBodyScene, point: Point) -> None:
    if scene.grip == "view":
        turn = scene.turn + TURN_SPEED * (point[0] - scene.last[0])
        scene.values["turn"] = (turn + 180.0) % 360.0 - 180.0
        tilt = scene.tilt - TURN_SPEED * (point[1] - scene.last[1])
        scene.values["tilt"] = min(max(tilt, -90.0), 90.0)
    elif scene.grip:
        view = camera_matrix(scene.turn, scene.tilt)
        x, y, z = on_plane(view, np.array(scene.start), local(scene, scene.pane, point)).tolist()
        scene.target = (x, y, z)
    scene.last = point


def _let_go(scene: RigidBodyScene) -> None:
    grip, scene.grip = scene.grip, ""
    if grip == "push" and scene.pushing == "release":
        fx, fy, fz = (scene.strength * (t - s) for s, t in zip(scene.start, scene.target, strict=True))
        if fx or fy or fz:
            scene.push = (fx, fy, fz, *scene.arm, scene.push_time)
    elif grip == "sphere":
        _add_sphere(scene)


def held_force(scene: RigidBodyScene) -> tuple[float, float, float] | None:
    """Force (N) of the hand that pulls the point it holds towards the pointer, or None."""
    if scene.grip != "push" or scene.pushing != "hold":
        return None
    point = scene.bodies.point_of(scene.pane, scene.arm).tolist()
    fx, fy, fz = (scene.strength * (t - p) for p, t in zip(point, scene.target, strict=True))
    return fx, fy, fz


def new_radius(scene: RigidBodyScene) -> float:
    """Radius (m) of the sphere that is being put on."""
    drawn = math.dist(scene.start, scene.target)
    return CLICK_RADIUS if drawn < LEAST_RADIUS else min(drawn, MOST_RADIUS)


def _add_sphere(scene: RigidBodyScene) -> None:
    count = len(scene.bodies.design)
    if count >= MOST_SPHERES:
        scene.told.append(f"There is room for {MOST_SPHERES} spheres.")
        return
    place = scene.bodies.center + np.array(scene.arm)
    row = (*place.tolist(), new_radius(scene), scene.new_density, float(COLORS.index("pink")))
    _edit(scene, (True, count, row))


def remove_sphere(scene: RigidBodyScene, index: int) -> None:
    """Take a sphere off; the last one stays."""
    if len(scene.bodies.design) == 1:
        scene.told.append("The last sphere stays.")
        return
    _edit(scene, (False, index, tuple(scene.bodies.design[index].tolist())))


def _edit(scene: RigidBodyScene, edit: Edit) -> None:
    scene.undone = []
    scene.done = [*scene.done, edit][-MOST_UNDONE:]
    _reshape(scene, edit)


def _reshape(scene: RigidBodyScene, edit: Edit) -> None:
    """Put a sphere on (True) or take it off, at its place in the list."""
    on, index, row = edit
    design = scene.bodies.design
    changed = np.insert(design, index, row, axis=0) if on else np.delete(design, index, axis=0)
    scene.bodies.reshape(changed)
    scene.push = None


def undo(scene: RigidBodyScene) -> None:
    """Take back the last sphere put on or taken off."""
    if scene.done:
        on, index, row = scene.done[-1]
        scene.undone, scene.done = [*scene.undone, scene.done[-1]], scene.done[:-1]
        _reshape(scene, (not on, index, row))


def redo(scene: RigidBodyScene) -> None:
    """Do again what was taken back."""
    if scene.undone:
        edit = scene.undone[-1]
        scene.done, scene.undone = [*scene.done, edit], scene.undone[:-1]
        _reshape(scene, edit)

"""The hand in C13: forces by click and drag, spheres made and taken away.

The scene keeps what the hand remembers as plain attributes, so that the stage can undo it: ``pressed`` while
a force is drawn, and ``pushes``, the forces that act now.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from game.physics.rigid import PUSHES, quaternion_conjugate, quaternion_rotate
from game.physics.spheres.composition import Makeup
from game.physics.spheres.spheres import MotionState, SphereBodies
from game.scenes.spheres.level import MOST_SPHERES
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.spheres.scene import SphereCollisions

TOOLS = ("push", "sphere", "remove")
NOBODY = -1
Point = tuple[float, float]


class Pressed(NamedTuple):
    """A force that is being drawn: the body, the point pressed in the body's frame, and the pointer."""

    body: int
    place: tuple[float, float, float]  # m from the body's centre, in its frame
    to_x: float
    to_y: float


class Push(NamedTuple):
    """A force that acts: on a body, at a point of its own, so long."""

    body: int
    place: tuple[float, float, float]
    force: tuple[float, float, float]  # N
    left: float  # s


def begin_anew(scene: SphereCollisions) -> None:
    """Forget what was begun."""
    scene.pressed = None


def take_pointer(scene: SphereCollisions, event: Pointer) -> None:
    """A pointer event in world coordinates."""
    point = (min(max(event.x, -1e4), 1e4), min(max(event.y, -1e4), 1e4))
    if event.kind == "down" and (event.button == 3 or (event.button == 1 and scene.tool == "remove")):
        remove(scene, sphere_at(scene, point))
    elif event.kind == "down" and event.button == 1:
        if scene.tool == "sphere":
            make(scene, point)
        else:
            press(scene, point)
    elif event.kind == "move" and scene.pressed is not None:
        scene.pressed = scene.pressed._replace(to_x=point[0], to_y=point[1])
    elif event.kind == "up" and event.button == 1 and scene.pressed is not None:
        let_go(scene, point)
    elif event.kind == "cancel":
        scene.pressed = None


def sphere_at(scene: SphereCollisions, point: Point) -> int:
    """The sphere under a point, or NOBODY; of several the last one."""
    bodies = scene.world.bodies
    away = bodies.places()[:, :2] - point
    under = np.flatnonzero((away * away).sum(axis=1) <= bodies.makeup.radii**2)
    return int(under[-1]) if len(under) else NOBODY


def press(scene: SphereCollisions, point: Point) -> None:
    """Begin to draw a force at a point of a sphere."""
    sphere = sphere_at(scene, point)
    if sphere == NOBODY:
        return
    bodies = scene.world.bodies
    body = int(bodies.makeup.owners[sphere])
    arm = np.array((*point, bodies.places()[sphere, 2])) - bodies.state.positions[body]
    local = quaternion_rotate(quaternion_conjugate(bodies.state.orientations[body]), arm)
    scene.pressed = Pressed(body, tuple(local.tolist()), *point)


def point_of(scene: SphereCollisions, body: int, place: tuple[float, float, float]) -> np.ndarray:
    """World position (3,) m of a point of a body."""
    state = scene.world.bodies.state
    turned: np.ndarray = state.positions[body] + quaternion_rotate(state.orientations[body], place)
    return turned


def let_go(scene: SphereCollisions, point: Point) -> None:
    """The drawn force begins to act."""
    pressed = scene.pressed
    assert pressed is not None
    scene.pressed = None
    if PUSHES not in scene.active:
        scene.told.append("Pushes are switched off.")
        return
    start = point_of(scene, pressed.body, pressed.place)
    x, y = scene.push_strength * (point[0] - start[0]), scene.push_strength * (point[1] - start[1])
    if x != 0.0 or y != 0.0:
        scene.end_exact("a force acts")
        scene.pushes.append(
            Push(pressed.body, pressed.place, (float(x), float(y), 0.0), float(scene.push_time))
        )


def act(scene: SphereCollisions, dt: float) -> None:
    """Let the forces act during the next step of dt (s)."""
    going = []
    for push in scene.pushes:
        share = min(push.left / dt, 1.0)
        if PUSHES in scene.active:
            force = share * np.array(push.force)
            scene.world.apply_force(push.body, force, point_of(scene, push.body, push.place))
        if push.left > dt * (1.0 + 1e-9):
            going.append(push._replace(left=push.left - dt))
    scene.pushes = going


def make(scene: SphereCollisions, point: Point) -> None:
    """A new sphere at a point, as a body of its own; no nearer to the walls than its radius."""
    bodies = scene.world.bodies
    if len(bodies.makeup.radii) >= MOST_SPHERES:
        scene.told.append(f"There is room for {MOST_SPHERES} spheres.")
        return
    view, radius = scene.content.view, scene.radius
    if 2.0 * radius > min(view.right - view.left, view.top - view.bottom):
        scene.told.append("The window is too small for such a sphere.")
        return
    x = min(max(point[0], view.left + radius), view.right - radius)
    y = min(max(point[1], view.bottom + radius), view.top - radius)
    new = SphereBodies(
        [(x, y)], [radius], masses=scene.density * 4.0 / 3.0 * np.pi * radius**3 if scene.real else 1.0,
        inertias="solid" if scene.real else "unit",
    )  # fmt: skip
    pairs: Any = (zip(bodies.makeup, new.makeup, strict=True), zip(bodies.state, new.state, strict=True))
    makeup = Makeup(*(np.concatenate(pair) for pair in pairs[0]))
    makeup.owners[-1] = bodies.count
    state = MotionState(*(np.concatenate(pair) for pair in pairs[1]))
    scene.take_bodies(SphereBodies.of_parts(makeup, state), scene.world.surroundings)


def remove(scene: SphereCollisions, sphere: int) -> None:
    """Take a sphere away, and all that are joined to it."""
    if sphere == NOBODY:
        return
    bodies, around = scene.world.bodies, scene.world.surroundings
    if bodies.count == 1:
        scene.told.append("The last body stays.")
        return
    gone = int(bodies.makeup.owners[sphere])
    stay = bodies.makeup.owners != gone
    kept = np.arange(bodies.count) != gone
    makeup = Makeup(*(part[kept] for part in bodies.makeup[:3]), *(part[stay] for part in bodies.makeup[3:]))
    makeup.owners[makeup.owners > gone] -= 1
    state = MotionState(*(part[kept] for part in bodies.state))
    number = np.cumsum(stay) - 1
    held = stay[around.hung]
    around = around._replace(hung=number[around.hung[held]], strings=around.strings[held])
    scene.pushes = [
        push._replace(body=push.body - (push.body > gone)) for push in scene.pushes if push.body != gone
    ]
    scene.pressed = None
    scene.take_bodies(SphereBodies.of_parts(makeup, state), around)

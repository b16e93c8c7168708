"""The hand in the mass-spring scenes: moving, making, linking, pinning and cutting while it runs.

The scene keeps what the hand remembers as plain attributes, so that the stage can undo it: ``chosen`` (a
particle or -1), ``first`` (the first end of a link or -1), ``knife`` (where a cut has come to, or None).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from game.physics.constraints.editing import (
    links_across,
    nearest_particle,
    with_link,
    with_particle,
    without_particle,
)
from game.scenes.springs.level import NOT_OWN
from game.stage import Pointer

if TYPE_CHECKING:
    from game.scenes.springs.base import MassSpringScene

TOOLS = ("hand", "particle", "link", "pin", "cut")
REACH = 0.045  # of the height in view: how near to a particle the pointer takes it
MOST_PARTICLES = 20_000  # that clicks can make
NOBODY = -1
Point = tuple[float, float]


def begin_anew(scene: MassSpringScene) -> None:
    """Forget what was begun; what is chosen stays."""
    scene.first = NOBODY
    scene.knife = None
    scene.system.release()


def take_pointer(scene: MassSpringScene, event: Pointer) -> None:
    """A pointer event in world coordinates."""
    point = (min(max(event.x, -1e4), 1e4), min(max(event.y, -1e4), 1e4))
    if event.kind == "down" and event.button == 3:
        scene.knife = point
    elif event.kind == "down" and event.button == 1:
        _press(scene, point)
    elif event.kind == "move":
        if scene.knife is not None:
            _cut(scene, point)
        elif scene.system.held != NOBODY:
            scene.system.drag(point)
    elif event.kind in ("up", "cancel"):
        if event.kind == "up" and scene.first != NOBODY:
            _link_to(scene, _at(scene, point), released=True)
        scene.knife = None
        scene.system.release()
        if event.kind == "cancel":
            scene.first = NOBODY


def _at(scene: MassSpringScene, point: Point) -> int:
    """The particle at a point, or NOBODY."""
    frame = scene.frame()
    return nearest_particle(scene.system, point, REACH * (frame.top - frame.bottom))


def _press(scene: MassSpringScene, point: Point) -> None:
    index = _at(scene, point)
    if scene.tool == "cut":
        scene.knife = point
    elif scene.tool == "particle" and index == NOBODY:
        _make_particle(scene, point)
    elif scene.tool == "link":
        if scene.first == NOBODY:
            scene.first = index
            choose(scene, index)
        else:
            _link_to(scene, index, released=False)
    elif scene.tool == "pin" and index != NOBODY:
        choose(scene, index)
        scene.values["fixed"] = not scene.values["fixed"]
        apply_parameter(scene, "fixed")
    else:
        choose(scene, index)
        if index != NOBODY:
            scene.system.grab(index)
            scene.system.drag(tuple(scene.system.positions[index].tolist()))


def choose(scene: MassSpringScene, index: int) -> None:
    """Let a particle be the chosen one (or nobody), and the parameters say what it is."""
    scene.chosen = index
    if index == NOBODY:
        return
    weight = inverse_mass(scene, index)
    scene.values["fixed"] = weight == 0.0
    if weight > 0.0:
        scene.values["mass"] = min(max(1.0 / weight, 1e-6), 1e6)
    links = np.flatnonzero(np.any(scene.system.links.pairs == index, axis=1))
    if "own_stiffness" in scene.values and len(links):
        own = scene.own[links[0]]
        scene.values["own_stiffness"] = float(own) if own != NOT_OWN else scene.values["stiffness"]


def inverse_mass(scene: MassSpringScene, index: int) -> float:
    """Inverse mass (1/kg) of a particle, also while the hand holds it."""
    system = scene.system
    return float(system.hand[1]) if system.held == index else float(system.inverse_masses[index])


def apply_parameter(scene: MassSpringScene, name: str) -> None:
    """Give what is chosen the mass, fixing or stiffness that the parameters say."""
    index, system = scene.chosen, scene.system
    if index == NOBODY:
        return
    if name == "own_stiffness":
        scene.own[np.any(system.links.pairs == index, axis=1)] = scene.values["own_stiffness"]
        scene.edited = True
        scene.renew_links()
        return
    weight = 0.0 if scene.fixed else 1.0 / scene.mass
    if system.held == index:
        system.hand[1] = weight
    else:
        system.inverse_masses[index] = weight
        if weight == 0.0:
            system.fields[2:4, index] = 0.0
    system.masses_changed()


def _make_particle(scene: MassSpringScene, point: Point) -> None:
    if scene.system.count >= MOST_PARTICLES:
        scene.told.append(f"There is room for {MOST_PARTICLES} particles.")
        return
    weight = 0.0 if scene.fixed else 1.0 / scene.mass
    system = with_particle(scene.system, point, weight)
    scene.take_system(system, scene.own)
    scene.chosen = system.count - 1


def _link_to(scene: MassSpringScene, index: int, released: bool) -> None:
    """End a link at a particle; a click that is released where it began waits for another one."""
    first = scene.first
    if released and index == first:
        return
    scene.first = NOBODY
    if index in (NOBODY, first):
        return
    try:
        system = with_link(scene.system, first, index)
    except ValueError as error:
        scene.told.append(f"{str(error).capitalize()}.")
        return
    scene.take_system(system, np.append(scene.own, NOT_OWN))
    scene.renew_links()
    scene.chosen = index


def _cut(scene: MassSpringScene, point: Point) -> None:
    """Cut all links between where the knife was and where it is now."""
    assert scene.knife is not None
    for link in links_across(scene.system, scene.knife, point):
        scene.system.cut(link)
    scene.knife = point


def delete(scene: MassSpringScene) -> None:
    """Take the chosen particle away, with its links."""
    index = scene.chosen
    if index == NOBODY:
        return
    begin_anew(scene)
    kept = np.all(scene.system.links.pairs != index, axis=1)
    try:
        system = without_particle(scene.system, index)
    except ValueError as error:
        scene.told.append(f"{str(error).capitalize()}.")
        return
    scene.take_system(system, scene.own[kept])
    scene.chosen = NOBODY

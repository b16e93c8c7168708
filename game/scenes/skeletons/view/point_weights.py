"""A point of the skin under the pointer: what it weighs on each bone, and where each alone would take it."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.scenes.skeletons.bench import reach_of
from game.scenes.skeletons.rig import Rig
from game.ui.canvas.canvas import Canvas

LEAST_SHOWN = 0.005  # of a weight


class Share(NamedTuple):
    """A bone that a point follows: its index, the weight, and where (2,) m it alone would take the point."""

    bone: int
    weight: float
    place: Floats


def point_at(rig: Rig, points: Floats, pointer: tuple[float, float]) -> int:
    """The point of an outline nearest to the pointer, of those within reach; -1 if there is none."""
    outlines = points[: int(rig.starts[-1])]
    if rig.binding is None or not len(outlines):
        return -1
    off = ((outlines - pointer) ** 2).sum(axis=1)
    nearest = int(np.argmin(off))
    return nearest if math.sqrt(float(off[nearest])) <= reach_of(rig.figure) else -1


def shares_of(rig: Rig, point: int) -> list[Share]:
    """The bones that a point follows in the pose shown, by falling weight."""
    bound = rig.binding
    assert bound is not None
    bind = rig.frames_bound()
    x, y = bound.points[point].tolist()
    found = []
    for bone, weight in zip(bound.bones[point].tolist(), bound.weights[point].tolist(), strict=True):
        if weight > 0.0:
            place = rig.shown.world[bone] @ np.linalg.solve(bind[bone], np.array((x, y, 1.0)))
            found.append(Share(bone, weight, place[:2]))
    return sorted(found, key=lambda share: -share.weight)


def draw_point_weights(canvas: Canvas, rig: Rig, points: Floats, pointer: tuple[float, float]) -> None:
    """The point with a ring; a dot where each bone alone would take it, with its name and weight."""
    point = point_at(rig, points, pointer)
    if point < 0:
        return
    place = tuple(points[point].tolist())
    shares = [share for share in shares_of(rig, point) if share.weight >= LEAST_SHOWN]
    for share in shares:
        canvas.line(place, tuple(share.place), "text2", 1.2, dash=(3.0, 4.0))
        canvas.dot(tuple(share.place), 4.0, "ghost")
    canvas.ring(place, 7.0, "amber", 1.8)
    for i, share in enumerate(shares):
        words = f"{100.0 * share.weight:.0f} %  {rig.figure.bones[share.bone].name}"
        canvas.label(place, words, "text1", 12, "semibold", anchor="left", offset=(16.0, 17.0 * i - 8.0))

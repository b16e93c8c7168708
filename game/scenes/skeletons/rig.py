"""A figure as it is computed: its skeleton, its skins bound to it, and both moved together.

Made from the content of a level; made again after each edit. Angles are those of the pose; the bind
pose is kept, and weights are of it alone.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.animation import Binding, Skeleton, Skinner, bind_given, bind_weights
from game.physics.animation.outlines import points_inside, rounded, sum_areas
from game.physics.animation.weights import distances_to_bones, weigh
from game.physics.kernels import elementary, elementwise
from game.scenes.skeletons.level import FigureContent, SkinEntry, bone_named

INSIDE = 1_400  # points within all skins that show their weights, about
COARSE = (24, 90, 300)  # points of an outline, above which a small figure has every 2nd, 4th, 6th one
ROUND = 0.006  # of the height in view: spacing of the points of a rounded skin


class WeightRules(NamedTuple):
    """How skins are bound: threshold (m), falloff, influences, and whether drawn outlines are rounded."""

    threshold: float = 0.3
    falloff: float = 3.0
    influences: int = 4
    smooth: bool = True


class Rig:
    """Skeleton, skins and what moves them.

    ``skeleton`` is in the present pose; ``skinned`` (v, 2) m by the last `move`: first all outlines, point by
    point, from ``starts`` (m + 1,) on, then the points within. ``areas`` (m,) m² as bound. ValueError for a
    figure that cannot be.
    """

    def __init__(self, figure: FigureContent, rules: WeightRules) -> None:
        self.figure, self.rules = figure, rules
        self.rest = np.radians([bone.angle for bone in figure.bones])
        self.skeleton = _skeleton_of(figure, self.rest)
        self._roots = np.flatnonzero(self.skeleton.parents < 0)
        self._places = self.skeleton.offsets[self._roots].copy()
        self.swings = np.array(
            [(math.radians(b.swing.by), b.swing.rate, b.swing.phase) if b.swing else (0.0, 0.0, 0.0)
             for b in figure.bones]
        )  # fmt: skip
        self.skinner: Skinner | None = None
        self._spare: Skinner | None = None
        self._few: Skinner | None = None
        self.few_starts = np.zeros(1, dtype=np.int64)  # of the outlines in `show_few`
        self._dense: Floats | None = None
        self.binding: Binding | None = None
        self.skinned, self.areas = np.zeros((0, 2)), np.zeros(len(figure.skins))
        self._bind()
        self.pose(self.start)
        self.shown = self.skeleton.copy()  # for pictures between two steps

    @property
    def start(self) -> Floats:
        """The pose (n + 2,) at the beginning: angles (rad) and the shift of the root (m)."""
        turns = np.radians([bone.turn for bone in self.figure.bones])
        return np.concatenate([self.rest + turns, self.figure.shift])

    @property
    def bound(self) -> Floats:
        """The pose (n + 2,) in which skins are bound."""
        return np.concatenate([self.rest, (0.0, 0.0)])

    @property
    def now(self) -> Floats:
        """The present pose (n + 2,)."""
        shift = self.skeleton.offsets[self._roots[0]] - self._places[0]
        return np.concatenate([self.skeleton.angles, shift])

    def frames_bound(self) -> Floats:
        """Frames (n, 3, 3) of the bones as the skins were bound."""
        bound = self.skeleton.copy()
        self._put(bound, self.bound)
        return bound.world

    def pose(self, pose: Floats) -> None:
        """Take angles and shift (n + 2,); the skin stays until it is moved."""
        self._put(self.skeleton, pose)

    def _put(self, skeleton: Skeleton, pose: Floats) -> None:
        skeleton.offsets[self._roots] = self._places + pose[-2:]
        skeleton.pose(pose[:-2])

    def swung(self, time: float) -> Floats:
        """The pose (n + 2,) in which the figure is at a time (s), moving by itself."""
        by, rate, phase = self.swings.T
        pose = self.start
        pose[:-2] += by * elementwise.sin(2.0 * math.pi * (rate * time + phase))
        turn = 2.0 * math.pi * self.figure.sway_rate * time
        pose[-2] += self.figure.sway[0] * elementary.sin(turn)
        pose[-1] += self.figure.sway[1] * elementary.sin(2.0 * turn)
        return pose

    @property
    def weights(self) -> Floats:
        """Weights (v, n) of all points on all bones."""
        if self._dense is None:
            bound = self.binding
            self._dense = bound.dense() if bound is not None else np.zeros((0, len(self.rest)))
        return self._dense

    # -- the skin -----------------------------------------------------------------------------------

    def move(self, blend: str) -> Floats:
        """Let the skin follow the bones; gives all of its points (v, 2) m."""
        if self.skinner is None:
            return self.skinned
        self.skinned = self.skinner(self.skeleton.world, blend)
        return self.skinned

    def show(self, pose: Floats, blend: str) -> Floats:
        """Pose `shown` so and give the points (v, 2) of its skin, for a picture; good until the next call."""
        self._stand(pose)
        return self.skinned if self._spare is None else self._spare(self.shown.world, blend)

    def show_few(self, pose: Floats, blend: str) -> Floats:
        """As `show`, with the points of the outlines alone, fewer of those that have many."""
        self._stand(pose)
        return self.skinned if self._few is None else self._few(self.shown.world, blend)

    def _stand(self, pose: Floats) -> None:
        """Pose `shown`, from a state whose numbers are finite: `Skeleton.pose` would look at them again."""
        shown = self.shown
        shown.offsets[self._roots] = self._places + pose[-2:]
        shown.angles[:] = pose[:-2]
        shown.update()

    def skin_shown(self, blend: str) -> Floats:
        """The points (v, 2) of the skin of `shown` by another blend, of their own."""
        return self.skinned if self._spare is None else self._spare(self.shown.world, blend).copy()

    def outline(self, skin: int) -> slice:
        """Which of the points are the outline of a skin."""
        return slice(int(self.starts[skin]), int(self.starts[skin + 1]))

    def areas_now(self) -> Floats:
        """Areas (m,) m² of the outlines as they are now."""
        areas = np.empty(len(self.figure.skins))
        if len(areas):
            sum_areas(self.skinned, self.starts, areas)
        return areas

    def _bind(self) -> None:
        skins, view = self.figure.skins, self.figure.view
        spacing = ROUND * (view.top - view.bottom)
        outlines = [self._outline(skin, spacing) for skin in skins]
        self.starts = np.concatenate([[0], np.cumsum([len(points) for points in outlines], dtype=np.int64)])
        self.starts = self.starts.astype(np.int64)
        if not skins:
            self.within = slice(0, 0)
            return
        inside = _inside(skins, outlines)
        parts = [*outlines, inside] if len(inside) else outlines
        binding = self._bound_together(skins, parts)
        self.within = slice(int(self.starts[-1]), len(binding.points))
        self.binding = binding
        self.skinner, self._spare = Skinner(binding), Skinner(binding)
        few, self.few_starts = coarser(self.starts)
        self._few = Skinner(
            Binding(binding.points[few], binding.bones[few], binding.weights[few], self.skeleton.world)
        )
        self.skinned = binding.points.copy()
        sum_areas(self.skinned, self.starts, self.areas)

    def _outline(self, skin: SkinEntry, spacing: float) -> Floats:
        points = np.array(skin.points)
        return rounded(points, spacing) if self.rules.smooth and skin.weights is None else points

    def _bound_together(self, skins: tuple[SkinEntry, ...], parts: list[Floats]) -> Binding:
        """All points in one binding, so that one call moves them."""
        width = min(self.rules.influences, self.skeleton.count)
        bones, weights, points = [], [], []
        for i, part in enumerate(parts):
            bound = self._bound(skins[i] if i < len(skins) else None, part)
            points.append(part)
            bones.append(_padded(bound.bones, width))
            weights.append(_padded(bound.weights, width))
        return Binding(
            np.concatenate(points), np.concatenate(bones), np.concatenate(weights), self.skeleton.world
        )

    def _bound(self, skin: SkinEntry | None, points: Floats) -> Binding:
        rules, skeleton = self.rules, self.skeleton
        if skin is not None and skin.weights is not None:
            return bind_given(skeleton, points, skin.weights, rules.influences)
        if skin is not None and skin.bones:
            own = sorted({bone_named(self.figure, name) for name in skin.bones})
            whole = np.zeros((len(points), skeleton.count))
            distances = distances_to_bones(points, skeleton.bases[own], skeleton.ends[own])
            weigh(distances, rules.threshold, rules.falloff, distances)
            whole[:, own] = distances
            return bind_given(skeleton, points, whole, rules.influences)
        return bind_weights(skeleton, points, rules.threshold, rules.falloff, rules.influences)


def coarser(starts: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Points of outlines for a small figure, fewer of those with many; and where the outlines then start."""
    kept = [
        np.arange(first, last, max(1, 2 * sum(last - first > many for many in COARSE)))
        for first, last in pairwise(starts.tolist())
    ]
    ends = np.cumsum([0, *(len(points) for points in kept)], dtype=np.int64)
    return np.concatenate(kept) if kept else np.zeros(0, dtype=np.int64), ends


def _padded(rows: NDArray, width: int) -> NDArray:
    return np.ascontiguousarray(np.pad(rows, ((0, 0), (0, width - rows.shape[1]))))


def _inside(skins: tuple[SkinEntry, ...], outlines: list[Floats]) -> Floats:
    """Points within the first skin that is bound by distance: it shows weights, and is the body."""
    for skin, outline in zip(skins, outlines, strict=True):
        if not skin.bones and skin.weights is None:
            area = np.empty(1)
            sum_areas(outline, np.array([0, len(outline)]), area)
            spacing = math.sqrt(max(abs(float(area[0])), 1e-12) / (INSIDE * math.sqrt(0.75)))
            return points_inside(outline, spacing)
    return np.zeros((0, 2))


def _skeleton_of(figure: FigureContent, angles: Floats) -> Skeleton:
    names = [bone.name for bone in figure.bones]
    if len(set(names)) != len(names):
        double = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"bones: two are named {double!r}")
    parents = []
    for bone in figure.bones:
        if bone.parent and bone.parent not in names:
            raise ValueError(f"bones: the parent {bone.parent!r} of {bone.name!r} is not there")
        parents.append(names.index(bone.parent) if bone.parent else -1)
    offsets = [
        bone.place
        if bone.place is not None
        else (figure.bones[p].length, 0.0) if p >= 0 else (0.0, 0.0)
        for bone, p in zip(figure.bones, parents, strict=True)
    ]  # fmt: skip
    free = (-math.inf, math.inf)
    limits = np.array([np.radians(b.limits) if b.limits else free for b in figure.bones])
    return Skeleton(
        parents, [bone.length for bone in figure.bones], angles, offsets,
        angles + limits[:, 0], angles + limits[:, 1],
    )  # fmt: skip

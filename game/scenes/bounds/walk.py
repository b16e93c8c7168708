"""Walks through the method: the fit by directions, the tree node by node, the query pair by pair."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.bounds import BoundingTree, Query, build_tree, fit_capsule, fit_obb, nearest
from game.physics.bounds.boxes import write_box
from game.physics.bounds.building import area_on_axis
from game.physics.bounds.capsules import write_capsule
from game.physics.bounds.hull import hull_of
from game.physics.kernels import elementary
from game.scenes.bounds.model import BoundsModel
from game.scenes.bounds.pair import least_area
from game.scenes.bounds.parameters import WALKS
from game.stage import Part

BEAT_ROUNDING = 1e-9  # so that sixty sixtieths of a second make a whole one


class FitWalk(NamedTuple):
    """The search by angle steps on one node: angles (k,) rad and the areas (k,) m² on them; the hull."""

    angles: Floats
    areas: Floats
    hull: Floats
    origin: Floats
    exact: float  # m², area of the exact fit; NaN if it is not known

    def ratio(self, index: int) -> float:
        """Area on a direction over that of the exact fit."""
        return float(self.areas[index]) / self.exact


def fit_row(walk: FitWalk, angle: float, kind: str) -> Floats:
    """The volume (1, 6) on an axis at an angle (rad)."""
    row = np.zeros((1, 6))
    write = write_capsule if kind == "capsule" else write_box
    x, y = walk.origin.tolist()
    write(walk.hull, len(walk.hull), elementary.cos(angle), elementary.sin(angle), x, y, row, 0)
    return row


class Walk(Part):
    """A row of steps that is known from its beginning, so that it goes back as well as on.

    cursor: how many steps have been made; beat: what there is of the next one.
    """

    def __init__(self, model: BoundsModel):
        self.model = model
        self.cursor, self.beat = 0, 0.0
        self._kept: tuple[BoundingTree, tuple[int, float], FitWalk] | None = None

    # -- its steps ----------------------------------------------------------------------------------

    def length(self) -> int:
        """How many steps the walk in play has."""
        pair, walked = self.model.pair, self.model.parameters.walked
        if not pair.trees or walked == "off":
            return 0
        if walked == "fit":
            return _directions(pair.options.kind, self.model.parameters.angle_step)
        if walked == "build":
            return sum(len(tree) for tree in pair.trees)
        return pair.query.row_count if pair.query is not None else 0

    @property
    def under_way(self) -> bool:
        """Whether a query is walked through, and its end has not been reached."""
        return self.model.parameters.walked == "query" and self.cursor < self.length()

    def stand_at(self, cursor: int) -> None:
        """Stand after so many steps of the walk, as far as it has them; it no longer plays."""
        self.cursor = min(max(cursor, 0), self.length())
        self.beat = 0.0
        self.model.parameters.playing = False

    def stay_within(self) -> None:
        """Stand no further than at the end of a walk that may have become shorter."""
        self.cursor = min(self.cursor, self.length())

    def begin(self) -> None:
        """Stand at the start of a walk that was chosen."""
        self.stand_at(0)
        self.model.ask(self.model.coherent)

    def take_next(self) -> None:
        """Choose the walk after this one, or none after the last."""
        parameters = self.model.parameters
        parameters.walked = WALKS[(WALKS.index(parameters.walked) + 1) % len(WALKS)]
        self.begin()

    def start_if_ended(self) -> None:
        """Where there is nothing left to play, stand at the start again."""
        if self.cursor >= self.length():
            self.cursor = 0

    def play(self, dt: float) -> None:
        """Go on at the chosen pace, if it plays; at its end it stands."""
        parameters = self.model.parameters
        if not parameters.playing:
            return
        self.beat += parameters.pace * dt
        made = int(self.beat + BEAT_ROUNDING)
        self.beat -= made
        self.cursor += made
        if self.cursor >= self.length():
            self.stand_at(self.cursor)

    # -- what a step is of --------------------------------------------------------------------------

    def building_at(self) -> tuple[int, int]:
        """The tree and the node that are built in the present step; the root of A before the first."""
        trees = self.model.pair.trees
        left = max(self.cursor - 1, 0)
        for i, tree in enumerate(trees):
            if left < len(tree):
                return i, left
            left -= len(tree)
        return len(trees) - 1, len(trees[-1]) - 1

    def fit(self) -> FitWalk:
        """The search on the chosen node, all of it; kept until another one is asked for."""
        parameters = self.model.parameters
        tree = self.model.pair.trees[self.model.chosen]
        node = min(int(parameters.node), len(tree) - 1)
        key = (node, parameters.angle_step)
        if self._kept is None or self._kept[0] is not tree or self._kept[1] != key:
            self._kept = (tree, key, _fit_walk(tree, node, parameters.angle_step))
        return self._kept[2]


def _directions(kind: str, step_degrees: float) -> int:
    """How many directions are tried for a volume of a kind."""
    if kind == "aabb":
        return 1
    range_degrees = 90.0 if kind == "obb" else 180.0
    return max(1, math.ceil(range_degrees / step_degrees - 1e-9))


def _fit_walk(tree: BoundingTree, node: int, step_degrees: float) -> FitWalk:
    """The search by angle steps round the segments of a node."""
    points = tree.ends[tree.segments_of(node)].reshape(-1, 2)
    hull, origin = hull_of(points)
    angles = np.radians(step_degrees * np.arange(_directions(tree.kind, step_degrees)))
    kind = tree.kind_number if tree.kind != "aabb" else 0
    areas = np.array(
        [area_on_axis(kind, hull, len(hull), elementary.cos(a), elementary.sin(a)) for a in angles.tolist()]
    )
    return FitWalk(angles, areas, hull, origin, least_area(tree.kind, points))


def warm_up(part: str) -> None:
    """Compile what a part of the scene needs."""
    line = [(0.0, 0.0), (1.0, 0.5), (2.0, 0.0), (2.5, 1.0)]
    tree = build_tree(line, "obb", 1)
    if part == "build":
        hull, _ = hull_of(tree.points)
        area_on_axis(0, hull, len(hull), 1.0, 0.0)
        fit_obb(line), fit_capsule(line)
    elif part == "query":
        query = Query(tree, tree)
        query.run((0.5, 0.0))
        query.marks()
    else:
        nearest(tree, tree, (5.0, 0.0))

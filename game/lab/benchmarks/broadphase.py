"""Broad phases on boxes that move by 2 % of their size, beside trees and a physics engine."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from game.arrays import Floats, Longs
from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.physics.broadphase import BroadPhase, HierarchicalGrid, SweepAndPrune, UniformGrid
from game.physics.broadphase.workloads import make_boxes

FRAMES = 8
OVERLAPS = 1.5  # of a box, mean


class Workload:
    """Frames of moving boxes: 2 % of the smallest box in a step, there and back."""

    def __init__(self, kind: str, count: int):
        boxes = make_boxes(kind, count, np.random.default_rng(1), fill=OVERLAPS / 4.0, speed=1.0)
        self.size = 2.0 * float(boxes.half_sizes.min())
        step = 0.02 * self.size * boxes.velocities
        self.frames = [(boxes.lowers + i * step, boxes.uppers + i * step) for i in range(FRAMES)]
        self.ids = np.arange(count)
        self._next = 0

    def frame(self) -> tuple[Floats, Floats]:
        """Lower and upper corners of the next frame."""
        self._next = (self._next + 1) % (2 * FRAMES - 2)
        return self.frames[self._next if self._next < FRAMES else 2 * FRAMES - 2 - self._next]


PHASES: dict[str, Callable[[float], BroadPhase]] = {
    "grid": lambda size: UniformGrid((0.0, 0.0), (1.0, 1.0), 1.1 * size),
    "hierarchical": lambda size: HierarchicalGrid(),
    "sweep": lambda size: SweepAndPrune(),
}


def stepper(phase: BroadPhase, workload: Workload) -> Callable[[], Longs]:
    """A call that updates all boxes and lists all pairs."""
    phase.add_boxes(*workload.frames[0])

    def step() -> Longs:
        phase.update_boxes(workload.ids, *workload.frame())
        return phase.pairs()

    step()
    return step


def _ours(name: str, kind: str, count: int) -> Call:
    workload = Workload(kind, count)
    return stepper(PHASES[name](workload.size), workload)


def kd_tree(kind: str, count: int) -> Call:
    """scipy's tree of centres, rebuilt; right for boxes of one size alone."""
    from scipy.spatial import cKDTree

    workload = Workload(kind, count)

    def step() -> int:
        lowers, uppers = workload.frame()
        tree = cKDTree(0.5 * (lowers + uppers))
        return len(tree.query_pairs(workload.size, p=np.inf, output_type="ndarray"))

    return step


def str_tree(kind: str, count: int) -> Call:
    """shapely's tree of boxes, rebuilt."""
    import shapely

    workload = Workload(kind, count)

    def step() -> int:
        lowers, uppers = workload.frame()
        boxes = shapely.box(lowers[:, 0], lowers[:, 1], uppers[:, 0], uppers[:, 1])
        found = shapely.STRtree(boxes).query(boxes)
        return int((found[0] < found[1]).sum())

    return step


def pymunk_step(kind: str, count: int) -> Call:
    """A step of pymunk with boxes that may pass through each other; the call returns their number."""
    import pymunk

    workload = Workload(kind, count)
    space = pymunk.Space()
    for low, high in zip(*(corners.tolist() for corners in workload.frames[0]), strict=True):
        body = pymunk.Body(1.0, 1.0)
        body.position = 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])
        space.add(body, pymunk.Poly.create_box(body, (high[0] - low[0], high[1] - low[1])))
    if hasattr(space, "on_collision"):
        space.on_collision(begin=lambda arbiter, space, data: setattr(arbiter, "process_collision", False))

    def step() -> int:
        space.step(1e-9)
        return len(space.shapes)

    return step


def _peers(kind: str, count: int) -> tuple[Peer, ...]:
    peers = [Peer("shapely STRtree", partial(str_tree, kind, count))]
    if kind == "equal":
        peers.insert(0, Peer("scipy cKDTree", partial(kd_tree, kind, count)))
    if count <= 10_000:
        peers.append(Peer("pymunk step", partial(pymunk_step, kind, count)))
    return tuple(peers)


SCENARIOS = tuple(
    Scenario(
        f"{name}-{kind}-{count}",
        f"{title}, {count:,} boxes{', one in a hundred 20 times larger' if kind == 'heavy-tail' else ''}",
        "step",
        partial(_ours, name, kind, count),
        peers=_peers(kind, count) if name != "sweep" else (),
    )
    for count in (1_000, 10_000, 100_000)
    for name, title, kind in (
        ("grid", "Uniform grid", "equal"),
        ("hierarchical", "Hierarchical grids", "heavy-tail"),
        ("sweep", "Sweep and prune", "equal"),
    )
)

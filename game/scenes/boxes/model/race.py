"""Boxes paired up by all broad phases, and their pairs kept by both managers, each timed."""

from __future__ import annotations

import math

import numpy as np

from game.physics.broadphase import (
    BroadPhase,
    BspTree,
    CoveringGrid,
    HashedPairs,
    HierarchicalGrid,
    KineticSweep,
    MatrixPairs,
    NaiveBroadPhase,
    PairEvents,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.broadphase.bsp.tree import TreeWork
from game.physics.broadphase.workloads import make_boxes
from game.physics.effects import EffectSet
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.base import BoxesModel
from game.scenes.boxes.model.compared import MOST_NAIVE
from game.scenes.boxes.model.crossover import COUNTS, CostCurves, cost_of_a_step, typical_size
from game.scenes.boxes.model.managers import matrix_for
from game.scenes.boxes.parameters import CONTESTANTS, RaceParameters

MOST_CELLS = 1 << 22
NO_WORK = TreeWork(0, 0, 0)


class RaceModel(BoxesModel):
    """The model of the race.

    phases: the broad phases that take part, by name; agree: whether each finds the pairs of the first;
    managers: both pair managers, None for a matrix that would be too large; swaps, tree_work: of the last
    step. curves: what steps have cost at other numbers of boxes.
    """

    parameters: RaceParameters
    shaping = ("cell", "slabs", *CONTESTANTS)

    def __init__(self, parameters: RaceParameters, active: EffectSet, seed: int):
        super().__init__(parameters, active, seed)
        self.curves = CostCurves()

    def make_structures(self) -> None:
        cell = max(self.parameters.cell * self.size, math.sqrt(WIDTH * HEIGHT / MOST_CELLS))
        slabs = int(self.parameters.slabs)
        many = len(self.boxes) > MOST_NAIVE
        chosen = [name for name in self.parameters.chosen() if name != "naive" or not many]
        chosen = chosen or ["hierarchical"]  # one must stay, to know the pairs
        self.phases = {name: _phase(name, min(cell, WIDTH), slabs) for name in chosen}
        for name in CONTESTANTS:
            if name not in self.phases:
                self.watch.forget(name)
        rows = len(self.boxes.alive)
        self.managers: dict[str, HashedPairs | MatrixPairs | None] = {
            "hash": HashedPairs(), "matrix": matrix_for(rows)
        }  # fmt: skip
        self.agree = dict.fromkeys(self.phases, True)
        self.answers: list[PairEvents] = []  # of the managers, in the last step
        self.swaps = 0
        self.tree_work = NO_WORK

    @property
    def kinetic(self) -> KineticSweep | None:
        """The kinetic sweep, if it takes part."""
        phase = self.phases.get("kinetic")
        return phase if isinstance(phase, KineticSweep) else None

    def structures(self) -> tuple[BroadPhase, ...]:
        return tuple(self.phases.values())

    def pair_up(self) -> None:
        first = None
        for name, phase in self.phases.items():
            before = phase.swaps if isinstance(phase, SweepAndPrune) else 0
            worked = phase.work if isinstance(phase, BspTree) else NO_WORK
            with self.watch.time(name):
                self.update(phase)
                pairs = phase.pairs()
            if isinstance(phase, SweepAndPrune):
                self.swaps = phase.swaps - before
                phase.manager.take_events()
            if isinstance(phase, BspTree):
                self.tree_work = TreeWork(*(b - a for a, b in zip(worked, phase.work, strict=True)))
            if first is None:
                first = self.pairs = pairs
            self.agree[name] = bool(np.array_equal(pairs, first))
            self.curves.note(name, len(self.boxes), self.watch.median(name))
        self._keep_pairs()

    def _keep_pairs(self) -> None:
        """Both managers take over the pairs."""
        rows, matrix = len(self.boxes.alive), self.managers["matrix"]
        if matrix is not None and matrix.greatest < rows - 1:
            self.managers["matrix"] = matrix_for(rows)
        self.answers = []
        for name, manager in self.managers.items():
            if manager is None:
                self.watch.forget(name)
                continue
            with self.watch.time(name):
                manager.set_pairs(self.pairs)
                self.answers.append(manager.take_events())
            self.begun, self.ended = (len(events) for events in self.answers[-1])

    def managers_agree(self) -> bool | None:
        """Whether both managers gave the same events in the last step; None if there was but one."""
        if len(self.answers) < 2:
            return None
        return all(np.array_equal(*events) for events in zip(*self.answers, strict=True))

    def advance(self, dt: float) -> None:
        if self.parameters.workload == "teleport":
            self._leap_all()
        super().advance(dt)

    def _leap_all(self) -> None:
        """Every box is somewhere else."""
        boxes = self.boxes
        random = np.random.default_rng((self.seed, self.steps, 4))
        sizes = boxes.uppers - boxes.lowers
        movable = np.isfinite(sizes).all(axis=1) & (boxes.alive == 1)
        places = random.random(sizes.shape) * np.maximum(np.array([WIDTH, HEIGHT]) - sizes, 0.0)
        boxes.lowers[movable] = places[movable]
        boxes.uppers[movable] = (places + sizes)[movable]

    def find_crossover(self) -> None:
        """Measure the contestants at eight to some two thousand boxes, made as those of the scene are."""
        chosen, dt = self.parameters, self.parameters.step_length
        self.curves.swept = {}
        for count in COUNTS:
            boxes = make_boxes(
                chosen.workload, count, np.random.default_rng((self.seed, count)), (WIDTH, HEIGHT),
                chosen.fill, chosen.speed, *chosen.large(),
            )  # fmt: skip
            cell = min(chosen.cell * typical_size(boxes), WIDTH)
            for name in CONTESTANTS:
                seconds = cost_of_a_step(_phase(name, cell, int(chosen.slabs)), boxes, dt)
                self.curves.note_swept(name, count, seconds)

    def change_parameter(self, name: str) -> None:
        if name not in ("count", "lines", *CONTESTANTS):
            self.curves.clear()  # what was measured was another workload
        super().change_parameter(name)
        if name in self.shaping and not self.parameters.chosen():
            self.messages.say("All are left out. Hierarchical grids stay: one must know the pairs.")


def _phase(name: str, cell: float, slabs: int) -> BroadPhase:
    """A contestant, empty; ``cell``: m, of uniform grids; ``slabs``: sides of the kinetic sweep's bounds."""
    if name == "naive":
        return NaiveBroadPhase()
    if name == "sweep":
        return SweepAndPrune()
    if name == "bsp":
        return BspTree()
    if name == "kinetic":
        return KineticSweep(slabs)
    if name == "hierarchical":
        return HierarchicalGrid()
    return (UniformGrid if name == "uniform" else CoveringGrid)((0.0, 0.0), (WIDTH, HEIGHT), cell)

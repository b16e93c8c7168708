"""All broad phases and both pair managers on one workload, in a table with live bars."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.lab.studies.broadphase.count import count_study
from game.physics.broadphase import (
    BroadPhase,
    CoveringGrid,
    HashedPairs,
    HierarchicalGrid,
    MatrixPairs,
    NaiveBroadPhase,
    PairEvents,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.broadphase.workloads import WORKLOADS
from game.scenes.boxes import BROAD_PHASE_RACE, view
from game.scenes.boxes.base import RATIO, SHARE, BoxesScene
from game.scenes.boxes.compared import MOST_IN_MATRIX, MOST_NAIVE
from game.scenes.boxes.figure import draw_costs
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.race_table import TABLE_RIGHT, Contestant, RaceTable, short
from game.stage import Choice, Equation, Frame, Param, Readout, Strip, Toggle

MOST_CELLS = 1 << 22

PHASES = (
    Contestant("naive", "Naive", "vermilion", "tests"),
    Contestant("uniform", "Uniform grid", "chalk", "tests"),
    Contestant("covering", "Grid, all cells covered", "violet", "tests"),
    Contestant("hierarchical", "Hierarchical grids", "green", "tests"),
    Contestant("sweep", "Sweep and prune", "pink", "swaps"),
)
MANAGERS = (
    Contestant("matrix", "Full matrix", "chalk", "begun"),
    Contestant("hash", "Hash table", "green", "begun"),
)


class BroadPhaseRace(BoxesScene):
    """Every broad phase is given the same boxes in every step, tells all pairs, and is timed: update and
    all pairs together. The bars are logarithmic, from a microsecond to a second. Beside them stand the work
    that was done, box tests or swaps, the memory, and whether the pairs are those of the others.

    Below, both pair managers take over the pairs and tell which began and which ended. Choose the workload:
    equal boxes, two sizes, a heavy tail of sizes, heaps, all on one line, a lattice full of ties, or boxes
    that all leap in every step. No method wins them all. The naive way is left out above 4000 boxes, the full
    matrix above 4096.
    """

    name, task, title = BROAD_PHASE_RACE.names
    study = count_study
    groups = ("Workload", "Boxes", "Contestants", "Step", "Disturbance", "Shown")

    workload = Choice(
        "equal",
        WORKLOADS,
        labels=(
            "Equal sizes",
            "Two sizes",
            "Heavy-tailed sizes",
            "Clustered",
            "On one line",
            "Lattice",
            "All leap each step",
        ),
        group="Workload",
        rebuild=True,
        help="how boxes are made, and whether they leap",
    )
    count = Param(
        400, 1, 100_000, whole=True, log=True, group="Workload", label="Number",
        help="boxes are added or removed while the others go on; their density stays",
    )  # fmt: skip
    fill = Param(
        0.1, 0.01, 2.0, log=True, group="Workload", label="Density", rebuild=True,
        help="area of equal boxes over that of the world; a box overlaps four times as many",
    )  # fmt: skip
    ratio = Param(
        RATIO, 1.0, 1000.0, log=True, group="Boxes", label="Large to small", rebuild=True,
        help="size of the largest boxes of the heavy tail over that of the small ones",
    )  # fmt: skip
    share = Param(
        SHARE,
        0.0,
        0.5,
        group="Boxes",
        label="Share of large ones",
        rebuild=True,
        help="where there are two sizes",
    )
    cell = Param(
        1.25,
        0.25,
        32.0,
        log=True,
        group="Boxes",
        label="Cell size",
        help="of the uniform grid, over that of boxes",
    )
    naive = Toggle(True, group="Contestants", label="Naive")
    uniform = Toggle(True, group="Contestants", label="Uniform grid")
    covering = Toggle(True, group="Contestants", label="Grid, all cells covered")
    hierarchical = Toggle(True, group="Contestants", label="Hierarchical grids")
    sweep = Toggle(True, group="Contestants", label="Sweep and prune")

    parts = (
        ("naive pairs", NaiveBroadPhase),
        ("uniform grid", lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
        ("covered cells", lambda: CoveringGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
        ("hierarchical grids", HierarchicalGrid),
        ("sweep and prune", SweepAndPrune),
    )
    strips = (
        Strip("Update and all pairs", "s", ("uniform", "hierarchical", "sweep")),
        Strip("Pair managers", "s", ("matrix", "hash")),
        Strip("Pairs", "", ("pairs",)),
    )
    figure = staticmethod(draw_costs)
    equations = (
        Equation("Naive", r"\frac{n(n-1)}{2}", "tests"),
        Equation("Grids", r"O(n)", "tests, boxes alike"),
        Equation(
            "Sweep and prune",
            r"2 n^2 \frac{8}{\pi^2} v \Delta t \left(\frac{1}{W} + \frac{1}{H}\right)",
            "swaps, mean",
        ),
        Equation("Full matrix", r"\frac{n(n-1)}{2}", "places of memory"),
    )
    try_this = (
        "Begin with 30 boxes: the naive way keeps up. Draw the number up and watch it fall behind.",
        "Choose the heavy tail: the uniform grid pays for its small cells, the hierarchy does not.",
        "Let all leap: sweep and prune sorts anew in every step. On one line it does so only at first.",
        "Switch off all but the uniform grid and draw the number to 100 000.",
    )

    # -- structures ---------------------------------------------------------------------------------

    def make_structures(self) -> None:
        cell = max(self.cell * self.size, math.sqrt(WIDTH * HEIGHT / MOST_CELLS))
        few = len(self.ids) <= MOST_NAIVE
        self.phases: dict[str, BroadPhase] = {}
        if self.naive and few:
            self.phases["naive"] = NaiveBroadPhase()
        if self.uniform:
            self.phases["uniform"] = UniformGrid((0.0, 0.0), (WIDTH, HEIGHT), min(cell, WIDTH))
        if self.covering:
            self.phases["covering"] = CoveringGrid((0.0, 0.0), (WIDTH, HEIGHT), min(cell, WIDTH))
        if self.hierarchical:
            self.phases["hierarchical"] = HierarchicalGrid()
        if self.sweep:
            self.phases["sweep"] = SweepAndPrune()
        if not self.phases:  # one must stay, to know the pairs
            self.phases["hierarchical"] = HierarchicalGrid()
        for contestant in PHASES:
            if contestant.name not in self.phases:
                self.watch.forget(contestant.name)
        self.managers = {"hash": HashedPairs(), "matrix": self._matrix()}
        self.agree = dict.fromkeys(self.phases, True)
        self.answers: list[PairEvents] = []  # of the managers, in the last step
        self.swaps = 0

    def _matrix(self) -> MatrixPairs | None:
        rows = len(self.alive)
        return MatrixPairs(max(1 << max(rows - 1, 1).bit_length(), 256)) if rows <= MOST_IN_MATRIX else None

    def structures(self) -> tuple[BroadPhase, ...]:
        return tuple(self.phases.values())

    def why_idle(self, name: str) -> str:
        if name == "workload":  # even boxes of a level may leap
            return ""
        if name == "naive" and len(self.ids) > MOST_NAIVE:
            return f"Above {view.grouped(MOST_NAIVE)} boxes the naive way is left out."
        if name == "cell" and not (self.uniform or self.covering):
            return "Both uniform grids are left out."
        return super().why_idle(name)

    def pair_up(self) -> None:
        first = None
        for name, phase in self.phases.items():
            before = phase.swaps if isinstance(phase, SweepAndPrune) else 0
            with self.watch.time(name):
                self.update(phase)
                pairs = phase.pairs()
            if isinstance(phase, SweepAndPrune):
                self.swaps = phase.swaps - before
                phase.manager.take_events()
            if first is None:
                first = self.pairs = pairs
            self.agree[name] = bool(np.array_equal(pairs, first))
        matrix = self.managers["matrix"]
        if matrix is not None and matrix.greatest < len(self.alive) - 1:
            self.managers["matrix"] = self._matrix()
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
        """Whether both managers told the same events in the last step; None if there was but one."""
        if len(self.answers) < 2:
            return None
        return all(np.array_equal(*events) for events in zip(*self.answers, strict=True))

    def advance(self, dt: float) -> None:
        if self.workload == "teleport":
            self._leap_all()
        super().advance(dt)

    def _leap_all(self) -> None:
        """Every box is somewhere else."""
        random = np.random.default_rng((self.seed, self.steps, 4))
        sizes = self.uppers - self.lowers
        movable = np.isfinite(sizes).all(axis=1) & (self.alive == 1)
        places = random.random(sizes.shape) * np.maximum(np.array([WIDTH, HEIGHT]) - sizes, 0.0)
        self.lowers[movable] = places[movable]
        self.uppers[movable] = (places + sizes)[movable]

    def parameter_changed(self, name: str) -> None:
        super().parameter_changed(name)
        if name in ("cell", *(contestant.name for contestant in PHASES)):
            counts = self.begun, self.ended
            self.begin_anew()
            self.begun, self.ended = counts
            if not any(self.values[contestant.name] for contestant in PHASES):
                self.told.append("All are left out. Hierarchical grids stay: one must know the pairs.")

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return Frame(-0.1, -0.1, TABLE_RIGHT + 0.1, 12.9)

    def readouts(self) -> tuple[Readout, ...]:
        names = [contestant.name for contestant in (*PHASES, *MANAGERS)]
        return (
            Readout("boxes", len(self.ids)),
            Readout("pairs", len(self.pairs)),
            Readout("begun", self.begun),
            Readout("ended", self.ended),
            *(Readout(name, self.watch.median(name), "s") for name in names),
            Readout("swaps", self.swaps),
            Readout("answers differ", float(sum(not same for same in self.agree.values()))),
        )

    def legend(self) -> tuple[tuple[str, str, str], ...]:
        return (
            ("box:vermilion", "overlapping", view.grouped(self.overlapping())),
            ("box:ghost", "boxes", view.grouped(len(self.ids))),
            ("line:vermilion", "pairs", view.grouped(len(self.pairs))),
        )

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw_ground(canvas)
        view.draw_boxes(self, canvas, alpha)
        table = RaceTable(canvas)
        table.head("Update and all pairs")
        fastest = min((self.watch.median(name) for name in self.phases), default=math.nan)
        for contestant in PHASES:
            phase = self.phases.get(contestant.name)
            if phase is None:
                table.row(contestant, math.nan, "left out", "", None, False)
                continue
            seconds = self.watch.median(contestant.name)
            work = self.swaps if isinstance(phase, SweepAndPrune) else phase.tests
            table.row(
                contestant, seconds, f"{short(work)} {contestant.work}", view.bytes_text(phase.memory()),
                self.agree[contestant.name] if len(self.phases) > 1 else None, seconds == fastest,
            )  # fmt: skip
        table.space(20)
        table.head("Pairs begun and ended")
        times = [self.watch.median(contestant.name) for contestant in MANAGERS]
        fastest = min((time for time in times if math.isfinite(time)), default=math.nan)
        for contestant, seconds in zip(MANAGERS, times, strict=True):
            manager = self.managers[contestant.name]
            if manager is None:
                table.row(contestant, math.nan, "left out", "", None, False)
                continue
            memory = view.bytes_text(manager.memory())
            table.row(
                contestant,
                seconds,
                f"{view.grouped(self.begun)} begun, {view.grouped(self.ended)} ended",
                memory,
                self.managers_agree(),
                seconds == fastest,
            )
        table.scale()

"""All broad phases and both pair managers on one workload, in a table with live bars."""

from __future__ import annotations

from game.lab.studies.broadphase.count import METHOD_COLORS, count_study
from game.physics.broadphase import (
    BspTree,
    CoveringGrid,
    HierarchicalGrid,
    KineticSweep,
    NaiveBroadPhase,
    SweepAndPrune,
    UniformGrid,
)
from game.scenes.boxes import BROAD_PHASE_RACE
from game.scenes.boxes.base import BoxesScene
from game.scenes.boxes.figure import draw_costs
from game.scenes.boxes.model.compared import MOST_NAIVE
from game.scenes.boxes.model.race import RaceModel
from game.scenes.boxes.numbers import grouped
from game.scenes.boxes.parameters import RaceParameters
from game.scenes.boxes.readouts import race_readouts
from game.scenes.boxes.view.race import RaceView
from game.stage import Action, Equation, Hint, SceneAction, StageEvent, Strip

IN_STRIP = ("uniform", "hierarchical", "sweep", "bsp", "kinetic")


class BroadPhaseRace(BoxesScene):
    """Every broad phase is given the same boxes in every step, tells all pairs, and is timed: update and all
    pairs together. The bars are logarithmic, from a microsecond to a second. Beside them stand how many times
    the fastest's that is, and the work that was done, box tests or swaps. Then come the memory, and whether
    the pairs are those of the others. The plot keeps what a step cost at each number of boxes that was tried.
    X measures them all from 8 to 2048 boxes and says from where on the naive method falls behind.

    Below, both pair managers take over the pairs and tell which began and which ended. Choose the workload:
    equal boxes, two sizes, a heavy tail of sizes, or heaps. Also all on one line, a lattice full of ties, or
    boxes that all leap in every step. The kinetic sweep bounds what a box will cover for some steps. It looks
    at it again when that is used up or the box did not go on as it did. No method wins them all. The naive
    method is left out above 4000 boxes, the full matrix above 4096.
    """

    name, task, title = BROAD_PHASE_RACE.names
    study = count_study
    groups = ("Workload", "Boxes", "Contestants", "Step", "Disturbance", "Shown")

    parameters_type = RaceParameters
    parameters: RaceParameters
    model_type = RaceModel
    model: RaceModel
    view_type = RaceView

    phases = (
        ("naive pairs", NaiveBroadPhase),
        ("uniform grid", lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
        ("covered cells", lambda: CoveringGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
        ("hierarchical grids", HierarchicalGrid),
        ("sweep and prune", SweepAndPrune),
        ("BSP tree", BspTree),
        ("kinetic sweep", KineticSweep),
    )
    strips = (
        Strip(
            "Update and all pairs",
            "s",
            IN_STRIP,
            colors=tuple(METHOD_COLORS[name] for name in IN_STRIP),
        ),
        Strip("Pair managers", "s", ("matrix", "hash")),
        Strip("Pairs", "", ("pairs",)),
    )
    hints = (*BoxesScene.hints, Hint(("X",), "find the crossover"))
    actions = (*BoxesScene.actions, SceneAction("crossover", "find the crossover", "x"))
    told = BoxesScene.told._replace(readouts=race_readouts)
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
        "Begin with 30 boxes: the naive method keeps up. Draw the number up and watch it fall behind.",
        "Choose the heavy tail: the uniform grid pays for its small cells, the hierarchy does not.",
        "Let all leap, or tremble on one line: sweep and prune sorts again in every step.",
        "Show the bounds of the kinetic sweep and give boxes 4, 8, 16 sides: fewer false pairs.",
        "Switch off all but the uniform grid and draw the number to 100 000.",
    )

    def action(self, name: str) -> None:
        if name == "crossover":
            self.model.find_crossover()
        else:
            super().action(name)

    def takes_long(self, event: StageEvent | None) -> bool:
        return event == Action("crossover") or super().takes_long(event)

    def why_idle(self, name: str) -> str:
        if name == "workload":  # those of a level may leap, too
            return ""
        if name == "naive" and len(self.model.boxes) > MOST_NAIVE:
            return f"Above {grouped(MOST_NAIVE)} boxes the naive method is left out."
        if name == "cell" and not (self.parameters.uniform or self.parameters.covering):
            return "Both uniform grids are left out."
        if name in ("slabs", "bounds") and not self.parameters.kinetic:
            return "The kinetic sweep is left out."
        return super().why_idle(name)

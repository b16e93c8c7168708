"""All solvers on one set-up, side by side."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from game.lab.studies.stacks import race_study
from game.levels import Level
from game.naming import titled
from game.physics.solids import SOLVERS
from game.physics.solids.effects import USUAL
from game.scenes.solids import RACE
from game.scenes.solids.race.figure import draw_loop_of_impulses
from game.scenes.solids.race.model import RaceModel
from game.scenes.solids.race.parameters import RaceParameters, field_of, short_of
from game.scenes.solids.race.view import RaceView, length_words
from game.stage import (
    Equation,
    Frame,
    Hint,
    Readout,
    SceneAction,
    SetParameter,
    Strip,
    Table,
    WarmUp,
)
from game.stage.messages import Messages
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import ModelScene

NAMES = {name: short_of(name) for name in SOLVERS}
SWITCHES = frozenset(field_of(name) for name in SOLVERS)


def _series(what: str) -> tuple[str, ...]:
    return tuple(f"{words}: {what}" for words in NAMES.values())


class SolverRace(ModelScene):
    """Bodies that press on each other make one large problem: all impulses at once, none of them a
    pull. No two ways to solve it agree, and all are given the same bodies here, the same step, as many
    substeps and sweeps.

    A stack sinks by the softness of its contacts and leans by what errs to one side. A chain gapes where its
    joints give way to a load. An arch at its limit stands or falls.

    In the equations: M masses, J rows of contacts and joints, λ impulses, v velocities, f forces, h substep.
    """

    name, task, title = RACE.names
    parameters_type = RaceParameters
    parameters: RaceParameters
    model: RaceModel
    effects = USUAL
    study = race_study
    level_parameter = "setup"
    may_be_infinite = frozenset(f"worlds.{k}.world.joints" for k in range(20))

    hints = (Hint(("1", "…", "7"), "set-ups"),)
    actions = tuple(
        SceneAction(name, words, str(k + 1))
        for k, (name, words) in enumerate((
            ("stack", "column"), ("pyramid", "pyramid"), ("heavy", "heavy on light"), ("cards", "cards"),
            ("chain", "chain"), ("arch", "arch"), ("ratios", "mass ratios"),
        ))
    )  # fmt: skip
    strips = (
        Strip("Sinks", "m", _series("sinks"), sometimes=_series("sinks")),
        Strip("Overlap or gap", "m", _series("off"), sometimes=_series("off")),
    )
    figure = staticmethod(draw_loop_of_impulses)
    equations = (
        Equation("Motion", r"\v{M} (\v{v} - \v{v}_0) = h \v{f} + \v{J}^T \v{\lambda}"),
        Equation("Contacts", r"\v{J} \v{v} \ge 0,  \v{\lambda} \ge 0,  \v{\lambda} \cdot \v{J} \v{v} = 0"),
        Equation(
            "One row at a time",
            r"\Delta\lambda_i = -\frac{(\v{J} \v{v})_i}{(\v{J} \v{M}^{-1} \v{J}^T)_{ii}}",
            "Catto 2005",
        ),
        Equation("Error after n sweeps of a stack of N", r"(1 - \frac{\pi^2}{2 N^2})^n", "Gauss and Seidel"),
    )  # fmt: skip
    try_this = (
        "Choose 1000 kg on ten boxes, and see who crushes them.",
        "Give all of them 1 substep and 16 sweeps, then 16 substeps and 1 sweep: the work is the same.",
        "Choose the arch: it is 3 % thicker than the least that stands.",
        "Open What accuracy costs: error against time for each.",
    )

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """Each solver, then what paints."""
        scene = cls()
        rows = [
            WarmUp(NAMES[name], partial(model.advance, cls.dt))
            for name, model in zip(scene.model.solvers, scene.model.worlds, strict=True)
        ]
        return (*rows, WarmUp("polygons", warm_up_painter))

    def build(self, level: Level | None) -> None:
        self.model = RaceModel(self.parameters, self.active)
        self.view = RaceView(self.model)
        self.said = Messages()

    def parameter_changed(self, name: str) -> None:
        self.model.change()

    def why_idle(self, name: str) -> str:
        """The quality decides the substeps unless it is one's own."""
        if name == "substeps" and self.parameters.tier != "own":
            return "The quality says how many there are; choose Own."
        return ""

    def takes_long(self, event: Any) -> bool:
        """Another solver is compiled first."""
        return isinstance(event, SetParameter) and event.name in SWITCHES

    def check(self) -> None:
        """What must always hold in every world."""
        for model in self.model.worlds:
            model.world.check()

    def advance(self, dt: float) -> None:
        for name in self.model.advance(dt):
            self.said.say(f"{titled(name)} could not go on.")

    def action(self, name: str) -> None:
        self.parameters.setup = name
        self.build(None)

    def readouts(self) -> list[Readout]:
        rows = []
        for k, name in enumerate(self.model.solvers):
            result, words = self.model.result(k), NAMES[name]
            rows += [
                Readout(f"{words}: sinks", result.sinks, "m"),
                Readout(f"{words}: leans", result.leans, "m"),
                Readout(f"{words}: off", max(result.overlap, result.gap), "m"),
                Readout(f"{words}: energy", result.energy, "J"),
                Readout(f"{words}: step", result.step, "s"),
            ]
        return rows

    def panel_table(self) -> Table:
        """All numbers."""
        rows = []
        for k, name in enumerate(self.model.solvers):
            result = self.model.result(k)
            off = max(result.overlap, result.gap)
            cells = [length_words(value) for value in (result.sinks, result.leans, off)]
            rows.append((NAMES[name], *cells))
        return Table(
            "Measured", ("solver", "sinks", "leans", "off"), tuple(rows), tuple(range(len(rows))),
            len(SOLVERS),
            "off: the deepest overlap or the widest gap of a joint",
        )  # fmt: skip

    def frame(self) -> Frame:
        return self.view.frame()

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, self.previous, alpha)

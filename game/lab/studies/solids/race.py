"""Solver against solver: error and time of all of them on eight laws, by substeps and by sweeps."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, NamedTuple

from game.lab.ranges import counts_between
from game.lab.studies.solids.laws import FRAME, LAWS, Law
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.solids import SolidSettings

MOST_TURNS = 64  # of a frame
REFEREE_POINTS = 60


class Use(NamedTuple):
    """A solver, and how n turns a frame are divided: sweeps in each substep, 0: all n in one substep."""

    solver: str
    label: str
    sweeps: int = 1

    def settings(self, turns: int) -> dict[str, Any]:
        """Substeps and iterations."""
        if self.sweeps == 0:
            return {"solver": self.solver, "substeps": 1, "iterations": turns}
        return {"solver": self.solver, "substeps": max(1, turns // self.sweeps), "iterations": self.sweeps}


USES = {
    "soft-step": Use("soft-step", "soft step, n substeps"),
    "impulses-sweeps": Use("sequential-impulses", "sequential impulses, n sweeps", 0),
    "impulses-substeps": Use("sequential-impulses", "sequential impulses, n substeps"),
    "xpbd": Use("xpbd", "XPBD, n substeps"),
    "avbd": Use("augmented-vertex-block-descent", "AVBD, n sweeps", 0),
    "compliant": Use("compliant-lagrangian", "compliant Lagrangian, n/4 substeps of 4 sweeps", 4),
    "shock": Use("shock-propagation", "shock propagation, n substeps"),
    "complementarity": Use("complementarity", "complementarity, n substeps"),
}


class LawTrial:
    """A law on settings, from its start each time."""

    def __init__(self, law: Law, settings: SolidSettings, turns: int) -> None:
        self.simulated_s = law.seconds
        self.law, self.settings, self.turns = law, settings, turns
        self.reset()

    def reset(self) -> None:
        """Nothing measured yet."""
        self.error, self.failure = math.nan, ""

    def run(self) -> None:
        """Make the set-up and step it; what a solver refuses or loses is its failure."""
        try:
            self.error = self.law.measure(self.settings)
        except ValueError:
            self.failure = "refused"
        except ArithmeticError:
            self.failure = "diverged"

    def outcome(self) -> Outcome:
        """Error of the last run, and sweeps made."""
        failure = self.failure or ("" if math.isfinite(self.error) and self.error < 1e3 else "diverged")
        return Outcome(self.error, round(self.turns * self.law.seconds / FRAME), failure)


def solid_settings(setting: Setting) -> tuple[SolidSettings, int]:
    """Settings of a world at a point of a study, and how many sweeps a frame these are."""
    if setting.method == "present":
        chosen = {name: setting.scene[name] for name in ("solver", "substeps", "iterations")}
    else:
        chosen = USES[setting.method].settings(int(setting.knob))
    return SolidSettings(**chosen), int(chosen["substeps"]) * int(chosen["iterations"])


def points_of(law: Law, most: int) -> list[Setting]:
    """All uses at the same turns, from one to ``most``."""
    return [
        Setting(name, n, {}, use.settings(n), (1.0 + 10.0 * (name == "complementarity")) * (10.0 + n))
        for n in counts_between(1, most, 7)
        for name, use in USES.items()
        if name != "complementarity" or law.points <= REFEREE_POINTS
        if use.sweeps <= n
    ]


def present_solver(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands."""
    chosen = {name: parameters[name] for name in ("solver", "substeps", "iterations")}
    turns = int(chosen["substeps"]) * int(chosen["iterations"])
    for name, use in USES.items():
        if use.settings(turns) == chosen:
            return Setting(name, turns, {}, chosen)
    return Setting("present", turns, {"substeps": float(chosen["substeps"])}, chosen)


def law_study(law: Law, most: int = MOST_TURNS, related: tuple[Study, ...] = ()) -> Study:
    """The study of one law. most: turns a frame; few make it quick."""

    def trial(setting: Setting) -> LawTrial:
        return LawTrial(law, *solid_settings(setting))

    return Study(
        name=f"solids-{law.name}",
        title=f"Solvers of solids: {law.title}",
        short=law.title[:1].upper() + law.title[1:],
        error=law.error,
        error_unit=law.unit,
        counter="sweeps",
        knob=Knob("turns", "substeps or sweeps a frame", parts=True),
        methods=tuple(
            Method(name, use.label, None)
            for name, use in USES.items()
            if name != "complementarity" or law.points <= REFEREE_POINTS
        ),
        settings=lambda: points_of(law, most),
        trial=trial,
        reference=law.reference,
        expectation="Substeps help where motion decides, sweeps only where contacts have not settled.",
        present=present_solver,
        workload=Workload(law.title),
        floor=law.spread,
        related=related,
    )


STUDIES = {name: law_study(law) for name, law in LAWS.items()}
race_study = law_study(LAWS["column"], related=tuple(STUDIES[name] for name in LAWS if name != "column"))

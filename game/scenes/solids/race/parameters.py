"""What can be chosen in the race."""

from __future__ import annotations

from typing import Any

from game.naming import titled, words_of
from game.physics.solids import SOLVERS
from game.stage import Choice, Param, Parameters, Toggle
from game.worlds.members import solids


def field_of(solver: str) -> str:
    """The parameter that says whether a solver takes part."""
    return f"with_{solver.replace('-', '_')}"


SHORT = {
    "sequential-impulses": "sequential",
    "xpbd": "XPBD",
    "augmented-vertex-block-descent": "AVBD",
    "compliant-lagrangian": "Lagrangian",
    "shock-propagation": "shock",
    "complementarity": "direct",
}
# takes part unless one says otherwise: each solver has to be compiled, and the direct one is for few contacts
FIRST = ("soft-step", "sequential-impulses", "xpbd", "compliant-lagrangian")


def short_of(solver: str) -> str:
    """A solver's name where there is little room."""
    return SHORT.get(solver, words_of(solver))


class SetupParameters(Parameters):
    """The set-up, and how finely it is computed."""

    setup = Choice(
        "stack", ("stack", "pyramid", "heavy", "cards", "chain", "arch", "ratios"), rebuild=True,
        group="Set-up",
        labels=("Column of 20", "Pyramid of 20 rows", "1000 kg on ten boxes", "Cards", "Chain with a load",
                "Arch at its limit", "Mass ratios to 20 000"),
        help="what all solvers compute",
    )  # fmt: skip
    tier = solids.choose_quality("Steps")
    substeps = solids.choose_substeps(64, "Steps")
    iterations = Param(4, 1, 100, whole=True, log=True, group="Steps", help="sweeps of a substep")
    step_length = solids.choose_step(1.0 / 60.0, 1.0 / 1000.0, 1.0 / 20.0, "Steps")


_fields: dict[str, Any] = {
    field_of(name): Toggle(name in FIRST, label=titled(name), group="Solvers", rebuild=True)
    for name in SOLVERS
}
SolverToggles = type("SolverToggles", (Parameters,), {"__doc__": "Who takes part.", **_fields})


class RaceParameters(SolverToggles, SetupParameters):  # type: ignore[misc, valid-type]
    """All of the race."""

    def chosen(self) -> list[str]:
        """Names of the solvers that take part."""
        return [name for name in SOLVERS if self.values[field_of(name)]]

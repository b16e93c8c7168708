"""Marks of the qualities that scenes of solids offer (play, teach, film) in what accuracy costs them."""

from __future__ import annotations

from collections.abc import Callable

from game.lab.study import Row
from game.physics.solids.settings import tier_of


def quality_marks(method: str, knob: float | None = None) -> Callable[[Row], str]:
    """For `Study.mark`: a quality's name at its substeps, on one method's rows.

    ``knob``: on those at that value alone, where substeps are what else tells points apart.
    """

    def mark(row: Row) -> str:
        if row.method != method or (bool(row.others) if knob is None else row.knob != knob):
            return ""
        return tier_of(float(row.scene.get("substeps", 0)))

    return mark

"""Marks of the qualities that scenes of solids offer (play, teach, film) in what accuracy costs them."""

from __future__ import annotations

from collections.abc import Callable

from game.lab.study import Row
from game.physics.solids.settings import tier_of


def quality_marks(method: str, others: dict[str, float] | None = None) -> Callable[[Row], str]:
    """For `Study.mark`: a quality's name at its substeps, on one method's rows with these other knobs."""

    def mark(row: Row) -> str:
        if row.method != method or row.others != (others or {}):
            return ""
        return tier_of(float(row.scene.get("substeps", 0)))

    return mark

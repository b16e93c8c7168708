"""Scenes that hold one broad phase against testing every box against every other."""

from __future__ import annotations

from game.physics.broadphase.effects import BOUNDARY, MOTION, NAIVE
from game.scenes.boxes.base import BoxesScene
from game.scenes.boxes.model.managers import MOST_IN_MATRIX
from game.scenes.boxes.numbers import grouped


class ComparedScene(BoxesScene):
    """Base of C06 and C07."""

    effects = MOTION | BOUNDARY | NAIVE

    def why_idle(self, name: str) -> str:
        if name == "manager" and len(self.model.boxes.alive) > MOST_IN_MATRIX:
            return f"Above {grouped(MOST_IN_MATRIX)} boxes pairs are kept in a hash table."
        return super().why_idle(name)

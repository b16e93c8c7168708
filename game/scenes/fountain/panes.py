"""Where the fountains of several methods stand in the picture: slices of the world side by side."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from game.scenes.fountain.model import FountainModel

TITLES = {"explicit-euler": "Explicit Euler", "midpoint": "Midpoint", "verlet": "Verlet"}


class Pane(NamedTuple):
    """A slice of the picture from left to right (m); shift: of the world in it, m; title: the method's."""

    left: float
    right: float
    shift: float
    title: str


def panes_of(model: FountainModel) -> list[Pane]:
    """One for each method; the whole picture for a single one."""
    view = model.content.view
    if not model.beside:
        return [Pane(view.left, view.right, 0.0, "")]
    count = len(model.systems)
    wide = (view.right - view.left) / count
    middle = model.nozzle_position(0)[0] if model.content.nozzles else 0.5 * (view.left + view.right)
    lefts = [view.left + wide * k for k in range(count)]
    return [
        Pane(left, left + wide, left + 0.5 * wide - middle, TITLES[method])
        for left, method in zip(lefts, model.methods, strict=True)
    ]


def pane_at(panes: Sequence[Pane], x: float) -> int:
    """Which pane is at a place (m) of the picture; the nearest one beyond the ends."""
    return next((k for k, pane in enumerate(panes) if x < pane.right), len(panes) - 1)

"""The parts of the picture in the scenes of bounding-volume trees: one, or two side by side."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from game.physics.kernels.limits import LimitError
from game.scenes.bounds.model import BoundsModel
from game.scenes.bounds.pair import Place, TreePair
from game.scenes.bounds.parameters import CapsuleParameters

TITLES = {"obb": "Oriented boxes", "capsule": "Capsules", "aabb": "Axis-aligned boxes"}


class Pane(NamedTuple):
    """A part of the picture with trees of one kind; the world is smaller in it, and moved."""

    pair: TreePair
    scale: float = 1.0
    x: float = 0.0
    y: float = 0.0
    title: str = ""

    def point(self, at: Sequence[float]) -> tuple[float, float]:
        """Where a point of the world is drawn."""
        return self.scale * at[0] + self.x, self.scale * at[1] + self.y

    def world(self, at: Sequence[float]) -> tuple[float, float]:
        """The point of the world that is drawn there."""
        return (at[0] - self.x) / self.scale, (at[1] - self.y) / self.scale

    def place(self, place: Place) -> Place:
        """Where a frame is drawn."""
        return Place(*self.point((place.x, place.y)), place.angle, self.scale)


class Panes:
    """Gives the parts of the picture as it is now: the whole for the trees in play."""

    def __init__(self, model: BoundsModel):
        self.model = model

    def __call__(self) -> list[Pane]:
        return [Pane(self.model.pair)]


class SideBySide(Panes):
    """If it is asked for and can be, the trees in play on the left and the others on the right."""

    def __init__(self, model: BoundsModel, parameters: CapsuleParameters):
        super().__init__(model)
        self.parameters = parameters

    def __call__(self) -> list[Pane]:
        model = self.model
        if not self.parameters.side_by_side or self.parameters.walked != "off" or len(model.outlines) != 2:
            return super().__call__()
        try:
            model.ask_beside()
        except LimitError:  # too many pairs to be kept: these trees alone
            return super().__call__()
        seen = model.content.view
        quarter, middle = 0.25 * (seen.right - seen.left), 0.5 * (seen.left + seen.right)
        height = 0.5 * (seen.bottom + seen.top)
        return [
            Pane(pair, 0.5, 0.5 * middle + side * quarter, 0.5 * height, TITLES[pair.options.kind])
            for pair, side in ((model.pair, -1.0), (model.beside, 1.0))
        ]

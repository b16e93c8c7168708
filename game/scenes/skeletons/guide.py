"""Making a figure, step by step: what is to be done, and what is done already."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.scenes.skeletons.level import FigureContent
from game.worlds.expectations import Caption

ENOUGH_BONES = 15  # as the course asks for
TURNED = 0.05  # rad by which a bone is to be turned


def steps_of(figure: FigureContent, turned: NDArray[np.float64]) -> list[Caption]:
    """Words for each step, and whether it is done. turned (n + 2,): the pose less the bind pose."""
    bones = len(figure.bones)
    return [
        Caption(
            f"New bone (2): click a parent, then the new end, {bones} of {ENOUGH_BONES}",
            bones >= ENOUGH_BONES,
        ),
        Caption("Skin (3): click around the bones, Enter closes", bool(figure.skins)),
        Caption("Turn (1): drag a bone, its children and the skin follow", _is_posed(figure, turned)),
    ]


def _is_posed(figure: FigureContent, turned: NDArray[np.float64]) -> bool:
    return bool(figure.skins) and bool(np.abs(turned[:-2]).max(initial=0.0) > TURNED)

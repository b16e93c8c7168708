"""What a model has heard in the last moments, as the sounds of a scene."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from numpy.typing import NDArray

from game.stage import Sound

HEARD_TIME, HEARD_KIND, HEARD_SPEED, HEARD_X = range(4)  # columns: s, number of the kind, m/s, m
HEARD_WIDTH = 4
REMEMBERED_S = 0.4  # s that an impact stays among those heard: more than the longest gap that is heard


def sounds_of(heard: NDArray[Any], names: Mapping[int, str], half: float, middle: float = 0.0) -> list[Sound]:
    """Of rows (k, HEARD_WIDTH), by the names of kinds; ``half`` m beside the middle is all on one side."""
    return [
        Sound(
            float(row[HEARD_TIME]), names[int(row[HEARD_KIND])], float(row[HEARD_SPEED]),
            max(-1.0, min(1.0, (float(row[HEARD_X]) - middle) / half)),
        )
        for row in heard
    ]  # fmt: skip

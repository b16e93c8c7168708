"""Values of a knob, spread over its range."""

from __future__ import annotations

import numpy as np


def counts_between(fewest: int, most: int, number: int) -> list[int]:
    """Whole numbers spread evenly in the logarithm, about so many, rising, without repetition."""
    return sorted({round(x) for x in np.geomspace(fewest, most, number).tolist()})

"""The settings of a rigid body, beside its state, each checked as it comes in."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.rigid.effects import BODIES
from game.physics.rigid.motion import METHODS
from game.physics.rigid.window import WALLS

LARGEST = 1e150  # of any number given, so that squares are numbers
_LIMITS = {"gravity": (-1e6, 1e6), "damping": (0.0, 1e6), "restitution": (0.0, 1.0)}
_OPTIONS = {"method": METHODS, "wall": WALLS}


def checked_setting(name: str, value: Any) -> Any:
    """A setting of `RigidBody.change` in its own type, or ValueError."""
    if name in _OPTIONS:
        if value not in _OPTIONS[name]:
            raise ValueError(f"{name} = {value!r}: expected one of {', '.join(_OPTIONS[name])}")
        return value
    if name in _LIMITS:
        least, most = _LIMITS[name]
        if not least <= value <= most:
            raise ValueError(f"{name} = {value!r}: expected {least:g} to {most:g}")
        return float(value)
    if name in ("lower", "upper"):
        return vector(name, value)
    if name == "normalizing":
        return bool(value)
    if name != "effects":
        raise ValueError(f"{name}: a rigid body has no such setting")
    return BODIES.checked(value)


def vector(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """(3,) finite numbers, or ValueError."""
    vector = np.array(value, dtype=np.float64)
    if vector.shape != (3,) or not (np.abs(vector) <= LARGEST).all():
        raise ValueError(f"{name}: expected three finite numbers")
    return vector

"""Which quantity of a state is not finite: asked after every step."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from game.physics.finite import finite_test


class FiniteWatch:
    """Names the first quantity of a state that is not finite; keeps views of arrays it has seen before."""

    def __init__(self, exempt: frozenset[str] = frozenset()) -> None:
        self._exempt = exempt
        self._seen: dict[str, tuple[np.ndarray, Any]] = {}

    def first_bad(self, state: Any) -> str | None:
        """Dotted name of the first field of the state that holds inf or NaN, or None."""
        seen = self._seen
        for name, value in zip(state._fields, state, strict=True):
            entry = seen.get(name)
            if entry is not None and entry[0] is value:
                test = entry[1]
                if test is None or test[0](test[1]):
                    continue
                return name
            bad = self._look(name, value)
            if bad is not None:
                return bad
        return None

    def _look(self, name: str, value: Any) -> str | None:
        """The slow way, for what is not an array already known."""
        if name in self._exempt:
            return None
        if isinstance(value, np.ndarray):
            test = finite_test(value)
            self._seen[name] = (value, test)
            return name if test is not None and not test[0](test[1]) else None
        if isinstance(value, (float, np.floating)):
            return None if math.isfinite(value) else name
        if isinstance(value, tuple):
            inner = (self._look(f"{name}.{key}", item) for key, item in _named(value))
            return next((found for found in inner if found is not None), None)
        return None


def _named(value: tuple[Any, ...]) -> Iterator[tuple[str, Any]]:
    return zip(getattr(value, "_fields", None) or map(str, range(len(value))), value, strict=True)

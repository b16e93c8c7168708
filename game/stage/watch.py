"""Which quantity of a state is not finite: asked after every step."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from game.physics.kernels.finite import finite_doubles, finite_test, finite_together


class FiniteWatch:
    """Names the first quantity of a state that is not finite, but for the ``exempt`` fields.

    As long as a state consists of the same arrays, all its float64 arrays are tested by one call.
    """

    def __init__(self, exempt: frozenset[str] = frozenset()) -> None:
        self._exempt = exempt
        self._arrays: list[tuple[int, np.ndarray]] | None = None  # position in the state, and what lay there
        self._views: tuple[np.ndarray, ...] = ()
        self._odd: list[tuple[Callable[[np.ndarray], bool], np.ndarray]] = []
        self._others: list[tuple[int, str]] = []  # what is no array

    def first_bad(self, state: Any) -> str | None:
        """Dotted name of the first field of the state that holds inf or NaN, or None."""
        if self._arrays is None:
            return self._look_anew(state)
        for index, array in self._arrays:
            if state[index] is not array:
                return self._look_anew(state)
        if self._views and not finite_together(self._views):
            return self._look_anew(state)
        for test, view in self._odd:
            if not test(view):
                return self._look_anew(state)
        for index, name in self._others:
            if (bad := self._look(name, state[index])) is not None:
                return bad
        return None

    def _look_anew(self, state: Any) -> str | None:
        """Test field by field, and note what the state consists of for the next time."""
        self._arrays, self._odd, self._others = [], [], []
        views = []
        bad = None
        for index, (name, value) in enumerate(_named(state)):
            if name in self._exempt:
                continue
            bad = bad or self._look(name, value)
            if not isinstance(value, np.ndarray):
                self._others.append((index, name))
                continue
            test = finite_test(value)
            if test is not None:
                self._arrays.append((index, value))
                if test[0] is finite_doubles:
                    views.append(test[1])
                else:
                    self._odd.append(test)
        self._views = tuple(views)
        return bad

    def _look(self, name: str, value: Any) -> str | None:
        """Test one field, or all within it."""
        if name in self._exempt:
            return None
        if isinstance(value, np.ndarray):
            test = finite_test(value)
            return None if test is None or test[0](test[1]) else name
        if isinstance(value, (float, np.floating)):
            return None if math.isfinite(value) else name
        if isinstance(value, tuple):
            inner = (self._look(f"{name}.{key}", item) for key, item in _named(value))
            return next((found for found in inner if found is not None), None)
        return None


def _named(value: tuple[Any, ...]) -> Iterator[tuple[str, Any]]:
    return zip(getattr(value, "_fields", None) or map(str, range(len(value))), value, strict=True)

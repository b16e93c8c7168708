"""A table that grows: one NamedTuple of arrays, a slot a row, slots of what was taken away used again."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Generic, NamedTuple, TypeVar

import numpy as np
from numpy.typing import DTypeLike, NDArray

Rows = TypeVar("Rows", bound=Any)


class Column(NamedTuple):
    """What one array of a table holds: dtype, numbers a row (0: a plain number), what an empty slot has."""

    dtype: DTypeLike = np.float64
    width: int = 0
    empty: float = 0.0


class Table(Generic[Rows]):
    """Rows of a NamedTuple of arrays; ``rows`` are views of those in use up to the highest.

    kind: the NamedTuple. columns: by field name. most: slots at most; ValueError beyond that, by ``name``.
    """

    def __init__(self, name: str, kind: type[Rows], columns: Mapping[str, Column], most: int):
        self.name, self.most = name, most
        self._kind, self._columns = kind, dict(columns)
        self._store: dict[str, NDArray[Any]] = {}
        self.top = 0
        self.free: list[int] = []
        self._grow(16)

    @property
    def capacity(self) -> int:
        """Slots that there is memory for."""
        return len(next(iter(self._store.values())))

    def take(self) -> int:
        """A slot, emptied; memory doubles where there is none left."""
        slot = self.free.pop() if self.free else self.take_run(1)
        for field, column in self._columns.items():
            self._store[field][slot] = column.empty
        return slot

    def take_run(self, count: int) -> int:
        """The first of so many new slots in a row."""
        if self.top + count > self.most:
            raise ValueError(f"{self.name}: at most {self.most}")
        if self.top + count > self.capacity:
            self._grow(max(2 * self.capacity, self.top + count))
        self.top += count
        self._view()
        return self.top - count

    def release(self, slot: int) -> None:
        """Give a slot back."""
        for field, column in self._columns.items():
            self._store[field][slot] = column.empty
        self.free.append(slot)

    def copy(self) -> tuple[Rows, NDArray[np.int64]]:
        """Copies of all rows, and of the free slots."""
        return self._kind(*(array.copy() for array in self.rows)), np.array(self.free, dtype=np.int64)

    def restore(self, rows: Rows, free: NDArray[np.int64]) -> None:
        """Be as when `copy` was called."""
        count = len(rows[0])
        if count > self.capacity:
            self._grow(count)
        self.top = count
        self._view()
        for mine, given in zip(self.rows, rows, strict=True):
            np.copyto(mine, given)
        self.free = [int(slot) for slot in free]

    def _grow(self, capacity: int) -> None:
        for field, column in self._columns.items():
            shape = (capacity, column.width) if column.width else (capacity,)
            array = np.full(shape, column.empty, dtype=column.dtype)
            if field in self._store:
                array[: self.top] = self._store[field][: self.top]
            self._store[field] = array
        self._view()

    def _view(self) -> None:
        self.rows: Rows = self._kind(**{field: array[: self.top] for field, array in self._store.items()})

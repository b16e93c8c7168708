"""A ledger of mass, momentum, energy and heat over all rooms of a scene: what came in, what is there,
what is open.
"""

from __future__ import annotations

import math
from typing import NamedTuple

QUANTITIES = ("mass", "momentum_x", "momentum_y", "energy", "heat")


class Entry(NamedTuple):
    """What one room holds. kg, N s, N s, J, J."""

    mass: float = 0.0
    momentum_x: float = 0.0
    momentum_y: float = 0.0
    energy: float = 0.0
    heat: float = 0.0


class Ledger:
    """Compares what rooms hold with what they held and what was put in from outside.

    `open_book` notes what each room holds; `bring` what comes from outside (a hand, gravity, a source);
    `open_share` is what rooms hold now less all of that: 0 where everything is conserved.
    """

    def __init__(self) -> None:
        self._held: dict[str, Entry] = {}
        self._brought: list[Entry] = []

    def open_book(self, rooms: dict[str, Entry]) -> None:
        """Begin anew with what rooms hold. ValueError for what is not finite."""
        self._held, self._brought = {name: _checked(name, entry) for name, entry in rooms.items()}, []

    def bring(self, entry: Entry) -> None:
        """Something comes from outside (negative: goes there). ValueError for what is not finite."""
        self._brought.append(_checked("brought", entry))

    def open_share(self, rooms: dict[str, Entry]) -> Entry:
        """By how much what rooms hold now differs from what it should be."""
        before = [*self._held.values(), *self._brought]
        return Entry(
            *(
                math.fsum([*(entry[k] for entry in rooms.values()), *(-entry[k] for entry in before)])
                for k in range(len(QUANTITIES))
            )
        )


def _checked(name: str, entry: Entry) -> Entry:
    for quantity, value in zip(QUANTITIES, entry, strict=True):
        if not math.isfinite(value):
            raise ValueError(f"{name}: {quantity} = {value!r}: expected a finite number")
    return entry

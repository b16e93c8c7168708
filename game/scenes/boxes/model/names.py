"""What boxes are called, a letter or their id counted from 1, and where two of them are apart."""

from __future__ import annotations

from collections.abc import Sequence

from game.scenes.boxes.model.arrays import BoxArrays

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
AXES = ("x", "y")


def named(boxes: BoxArrays) -> bool:
    """Whether there are so few boxes that each has a letter."""
    return len(boxes.alive) <= len(LETTERS)


def name_of(boxes: BoxArrays, box: int) -> str:
    """A letter where there are few boxes, else the id, counted from 1."""
    return LETTERS[box] if named(boxes) else f"#{box + 1}"


def listed_names(boxes: BoxArrays, some: Sequence[int], most: int = 4) -> str:
    """The names of some boxes, the rest by their number."""
    names = [name_of(boxes, box) for box in some[:most]]
    return ", ".join(names) + (f" and {len(some) - most} more" if len(some) > most else "")


def apart_on(boxes: BoxArrays, a: int, b: int) -> str:
    """The axes on which what two boxes cover does not overlap: "x", "y", "x and y", or "" for a pair."""
    lowers, uppers = boxes.covered()
    gaps = (lowers[a] > uppers[b]) | (lowers[b] > uppers[a])
    return " and ".join(AXES[axis] for axis in range(2) if gaps[axis])


def outcomes(boxes: BoxArrays, box: int, candidates: Sequence[int]) -> tuple[list[int], list[int]]:
    """Of the boxes that a box is tested against: those that overlap it and those rejected, each but once."""
    distinct = list(dict.fromkeys(candidates))
    pairs = [other for other in distinct if not apart_on(boxes, box, other)]
    return pairs, [other for other in distinct if other not in set(pairs)]


def result_of(pairs: Sequence[int], rejected: Sequence[int]) -> str:
    """What came of the tests, in a few words."""
    found = f"{len(pairs)} pair" + ("" if len(pairs) == 1 else "s")
    return f"{found}, {len(rejected)} rejected"

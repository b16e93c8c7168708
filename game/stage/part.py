"""Parts of a scene: its model, its hand, what it measures.

A scene knows all its parts, a view knows model and hand, a hand the model, the model parameters, level and
physics. None knows the scene.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any


class Part:
    """An object of a scene that the stage remembers as it remembers the scene itself.

    Its plain attributes (numbers, words, lists of them; see states/memory.py) come back with each step back.
    Arrays that later steps depend on belong into the scene's ``state``. A part stays the same object from
    ``build`` on.
    """


def structures_of(owner: Any, seen: set[int] | None = None) -> Iterator[Any]:
    """What a scene or a part owns, parts of parts included; each once."""
    seen = set() if seen is None else seen
    for value in vars(owner).values():
        if id(value) in seen:
            continue
        seen.add(id(value))
        yield value
        if isinstance(value, Part):
            yield from structures_of(value, seen)

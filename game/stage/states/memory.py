"""What a scene remembers beside its state: plain attributes such as a ball held by the pointer or a score.

A scene may keep such things as ordinary attributes; the stage remembers them with each snapshot, so that
stepping back undoes a drag as well. So may its parts (part.py). Numbers, words, None, enumerations, frozen
structs, and lists, tuples, sets, dicts and deques of these count as plain, and random generators (their
state). Arrays do not: an array that later steps depend on belongs into the state.
"""

from __future__ import annotations

import copy
import enum
from collections import deque
from typing import Any, NamedTuple

import msgspec
import numpy as np

from game.stage.part import Part

OWN = frozenset(("values", "parameters", "active", "previous", "level", "seed"))  # kept by the stage itself
_ATOMS = (type(None), bool, int, float, complex, str, bytes, np.generic, enum.Enum, range)
_CONTAINERS = (list, set, frozenset, dict, deque)  # these very types: subclasses may hide more
_MAX_DEPTH = 6


class Memory(NamedTuple):
    """Copies of a scene's plain attributes, and what they take."""

    attributes: dict[str, Any]
    bytes: int


class _GeneratorState(NamedTuple):
    """Where a random generator stands."""

    state: dict[str, Any]


def remember(scene: Any, seen: set[int] | None = None) -> Memory:
    """Copies of the plain attributes of a scene and of its parts; ``seen``: ids of parts kept already."""
    kept: dict[str, Any] = {}
    weight = 0
    seen = set() if seen is None else seen
    for name, value in vars(scene).items():
        if name in OWN:
            continue
        if isinstance(value, Part):
            if id(value) not in seen:
                seen.add(id(value))
                kept[name] = remember(value, seen)
                weight += kept[name].bytes
            continue
        if isinstance(value, np.random.Generator):
            kept[name] = _GeneratorState(copy.deepcopy(dict(value.bit_generator.state)))
            weight += 600
            continue
        items = _count(value, _MAX_DEPTH)
        if items:
            kept[name] = _copied(value)
            weight += 100 * items
    return Memory(kept, weight)


def recall(scene: Any, memory: Memory) -> None:
    """Set a scene's plain attributes to what they were; those made since are removed."""
    for name, value in memory.attributes.items():
        if isinstance(value, Memory):
            recall(getattr(scene, name), value)
        elif isinstance(value, _GeneratorState):
            getattr(scene, name).bit_generator.state = value.state
        else:
            setattr(scene, name, _copied(value))
    since = set(vars(scene)) - set(memory.attributes) - OWN
    for name in sorted(since):
        if _count(vars(scene)[name], _MAX_DEPTH):
            delattr(scene, name)


def _count(value: Any, depth: int) -> int:
    """How many plain things a value holds; 0 if any part of it is not plain."""
    if isinstance(value, _ATOMS):
        return 1
    if isinstance(value, msgspec.Struct):
        return 2 if type(value).__struct_config__.frozen else 0
    if depth == 0:
        return 0
    parts: Any
    if type(value) is dict:
        parts = [*value.keys(), *value.values()]
    elif type(value) in _CONTAINERS or isinstance(value, tuple):
        parts = value
    else:
        return 0
    total = 1
    for part in parts:
        inside = _count(part, depth - 1)
        if not inside:
            return 0
        total += inside
    return total


def _copied(value: Any) -> Any:
    """A copy down to the plain things, which cannot change."""
    if isinstance(value, dict):
        return {key: _copied(item) for key, item in value.items()}
    if isinstance(value, tuple):
        return type(value)(*map(_copied, value)) if hasattr(value, "_fields") else tuple(map(_copied, value))
    if isinstance(value, deque):
        return deque(map(_copied, value), value.maxlen)
    if isinstance(value, (list, set)):
        return type(value)(map(_copied, value))
    return value

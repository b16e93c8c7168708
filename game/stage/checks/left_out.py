"""Which field later steps depend on although neither ``state`` nor the stage's memory brings it back.

A scene steps, is put back and steps again. If it comes to another state than the first time, whatever is not
what it was after being put back may be the cause. A field is named if giving it back by hand mends that.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from game.stage.scene import Scene
from game.stage.states.memory import OWN, recall, remember
from game.stage.states.state import copy_state, digest_of

STEPS = 20
_DEPTH = 4
_NUMBERS = (bool, int, float, str, np.generic)


def fields_left_out(scene: Scene, dt: float) -> list[str]:
    """Dotted names of such fields (``model.rates``) of a scene that may be used up; [] if none is found.

    dt: s, of a step. Arrays, numbers and words are looked at, in the scene and in what it is made of.
    """
    state, memory = copy_state(scene.state()), remember(scene)
    kept = {name: _copied(getattr(owner, attribute)) for name, owner, attribute in _fields(scene)}

    def goes_to(given_back: tuple[str, ...]) -> str:
        """Digest after some steps from what there was, with these fields put back by hand."""
        scene.restore(copy_state(state))
        recall(scene, memory)
        for name, owner, attribute in list(_fields(scene)):
            if name in given_back:
                _put_back(owner, attribute, kept[name])
        for _ in range(STEPS):
            scene.advance(dt)
        return digest_of(scene.state(), 0)

    for _ in range(STEPS):
        scene.advance(dt)
    first = digest_of(scene.state(), 0)
    scene.restore(copy_state(state))
    recall(scene, memory)
    changed = tuple(
        name
        for name, owner, attribute in _fields(scene)
        if name in kept and not _equal(kept[name], getattr(owner, attribute))
    )
    if goes_to(()) == first or goes_to(changed) != first:
        return []
    alone = [name for name in changed if goes_to((name,)) == first]
    return alone or list(changed)


def _fields(owner: Any, prefix: str = "", depth: int = _DEPTH) -> Iterator[tuple[str, Any, str]]:
    """Name, owner and attribute of each array, number and word in an object and in the objects it has."""
    for attribute, value in vars(owner).items():
        if not prefix and attribute in OWN:
            continue
        if isinstance(value, (np.ndarray, *_NUMBERS)):
            yield prefix + attribute, owner, attribute
        elif depth > 0 and type(value).__module__.partition(".")[0] != "builtins" and _has_fields(value):
            yield from _fields(value, f"{prefix}{attribute}.", depth - 1)


def _has_fields(value: Any) -> bool:
    """An object that keeps attributes which can be set."""
    return hasattr(value, "__dict__") and not isinstance(value, type) and not callable(value)


def _copied(value: Any) -> Any:
    return value.copy() if isinstance(value, np.ndarray) else value


def _put_back(owner: Any, attribute: str, value: Any) -> None:
    """Give a field its value; an array in place, as others may hold it as well."""
    now = getattr(owner, attribute)
    if isinstance(now, np.ndarray) and now.flags.writeable and now.shape == np.shape(value):
        np.copyto(now, value)
    else:
        setattr(owner, attribute, _copied(value))


def _equal(one: Any, other: Any) -> bool:
    if isinstance(one, np.ndarray):
        return isinstance(other, np.ndarray) and one.tobytes() == other.tobytes()
    return type(one) is type(other) and bool(one == other)

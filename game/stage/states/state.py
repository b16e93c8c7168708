"""What the stage does with a scene's state, whatever it holds: copy it, weigh it, digest it.

A state is a NamedTuple of arrays, numbers, words and further tuples of these.
"""

from __future__ import annotations

import hashlib
import struct
from typing import Any

import numpy as np

OVERHEAD = 160  # bytes that Python takes for one array beside its numbers


def copy_state(state: Any, into: Any = None) -> Any:
    """A copy of a state; arrays of ``into`` (an earlier copy) are used again where they fit."""
    copies = []
    for index, value in enumerate(state):
        old = into[index] if into is not None and index < len(into) else None
        if isinstance(value, np.ndarray):
            if isinstance(old, np.ndarray) and old.shape == value.shape and old.dtype == value.dtype:
                np.copyto(old, value)
                copies.append(old)
            else:
                copies.append(value.copy())
        elif isinstance(value, tuple):
            copies.append(copy_state(value, old if isinstance(old, tuple) else None))
        else:
            copies.append(value)
    return type(state)(*copies) if hasattr(state, "_fields") else tuple(copies)


def same_shapes(state: Any, other: Any) -> bool:
    """True if two states have the same fields with arrays of the same shapes."""
    if other is None or len(state) != len(other):
        return False
    for value, twin in zip(state, other, strict=True):
        if isinstance(value, np.ndarray) and (not isinstance(twin, np.ndarray) or value.shape != twin.shape):
            return False
        if isinstance(value, tuple) and not (isinstance(twin, tuple) and same_shapes(value, twin)):
            return False
    return True


def state_bytes(state: Any) -> int:
    """Bytes that a copy of the state takes."""
    total = OVERHEAD
    for value in state:
        if isinstance(value, np.ndarray):
            total += value.nbytes + OVERHEAD
        elif isinstance(value, tuple):
            total += state_bytes(value)
        else:
            total += 64 + (len(value) if isinstance(value, (str, bytes)) else 0)
    return total


def digest_of(state: Any, step: int) -> str:
    """Hash of a state and its step number: names, types, shapes and bytes. Equal states, equal digests.

    TypeError for what is not an array of numbers, a number, a word or a tuple of these.
    """
    hasher = hashlib.blake2b(struct.pack("<q", step), digest_size=16)
    _feed(hasher, "", state)
    return hasher.hexdigest()


def _feed(hasher: Any, prefix: str, state: Any) -> None:
    names = getattr(state, "_fields", None) or tuple(map(str, range(len(state))))
    for name, value in zip(names, state, strict=True):
        path = f"{prefix}{name}"
        if isinstance(value, (np.ndarray, np.generic)):
            array = np.ascontiguousarray(value)
            if array.dtype.hasobject:
                raise TypeError(f"state {path}: an array of Python objects has no bytes to compare")
            hasher.update(f"{path}|{array.dtype.str}|{np.shape(value)}|".encode())
            hasher.update(array.reshape(-1).view(np.uint8).data)
        elif isinstance(value, tuple):
            hasher.update(f"{path}|tuple {len(value)}|".encode())
            _feed(hasher, f"{path}.", value)
        elif value is None or isinstance(value, (bool, int, float, str, bytes)):
            text = value.hex() if isinstance(value, float) else repr(value)
            hasher.update(f"{path}|{type(value).__name__}|{text}|".encode())
        else:
            raise TypeError(f"state {path}: {type(value).__name__} is no part of a state")

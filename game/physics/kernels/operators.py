"""The type of a sum is asked for once: numba's answers about plain numbers are remembered.

For each ``a * b`` numba asks all that ever declared a multiplication, of arrays, tuples, strings, sets and so
on, until one knows it: a millisecond or two, for each of the thousands of operators of a kernel, a fifth of
the time of compiling. For plain numbers, and for elements of arrays, the answer depends on the types only.
"""

from __future__ import annotations

import operator
from typing import Any

from numba.core import types
from numba.core.types.functions import BaseFunction

OF_ELEMENTS = frozenset({operator.getitem, operator.setitem})
_ask = BaseFunction.get_call_type
_answers: dict[tuple[Any, ...], Any] = {}


def _is_number(kind: Any) -> bool:
    return isinstance(kind, types.Number | types.Boolean)


def _is_element(kind: Any) -> bool:
    if isinstance(kind, types.UniTuple):  # type: ignore[attr-defined]
        kind = kind.dtype
    return isinstance(kind, types.Array) or _is_number(kind)


def _remembered(self: Any, context: Any, arguments: Any, options: Any) -> Any:
    """The signature of a call, as numba's own method finds it."""
    plain = _is_element if self.typing_key in OF_ELEMENTS else _is_number
    if options or not all(plain(kind) for kind in arguments):
        return _ask(self, context, arguments, options)
    key = (self, context, *arguments)
    found = _answers.get(key)
    if found is None:
        found = _ask(self, context, arguments, options)
        # what is written in Python is compiled with the caller's options: numba keeps that apart itself
        if found is not None and self._impl_keys.get(found.args) is self.typing_key:
            _answers[key] = found
    return found


def remember_operators() -> None:
    """Let numba remember, in this process. Nothing else about it changes."""
    BaseFunction.get_call_type = _remembered  # type: ignore[method-assign, assignment]

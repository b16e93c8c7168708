"""Things that numba's compiler does ten thousands of times, done at once for Carom's kernels.

To find the types of a kernel numba goes round its statements until nothing changes. It asks each time anew
what, say, a float plus an integer gives: it tries some sixty rules for ``+``, most of them for texts, sets
and dates. For each it looks up whether that rule has been compiled under the flags in force, which are
compared option by option. It lists the variables of a statement by walking through everything that hangs on
it. After each of nine passes it finds out where every variable is needed last, which is used after one of
them. And it tells of each time that LLVM is locked. Together that was a quarter of the time that a scene's
kernels compile in.

Carom's contexts remember what the operators on plain numbers and elements of arrays answered (`Answers`);
their flags are compared as dictionaries (`QuickFlags`). What numba asks no context for is exchanged while one
of Carom's kernels compiles (`short_cuts`), which no other thread can do meanwhile, and put back afterwards.
The answers are numba's own, so the machine code is the same.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable
from typing import Any

import llvmlite.binding as llvm
from numba.core import base, ir, postproc, transforms, types
from numba.core.compiler import Flags
from numba.core.types.containers import BaseAnonymousTuple
from numba.extending import overload
from numba.np import arrayobj

_PLAIN = (types.Number, types.Boolean)
_ELEMENT = (types.Array, *_PLAIN)
_OF_ELEMENTS = frozenset((operator.getitem, operator.setitem))


class Answers:
    """What functions gave for types of arguments that were asked for before."""

    def __init__(self) -> None:
        # by a function type's identity, which the entry keeps alive
        self._known: dict[int, tuple[Any, dict[Any, Any]]] = {}

    def ask(self, function: Any, context: Any, args: Any, kws: Any) -> Any:
        """The signature of a call; None if it has none, or is none of an operator on plain types."""
        is_plain = _is_element if function.typing_key in _OF_ELEMENTS else _is_number
        if kws or not all(map(is_plain, args)):
            return None
        answers = self._known.setdefault(id(function), (function, {}))[1]
        signature = answers.get(tuple(args))
        if signature is None:
            signature = function.get_call_type(context, args, kws)
            # Only rules that numba has built in: what an overload was compiled to depends on the flags.
            if signature is not None and function.get_impl_key(signature) is function.typing_key:
                answers[tuple(args)] = signature
        return signature


def _is_number(kind: Any) -> bool:
    return isinstance(kind, _PLAIN)


def _is_element(kind: Any) -> bool:
    """An array, a number, or a tuple of numbers: what elements of arrays are read and written by."""
    if isinstance(kind, BaseAnonymousTuple):
        return all(isinstance(part, _PLAIN) for part in kind)
    return isinstance(kind, _ELEMENT)


class QuickFlags(Flags):
    """Flags that are told apart as dictionaries."""

    __slots__ = ()

    def values(self) -> dict[str, Any]:
        """All options with their values."""
        return {**_defaults, **self._values}

    def __eq__(self, other: object) -> Any:
        return self is other or super().__eq__(other)

    def __hash__(self) -> int:
        return hash(QuickFlags)


_defaults = {name: option.default for name, option in Flags.options.items()}


def count_rules(registries: Any, lists: tuple[str, ...]) -> int:
    """How many rules some registries hold: there are only ever more."""
    return sum(len(getattr(registry, name)) for registry in registries for name in lists)


class _ShortCuts:
    """What of numba is exchanged while a kernel of Carom's compiles, at any depth, by one thread."""

    def __init__(self) -> None:
        self._depth = 0
        self._before: tuple[Any, ...] = ()

    def __enter__(self) -> None:
        if not self._depth:
            self._before = ir.Inst._rec_list_vars, postproc.PostProcessor.run, base._has_loc
            _exchange(_variables, _run, _has_loc)
            _lock_callbacks(llvm.ffi.unregister_lock_callback)
        self._depth += 1

    def __exit__(self, *_raised: object) -> None:
        self._depth -= 1
        if not self._depth:
            _exchange(*self._before)
            _lock_callbacks(llvm.ffi.register_lock_callback)


def _exchange(variables: Any, run: Any, has_loc: Any) -> None:
    ir.Inst._rec_list_vars = variables
    postproc.PostProcessor.run = run
    base._has_loc = has_loc


short_cuts = _ShortCuts()


def _lock_callbacks(change: Callable[..., None]) -> None:
    """numba times how long LLVM is locked, by two objects made at each of a hundred thousand calls of it."""
    with llvm.ffi.lib._lock._lock:  # that no thread is between the two
        for callbacks in _CALLBACKS:
            change(*callbacks)


_CALLBACKS = [pair for pair in llvm.ffi.lib._lock._cblist if pair[0].__module__ == "numba.core.base"]


# ---------------------------------------------------------------- variables of a statement

_bare = {str, int, bool, float, type(None), ir.Loc, ir.Const, ir.Global, ir.FreeVar, ir.Arg}


def _gather(value: Any, found: list[ir.Var]) -> None:
    kind = type(value)
    if kind is ir.Var:
        found.append(value)
    elif kind is dict:
        _gather_all(value.values(), found)
    elif kind is list or kind is tuple:
        _gather_all(value, found)
    elif isinstance(value, ir.Var):
        found.append(value)
    elif isinstance(value, ir.Inst):
        found.extend(value.list_vars())
    elif isinstance(value, dict):
        _gather_all(value.values(), found)
    elif isinstance(value, list | tuple):
        _gather_all(value, found)
    else:
        _bare.add(kind)  # the next of its kind is none of these either


def _gather_all(values: Iterable[Any], found: list[ir.Var]) -> None:
    for value in values:
        kind = type(value)
        if kind is ir.Var:
            found.append(value)
        elif kind not in _bare:
            _gather(value, found)


def _variables(_self: Any, value: Any) -> list[ir.Var]:
    found: list[ir.Var] = []
    _gather_all((value,), found)
    return found


# ---------------------------------------------------------------- where they are needed last

_find = postproc.PostProcessor.run


def _run(self: Any, emit_dels: bool = False, extend_lifetimes: bool = False) -> None:
    """Nine passes end by asking where each variable is needed last; the answer is used after one of them."""
    code = self.func_ir
    if emit_dels or code.is_generator:
        _find(self, emit_dels, extend_lifetimes)
        return
    code.blocks = transforms.canonicalize_cfg(code.blocks)
    code.variable_lifetime = postproc.VariableLifetime(code.blocks)  # finds out when it is asked
    code.generator_info = None


# ---------------------------------------------------------------- functions that take a place in the source

_ask = base._has_loc
_takes_loc: dict[Any, bool] = {}


def _has_loc(function: Any) -> bool:
    """Whether a function takes one: that is asked of the same code at each call written."""
    code = getattr(function, "__code__", None)
    if code is None or hasattr(function, "__wrapped__") or hasattr(function, "__signature__"):
        return bool(_ask(function))
    if code not in _takes_loc:
        _takes_loc[code] = bool(_ask(function))
    return _takes_loc[code]


@overload(arrayobj.raise_with_shape_context, target="carom", strict=False)
def _say_little_of_shapes(src_shapes: Any, index_shape: Any) -> Any:
    """Where an array is put into a slice of another shape numba's error tells both, as texts put together
    by kernels of their own: these took as long as the largest of ours. Without them it says that they differ.
    """
    return arrayobj.ol_raise_with_shape_context_generic(src_shapes, index_shape)

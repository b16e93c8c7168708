"""Things that numba's compiler does ten thousands of times, done at once.

To find the types of a kernel numba goes round its statements until nothing changes, and asks each time
anew what, say, a float plus an integer gives: it tries some sixty rules for ``+``, most of them for texts,
sets and dates, and for each looks up whether that rule has been compiled under the flags in force, which
are compared option by option. It lists the variables of a statement by walking through all that hangs on it,
and after each of nine passes finds out where every variable is needed last, which is used after one of them.
And it tells of each time that LLVM is locked. Together that was a quarter of the time that a scene's kernels
compile in.

`answer_at_once` lets the operators on plain numbers, and on elements of arrays, remember what they answered,
compares flags as dictionaries, passes over what can have no variable in it, finds lifetimes when they are
asked for, tells nobody of locks, and puts no shapes into words. The answers are numba's own, so the machine
code is the same. What a later numba has moved is left as it is.
"""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import Any

import llvmlite.binding as llvm
from numba.core import base as contexts
from numba.core import ir, postproc, targetconfig, transforms, types
from numba.core.types.containers import BaseAnonymousTuple
from numba.core.types.functions import BaseFunction
from numba.core.typing import context as typing_contexts
from numba.core.typing.templates import builtin_registry
from numba.np import arrayobj

_PLAIN = (types.Number, types.Boolean)
_ELEMENT = (types.Array, *_PLAIN)
_OF_ELEMENTS = frozenset((operator.getitem, operator.setitem))
_answers: dict[
    int, tuple[Any, dict[Any, Any]]
] = {}  # by a function type's identity, which the entry keeps alive


def _is_number(kind: Any) -> bool:
    return isinstance(kind, _PLAIN)


def _is_element(kind: Any) -> bool:
    """An array, a number, or a tuple of numbers: what elements of arrays are read and written by."""
    if isinstance(kind, BaseAnonymousTuple):
        return all(isinstance(part, _PLAIN) for part in kind)
    return isinstance(kind, _ELEMENT)


def answer_at_once() -> None:
    """Take these short cuts, once in a process; a second call changes nothing."""
    if getattr(BaseFunction.get_call_type, "__module__", __name__) != __name__:
        _remember_operators()
        _compare_flags_whole()
        _list_variables_only()
        _find_lifetimes_once()
        _tell_nobody_of_locks()
        _refresh_when_there_is_more()
        _look_at_signatures_once()
        _say_little_of_shapes()


def _remember_operators() -> None:
    ask = BaseFunction.get_call_type

    def get_call_type(self: Any, context: Any, args: Any, kws: Any) -> Any:
        is_plain = _is_element if self.typing_key in _OF_ELEMENTS else _is_number
        if kws or not all(map(is_plain, args)):
            return ask(self, context, args, kws)
        answers = _answers.setdefault(id(self), (self, {}))[1]
        question = (context, tuple(args))
        signature = answers.get(question)
        if signature is None:
            signature = ask(self, context, args, kws)
            # Only rules that numba has built in: what an overload was compiled to depends on the flags.
            if signature is not None and self.get_impl_key(signature) is self.typing_key:
                answers[question] = signature
        return signature

    setattr(BaseFunction, "get_call_type", get_call_type)  # noqa: B010 (no plain assignment to a method)


def _compare_flags_whole() -> None:
    config = targetconfig.TargetConfig
    if not hasattr(config, "options") or "_values" not in getattr(config, "__slots__", ()):
        return
    defaults: dict[type, dict[str, Any]] = {}

    def values(self: Any) -> dict[str, Any]:
        mine = defaults.get(type(self))
        if mine is None:
            mine = defaults[type(self)] = {name: option.default for name, option in self.options.items()}
        return {**mine, **self._values}

    def equal(self: Any, other: object) -> Any:
        if self is other:
            return True
        return values(self) == values(other) if isinstance(other, config) else NotImplemented

    config.values = values
    config.__eq__ = equal
    config.__hash__ = lambda self: hash(type(self))  # as before: the names of all options, not their values


def _list_variables_only() -> None:
    if not hasattr(ir.Inst, "_rec_list_vars"):
        return
    bare = {str, int, bool, float, type(None), ir.Loc, ir.Const, ir.Global, ir.FreeVar, ir.Arg}

    def gather(value: Any, found: list[ir.Var]) -> None:
        kind = type(value)
        if kind is ir.Var:
            found.append(value)
        elif kind is dict:
            gather_all(value.values(), found)
        elif kind is list or kind is tuple:
            gather_all(value, found)
        elif isinstance(value, ir.Var):
            found.append(value)
        elif isinstance(value, ir.Inst):
            found.extend(value.list_vars())
        elif isinstance(value, dict):
            gather_all(value.values(), found)
        elif isinstance(value, list | tuple):
            gather_all(value, found)
        else:
            bare.add(kind)  # the next of its kind is none of these either

    def gather_all(values: Iterable[Any], found: list[ir.Var]) -> None:
        for value in values:
            kind = type(value)
            if kind is ir.Var:
                found.append(value)
            elif kind not in bare:
                gather(value, found)

    def variables(self: Any, value: Any) -> list[ir.Var]:
        found: list[ir.Var] = []
        gather_all((value,), found)
        return found

    ir.Inst._rec_list_vars = variables


def _find_lifetimes_once() -> None:
    """Nine passes end by asking where each variable is needed last; the answer is used after one of them."""
    processor = postproc.PostProcessor
    find = processor.run

    def run(self: Any, emit_dels: bool = False, extend_lifetimes: bool = False) -> None:
        code = self.func_ir
        if emit_dels or code.is_generator:
            find(self, emit_dels, extend_lifetimes)
            return
        code.blocks = transforms.canonicalize_cfg(code.blocks)
        code.variable_lifetime = postproc.VariableLifetime(code.blocks)  # finds out when it is asked
        code.generator_info = None

    processor.run = run


def _tell_nobody_of_locks() -> None:
    """numba times how long LLVM is locked, by two objects made at each of a hundred thousand calls of it."""
    lock = getattr(llvm.ffi.lib, "_lock", None)
    for callbacks in list(getattr(lock, "_cblist", ())):
        if callbacks[0].__module__ == "numba.core.base":
            llvm.ffi.unregister_lock_callback(*callbacks)


def _refresh_when_there_is_more() -> None:
    """numba looks for new rules before each kernel, and whenever it finds none; mostly there are no more."""
    for kind, lists in (
        (contexts.BaseContext, ("functions", "getattrs", "setattrs", "casts", "constants")),
        (typing_contexts.BaseContext, ("functions", "attributes", "globals")),
    ):
        kind.refresh = _counting(kind.refresh, lists)


def _counting(refresh: Any, lists: tuple[str, ...]) -> Any:
    def refresh_if_more(self: Any) -> None:
        counted = sum(len(getattr(registry, name)) for registry in self._registries for name in lists)
        if getattr(self, "carom_rules", None) != counted:
            refresh(self)
            self.carom_rules = sum(
                len(getattr(registry, name)) for registry in self._registries for name in lists
            )
        elif hasattr(self, "typing_context"):
            self.typing_context.refresh()

    return refresh_if_more


def _look_at_signatures_once() -> None:
    """Whether a function takes a place in the source: that is asked of the same code at each call written."""
    ask = getattr(contexts, "_has_loc", None)
    if ask is None:
        return
    known: dict[Any, bool] = {}

    def has_loc(function: Any) -> bool:
        code = getattr(function, "__code__", None)
        if code is None or hasattr(function, "__wrapped__") or hasattr(function, "__signature__"):
            return bool(ask(function))
        if code not in known:
            known[code] = bool(ask(function))
        return known[code]

    setattr(contexts, "_has_loc", has_loc)  # noqa: B010 (no plain assignment to a function)


def _say_little_of_shapes() -> None:
    """Where an array is put into a slice of another shape numba's error tells both, as texts put together
    by kernels of their own: these took as long as the largest of ours. Without them it says that they differ.
    """
    brief = getattr(arrayobj, "ol_raise_with_shape_context_generic", None)
    for rule in builtin_registry.functions:
        written = getattr(rule, "_overload_func", None)
        if brief is not None and getattr(written, "__name__", "") == "ol_raise_with_shape_context_cpu":
            rule._overload_func = staticmethod(brief)

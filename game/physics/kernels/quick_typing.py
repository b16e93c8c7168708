"""Three things that numba's compiler does ten thousands of times, done at once.

To find the types of a kernel numba goes round its statements until nothing changes, and asks each time
anew what, say, a float plus an integer gives: it tries some sixty rules for ``+``, most of them for texts,
sets and dates, and for each looks up whether that rule has been compiled under the flags in force, which
are compared option by option. And it lists the variables of a statement by walking through all that hangs on
it. Together that was a fifth of the time that a scene's kernels compile in.

`answer_at_once` lets the operators on plain numbers remember what they answered, compares flags as
dictionaries, and passes over what can have no variable in it. The answers are numba's own, so the machine
code is the same. What a later numba has moved is left as it is.
"""

from __future__ import annotations

from typing import Any

from numba.core import ir, targetconfig, types
from numba.core.types.functions import BaseFunction

_PLAIN = (types.Number, types.Boolean)
_answers: dict[
    int, tuple[Any, dict[Any, Any]]
] = {}  # by a function type's identity, which the entry keeps alive


def answer_at_once() -> None:
    """Take these short cuts, once in a process; a second call changes nothing."""
    if getattr(BaseFunction.get_call_type, "__module__", __name__) != __name__:
        _remember_operators()
        _compare_flags_whole()
        _list_variables_only()


def _remember_operators() -> None:
    ask = BaseFunction.get_call_type

    def get_call_type(self: Any, context: Any, args: Any, kws: Any) -> Any:
        if kws or not all(isinstance(kind, _PLAIN) for kind in args):
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
    bare = frozenset((str, int, bool, float, type(None), ir.Loc))

    def variables(self: Any, value: Any) -> list[ir.Var]:
        kind = type(value)
        if kind in bare:
            return []
        if isinstance(value, ir.Var):
            return [value]
        if isinstance(value, ir.Inst):
            return list(value.list_vars())
        if isinstance(value, dict):
            value = value.values()
        elif not isinstance(value, list | tuple):
            return []
        return [found for part in value if type(part) not in bare for found in variables(self, part)]

    ir.Inst._rec_list_vars = variables

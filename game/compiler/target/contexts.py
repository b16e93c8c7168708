"""What Carom's kernels are typed and written in: contexts of numba's, under a name of their own.

numba keeps the rules of typing and the forms of values in two contexts for each target. These two begin with
all that numba's processor target has, as a later rule of another package is known here too. What Carom adds
is known here alone.
"""

from __future__ import annotations

import operator
import os
from functools import cache
from typing import Any
from weakref import WeakKeyDictionary

from numba import types
from numba.core.cpu import CPUContext
from numba.core.datamodel import default_manager
from numba.core.datamodel.manager import DataModelManager
from numba.core.registry import CPUTarget, cpu_target
from numba.core.runtime import rtsys
from numba.core.target_extension import CPU, dispatcher_registry, target_override, target_registry
from numba.core.typing.context import Context

from game.compiler.target.bundles import ArrayModel, NamedTupleModel, NamedUniTupleModel
from game.compiler.target.entries import EntryAPI
from game.compiler.target.short_cuts import Answers, count_rules

NAME = "carom"
# numba tells two functions of one name apart, as two closures over different integers, by a number that it
# counts up from 1 in each process. Kept code of two processes then has one name for different functions, and
# a kernel that calls both would call one of them twice. So each process counts from a place of its own.
_FIRST_NUMBER = int.from_bytes(os.urandom(6), "little") << 14


class Kernels(CPU):
    """Carom's target: this processor."""


target_registry[NAME] = Kernels
_twins: WeakKeyDictionary[Any, Any] = WeakKeyDictionary()  # of functions of numba's own target


def as_ours(kind: Any) -> Any:
    """A type; for that of a function compiled for numba's own target, the type of the same one for Carom's.

    A kernel of Carom's that comes in as an argument has numba's type, as it would anywhere.
    """
    if type(kind) is not types.Dispatcher or kind.dispatcher.targetdescr is not cpu_target:
        return kind
    given = kind.dispatcher
    twin = getattr(given, "carom_kernel", None) or _twins.get(given)
    if twin is None:
        own = dispatcher_registry[Kernels]
        twin = _twins[given] = own(given.py_func, locals=given.locals, targetoptions=given.targetoptions)
    return types.Dispatcher(twin.called)


class KernelTyping(Context):
    """Types of Carom's kernels."""

    def init(self) -> None:
        """Begin with no answers."""
        self._answers = Answers()
        self._counted = -1
        super().init()

    def install_registry(self, registry: Any) -> None:
        """Take rules over, those for Carom's target among them."""
        with target_override(NAME):
            super().install_registry(registry)

    def refresh(self) -> None:
        """Look for new rules, if there are more than the last time."""
        if count_rules(self._registries, ("functions", "attributes", "globals")) != self._counted:
            super().refresh()
            self._counted = count_rules(self._registries, ("functions", "attributes", "globals"))

    def resolve_value_type(self, val: Any) -> Any:
        """The type of a constant; of another target's function, that of its twin here."""
        if getattr(val, "targetdescr", None) is target:
            return types.Dispatcher(val.called)
        return as_ours(super().resolve_value_type(val))

    def resolve_function_type(self, func: Any, args: Any, kws: Any) -> Any:
        """The signature of a call."""
        if isinstance(func, types.BaseFunction):
            known = self._answers.ask(func, self, args, kws)
            if known is not None:
                return known
        return super().resolve_function_type(as_ours(func), args, kws)

    def call_type(self, func: Any, args: Any) -> Any:
        """The signature of a call of an operator; as its own ``get_call_type``, and remembered."""
        return self._answers.ask(func, self, args, {}) or func.get_call_type(self, args, {})

    def resolve_setitem(self, target: Any, index: Any, value: Any) -> Any:
        """The signature of an assignment to an element."""
        return self.call_type(self.resolve_value_type(operator.setitem), (target, index, value))


class KernelContext(CPUContext):
    """How values of Carom's kernels are laid out, and the code of what is done with them."""

    def __init__(self, typing: KernelTyping, target: str):
        self._counted = -1
        super().__init__(typing, target)

    def init(self) -> None:
        """Begin with numba's layouts and those of Carom."""
        super().init()
        self.data_model_manager = _layouts()

    def refresh(self) -> None:
        """Look for new rules, if there are more than the last time."""
        lists = ("functions", "getattrs", "setattrs", "casts", "constants")
        if count_rules(self._registries, lists) == self._counted:
            self.typing_context.refresh()
            return
        super().refresh()
        self._counted = count_rules(self._registries, lists)

    def load_additional_registries(self) -> None:
        """Take over all that numba has for this processor; its memory's functions are compiled as its own."""
        rtsys.initialize(cpu_target.target_context)
        super().load_additional_registries()

    def mangler(self, name: str, types: Any, *, abi_tags: Any = (), uid: Any = None) -> str:
        """The name of a function in the code, no other process's."""
        number = None if uid is None else _FIRST_NUMBER + uid
        return str(super().mangler(name, types, abi_tags=abi_tags, uid=number))

    def get_function(self, fn: Any, sig: Any, _firstcall: bool = True) -> Any:
        """The code of a call."""
        return super().get_function(as_ours(fn), sig, _firstcall)

    def get_python_api(self, builder: Any) -> EntryAPI:
        """What is written to talk with Python."""
        return EntryAPI(self, builder)


@cache
def _layouts() -> DataModelManager:
    """How values are laid out: as numba has it, but for arrays and large tuples as arguments."""
    layouts = DataModelManager().chain(default_manager)
    layouts.register(types.Array, ArrayModel)
    layouts.register(types.NamedTuple, NamedTupleModel)
    layouts.register(types.NamedUniTuple, NamedUniTupleModel)
    return layouts


class KernelTarget(CPUTarget):
    """Where dispatchers find the two contexts, which are made when they are asked for."""

    def __init__(self) -> None:
        super().__init__(NAME)
        self._typing: KernelTyping | None = None
        self._writing: KernelContext | None = None

    @property
    def typing_context(self) -> KernelTyping:
        """Types of Carom's kernels."""
        if self._typing is None:
            self._typing = KernelTyping()
        return self._typing

    @property
    def target_context(self) -> KernelContext:
        """Code of Carom's kernels."""
        if self._writing is None:
            self._writing = KernelContext(self.typing_context, NAME)
        return self._writing


target = KernelTarget()

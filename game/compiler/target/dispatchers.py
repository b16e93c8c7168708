"""Carom's kernels to Python, and their meeting with other packages' functions.

To Python a kernel is a dispatcher of numba's, compiled for Carom's target. To a function of another package,
which numba compiles for its own target, it is a plain function of numba's: its Python source, compiled once
more as that package's own code. So two ways to hand over arguments never meet. The other way round, a
function of another package that a kernel calls is compiled once more for Carom's target (see `as_ours`).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numba
from numba import types
from numba.core.compiler import Compiler
from numba.core.compiler_lock import global_compiler_lock
from numba.core.dispatcher import Dispatcher
from numba.core.target_extension import dispatcher_registry, jit_registry, target_override

from game.compiler.target.contexts import NAME, Kernels, target
from game.compiler.target.linking import InnerCompiler, OuterCompiler
from game.compiler.target.short_cuts import QuickFlags, short_cuts

_OPTIONS_OF_NUMBA = ("inline", "boundscheck", "error_model", "nogil")  # that its own target gets as well


class TargetDispatcher(Dispatcher):
    """A function for Carom's target."""

    targetdescr = target
    _cache: Any
    _compiler: Any

    def __init__(
        self, py_func: Any, locals: Any = None, targetoptions: Any = None, pipeline_class: Any = Compiler
    ):
        super().__init__(py_func, locals, targetoptions, pipeline_class)
        self._compiler._customize_flags = QuickFlags
        self._plain: Any = None

    @property
    def called(self) -> TargetDispatcher:
        """The dispatcher that other functions of this target call."""
        return self

    @property
    def _numba_type_(self) -> Any:
        return types.Dispatcher(self.plain)

    @property
    def plain(self) -> Any:
        """The same function for numba's own target."""
        if self._plain is None:
            options = {
                name: self.targetoptions[name] for name in _OPTIONS_OF_NUMBA if name in self.targetoptions
            }
            self._plain = numba.njit(**options)(self.py_func)
            self._plain.carom_kernel = self
        return self._plain

    def compile(self, sig: Any) -> Any:
        """Compile for argument types, or take from where it is kept; no other thread compiles meanwhile."""
        if sig in self.overloads:
            return self.overloads[sig].entry_point
        with global_compiler_lock, target_override(NAME), short_cuts:
            return super().compile(sig)

    def add_overload(self, cres: Any) -> None:
        """Take compiled code, without the statements and types that it was made of.

        numba keeps them for `inspect_types`: an eighth of the memory that a process takes as it compiles.
        """
        super().add_overload(cres._replace(type_annotation=""))


class KernelDispatcher(TargetDispatcher):
    """A kernel."""

    def __init__(
        self, py_func: Any, locals: Any = None, targetoptions: Any = None, pipeline_class: Any = None
    ):
        is_inner = bool((targetoptions or {}).get("no_cfunc_wrapper"))
        pipeline = pipeline_class or (InnerCompiler if is_inner else OuterCompiler)
        super().__init__(py_func, locals, targetoptions, pipeline)
        self._is_shut = bool(self.targetoptions.get("no_cpython_wrapper"))
        self.make_inner: Callable[[], KernelDispatcher] | None = None  # set where the kernel may be one
        self._inner: KernelDispatcher | None = None

    @property
    def called(self) -> KernelDispatcher:
        """The dispatcher that other kernels call.

        For most it is an inner kernel of the same function. Machine code of its own and an entry for Python
        are made only when Python calls. A kernel that calls itself calls the one that compiles.
        """
        if self.make_inner is None or self.is_compiling:
            return self
        if self._inner is None:
            self._inner = self.make_inner()
        return self._inner

    def get_call_template(self, args: Any, kws: Any) -> Any:
        """The rule by which a call of the kernel is typed, the same for a constant as for a variable.

        For numba ``f(a, 0)`` is another signature than ``f(a, i)``, and all that f calls is compiled once
        more for it. The optimiser puts the constant in anyway where that is worth something.
        """
        plain = {name: types.unliteral(kind) for name, kind in dict(kws).items()}
        return super().get_call_template(tuple(types.unliteral(kind) for kind in args), plain)

    def add_overload(self, cres: Any) -> None:
        """Take compiled code; no call from Python reaches code that has no entry for it."""
        if self._is_shut:
            self.overloads[tuple(cres.signature.args)] = cres._replace(type_annotation="")
        else:
            super().add_overload(cres)

    def _compile_for_args(self, *args: Any, **kws: Any) -> Any:
        if self._is_shut:
            raise TypeError(f"{self.py_func.__name__}: an inner kernel, which only other kernels can call")
        return super()._compile_for_args(*args, **kws)  # type: ignore[misc]


dispatcher_registry[Kernels] = TargetDispatcher
jit_registry[Kernels] = partial(numba.jit, _target=NAME)

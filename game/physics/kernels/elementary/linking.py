"""The elementary functions as symbols that machine code calls by name, as it would call the C library's.

Kernels that inlined them would all be compiled with a copy, as numba hands a callee's code on to each caller.
So each is compiled once, and its address is made known to LLVM before any kernel is compiled or taken from
the disk (`make_known`). Calls are marked as free of side effects, so that loops keep what they hold.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import llvmlite.binding
from llvmlite import ir
from numba import config, types
from numba.core import cgutils
from numba.core.compiler_lock import global_compiler_lock
from numba.core.typing import signature
from numba.extending import lower_builtin, type_callable

from game.compiler.tried import is_plain

if not is_plain():
    from game.compiler.target.kept import BEFORE_LOADING

PREFIX = "carom_"
_functions: dict[str, tuple[Any, int]] = {}  # by name: dispatcher, number of arguments
_begun: set[str] = set()
_known: set[str] = set()


def linked(name: str, count: int, function: Callable[..., float]) -> Callable[..., float]:
    """What kernels call for a linked kernel of ``count`` floats: a symbol, or itself if kernels are plain."""
    if config.DISABLE_JIT or is_plain():
        return function

    def symbol(*_arguments: float) -> float:
        raise TypeError(f"{name}: a symbol, which only kernels can call")

    doubles = [types.float64] * count
    kind = ir.FunctionType(ir.DoubleType(), [ir.DoubleType()] * count)

    @type_callable(symbol)
    def type_symbol(_context: Any) -> Callable[..., Any]:
        make_known(name)
        return (
            (lambda x: signature(types.float64, *doubles))
            if count == 1
            else (lambda x, y: signature(types.float64, *doubles))
        )

    @lower_builtin(symbol, *doubles)
    def lower_symbol(_context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        callee = cgutils.get_or_insert_function(builder.module, kind, PREFIX + name)
        callee.attributes.add("nounwind")
        callee.attributes.add("readnone")
        return builder.call(callee, arguments)

    _functions[name] = function, count
    return symbol


def make_known(name: str) -> None:
    """Compile a function, or take it from the disk, and tell LLVM where it is; once in a process."""
    if name in _known or name not in _functions:
        return
    with global_compiler_lock:
        if name in _known or name in _begun:  # by another thread before, or compiling it asks for itself
            return
        _begun.add(name)
        try:
            dispatcher, count = _functions[name]
            doubles = (types.float64,) * count
            dispatcher.compile(doubles)
            result = dispatcher.overloads[doubles]
            address = result.library.get_pointer_to_function(result.fndesc.llvm_cfunc_wrapper_name)
            llvmlite.binding.add_symbol(PREFIX + name, address)
            _known.add(name)
        finally:
            _begun.discard(name)


def known() -> set[str]:
    """Names of the functions whose addresses LLVM knows by now."""
    return set(_known)


def make_symbol_known(symbol: str) -> None:
    """The same for a symbol that machine code calls; nothing for one that is not of these."""
    if symbol.startswith(PREFIX):
        make_known(symbol.removeprefix(PREFIX))


if not is_plain():
    BEFORE_LOADING.append(make_symbol_known)

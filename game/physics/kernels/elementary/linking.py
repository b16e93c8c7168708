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

from game.physics.kernels import jit_cache

PREFIX = "carom_"
_waiting: dict[str, tuple[Any, int]] = {}  # by name: dispatcher, number of arguments


def linked(name: str, count: int, function: Callable[..., float]) -> Callable[..., float]:
    """What kernels call for a linked kernel of ``count`` floats: a symbol; itself if nothing is compiled."""
    if config.DISABLE_JIT:
        return function

    def symbol(*_arguments: float) -> float:
        raise TypeError(f"{name}: a symbol, which only kernels can call")

    doubles = [types.float64] * count
    kind = ir.FunctionType(ir.DoubleType(), [ir.DoubleType()] * count)

    @type_callable(symbol)
    def type_symbol(_context: Any) -> Callable[..., Any]:
        make_known()
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

    _waiting[name] = function, count
    return symbol


def make_known() -> None:
    """Compile the functions, or take them from the disk, and tell LLVM where they are; once in a process."""
    if not _waiting:
        return
    with global_compiler_lock:
        found = dict(_waiting)
        _waiting.clear()  # loading them asks for this again
        for name, (dispatcher, count) in found.items():
            doubles = (types.float64,) * count
            dispatcher.compile(doubles)
            result = dispatcher.overloads[doubles]
            address = result.library.get_pointer_to_function(result.fndesc.llvm_cfunc_wrapper_name)
            llvmlite.binding.add_symbol(PREFIX + name, address)


jit_cache.BEFORE_LOADING.append(make_known)

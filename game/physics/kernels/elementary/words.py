"""A float64 as the word of its bits, and back, in kernels and in plain Python alike."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import lower_builtin, type_callable

EXPONENT_BIAS = 1023
MANTISSA_BITS = 52
_DOUBLE = struct.Struct("<d")
_WORD = struct.Struct("<q")


def bits_of(x: float) -> int:
    """The 64 bits of a float as a signed integer."""
    return int(_WORD.unpack(_DOUBLE.pack(x))[0])


def from_bits(word: int) -> float:
    """The float that has these 64 bits, given as a signed integer."""
    return float(_DOUBLE.unpack(_WORD.pack(word))[0])


@type_callable(bits_of)
def _type_bits_of(_context: Any) -> Callable[[Any], Any]:
    return lambda x: types.int64 if x == types.float64 else None


@type_callable(from_bits)
def _type_from_bits(_context: Any) -> Callable[[Any], Any]:
    return lambda word: types.float64 if isinstance(word, types.Integer) else None


@lower_builtin(bits_of, types.float64)
def _lower_bits_of(_context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
    return builder.bitcast(arguments[0], ir.IntType(64))


@lower_builtin(from_bits, types.Integer)
def _lower_from_bits(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
    word = context.cast(builder, arguments[0], signature.args[0], types.int64)
    return builder.bitcast(word, ir.DoubleType())

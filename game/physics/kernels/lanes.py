"""Numbers side by side: eight of them in one vector, for kernels that do the same to many things.

numba goes number by number where a loop asks and chooses; written with lanes, eight go through at once. Each
lane gets what a plain float would get from the same operations, bit for bit: + - * / are those of IEEE 754 in
every lane, nothing is fused, and `larger` and `smaller` say what max and min say. A processor with shorter
vectors takes several of them.

Lanes are a type of numba's: ``+ - * /`` and comparisons work among them and with floats. Where a kernel would
branch, it makes both and takes `choose`. Without compilation lanes are arrays of numpy.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from llvmlite import ir
from numba import config, types
from numba.core import cgutils
from numba.core.datamodel import models
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, register_model

LANES = 8
QUAD = 4
_DOUBLE, _INT = ir.DoubleType(), ir.IntType(32)
_VECTOR, _QUAD = ir.VectorType(_DOUBLE, LANES), ir.VectorType(_DOUBLE, QUAD)
_BITS = ir.VectorType(ir.IntType(1), LANES)


class LanesType(types.Type):
    """LANES floats."""

    def __init__(self) -> None:
        super().__init__(name="lanes")


class MaskType(types.Type):
    """LANES answers, true or false."""

    def __init__(self) -> None:
        super().__init__(name="mask")


lanes, mask = LanesType(), MaskType()


@register_model(LanesType)
class _LanesModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _VECTOR)


@register_model(MaskType)
class _MaskModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _BITS)


def _spread(builder: Any, value: Any) -> Any:
    """A number in all lanes; lanes as they are."""
    if value.type == _VECTOR:
        return value
    nothing = ir.Constant(_VECTOR, ir.Undefined)
    first = builder.insert_element(nothing, value, ir.Constant(_INT, 0))
    return builder.shuffle_vector(first, nothing, ir.Constant(ir.VectorType(_INT, LANES), [0] * LANES))


def _let(symbol: Any, result: Any, make: Callable[[Any, Any, Any], Any]) -> None:
    """Let an operator work on lanes, and on lanes and floats."""
    pairs = [(lanes, lanes), (lanes, types.float64), (types.float64, lanes)]

    class Rule(ConcreteTemplate):
        cases = [signature(result, *pair) for pair in pairs]

    infer_global(symbol)(Rule)
    for pair in pairs:

        @lower_builtin(symbol, *pair)
        def lower(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return make(builder, *(_spread(builder, value) for value in args))


def _arithmetic(name: str, builder: Any, a: Any, b: Any) -> Any:
    return getattr(builder, name)(a, b)


def _comparison(sign: str, builder: Any, a: Any, b: Any) -> Any:
    return builder.fcmp_ordered(sign, a, b)


for _name, _also in (("add", "iadd"), ("sub", "isub"), ("mul", "imul"), ("truediv", "itruediv")):
    for _symbol in (_name, _also):
        _instruction = {"truediv": "fdiv"}.get(_name, f"f{_name}")
        _let(getattr(operator, _symbol), lanes, partial(_arithmetic, _instruction))
for _name, _sign in (("gt", ">"), ("ge", ">="), ("lt", "<"), ("le", "<=")):
    _let(getattr(operator, _name), mask, partial(_comparison, _sign))


@infer_global(operator.neg)
class _Negative(ConcreteTemplate):
    cases = [signature(lanes, lanes)]


@lower_builtin(operator.neg, lanes)
def _lower_negative(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
    return builder.fneg(args[0])


@infer_global(operator.and_)
class _Both(ConcreteTemplate):
    cases = [signature(mask, mask, mask)]


@lower_builtin(operator.and_, mask, mask)
def _lower_both(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
    return builder.and_(*args)


def _is_lanes_or_float(kind: Any) -> bool:
    return isinstance(kind, LanesType) or kind == types.float64


@intrinsic
def _choose(typing_context: Any, which: Any, one: Any, other: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.select(args[0], _spread(builder, args[1]), _spread(builder, args[2]))

    if isinstance(which, MaskType) and _is_lanes_or_float(one) and _is_lanes_or_float(other):
        return lanes(which, one, other), generate
    return None


def _extreme(sign: str) -> Any:
    @intrinsic
    def extreme(typing_context: Any, one: Any, other: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            a, b = (_spread(builder, value) for value in args)
            return builder.select(builder.fcmp_ordered(sign, b, a), b, a)

        if _is_lanes_or_float(one) and _is_lanes_or_float(other):
            return lanes(one, other), generate
        return None

    return extreme


@intrinsic
def _either(typing_context: Any, one: Any, other: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.or_(*args)

    return mask(mask, mask), generate


@intrinsic
def _root(typing_context: Any, value: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kind = ir.FunctionType(_VECTOR, [_VECTOR])
        name = f"llvm.sqrt.v{LANES}f64"
        return builder.call(cgutils.get_or_insert_function(builder.module, kind, name), args)

    return lanes(lanes), generate


@intrinsic
def _gather(typing_context: Any, table: Any, width: Any, numbers: Any, at: Any, column: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        data, rows = (_data(context, builder, signature.args[k], args[k]) for k in (0, 2))
        found = ir.Constant(_VECTOR, ir.Undefined)
        for lane, place in enumerate(_places(builder, data, rows, args[3], args[1], args[4])):
            number = builder.load(builder.bitcast(place, _DOUBLE.as_pointer()), align=8)
            found = builder.insert_element(found, number, ir.Constant(_INT, lane))
        return found

    return lanes(table, types.uint64, numbers, types.uint64, types.uint64), generate


@intrinsic
def _any_of(typing_context: Any, which: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        bits = ir.IntType(LANES)
        return builder.icmp_unsigned("!=", builder.bitcast(args[0], bits), ir.Constant(bits, 0))

    return types.boolean(mask), generate


@intrinsic
def _all_of(typing_context: Any, which: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        bits = ir.IntType(LANES)
        every = ir.Constant(bits, (1 << LANES) - 1)
        return builder.icmp_unsigned("==", builder.bitcast(args[0], bits), every)

    return types.boolean(mask), generate


def _data(context: Any, builder: Any, kind: Any, array: Any) -> Any:
    return context.make_array(kind)(context, builder, array).data


@intrinsic
def _load(typing_context: Any, array: Any, at: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        place = builder.gep(_data(context, builder, signature.args[0], args[0]), [args[1]])
        return builder.load(builder.bitcast(place, _VECTOR.as_pointer()), align=8)

    return lanes(array, types.uint64), generate


@intrinsic
def _store(typing_context: Any, array: Any, at: Any, value: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        place = builder.gep(_data(context, builder, signature.args[0], args[0]), [args[1]])
        builder.store(args[2], builder.bitcast(place, _VECTOR.as_pointer()), align=8)
        return context.get_dummy_value()

    return types.void(array, types.uint64, lanes), generate


@intrinsic
def _fetch(typing_context: Any, array: Any, at: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        place = builder.gep(_data(context, builder, signature.args[0], args[0]), [args[1]])
        byte, flags = ir.IntType(8).as_pointer(), [ir.Constant(_INT, number) for number in (0, 3, 1)]
        kind = ir.FunctionType(ir.VoidType(), [byte, _INT, _INT, _INT])
        known = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0i8")
        builder.call(known, [builder.bitcast(place, byte), *flags])  # to read, often, data
        return context.get_dummy_value()

    return types.void(array, types.uint64), generate


@intrinsic
def _zeros(typing_context: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return ir.Constant(_VECTOR, [0.0] * LANES)

    return lanes(), generate


def _swap_blocks(builder: Any, rows: list[Any]) -> list[Any]:
    """Four vectors in the place of which each block of four by four is turned over: rows become columns."""
    size = rows[0].type.count
    rows = list(rows)
    for step in (1, 2):
        low = [k if not k & step else size + k - step for k in range(size)]
        high = [k + step if not k & step else size + k for k in range(size)]
        kind = ir.VectorType(_INT, size)
        for i in (k for k in range(QUAD) if not k & step):
            one, other = rows[i], rows[i + step]
            rows[i] = builder.shuffle_vector(one, other, ir.Constant(kind, low))
            rows[i + step] = builder.shuffle_vector(one, other, ir.Constant(kind, high))
    return rows


def _places(builder: Any, data: Any, numbers: Any, at: Any, width: Any, column: Any) -> list[Any]:
    """Where in a table the four columns from ``column`` on begin, for each of the rows numbers[at + lane]."""
    found = []
    for lane in range(LANES):
        place = builder.gep(numbers, [builder.add(at, ir.Constant(ir.IntType(64), lane))])
        row = builder.zext(builder.load(place), ir.IntType(64))
        start = builder.add(builder.mul(row, width), column)
        found.append(builder.bitcast(builder.gep(data, [start]), _QUAD.as_pointer()))
    return found


@intrinsic
def _load_quads(typing_context: Any, table: Any, width: Any, numbers: Any, at: Any, column: Any) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        data, rows = (_data(context, builder, signature.args[k], args[k]) for k in (0, 2))
        quads = [
            builder.load(place, align=8) for place in _places(builder, data, rows, args[3], args[1], args[4])
        ]
        if LANES > QUAD:
            whole = ir.Constant(ir.VectorType(_INT, LANES), list(range(LANES)))
            quads = [builder.shuffle_vector(quads[k], quads[k + QUAD], whole) for k in range(QUAD)]
        return context.make_tuple(builder, signature.return_type, _swap_blocks(builder, quads))

    kind = types.UniTuple(lanes, QUAD)
    return kind(table, types.uint64, numbers, types.uint64, types.uint64), generate


@intrinsic
def _store_quads(
    typing_context: Any, table: Any, width: Any, numbers: Any, at: Any, column: Any, values: Any
) -> Any:
    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        data, rows = (_data(context, builder, signature.args[k], args[k]) for k in (0, 2))
        quads = _swap_blocks(builder, [builder.extract_value(args[5], k) for k in range(QUAD)])
        places = _places(builder, data, rows, args[3], args[1], args[4])
        for lane in reversed(range(LANES)):
            part = list(range(lane // QUAD * QUAD, lane // QUAD * QUAD + QUAD))
            row = quads[lane % QUAD]
            if LANES > QUAD:
                row = builder.shuffle_vector(row, row, ir.Constant(ir.VectorType(_INT, QUAD), part))
            builder.store(row, places[lane], align=8)
        return context.get_dummy_value()

    kind = types.UniTuple(lanes, QUAD)
    return types.void(table, types.uint64, numbers, types.uint64, types.uint64, kind), generate


def _load_plainly(array: Any, at: Any) -> Any:
    """The lanes at ``at`` of an array, counted through all of it."""
    return array.reshape(-1)[int(at) : int(at) + LANES].copy()


def _store_plainly(array: Any, at: Any, value: Any) -> None:
    """Write lanes to ``at`` of an array, counted through all of it."""
    array.reshape(-1)[int(at) : int(at) + LANES] = value


def _fetch_plainly(array: Any, at: Any) -> None:
    """Bring the line of memory that has the number at ``at`` of an array nearer, to be read before long."""


def _gather_plainly(table: Any, width: Any, numbers: Any, at: Any, column: Any) -> Any:
    """A column of the rows numbers[at + lane] of a table of ``width`` columns."""
    rows = numbers.reshape(-1)[int(at) : int(at) + LANES]
    return table.reshape(-1)[rows * int(width) + int(column)]


def _load_quads_plainly(table: Any, width: Any, numbers: Any, at: Any, column: Any) -> Any:
    """Four columns from ``column`` on of the rows numbers[at + lane] of a table of ``width`` columns.

    numbers: int32, not negative, counted through all of the array.
    """
    rows = numbers.reshape(-1)[int(at) : int(at) + LANES]
    return tuple(table[rows, int(column) + k] for k in range(QUAD))


def _store_quads_plainly(table: Any, width: Any, numbers: Any, at: Any, column: Any, values: Any) -> None:
    """Write what `load_quads` reads. Where several lanes name a row, the first one's values stay."""
    rows = numbers.reshape(-1)[int(at) : int(at) + LANES]
    for lane in reversed(range(LANES)):
        table[rows[lane], int(column) : int(column) + QUAD] = [value[lane] for value in values]


if config.DISABLE_JIT:
    choose: Any = np.where
    larger: Any = lambda one, other: np.where(other > one, other, one)  # noqa: E731
    smaller: Any = lambda one, other: np.where(other < one, other, one)  # noqa: E731
    either: Any = np.logical_or
    root: Any = np.sqrt
    any_of: Any = np.any
    zeros: Any = lambda: np.zeros(LANES)  # noqa: E731
    all_of: Any = np.all
    load, store, fetch = _load_plainly, _store_plainly, _fetch_plainly
    gather, load_quads, store_quads = _gather_plainly, _load_quads_plainly, _store_quads_plainly
else:
    choose, larger, smaller = _choose, _extreme(">"), _extreme("<")
    any_of, all_of, zeros, load, store, fetch = _any_of, _all_of, _zeros, _load, _store, _fetch
    either, root, gather, load_quads, store_quads = _either, _root, _gather, _load_quads, _store_quads

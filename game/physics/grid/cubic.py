"""Cubic interpolation in vector instructions, bit for bit what the plain functions beside it say.

numba's own loops go number by number here: four neighbours, or four fields of a point, at once take a third
of the time. Every sum is made in the order that the plain functions give it, so all processors agree.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import config, types
from numba.extending import intrinsic

_DOUBLE, _INT = ir.DoubleType(), ir.IntType(32)
_PAIR, _FOUR = ir.VectorType(_DOUBLE, 2), ir.VectorType(_DOUBLE, 4)


def _all(value: float) -> ir.Constant:
    return ir.Constant(_FOUR, [value] * 4)


def _pick(builder: Any, one: Any, other: Any, places: tuple[int, ...]) -> Any:
    """Lanes of two vectors, counted through both."""
    return builder.shuffle_vector(one, other, ir.Constant(ir.VectorType(_INT, 4), list(places)))


def _spread(builder: Any, value: Any, lanes: int) -> Any:
    """A number in all lanes."""
    nothing = ir.Constant(ir.VectorType(_DOUBLE, lanes), ir.Undefined)
    first = builder.insert_element(nothing, value, ir.Constant(_INT, 0))
    return builder.shuffle_vector(first, nothing, ir.Constant(ir.VectorType(_INT, lanes), [0] * lanes))


def _load(builder: Any, data: Any, at: Any, lanes: int = 4) -> Any:
    place = builder.bitcast(builder.gep(data, [at]), ir.VectorType(_DOUBLE, lanes).as_pointer())
    return builder.load(place, align=8)


def weights_of(builder: Any, places: Any) -> tuple[Any, Any]:
    """`cubic_weights` of the two lanes of ``places``, four lanes each."""
    rest = builder.fsub(ir.Constant(_PAIR, [1.0, 1.0]), places)
    near, far = _pick(builder, places, rest, (0, 2, 1, 3)), _pick(builder, places, rest, (2, 0, 3, 1))
    left, right = _pick(builder, places, rest, (0, 0, 1, 1)), _pick(builder, places, rest, (2, 2, 3, 3))
    rise = builder.fadd(_all(1.0), near)
    outer = builder.fdiv(builder.fmul(builder.fmul(rise, left), right), _all(6.0))
    inner = builder.fmul(builder.fmul(_all(0.5), rise), far)
    inner = builder.fmul(inner, _pick(builder, rise, rise, (1, 0, 3, 2)))
    outer = builder.fneg(outer)
    return _pick(builder, outer, inner, (1, 4, 5, 0)), _pick(builder, outer, inner, (3, 6, 7, 2))


def pair_of(builder: Any, one: Any, other: Any) -> Any:
    """Two numbers as a vector."""
    first = builder.insert_element(ir.Constant(_PAIR, ir.Undefined), one, ir.Constant(_INT, 0))
    return builder.insert_element(first, other, ir.Constant(_INT, 1))


def cubic_weights(f: Any) -> Any:
    """Of the four points around a place, f behind the second."""
    g = 1.0 - f
    a, b = (1.0 + f) * f * g / 6.0, (1.0 + g) * f * g / 6.0
    return -b, 0.5 * (1.0 + f) * g * (1.0 + g), 0.5 * (1.0 + g) * f * (1.0 + f), -a


def _cubic_pair_plainly(f: Any, g: Any) -> Any:
    """Weights along x and along y, one after the other."""
    return (*cubic_weights(f), *cubic_weights(g))


@intrinsic
def _cubic_pair_at_once(typing_context: Any, f: Any, g: Any) -> Any:
    """``_cubic_pair_plainly``, with one division instead of four."""
    signature = types.UniTuple(types.float64, 8)(types.float64, types.float64)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        lanes = [
            builder.extract_element(vector, ir.Constant(_INT, k))
            for vector in weights_of(builder, pair_of(builder, *args))
            for k in range(4)
        ]
        return context.make_tuple(builder, signature.return_type, lanes)

    return signature, generate


cubic_pair = _cubic_pair_plainly if config.DISABLE_JIT else _cubic_pair_at_once


def _cubic_sum_plainly(flat: Any, k: Any, row: Any, f: Any, g: Any) -> Any:
    """The bicubic value of sixteen numbers, k the lowest left one, row numbers from one row to the next."""
    (a, b, c, d), (p, q, r, s) = cubic_weights(f), cubic_weights(g)
    k = int(k)
    m, n, o = k + int(row), k + 2 * int(row), k + 3 * int(row)
    outer = p * ((a * flat[k] + d * flat[k + 3]) + (b * flat[k + 1] + c * flat[k + 2]))
    inner = q * ((a * flat[m] + d * flat[m + 3]) + (b * flat[m + 1] + c * flat[m + 2]))
    inner += r * ((a * flat[n] + d * flat[n + 3]) + (b * flat[n + 1] + c * flat[n + 2]))
    outer += s * ((a * flat[o] + d * flat[o + 3]) + (b * flat[o + 1] + c * flat[o + 2]))
    return outer + inner


@intrinsic
def _cubic_sum_at_once(typing_context: Any, flat: Any, k: Any, row: Any, f: Any, g: Any) -> Any:
    """``_cubic_sum_plainly``, a row of four at once."""
    signature = types.float64(flat, types.uint64, types.uint64, types.float64, types.float64)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        array, at, row, f, g = args
        data = context.make_array(signature.args[0])(context, builder, array).data
        return sum_around(builder, data, at, row, pair_of(builder, f, g))

    return signature, generate


def sum_around(builder: Any, data: Any, at: Any, row: Any, places: Any) -> Any:
    """`cubic_sum` for a pair of places within the cell: a row's four products in one vector, then two rows'
    sums side by side, then four.
    """
    x, y = weights_of(builder, places)
    parts = []
    for _ in range(4):
        parts.append(builder.fmul(x, _load(builder, data, at)))
        at = builder.add(at, row)
    low, high = (
        builder.fadd(_pick(builder, one, other, (0, 1, 4, 5)), _pick(builder, one, other, (3, 2, 7, 6)))
        for one, other in (parts[:2], parts[2:])
    )
    rows = builder.fadd(_pick(builder, low, high, (0, 2, 4, 6)), _pick(builder, low, high, (1, 3, 5, 7)))
    rows = builder.fmul(y, rows)
    k0, k1, k2, k3 = (builder.extract_element(rows, ir.Constant(_INT, k)) for k in range(4))
    return builder.fadd(builder.fadd(k0, k3), builder.fadd(k1, k2))


cubic_sum = _cubic_sum_plainly if config.DISABLE_JIT else _cubic_sum_at_once


def _limited_plainly(lanes: int) -> Any:
    def limited(flat: Any, at: Any, one: Any, row: Any, weights: Any, out: Any, first: Any) -> None:
        """out[first : first + lanes]: bicubic values of fields, each kept within the four around the place.

        at: the first field's lowest left of sixteen numbers; one, row: numbers from a point to the next, and
        from a row to the next; weights (8,): `cubic_pair`.
        """
        a, b, c, d, p, q, r, s = weights
        at, one, row, first = int(at), int(one), int(row), int(first)
        for lane in range(lanes):
            e = [[flat[at + lane + j * row + i * one] for i in range(4)] for j in range(4)]
            sums = [(a * e[j][0] + d * e[j][3]) + (b * e[j][1] + c * e[j][2]) for j in range(4)]
            found = (p * sums[0] + s * sums[3]) + (q * sums[1] + r * sums[2])
            around = (e[1][1], e[1][2], e[2][1], e[2][2])
            found = found if found > min(around) else min(around)
            out[first + lane] = found if found < max(around) else max(around)

    return limited


def _limited_at_once(lanes: int) -> Any:
    @intrinsic
    def limited(
        typing_context: Any, flat: Any, at: Any, one: Any, row: Any, weights: Any, out: Any, first: Any
    ) -> Any:
        numbers = types.UniTuple(types.float64, 8)
        signature = types.void(flat, types.uint64, types.uint64, types.uint64, numbers, out, types.uint64)

        def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            array, at, one, row, given, goal, first = args
            data = context.make_array(signature.args[0])(context, builder, array).data
            places = context.make_array(signature.args[5])(context, builder, goal).data
            w = [_spread(builder, builder.extract_value(given, k), lanes) for k in range(8)]
            found = _limited_around(builder, data, (at, one, row), w, lanes)
            goal = builder.bitcast(builder.gep(places, [first]), found.type.as_pointer())
            builder.store(found, goal, align=8)
            return context.get_dummy_value()

        return signature, generate

    return limited


def _limited_around(builder: Any, data: Any, where: tuple[Any, Any, Any], w: list[Any], lanes: int) -> Any:
    """A vector of values, a field a lane."""
    at, one, row = where
    sums, middle = [], []
    for j in range(4):
        place, e = at, []
        for _ in range(4):
            e.append(_load(builder, data, place, lanes))
            place = builder.add(place, one)
        ends = builder.fadd(builder.fmul(w[0], e[0]), builder.fmul(w[3], e[3]))
        within = builder.fadd(builder.fmul(w[1], e[1]), builder.fmul(w[2], e[2]))
        sums.append(builder.fmul(w[4 + j], builder.fadd(ends, within)))
        if j in (1, 2):
            middle += e[1:3]
        at = builder.add(at, row)
    found = builder.fadd(builder.fadd(sums[0], sums[3]), builder.fadd(sums[1], sums[2]))
    low, high = (
        choose(builder, sign, *(choose(builder, sign, *middle[k : k + 2]) for k in (0, 2))) for sign in "<>"
    )
    return choose(builder, "<", choose(builder, ">", found, low), high)


def choose(builder: Any, sign: str, one: Any, other: Any) -> Any:
    """one where it is smaller (or larger), else other."""
    return builder.select(builder.fcmp_ordered(sign, one, other), one, other)


limited_four, limited_eight = map(_limited_plainly if config.DISABLE_JIT else _limited_at_once, (4, 8))

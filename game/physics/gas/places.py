"""Where the gas of a point comes from, x and y side by side in one vector instruction.

For grids that are not periodic. Each exists plainly, too: for runs without compilation, and to be compared
with; the bits are the same.
"""

from __future__ import annotations

import math
from typing import Any

from llvmlite import ir
from numba import config, types
from numba.core import cgutils
from numba.extending import intrinsic

from game.physics.grid.cubic import choose, pair_of

FARTHEST = 1e6  # cells in a step; more, or what is no number, is no displacement at all
_DOUBLE, _INT, _LONG = ir.DoubleType(), ir.IntType(32), ir.IntType(64)
_PAIR, _PLACES = ir.VectorType(_DOUBLE, 2), ir.VectorType(_LONG, 2)


def _both(value: float) -> ir.Constant:
    return ir.Constant(_PAIR, [value, value])


def _load(builder: Any, data: Any, at: Any) -> Any:
    return builder.load(builder.bitcast(builder.gep(data, [at]), _PAIR.as_pointer()), align=8)


def _data(context: Any, builder: Any, kind: Any, array: Any) -> Any:
    return context.make_array(kind)(context, builder, array).data


def _lane(builder: Any, vector: Any, k: int) -> Any:
    return builder.extract_element(vector, ir.Constant(_INT, k))


def _limits(builder: Any, bounds: Any) -> tuple[Any, Any]:
    """Lower and upper ends of both axes from (low x, high x, low y, high y)."""
    low_x, high_x, low_y, high_y = (builder.extract_value(bounds, k) for k in range(4))
    return pair_of(builder, low_x, low_y), pair_of(builder, high_x, high_y)


def _clamp(builder: Any, x: Any, limits: tuple[Any, Any]) -> Any:
    """`clamped`: the lower end for what is no number."""
    return choose(builder, "<", choose(builder, ">", x, limits[0]), limits[1])


def _of_both(builder: Any, name: str, x: Any) -> Any:
    """One of LLVM's functions of both lanes."""
    function = cgutils.get_or_insert_function(builder.module, ir.FunctionType(_PAIR, [_PAIR]), name)
    return builder.call(function, [x])


def _whole(builder: Any, x: Any) -> tuple[Any, Any, Any]:
    """Whole numbers at or below x, as integers, and what is left."""
    below = _of_both(builder, "llvm.floor.v2f64", x)
    places = builder.fptosi(below, _PLACES)
    return places, below, builder.fsub(x, below)


def _origin_plainly(moves: Any, one: Any, other: Any, place: Any, half: Any, bounds: Any) -> Any:
    """Column and row at or below place - half (move + move), within bounds, and the shares beyond them.

    one, other: where the two moves (x, y) begin in moves; place (x, y); bounds: low x, high x, low y, high y.
    """
    one, other = int(one), int(other)
    x, y = (place[k] - half * (moves[one + k] + moves[other + k]) for k in range(2))
    x, y = (x if x > bounds[0] else bounds[0]), (y if y > bounds[2] else bounds[2])
    x, y = (x if x < bounds[1] else bounds[1]), (y if y < bounds[3] else bounds[3])
    column, row = math.floor(x), math.floor(y)
    return column, row, x - column, y - row


@intrinsic
def _origin_at_once(
    typing_context: Any, moves: Any, one: Any, other: Any, place: Any, half: Any, bounds: Any
) -> Any:
    """``_origin_plainly`` in vectors of two."""
    two, four = types.UniTuple(types.float64, 2), types.UniTuple(types.float64, 4)
    found = types.Tuple((types.int64, types.int64, types.float64, types.float64))
    signature = found(moves, types.uint64, types.uint64, two, types.float64, four)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        array, one, other, place, half, bounds = args
        data = _data(context, builder, signature.args[0], array)
        both = builder.fadd(_load(builder, data, one), _load(builder, data, other))
        here = pair_of(builder, *(builder.extract_value(place, k) for k in range(2)))
        x = builder.fsub(here, builder.fmul(pair_of(builder, half, half), both))
        places, _, rest = _whole(builder, _clamp(builder, x, _limits(builder, bounds)))
        lanes = [_lane(builder, vector, k) for vector in (places, rest) for k in range(2)]
        return context.make_tuple(builder, signature.return_type, lanes)

    return signature, generate


origin = _origin_plainly if config.DISABLE_JIT else _origin_at_once


def _midpoint_plainly(w: Any, shape: Any, j: Any, i: Any, scale: Any, bounds: Any, shift: Any) -> None:
    """Write the displacement (x, y) of cell (j, i) over a step by the midpoint rule into shift.

    w, shift: flat (rows, columns, 2); shape: rows, columns; bounds: of where the way back may end.
    """
    ny, nx = int(shape[0]), int(shape[1])
    k = 2 * (int(j) * nx + int(i))
    dx, dy = scale * w[k], scale * w[k + 1]
    if abs(dx) < FARTHEST and abs(dy) < FARTHEST:
        x, y = i - 0.5 * dx, j - 0.5 * dy
        x, y = (x if x > 0.0 else 0.0), (y if y > 0.0 else 0.0)
        x, y = (x if x < nx - 1.0 else nx - 1.0), (y if y < ny - 1.0 else ny - 1.0)
        column, row = int(x), int(y)
        f, g = x - column, y - row
        at, right = 2 * (row * nx + column), 2 if column < nx - 1 else 0
        up = 2 * nx if row < ny - 1 else 0
        a, b, c, d = (1.0 - g) * (1.0 - f), (1.0 - g) * f, g * (1.0 - f), g * f
        dx, dy = (
            scale * ((a * w[m] + b * w[m + right]) + (c * w[m + up] + d * w[m + up + right]))
            for m in (at, at + 1)
        )
    if not (abs(dx) < FARTHEST and abs(dy) < FARTHEST):
        dx, dy = 0.0, 0.0
    x, y = i - dx, j - dy
    x, y = (x if x > bounds[0] else bounds[0]), (y if y > bounds[2] else bounds[2])
    x, y = (x if x < bounds[1] else bounds[1]), (y if y < bounds[3] else bounds[3])
    shift[k], shift[k + 1] = i - x, j - y


def _near(builder: Any, d: Any) -> Any:
    """Whether both displacements are numbers below FARTHEST, two lanes of the answer."""
    each = builder.fcmp_ordered("<", _of_both(builder, "llvm.fabs.v2f64", d), _both(FARTHEST))
    swapped = ir.Constant(ir.VectorType(_INT, 2), [1, 0])
    return builder.and_(each, builder.shuffle_vector(each, each, swapped))


def _bilinear(builder: Any, data: Any, shape: tuple[Any, Any], x: Any) -> Any:
    """The velocity at x (column, row), which lies within the outermost centres."""
    ny, nx = shape
    one, two, none = (ir.Constant(_LONG, value) for value in (1, 2, 0))
    places, _, rest = _whole(builder, x)
    column, row = (_lane(builder, places, k) for k in range(2))
    f, g = (_lane(builder, rest, k) for k in range(2))
    right = builder.select(builder.icmp_signed("<", column, builder.sub(nx, one)), two, none)
    above = builder.select(builder.icmp_signed("<", row, builder.sub(ny, one)), builder.mul(two, nx), none)
    at = builder.mul(two, builder.add(builder.mul(row, nx), column))
    e, h = (builder.fsub(ir.Constant(_DOUBLE, 1.0), part) for part in (f, g))
    sums = []
    for start, (q, w), (r, v) in (
        (at, (h, e), (h, f)),
        (builder.add(at, above), (g, e), (g, f)),
    ):
        left, far = builder.fmul(q, w), builder.fmul(r, v)
        one_side = builder.fmul(pair_of(builder, left, left), _load(builder, data, start))
        other = builder.fmul(pair_of(builder, far, far), _load(builder, data, builder.add(start, right)))
        sums.append(builder.fadd(one_side, other))
    return builder.fadd(*sums)


@intrinsic
def _midpoint_at_once(
    typing_context: Any, w: Any, shape: Any, j: Any, i: Any, scale: Any, bounds: Any, shift: Any
) -> Any:
    """``_midpoint_plainly`` in vectors of two."""
    sizes, four = types.UniTuple(types.int64, 2), types.UniTuple(types.float64, 4)
    signature = types.void(w, sizes, types.int64, types.int64, types.float64, four, shift)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        array, shape, j, i, scale, bounds, goal = args
        data = _data(context, builder, signature.args[0], array)
        ny, nx = (builder.extract_value(shape, k) for k in range(2))
        at = builder.mul(ir.Constant(_LONG, 2), builder.add(builder.mul(j, nx), i))
        here = pair_of(builder, *(builder.sitofp(number, _DOUBLE) for number in (i, j)))
        ends = pair_of(
            builder, *(builder.fsub(builder.sitofp(n, _DOUBLE), ir.Constant(_DOUBLE, 1.0)) for n in (nx, ny))
        )
        scales = pair_of(builder, scale, scale)
        d = builder.fmul(scales, _load(builder, data, at))
        first = _near(builder, d)
        middle = builder.fsub(here, builder.fmul(_both(0.5), d))
        middle = _clamp(builder, middle, (_both(0.0), ends))
        d = builder.fmul(scales, _bilinear(builder, data, (ny, nx), middle))
        d = builder.select(builder.and_(first, _near(builder, d)), d, _both(0.0))
        x = _clamp(builder, builder.fsub(here, d), _limits(builder, bounds))
        places = builder.gep(_data(context, builder, signature.args[6], goal), [at])
        builder.store(builder.fsub(here, x), builder.bitcast(places, _PAIR.as_pointer()), align=8)
        return context.get_dummy_value()

    return signature, generate


midpoint = _midpoint_plainly if config.DISABLE_JIT else _midpoint_at_once

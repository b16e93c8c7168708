"""Several neighbouring pixels at once, in vector instructions: numba's own loops are several times slower.

Each exists plainly, too: for runs without compilation, and to be compared with.
"""

from __future__ import annotations

import math
from typing import Any

from llvmlite import ir
from numba import config, types
from numba.core import cgutils
from numba.extending import intrinsic


def blend_four_plainly(pixels: Any, position: int, weights: Any, first: int, color: int) -> None:
    """Lay a colour over ``pixels[position : position + 4]`` of a flat picture.

    ``weights[first : first + 16]`` (uint16, 0 to 256) holds each pixel's weight four times, once a channel.
    """
    for i in range(4):
        below, weight = int(pixels[position + i]), int(weights[first + 4 * i])
        mixed = 0
        for shift in (0, 8, 16, 24):
            a, b = (color >> shift) & 255, (below >> shift) & 255
            mixed |= ((a * weight + b * (256 - weight) + 128) >> 8) << shift
        pixels[position + i] = mixed


@intrinsic
def _blend_four_at_once(
    typing_context: Any, pixels: Any, position: Any, weights: Any, first: Any, color: Any
) -> Any:
    """``blend_four_plainly`` in eight vector instructions; numba's own loop is five times slower."""
    signature = types.void(pixels, position, weights, first, color)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        picture, at, table, start, ink = args
        bytes16, words16 = ir.VectorType(ir.IntType(8), 16), ir.VectorType(ir.IntType(16), 16)
        ints4, int32 = ir.VectorType(ir.IntType(32), 4), ir.IntType(32)
        data = context.make_array(signature.args[0])(context, builder, picture).data
        rows = context.make_array(signature.args[2])(context, builder, table).data
        place = builder.bitcast(builder.gep(data, [at]), bytes16.as_pointer())
        source = builder.bitcast(builder.gep(rows, [start]), words16.as_pointer())
        below = builder.zext(builder.load(place, align=4), words16)
        weight = builder.load(source, align=2)
        nothing = ir.Constant(ints4, ir.Undefined)
        one = builder.insert_element(nothing, builder.trunc(ink, int32), ir.Constant(int32, 0))
        four = builder.shuffle_vector(one, nothing, ir.Constant(ints4, [0] * 4))
        over = builder.zext(builder.bitcast(four, bytes16), words16)
        keep = builder.sub(ir.Constant(words16, [256] * 16), weight)
        mixed = builder.add(builder.mul(over, weight), builder.mul(below, keep))
        mixed = builder.lshr(
            builder.add(mixed, ir.Constant(words16, [128] * 16)), ir.Constant(words16, [8] * 16)
        )
        builder.store(builder.trunc(mixed, bytes16), place, align=4)
        return context.get_dummy_value()

    return signature, generate


blend_four = blend_four_plainly if config.DISABLE_JIT else _blend_four_at_once


def _mix_four_plainly(pixels: Any, position: int, color: int, weight: int) -> None:
    """Lay a colour with one weight (0 to 256) to four pixels of a C-ordered picture, from ``position`` on."""
    flat = pixels.reshape(-1)
    for i in range(position, position + 4):
        below, mixed = int(flat[i]), 0
        for shift in (0, 8, 16, 24):
            a, b = (color >> shift) & 255, (below >> shift) & 255
            mixed |= ((a * weight + b * (256 - weight) + 128) >> 8) << shift
        flat[i] = mixed


@intrinsic
def _mix_four_at_once(typing_context: Any, pixels: Any, position: Any, color: Any, weight: Any) -> Any:
    """``_mix_four_plainly`` in vector instructions; what does not depend on the place is made once a row."""
    signature = types.void(pixels, position, color, weight)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        picture, at, ink, share = args
        bytes16, words16 = ir.VectorType(ir.IntType(8), 16), ir.VectorType(ir.IntType(16), 16)
        ints4, int32, int16 = ir.VectorType(ir.IntType(32), 4), ir.IntType(32), ir.IntType(16)
        data = context.make_array(signature.args[0])(context, builder, picture).data
        place = builder.bitcast(builder.gep(data, [at]), bytes16.as_pointer())
        below = builder.zext(builder.load(place, align=4), words16)
        nothing, none = ir.Constant(ints4, ir.Undefined), ir.Constant(words16, ir.Undefined)
        one = builder.insert_element(nothing, builder.trunc(ink, int32), ir.Constant(int32, 0))
        four = builder.shuffle_vector(one, nothing, ir.Constant(ints4, [0] * 4))
        over = builder.zext(builder.bitcast(four, bytes16), words16)
        first = builder.insert_element(none, builder.trunc(share, int16), ir.Constant(int32, 0))
        every = ir.Constant(ir.VectorType(int32, 16), [0] * 16)
        weights = builder.shuffle_vector(first, none, every)
        keep = builder.sub(ir.Constant(words16, [256] * 16), weights)
        added = builder.add(builder.mul(over, weights), ir.Constant(words16, [128] * 16))
        mixed = builder.add(added, builder.mul(below, keep))
        mixed = builder.lshr(mixed, ir.Constant(words16, [8] * 16))
        builder.store(builder.trunc(mixed, bytes16), place, align=4)
        return context.get_dummy_value()

    return signature, generate


mix_four = _mix_four_plainly if config.DISABLE_JIT else _mix_four_at_once


def _cover_four_plainly(
    pixels: Any, position: int, place: Any, middle: Any, limits: Any, color: int, alpha: float
) -> None:
    """Lay a disc over up to four pixels of a row, from ``position`` on of a C-ordered picture.

    place: the first one's column, and how many count; middle: the disc's x, and the square of how far the row
    is below it; limits: the square of a distance up to which pixels are covered whole, and the distance at
    which none of them is any more. Four pixels from ``position`` on must be there, whatever counts.
    """
    (column, count), (x, below), (whole, outer) = place, middle, limits
    flat = pixels.reshape(-1)
    for k in range(count):
        dx = column + k + 0.5 - x
        squared = dx * dx + below
        share = (1.0 if squared <= whole else outer - math.sqrt(squared)) * alpha
        weight = int(min(share, 1.0) * 256.0 + 0.5) if share > 0.0 else 0
        under, mixed = int(flat[position + k]), 0
        for shift in (0, 8, 16, 24):
            a, b = (color >> shift) & 255, (under >> shift) & 255
            mixed |= ((a * weight + b * (256 - weight) + 128) >> 8) << shift
        flat[position + k] = mixed


def _four_weights(builder: Any, place: Any, middle: Any, limits: Any, alpha: Any) -> Any:
    """Weights of four neighbours, 0 for those that do not count."""
    doubles, ints, int32 = ir.VectorType(ir.DoubleType(), 4), ir.VectorType(ir.IntType(32), 4), ir.IntType(32)

    def spread(value: Any, kind: Any) -> Any:
        nothing = ir.Constant(kind, ir.Undefined)
        first = builder.insert_element(nothing, value, ir.Constant(int32, 0))
        return builder.shuffle_vector(first, nothing, ir.Constant(ints, [0] * 4))

    def all_of(value: float) -> Any:
        return ir.Constant(doubles, [value] * 4)

    lanes = ir.Constant(ints, [0, 1, 2, 3])
    columns = builder.add(spread(builder.trunc(place[0], int32), ints), lanes)
    dx = builder.fadd(builder.sitofp(columns, doubles), all_of(0.5))
    dx = builder.fsub(dx, spread(middle[0], doubles))
    squared = builder.fadd(builder.fmul(dx, dx), spread(middle[1], doubles))
    root = cgutils.get_or_insert_function(
        builder.module, ir.FunctionType(doubles, [doubles]), "llvm.sqrt.v4f64"
    )
    rest = builder.fsub(spread(limits[1], doubles), builder.call(root, [squared]))
    inside = builder.fcmp_ordered("<=", squared, spread(limits[0], doubles))
    share = builder.fmul(builder.select(inside, all_of(1.0), rest), spread(alpha, doubles))
    share = builder.select(builder.fcmp_ordered(">", share, all_of(0.0)), share, all_of(0.0))
    share = builder.select(builder.fcmp_ordered("<", share, all_of(1.0)), share, all_of(1.0))
    found = builder.fptosi(builder.fadd(builder.fmul(share, all_of(256.0)), all_of(0.5)), ints)
    counts = builder.icmp_signed("<", lanes, spread(builder.trunc(place[1], int32), ints))
    return builder.select(counts, found, ir.Constant(ints, [0] * 4))


@intrinsic
def _cover_four_at_once(
    typing_context: Any,
    pixels: Any,
    position: Any,
    place: Any,
    middle: Any,
    limits: Any,
    color: Any,
    alpha: Any,
) -> Any:
    """``_cover_four_plainly`` in vector instructions; a pixel that does not count is written as it was."""
    two, pair = types.UniTuple(types.int64, 2), types.UniTuple(types.float64, 2)
    signature = types.void(pixels, types.int64, two, pair, pair, types.int64, types.float64)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        picture, at, *tuples, ink, alpha = args
        place, middle, limits = ([builder.extract_value(one, k) for k in range(2)] for one in tuples)
        bytes16, words16 = ir.VectorType(ir.IntType(8), 16), ir.VectorType(ir.IntType(16), 16)
        ints4, int32 = ir.VectorType(ir.IntType(32), 4), ir.IntType(32)
        data = context.make_array(signature.args[0])(context, builder, picture).data
        goal = builder.bitcast(builder.gep(data, [at]), bytes16.as_pointer())
        below = builder.zext(builder.load(goal, align=4), words16)
        nothing = ir.Constant(ints4, ir.Undefined)
        one = builder.insert_element(nothing, builder.trunc(ink, int32), ir.Constant(int32, 0))
        four = builder.shuffle_vector(one, nothing, ir.Constant(ints4, [0] * 4))
        over = builder.zext(builder.bitcast(four, bytes16), words16)
        weights = _four_weights(builder, place, middle, limits, alpha)
        short = builder.trunc(weights, ir.VectorType(ir.IntType(16), 4))
        each = ir.Constant(ir.VectorType(int32, 16), [k // 4 for k in range(16)])
        weight = builder.shuffle_vector(short, ir.Constant(short.type, ir.Undefined), each)
        keep = builder.sub(ir.Constant(words16, [256] * 16), weight)
        mixed = builder.add(builder.mul(over, weight), builder.mul(below, keep))
        mixed = builder.add(mixed, ir.Constant(words16, [128] * 16))
        mixed = builder.lshr(mixed, ir.Constant(words16, [8] * 16))
        builder.store(builder.trunc(mixed, bytes16), goal, align=4)
        return context.get_dummy_value()

    return signature, generate


cover_four = _cover_four_plainly if config.DISABLE_JIT else _cover_four_at_once


def _is_blank_plainly(sums: Any, position: int) -> bool:
    """Whether eight sums (float32) from ``position`` of a C-ordered picture of them on are zero."""
    return not sums.reshape(-1)[position : position + 8].any()


@intrinsic
def _is_blank_at_once(typing_context: Any, sums: Any, position: Any) -> Any:
    """``_is_blank_plainly`` in two instructions."""
    signature = types.boolean(sums, position)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        table, at = args
        eight = ir.IntType(256)
        data = context.make_array(signature.args[0])(context, builder, table).data
        place = builder.bitcast(builder.gep(data, [at]), eight.as_pointer())
        return builder.icmp_unsigned("==", builder.load(place, align=4), ir.Constant(eight, 0))

    return signature, generate


is_blank = _is_blank_plainly if config.DISABLE_JIT else _is_blank_at_once

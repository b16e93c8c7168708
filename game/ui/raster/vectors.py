"""Several neighbouring pixels at once, in vector instructions: numba's own loops are several times slower.

Each exists plainly, too: for runs without compilation, and to be compared with.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import config, types
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

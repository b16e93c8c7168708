"""Light added to several neighbouring pixels at once: what is too bright stays as bright as a pixel can be.

Each exists plainly, too: for runs without compilation, and to be compared with.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import config, types
from numba.core import cgutils
from numba.extending import intrinsic

_BYTES, _WORDS = ir.VectorType(ir.IntType(8), 16), ir.VectorType(ir.IntType(16), 16)


def _add_four_plainly(pixels: Any, position: int, weights: Any, first: int, color: int) -> None:
    """Add a colour to ``pixels[position : position + 4]`` of a flat picture.

    ``weights[first : first + 16]`` (uint16, 0 to 256) holds each pixel's weight four times, once a channel.
    """
    for i in range(4):
        below, weight = int(pixels[position + i]), int(weights[first + 4 * i])
        summed = 0
        for shift in (0, 8, 16, 24):
            added = ((color >> shift) & 255) * weight >> 8
            summed |= min(((below >> shift) & 255) + added, 255) << shift
        pixels[position + i] = summed


def _saturating_sum(builder: Any, a: Any, b: Any) -> Any:
    name, signature = "llvm.uadd.sat.v16i8", ir.FunctionType(_BYTES, [_BYTES, _BYTES])
    return builder.call(cgutils.get_or_insert_function(builder.module, signature, name), [a, b])


@intrinsic
def _add_four_at_once(
    typing_context: Any, pixels: Any, position: Any, weights: Any, first: Any, color: Any
) -> Any:
    """``_add_four_plainly`` in six vector instructions."""
    signature = types.void(pixels, position, weights, first, color)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        picture, at, table, start, ink = args
        ints4, int32 = ir.VectorType(ir.IntType(32), 4), ir.IntType(32)
        data = context.make_array(signature.args[0])(context, builder, picture).data
        rows = context.make_array(signature.args[2])(context, builder, table).data
        place = builder.bitcast(builder.gep(data, [at]), _BYTES.as_pointer())
        source = builder.bitcast(builder.gep(rows, [start]), _WORDS.as_pointer())
        nothing = ir.Constant(ints4, ir.Undefined)
        one = builder.insert_element(nothing, builder.trunc(ink, int32), ir.Constant(int32, 0))
        four = builder.shuffle_vector(one, nothing, ir.Constant(ints4, [0] * 4))
        light = builder.zext(builder.bitcast(four, _BYTES), _WORDS)
        weight = builder.load(source, align=2)
        added = builder.lshr(builder.mul(light, weight), ir.Constant(_WORDS, [8] * 16))
        summed = _saturating_sum(builder, builder.load(place, align=4), builder.trunc(added, _BYTES))
        builder.store(summed, place, align=4)
        return context.get_dummy_value()

    return signature, generate


add_four = _add_four_plainly if config.DISABLE_JIT else _add_four_at_once

_LEFT = [7] * 4 + [5] * 4 + [3] * 4 + [1] * 4
_RIGHT = [1] * 4 + [3] * 4 + [5] * 4 + [7] * 4


def _add_between_plainly(pixels: Any, position: int, line: Any, cell: int, grain: Any, row: int) -> None:
    """Add light to four pixels that lie between two cells of a coarser line of light.

    ``line`` (uint16, flat): four channels a cell, in 1/32 of a pixel's step, 255 at most. Each pixel takes
    from both cells as it lies between them. ``grain[row : row + 16]``: what is added before rounding (1/256).
    """
    for i in range(4):
        below, summed = int(pixels[position + i]), 0
        for channel in range(4):
            a, b = int(line[4 * cell + channel]), int(line[4 * cell + 4 + channel])
            light = (a * _LEFT[4 * i] + b * _RIGHT[4 * i] + int(grain[row + 4 * i + channel])) >> 8
            shift = 8 * channel
            summed |= min(((below >> shift) & 255) + light, 255) << shift
        pixels[position + i] = summed


@intrinsic
def _add_between_at_once(
    typing_context: Any, pixels: Any, position: Any, line: Any, cell: Any, grain: Any, row: Any
) -> Any:
    """``_add_between_plainly`` in vector instructions."""
    signature = types.void(pixels, position, line, cell, grain, row)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        picture, at, lights, place, grains, start = args
        words8, int32 = ir.VectorType(ir.IntType(16), 8), ir.IntType(32)
        data = context.make_array(signature.args[0])(context, builder, picture).data
        rows = context.make_array(signature.args[2])(context, builder, lights).data
        table = context.make_array(signature.args[4])(context, builder, grains).data
        target = builder.bitcast(builder.gep(data, [at]), _BYTES.as_pointer())
        first = builder.mul(place, ir.Constant(place.type, 4))
        pair = builder.load(builder.bitcast(builder.gep(rows, [first]), words8.as_pointer()), align=2)
        nothing = ir.Constant(words8, ir.Undefined)
        spread = ir.VectorType(int32, 16)
        left = builder.shuffle_vector(pair, nothing, ir.Constant(spread, [0, 1, 2, 3] * 4))
        right = builder.shuffle_vector(pair, nothing, ir.Constant(spread, [4, 5, 6, 7] * 4))
        mixed = builder.add(
            builder.mul(left, ir.Constant(_WORDS, _LEFT)), builder.mul(right, ir.Constant(_WORDS, _RIGHT))
        )
        added = builder.load(builder.bitcast(builder.gep(table, [start]), _WORDS.as_pointer()), align=2)
        light = builder.lshr(builder.add(mixed, added), ir.Constant(_WORDS, [8] * 16))
        summed = _saturating_sum(builder, builder.load(target, align=4), builder.trunc(light, _BYTES))
        builder.store(summed, target, align=4)
        return context.get_dummy_value()

    return signature, generate


add_between = _add_between_plainly if config.DISABLE_JIT else _add_between_at_once

"""One pixel of a picture: how a colour is laid over it, and how four neighbours are at once.

A pixel is 0xAARRGGBB in a uint32. A weight of 256 replaces it, 0 leaves it. All four channels are mixed, the
colour counting as opaque: on a surface without alpha the top byte is ignored; on one with alpha that starts
at zero the result is premultiplied.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from llvmlite import ir
from numba import config, types
from numba.extending import intrinsic

from game.physics.jit import kernel

FARTHEST = 1.0e9  # px; beyond this a coordinate has lost its subpixels and nothing is drawn
OPAQUE = 0xFF000000
FULL = 256  # the weight that replaces a pixel


@kernel
def is_drawable(value: float) -> bool:
    """Whether a coordinate or length is finite and near enough to draw with."""
    return -FARTHEST <= value <= FARTHEST


@kernel
def blend(pixels: Any, row: int, column: int, color: int, weight: int) -> None:
    """Lay a colour over one pixel with ``weight`` 0 to 256."""
    below = np.int64(pixels[row, column])
    keep = FULL - weight
    red_blue = ((color & 0xFF00FF) * weight + (below & 0xFF00FF) * keep + 0x800080) >> 8
    over = ((color >> 8) & 0xFF00FF) | 0xFF0000
    alpha_green = over * weight + ((below >> 8) & 0xFF00FF) * keep + 0x800080
    pixels[row, column] = (red_blue & 0xFF00FF) | (alpha_green & 0xFF00FF00)


@kernel
def fill_row(pixels: Any, row: int, start: int, stop: int, color: int, weight: int) -> None:
    """Lay a colour over the pixels ``start`` to ``stop`` - 1 of a row with one weight."""
    if weight >= FULL:
        solid = np.uint32((color & 0xFFFFFF) | OPAQUE)
        for column in range(start, stop):
            pixels[row, column] = solid
    elif weight > 0:
        for column in range(start, stop):
            blend(pixels, row, column, color, weight)


@kernel
def weight_of(coverage: float, alpha: float) -> int:
    """Blending weight 0 to 256 of a covered share of a pixel; nan counts as nothing."""
    share = coverage * alpha
    if not share > 0.0:
        return 0
    return int(min(share, 1.0) * 256.0 + 0.5)


@kernel
def lay(pixels: Any, row: int, column: int, color: int, share: float) -> None:
    """Lay a colour over a share 0 to 1 of one pixel; more counts as 1, less and nan as 0."""
    weight = weight_of(share, 1.0)
    if weight > 0:
        blend(pixels, row, column, color, weight)


@kernel
def strip_coverage(distance: float, half: float) -> float:
    """Share of a one-pixel window ``distance`` from the middle of a strip that the strip covers.

    Exact along the axis across the strip: thin lines fade, they do not break up.
    """
    return max(0.0, min(half, distance + 0.5) - max(-half, distance - 0.5))


@kernel
def bounds_of(pixels: Any, clip: Any) -> Any:
    """The clip cut to the picture, as four integers."""
    return max(0, clip[0]), max(0, clip[1]), min(pixels.shape[1], clip[2]), min(pixels.shape[0], clip[3])


@kernel
def clip_bounds(pixels: Any, clip: Any, left: float, top: float, right: float, bottom: float) -> Any:
    """Pixels that a box touches inside the clip: first column and row, past-the-last column and row."""
    x_low = max(0, clip[0], math.floor(max(left, -1.0)))
    y_low = max(0, clip[1], math.floor(max(top, -1.0)))
    x_high = min(pixels.shape[1], clip[2], math.ceil(min(right, 1.0 * pixels.shape[1])))
    y_high = min(pixels.shape[0], clip[3], math.ceil(min(bottom, 1.0 * pixels.shape[0])))
    return x_low, y_low, x_high, y_high


def _blend_four_plainly(pixels: Any, position: int, weights: Any, first: int, color: int) -> None:
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
    """``_blend_four_plainly`` in eight vector instructions; numba's own loop is five times slower."""
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


blend_four = _blend_four_plainly if config.DISABLE_JIT else _blend_four_at_once

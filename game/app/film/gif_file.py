"""GIF files of our own making, so that a film needs nothing that is not installed.

Pictures wait packed until all colours are known. Then 255 of them are chosen for the whole film by halving
the box of colours that is widest (P. Heckbert, Color Image Quantization for Frame Buffer Display, SIGGRAPH
1982), and of each picture only what has changed is written.
"""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pygame
from numpy.typing import NDArray

from game.files import FileProblem, write_bytes
from game.ui.raster.gif_codes import packed_codes

BITS = 6  # of each of red, green, blue that are kept
SAME = 255  # colour that means: as in the picture before
CHOSEN = 255  # colours
_STEPS = 1 << BITS


class GifFile:
    """Pictures of one size (px, width and height) at ``rate`` a second, a divisor of 100."""

    def __init__(self, path: Path, size: tuple[int, int], rate: int) -> None:
        self.path, self.size, self.rate = path, size, rate
        self._pictures: list[bytes] = []
        self._repeats: list[int] = []  # of each picture, how often it is shown
        self._counts = np.zeros(_STEPS**3, np.int64)  # of pixels, by colour

    @property
    def count(self) -> int:
        """Pictures, those that are shown again counted again."""
        return sum(self._repeats)

    def add(self, pixels: NDArray[np.uint8], times: int = 1) -> None:
        """A picture (height, width, 4) of blue, green, red; shown so many times."""
        codes = _codes_of(pixels)
        self._counts += np.bincount(codes.ravel(), minlength=_STEPS**3)
        packed = zlib.compress(codes.tobytes(), 1)
        if self._pictures and packed == self._pictures[-1]:
            self._repeats[-1] += times
            return
        self._pictures.append(packed)
        self._repeats.append(times)

    def write(self, tell: Callable[[float], object] = lambda share: None) -> None:
        """Write the file, whole or not at all; FileProblem. ``tell``: how much of it is done, 0 to 1."""
        if not self._pictures:
            raise FileProblem("no picture was taken")
        colors, index = chosen_colors(self._counts)
        width, height = self.size
        parts = [
            b"GIF89a", struct.pack("<HHBBB", width, height, 0xF7, 0, 0), colors.tobytes(),
            b"\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00",
        ]  # fmt: skip
        before: NDArray[np.uint8] | None = None
        for i, packed in enumerate(self._pictures):
            codes = np.frombuffer(zlib.decompress(packed), np.uint32).reshape(height, width)
            picture = index[codes]
            parts.append(_block(picture, before, self._repeats[i] * 100 // self.rate))
            before = picture
            tell((i + 1) / len(self._pictures))
        write_bytes(self.path, b"".join([*parts, b"\x3b"]))


def _codes_of(pixels: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """Red, green and blue in one number, (height, width), from pixels (height, width, 4) of b, g, r."""
    few = (pixels[:, :, :3] >> (8 - BITS)).astype(np.uint32)
    return np.ascontiguousarray((few[:, :, 2] << 2 * BITS) | (few[:, :, 1] << BITS) | few[:, :, 0])


def _block(picture: NDArray[np.uint8], before: NDArray[np.uint8] | None, hundredths: int) -> bytes:
    """One picture in the file: the box of it that has changed."""
    top, left, (bottom, right) = 0, 0, picture.shape
    shown = picture
    if before is not None:
        changed = picture != before
        rows, columns = np.flatnonzero(changed.any(axis=1)), np.flatnonzero(changed.any(axis=0))
        top, bottom = (int(rows[0]), int(rows[-1]) + 1) if rows.size else (0, 1)
        left, right = (int(columns[0]), int(columns[-1]) + 1) if columns.size else (0, 1)
        shown = np.where(changed, picture, np.uint8(SAME))[top:bottom, left:right]
    control = struct.pack("<BBBBHBB", 0x21, 0xF9, 4, 0x05, min(hundredths, 65535), SAME, 0)
    place = struct.pack("<BHHHHBB", 0x2C, left, top, right - left, bottom - top, 0, 8)
    codes = packed_codes(np.ascontiguousarray(shown).ravel())
    pieces = [bytes((len(part),)) + part for part in (codes[i : i + 255] for i in range(0, len(codes), 255))]
    return b"".join([control, place, *pieces, b"\x00"])


def chosen_colors(counts: NDArray[np.int64]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Colours (256, 3) that suit pixels counted by their code, and the colour (by number) of each code."""
    used = np.flatnonzero(counts)
    parts = np.stack([(used >> shift) & (_STEPS - 1) for shift in (2 * BITS, BITS, 0)], axis=1)
    weights = counts[used].astype(np.float64)
    boxes = [np.arange(used.size)]
    while len(boxes) < CHOSEN:
        widths = [_spread(parts[box], weights[box]) for box in boxes]
        widest = int(np.argmax(widths))
        if widths[widest] <= 0.0:
            break
        boxes += _halves(boxes.pop(widest), parts, weights)
    colors, index = np.zeros((256, 3), np.uint8), np.zeros(_STEPS**3, np.uint8)
    for number, box in enumerate(boxes):
        mean = np.average(parts[box], axis=0, weights=weights[box])
        colors[number] = np.rint(mean * 255.0 / (_STEPS - 1))
        index[used[box]] = number
    return colors, index


def _spread(parts: NDArray[np.int64], weights: NDArray[np.float64]) -> float:
    """How much a box wants to be halved: its longest side, and that more if many pixels lie in it."""
    if len(parts) < 2:
        return 0.0
    side = float(np.max(parts.max(axis=0) - parts.min(axis=0)))
    return side * float(weights.sum()) ** 0.25


def _halves(
    box: NDArray[np.int64], parts: NDArray[np.int64], weights: NDArray[np.float64]
) -> list[NDArray[np.int64]]:
    """A box cut across its longest side, where half of its pixels lie on either side."""
    inside = parts[box]
    axis = int(np.argmax(inside.max(axis=0) - inside.min(axis=0)))
    order = np.argsort(inside[:, axis], kind="stable")
    along = np.cumsum(np.sqrt(weights[box][order]))
    cut = int(np.searchsorted(along, 0.5 * along[-1]))
    cut = min(max(cut, 1), box.size - 1)
    return [box[order[:cut]], box[order[cut:]]]


def pixels_of_picture(picture: pygame.Surface) -> NDArray[np.uint8]:
    """A copy of a 32-bit picture's pixels, (height, width, 4) of blue, green, red and what is unused."""
    width, height = picture.get_size()
    rows = np.frombuffer(picture.get_buffer().raw, np.uint8).reshape(height, -1, 4)
    return rows[:, :width].copy()

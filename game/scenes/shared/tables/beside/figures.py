"""Figures of a stroke below each other beside a table: direction, margin, chance."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look

ROOM_FOR_CAPTIONS = 0.85  # scale
WORDS, UNDER, CAPTION = 19.0, 36.0, 7.0  # design px: of what is said, its caption, what a caption moves
FOOT, UNDER_FOOT = 27.0, 43.0  # design px from a title to the end of what is said, and of its caption
TIGHTEST = 36.0  # design px from one title to the next


class Number(NamedTuple):
    """A figure: its title, what it says; lit: the title stands out; under: a caption; small: what it says is
    long.
    """

    title: str
    words: str
    lit: bool = False
    under: str = ""
    small: bool = False


def pitch_of(numbers: Sequence[Number], usual: float, room: float) -> tuple[float, bool]:
    """From one title to the next, design px, and whether captions are drawn, so that all of it fits.

    usual: the pitch where there is room enough. room: design px from the first title to what follows.
    """
    gaps, captioned = max(len(numbers) - 1, 1), [bool(number.under) for number in numbers]
    last = UNDER_FOOT if captioned and captioned[-1] else FOOT
    fits = (room - last - CAPTION * sum(captioned[:-1])) / gaps
    if not any(captioned) or fits >= TIGHTEST:
        return max(min(usual, fits), min(usual, TIGHTEST)), True
    return max(min(usual, (room - FOOT) / gaps), min(usual, TIGHTEST)), False


def draw_numbers(
    canvas: Canvas, look: Look, numbers: Sequence[Number], at: tuple[float, float], pitch: float, end: float
) -> None:
    """Figures below each other. at: (x, y) px of the first title; pitch: px to the next; end: y px at which
    something else begins.
    """
    x, top = at
    wide, captions = pitch_of(numbers, pitch / look.k, (end - top) / look.k)
    captions = captions and look.k >= ROOM_FOR_CAPTIONS
    y = top
    for number in numbers:
        color = "accent" if number.lit else "text2"
        look.text(canvas.surface, number.title, (x, y), 13, "medium", color, "center")
        letters = 11 if number.small else 13
        look.text(
            canvas.surface, number.words, (x, y + look.px(WORDS)), letters, "semibold", "text1", "center"
        )
        if number.under and captions:
            look.text(canvas.surface, number.under, (x, y + look.px(UNDER)), 11, "medium", "text3", "center")
            y += look.px(CAPTION)
        y += wide * look.k

"""What a level expects of a readout, beside what is measured: one line each, for as long as one looks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, NamedTuple

import msgspec
import numpy as np

from game.stage import Frame, Readout, Scene
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si
from game.worlds.entries.entry import LevelEntry

SIZE, WEIGHT = 13, "semibold"
FIRST, LINE = 14.0, 20.0  # design px down to the first line, and from line to line
ROUNDING = 1e-9  # of a bound: what is measured and less is rounding
HEADROOM, OF_A_LINE = 0.04, 0.045  # of the height in view, above captions and for each

Number = Annotated[float, msgspec.Meta(ge=-1e12, le=1e12)]


class Expectation(LevelEntry, frozen=True, kw_only=True):
    """What a readout should be, or become (SI), give or take ``within``; or the most that it may be."""

    readout: Annotated[str, msgspec.Meta(max_length=40)]
    value: Number
    within: Annotated[float, msgspec.Meta(ge=0.0, le=1e12)] = 0.0
    at_most: bool = False


Expectations = Annotated[tuple[Expectation, ...], msgspec.Meta(max_length=4)]


class Caption(NamedTuple):
    """Words, and whether what is measured is as expected."""

    words: str
    met: bool


def captions_of(expected: Sequence[Expectation], readouts: Sequence[Readout]) -> list[Caption]:
    """One caption for each expectation. ValueError, naming it, if there is no such readout."""
    measured = {readout.name: readout for readout in readouts}
    found = []
    for i, entry in enumerate(expected):
        if entry.readout not in measured:
            known = ", ".join(measured)
            raise ValueError(f"expected[{i}].readout: no readout {entry.readout!r}; there are {known}")
        _, value, unit = measured[entry.readout]
        if entry.at_most:
            shown = value if abs(value) > ROUNDING * entry.value else 0.0  # no figures of rounding
            met = abs(value) <= entry.value
        else:
            met = abs(value - entry.value) <= entry.within
            shown = _aim(entry, value) if met else value
        found.append(Caption(f"{_aim_in_words(entry, value, unit)}, measured {format_si(shown, unit)}", met))
    return found


def captions_now(scene: Scene, expected: Sequence[Expectation]) -> list[Caption]:
    """Captions of a scene in which time must pass before there is anything to measure.

    Before its first step each says that nothing was measured yet. The readouts are known to be there.
    """
    if not expected:
        return []
    readouts = scene.readouts()
    if scene.begun:
        return captions_of(expected, readouts)
    now = {readout.name: readout for readout in readouts}
    words = (_aim_in_words(entry, now[entry.readout].value, now[entry.readout].unit) for entry in expected)
    return [Caption(f"{aim}, not measured yet", False) for aim in words]


def _aim(entry: Expectation, value: float) -> float:
    """What is expected: whole where what is measured is a number of things."""
    whole = isinstance(value, int) and float(entry.value).is_integer()
    return int(entry.value) if whole else entry.value


def _aim_in_words(entry: Expectation, value: float, unit: str) -> str:
    if entry.at_most:
        return f"{entry.readout}: at most {format_si(entry.value, unit)}"
    return f"{entry.readout}: expected {format_si(_aim(entry, value), unit)}"


def with_headroom(frame: Frame, lines: int) -> Frame:
    """A frame (m) with space for so many captions above it."""
    share = HEADROOM + OF_A_LINE * lines if lines else 0.0
    return frame._replace(top=frame.top + share * (frame.top - frame.bottom))


def draw_captions(
    canvas: Canvas, top: tuple[float, float], captions: Sequence[Caption], again_in: float | None = None
) -> None:
    """Line by line on a plate, from a place (m) downwards: green where it is as expected, amber where not, or
    not yet. ``again_in``: s until all begins again, or None."""
    rows = [(words, "green" if met else "amber") for words, met in captions]
    if again_in is not None:
        rows.append((canvas.figure("again", f"again in {again_in:.0f} s"), "text2"))
    if not rows or not canvas.words:
        return
    _draw_plate(canvas, top, [words for words, _ in rows])
    for line, (words, color) in enumerate(rows):
        canvas.label(top, words, color, SIZE, WEIGHT, "top", (0.0, FIRST + LINE * line))


def _draw_plate(canvas: Canvas, top: tuple[float, float], lines: Sequence[str]) -> None:
    """Ground of the stage's colour behind lines, so that nothing that moves is read with them."""
    wide = max(canvas.fonts.size(words, SIZE, WEIGHT)[0] for words in lines) / canvas.pixels_per_unit
    half = 0.5 * wide + canvas.px(8.0)
    down = -1.0 if canvas.camera.y_up else 1.0
    head = top[1] + down * canvas.px(FIRST - 4.0)
    foot = top[1] + down * canvas.px(FIRST + LINE * len(lines))
    corners = ((top[0] - half, head), (top[0] + half, head), (top[0] + half, foot), (top[0] - half, foot))
    canvas.polygon(np.array(corners), fill="stage", fill_alpha=0.86)

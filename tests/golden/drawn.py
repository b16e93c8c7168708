"""What is drawn, as a list of verbs and what they are called with: no pixel of them is painted."""

from __future__ import annotations

import functools
import inspect
import math
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pygame

from game.stage import Stage
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.canvas.pen import FIGURE, Pen
from game.ui.look.fonts import FontBook
from game.ui.look.look import Look
from game.ui.look.theme import DARK

SIZE = (1280, 720)  # px
MARGIN = 20.0  # px
COLORS = 2.0**24
MOST = 4096  # numbers of an array that are added: of a longer one every second, third or so on
PARTS, FINE_PARTS = (4, 2), (16, 9)  # of the picture, across and down
GOLDEN_RATIO = 0.5 * (math.sqrt(5.0) - 1.0)
BEYOND = 1e3  # what stands for a number that is not finite
ASIDE = {  # of the canvas: they say something, or prepare; what they give shows in a verb
    "at_home", "begin", "color", "end", "figure", "ink", "magnified", "marks", "place", "place_all", "px",
    "room_for", "speed_colors", "within",
}  # fmt: skip
OF_FONTS = ("draw", "render", "render_on_halo")


class Tally:
    """Numbers and words of many calls: how many, a sum with weights by their order, a check sum of words.

    Another number, another order or another word is another tally; what differs by rounding is not.
    """

    def __init__(self) -> None:
        """Nothing is counted."""
        self.calls = self.count = 0
        self.weighted = self.absolute = 0.0
        self.words = 0

    def add(self, value: Any) -> None:
        """Count what a verb is called with, whatever it is made of."""
        if isinstance(value, (str, bytes)):
            self.words = zlib.crc32(value if isinstance(value, bytes) else value.encode(), self.words)
        elif isinstance(value, pygame.Color):
            self.add(f"#{value.r:02x}{value.g:02x}{value.b:02x}{value.a:02x}")
        elif isinstance(value, pygame.Surface):
            self.add(value.get_size())
        elif value is None or callable(value):
            self.add("-")
        elif isinstance(value, (bool, int, float, np.number, np.ndarray)):
            numbers = np.asarray(value)
            share = COLORS if numbers.dtype == np.uint32 else 1.0  # colours are not to outweigh places
            self._add_numbers(numbers.astype(np.float64).ravel() / share)
        elif isinstance(value, dict):
            self.add(tuple(value.items()))
        elif hasattr(value, "__iter__"):
            values = list(value)
            if values and all(isinstance(one, (int, float, np.number)) for one in values):
                self._add_numbers(np.array(values, np.float64))
            else:
                for one in values:
                    self.add(one)
        else:
            self.add(type(value).__name__)

    def text(self) -> str:
        """In a line: calls, numbers, their weighted sum / that of their sizes, check sum of the words."""
        return f"{self.calls} {self.count} {self.weighted + 0.0:.9g}/{self.absolute:.4g} {self.words:08x}"

    def _add_numbers(self, numbers: np.ndarray) -> None:
        if len(numbers) > MOST:
            self.add(len(numbers))
            numbers = numbers[:: len(numbers) // MOST + 1]
        finite = np.where(np.isfinite(numbers), numbers, BEYOND)
        weighted = finite * (0.5 + (GOLDEN_RATIO * np.arange(self.count, self.count + len(finite))) % 1.0)
        self.count += len(finite)
        self.weighted += float(weighted.sum())
        self.absolute += float(np.abs(weighted).sum())


Tallies = dict[str, Tally]


def drawing_of(stage: Stage) -> tuple[Tallies, pygame.Surface]:
    """What a scene draws now of the whole of its frame, by verb, and what it paints past the verbs."""
    tallies: Tallies = {}
    canvas = _canvas_type()(listening_look(tallies))
    canvas.tallies = tallies
    canvas.unit, canvas.covered = stage.scene_type.unit, True
    surface = pygame.Surface(SIZE, 0, 32)
    camera = Camera(y_up=stage.scene_type.y_up, quarter_turns=stage.scene_type.quarter_turns)
    camera.fit(stage.scene.frame(), surface.get_rect(), MARGIN)
    canvas.begin(surface, surface.get_rect(), camera)
    try:
        stage.scene.draw(canvas, 1.0)
    finally:
        canvas.end()
    return tallies, surface


def figure_of(paint: Callable[[Any], None], size: tuple[float, float] = FIGURE) -> Tallies:
    """What a card or a help page's figure draws, by the verbs of its pen."""
    tallies: Tallies = {}
    pen = _pen_type()((round(size[0]), round(size[1])), listening_look(tallies), size)
    pen.tallies = tallies
    paint(pen)
    return tallies


def listening_look(tallies: Tallies) -> Look:
    """A look whose fonts count the words that are set in them."""
    look = Look(DARK)
    look.fonts = _font_type()(1.0)
    look.fonts.tallies = tallies  # type: ignore[attr-defined]
    return look


def lines(tallies: Tallies) -> dict[str, str]:
    """A line for each verb."""
    return {verb: tally.text() for verb, tally in sorted(tallies.items())}


def in_one(tallies: Tallies) -> Tally:
    """All verbs in one tally, each by its shares, so that none outweighs another."""
    whole = Tally()
    for verb, tally in sorted(tallies.items()):
        whole.calls += tally.calls
        size = tally.absolute
        whole.add((verb, str(tally.count), f"{tally.words:08x}"))
        whole.add((tally.weighted / size, math.log10(size)) if size > 0.0 else (0.0, 0.0))
    return whole


def painted(surface: pygame.Surface, parts: tuple[int, int] = PARTS) -> str:
    """How bright the pixels are in each part of a picture, if any were painted past the verbs."""
    pixels = np.frombuffer(surface.get_buffer(), np.uint32)
    if not pixels.any():
        return ""
    across, down = parts
    cells = pixels.view(np.uint8).reshape(down, SIZE[1] // down, across, SIZE[0] // across, 4)
    return " ".join(f"{value:.1f}" for value in cells[..., :3].mean(axis=(1, 3, 4)).ravel())


@functools.cache
def _canvas_type() -> type[Any]:
    return _counting(Canvas, ASIDE)


@functools.cache
def _pen_type() -> type[Any]:
    return _counting(Pen, {"at", "veiled", "word_places", "finished"})


@functools.cache
def _font_type() -> type[Any]:
    counting = {name: _passed_on(getattr(FontBook, name)) for name in OF_FONTS}
    return type("CountingFonts", (FontBook,), counting)


def _counting(of: type[Any], aside: set[str]) -> type[Any]:
    """A type like another whose verbs count what they are called with, and do nothing."""
    verbs = {}
    for name, verb in inspect.getmembers(of, inspect.isfunction):
        if not name.startswith("_") and name not in aside:
            verbs[name] = _counted(verb)
    for name in ("within", "magnified"):
        if hasattr(of, name):
            verbs[name] = _entered(getattr(of, name))
    return type(f"Counting{of.__name__}", (of,), verbs)


def _counted(verb: Callable[..., Any]) -> Callable[..., None]:
    @functools.wraps(verb)
    def count(self: Any, *values: Any, **named: Any) -> None:
        _note(self.tallies, verb.__name__, values, named)

    return count


def _passed_on(verb: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(verb)
    def count(self: Any, *values: Any, **named: Any) -> Any:
        shown = [value for value in values if not isinstance(value, pygame.Surface)]
        _note(self.tallies, f"fonts.{verb.__name__}", shown, named)
        return verb(self, *values, **named)

    return count


def _entered(verb: Callable[..., Any]) -> Callable[..., Any]:
    @contextmanager
    def enter(self: Any, *values: Any, **named: Any) -> Iterator[None]:
        _note(self.tallies, verb.__name__, values, named)
        with verb(self, *values, **named):
            yield

    return enter


def _note(tallies: Tallies, verb: str, values: Any, named: dict[str, Any]) -> None:
    tally = tallies.setdefault(verb, Tally())
    tally.calls += 1
    for value in values:
        tally.add(value)
    for name in sorted(named):
        tally.add(name)
        tally.add(named[name])

"""Where everything lies in a scene's window, for any size and interface scale.

A pure function of the window: top bar above, panel at the right (a drawer over the stage where the window
is narrow), charts and key hints below the stage. Regions never overlap, whatever the size; in a small
window the least important go first: charts shrink to their last values, then hints, charts and panel go.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import pygame

Rect = pygame.Rect

TOP_BAR, PANEL, STRIPS, STRIP_VALUES, HINT_BAR, GUTTER = 48, 320, 128, 32, 32, 16  # design px
TALL_STRIPS = 232  # design px; of a row in which there is a phase plot
OVERLAID_HINTS = 28  # design px; of the row of hints over a picture that fills the window
GAME = (1280, 720)  # design px of such a picture: its own rows above and below are as high as bar and hints
DRAWER_BELOW = 1120  # design px of window width
TWO_CHARTS_BELOW = 880  # design px of stage width
VALUES_BELOW = 600  # design px of window height
SMALLEST = (320, 240)  # design px that the regions need; below that the scale shrinks instead
COMFORTABLE = (480, 360)  # design px that cards need; no chosen scale makes a window smaller than that
EDGES, SMALL_EDGES, SMALL_BELOW = (32, 48), (16, 16), 560  # design px about a card; of a window's side


class Layout(NamedTuple):
    """Rectangles in window pixels. ``panel`` is empty when it is off; a drawer lies over the stage."""

    k: float
    window: Rect
    top_bar: Rect
    stage: Rect
    panel: Rect
    drawer: bool  # the panel covers part of the stage
    strips: Rect  # empty when there are none
    charts: tuple[Rect, ...]  # one column for each chart shown
    values_only: bool  # the charts show their last values and no curves
    hint_bar: Rect
    overlaid: bool = False  # bar and hints lie over the stage, which is all of the window

    @property
    def free_stage(self) -> Rect:
        """The stage without what a drawer covers."""
        if not (self.drawer and self.panel.w):
            return self.stage
        return Rect(
            self.stage.x, self.stage.y, max(1, min(self.stage.w, self.panel.x - self.stage.x)), self.stage.h
        )


def auto_scale(width: int, height: int, user: float = 1.0) -> float:
    """Interface scale: by the window's height, times the user's own, but never too large for the window."""
    automatic = 1.0
    for least, k in ((1600, 2.0), (1200, 1.5), (900, 1.25)):
        if height >= least:
            automatic = k
            break
    user = user if math.isfinite(user) else 1.0
    space = min(1.0, width / SMALLEST[0], height / SMALLEST[1])
    space = max(space, min(width / COMFORTABLE[0], height / COMFORTABLE[1]))
    return max(0.5, min(automatic * min(max(user, 0.75), 2.0), space, 4.0))


def arrange(
    width: int, height: int, k: float, *, panel: bool = True, strips: int = 3, tall: bool = False
) -> Layout:
    """Lay out a window of that many pixels at interface scale ``k``, with so many strip charts.

    ``tall``: their row is higher, where the window is.
    """
    window = Rect(0, 0, max(1, width), max(1, height))
    px = _scaler(k)
    narrow = window.w < DRAWER_BELOW * k
    bar_height = min(px(TOP_BAR), window.h - 1) if window.h > px(TOP_BAR) else 0
    top_bar = Rect(0, 0, window.w, bar_height)
    panel_width = min(px(PANEL), window.w) if panel and bar_height else 0
    panel_rect = Rect(window.w - panel_width, bar_height, panel_width, window.h - bar_height)
    below = Rect(0, bar_height, window.w - (0 if narrow else panel_width), window.h - bar_height)
    if below.w < 1:
        below.w = 1
    hint_height = px(HINT_BAR) if below.h >= px(180) else 0
    values_only = window.h < VALUES_BELOW * k
    full = TALL_STRIPS if tall and below.h >= px(2 * TALL_STRIPS) else STRIPS
    strip_height = px(STRIP_VALUES if values_only else full) if strips and below.h >= px(240) else 0
    stage = Rect(0, below.y, below.w, max(1, below.h - hint_height - strip_height))
    strips_rect = Rect(0, stage.bottom, below.w, strip_height)
    hint_bar = Rect(0, strips_rect.bottom, below.w, hint_height)
    if narrow and panel_width:
        panel_rect.h = stage.h
    shown = _chart_count(below.w / k, strips) if strip_height else 0
    return Layout(
        k, window, top_bar, stage, panel_rect, narrow and panel_width > 0, strips_rect,
        _columns(strips_rect, shown, px(GUTTER)), values_only, hint_bar,
    )  # fmt: skip


def arrange_over(width: int, height: int, k: float) -> Layout:
    """The layout of a game that fills its window, without panel and charts: bar and hints lie over it.

    The game leaves rows free for them, as high as they are in a window of GAME. Where the interface's scale
    makes them higher than those rows, all is arranged as usual.
    """
    if k > min(width / GAME[0], height / GAME[1]) + 1e-9:
        return arrange(width, height, k, panel=False, strips=0)
    window = Rect(0, 0, width, height)
    bar, hints = round(TOP_BAR * k), round(OVERLAID_HINTS * k)
    nothing = Rect(width, bar, 0, 0)
    return Layout(
        k, window, Rect(0, 0, width, bar), window, nothing, False, Rect(0, height - hints, width, 0), (),
        False, Rect(0, height - hints, width, hints), overlaid=True,
    )  # fmt: skip


def overlay_rect(window: Rect, k: float, height: float, width: float = 1056.0) -> Rect:
    """A card in the middle: at most ``width`` wide, 32 free at its sides, 48 above and below (design px).

    In a small window less is left free.
    """
    edges = SMALL_EDGES if min(window.w, window.h) < SMALL_BELOW * k else EDGES
    w = max(1, min(round(width * k), window.w - round(2 * edges[0] * k)))
    h = max(1, min(round(height * k), window.h - round(2 * edges[1] * k)))
    card = Rect(0, 0, w, h)
    card.center = window.center
    return card


def _scaler(k: float):
    return lambda x: round(x * k)


def _chart_count(stage_width: float, strips: int) -> int:
    if stage_width < 400:
        return min(strips, 1)
    return min(strips, 2 if stage_width < TWO_CHARTS_BELOW else 3)


def _columns(strips: Rect, count: int, gutter: int) -> tuple[Rect, ...]:
    """Columns of one width with gutters between and beside them."""
    if not count:
        return ()
    pitch = (strips.w - gutter) / count
    columns = []
    for i in range(count):
        left, right = round(gutter + i * pitch), round((i + 1) * pitch)
        columns.append(Rect(strips.x + left, strips.y, max(1, right - left), strips.h))
    return tuple(columns)

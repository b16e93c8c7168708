"""Paints all skins of a figure in one call, in their colours."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygame

from game.arrays import Floats
from game.scenes.skeletons.cells import WHOLE, Cell
from game.scenes.skeletons.rig import Rig
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.polygons import NO_EDGE, paint

INK = pygame.Color(18, 22, 26)  # what edges are darkened with


def fill_color(canvas: Canvas, fill: str) -> pygame.Color:
    """The colour of a skin by name or "#rrggbb"; what is none is chalk."""
    try:
        return pygame.Color(fill) if fill.startswith("#") else canvas.color(fill)
    except (KeyError, ValueError, AttributeError):
        return canvas.color("chalk")


class SkinPainter:
    """Paints the skins of one rig after the other; keeps the colours of the last."""

    def __init__(self) -> None:
        self._rig: Rig | None = None
        self._theme: Any = None
        self._moved = np.zeros((0, 2))
        self._inks = self._edges = self._none = np.zeros(0, dtype=np.int64)
        self._strengths, self._shades = np.zeros(0), np.zeros(0, dtype=bool)

    def _take(self, canvas: Canvas, rig: Rig) -> None:
        """Colours of the rig's skins. A skin that lets something through has a line for its edge, or none."""
        if rig is self._rig and canvas.theme is self._theme:
            return
        self._rig, self._theme = rig, canvas.theme
        skins = rig.figure.skins
        colors = [fill_color(canvas, skin.fill) for skin in skins]
        self._inks = np.array([canvas.ink(color) for color in colors], dtype=np.int64)
        darker = [canvas.ink(color.lerp(INK, 0.5)) for color in colors]
        solid = [skin.outline and skin.strength >= 1.0 for skin in skins]
        self._edges = np.array(
            [ink if s else NO_EDGE for ink, s in zip(darker, solid, strict=True)], np.int64
        )
        self._strengths = np.array([skin.strength for skin in skins])
        self._shades = np.array([not skin.outline and skin.strength < 0.5 for skin in skins])
        self._moved = np.zeros((len(rig.skinned), 2))
        self._none = np.full_like(self._edges, NO_EDGE)

    def paint(
        self, canvas: Canvas, rig: Rig, points: Floats, strength: float = 1.0, fine: bool = True,
        cell: Cell = WHOLE,
    ) -> None:  # fmt: skip
        """All skins, from the first to the last, at places (v, 2) of the figure, which stands in ``cell``.

        fine: with edges, shades and every point; else the few points of `Rig.show_few`.
        """
        if not rig.figure.skins:
            return
        self._take(canvas, rig)
        solid = strength >= 1.0
        starts = rig.starts if fine else rig.few_starts
        points = cell.out(points[: starts[-1]])
        edges = self._edges if solid and fine else self._none
        shares = strength * self._strengths
        if not fine:
            shares[self._shades] = 0.0
        paint(canvas, points, starts, self._inks, shares, edges, self._moved)
        for i, skin in enumerate(rig.figure.skins):
            if skin.outline and (not solid or skin.strength < 1.0):
                edge = fill_color(canvas, skin.fill).lerp(INK, 0.25)
                outline = points[starts[i] : starts[i + 1]]
                canvas.polyline(outline, edge, 1.6, closed=True, alpha=0.9 * strength)

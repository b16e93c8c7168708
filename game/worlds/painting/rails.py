"""Tracks as two steel rails with ties between them, on pegs: one is seen behind the other, a bit higher."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pygame

from game.arrays import Floats
from game.physics.solids.tracks import curves as c
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.inks import color_of

PARTS = 4  # chords that a piece is drawn by
BREADTH = 0.06  # m, of a rail
PEG, EVERY = 0.05, 1.3  # m: radius of a peg, between two
THIN = 2.5  # design px: of a thinner rail only the one in front is seen
FINE = 0.0012  # m: so far a drawn line may be off
BACK_AT = np.array((0.085, 0.1))  # m: where the rail behind is seen
TIES_EVERY = 0.26  # m between ties of the two
LIGHT_AT = np.array((-0.006, 0.014))  # m: where the light lies on a rail
# by day and at night: dark edge, steel, light
TONES = {False: (0x4B555D, 0x9AA5AD, 0xF4F7F8), True: (0x10151A, 0x77838E, 0xDDE6EC)}


class Rail(NamedTuple):
    """line (n, 2) m; pegs (k, 2) m; ties (l, 2) m on it; low and high: corners of its box, m."""

    line: Floats
    pegs: Floats
    ties: Floats
    low: Floats
    high: Floats


def lines_of(pieces: c.Pieces, curves: list[c.Curve], parts: int = PARTS) -> list[Floats]:
    """Each track as points (n, 2) m along its smooth curve."""
    found = []
    t = np.linspace(0.0, 1.0, parts, endpoint=False)[:, None]
    for number, curve in enumerate(curves):
        own = pieces.rows[(pieces.rows[:, c.TRACK] == number) & (pieces.rows[:, c.KIND] != c.VERTEX)]
        own = own[: len(own) // 2]  # the left side; the right one is the same curve
        axes = [
            own[:, at] + t * (own[:, at + 1] + t * (own[:, at + 2] + t * own[:, at + 3]))
            for at in (c.CX, c.CY)
        ]
        line = np.stack([axis.T.ravel() for axis in axes], axis=1)
        end = [[own[-1, at : at + 4].sum() for at in (c.CX, c.CY)]]
        found.append(np.concatenate([line, line[:1] if curve.closed else end]))
    return found


def rails_of(pieces: c.Pieces, curves: list[c.Curve]) -> list[Rail]:
    """All tracks, with no more points than can be seen."""
    found = []
    for line in lines_of(pieces, curves):
        thin = _thinned(line)
        way = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
        at = np.arange(0.3, max(float(way[-1]) - 0.1, 0.31), EVERY)
        ties = np.arange(0.5 * TIES_EVERY, max(float(way[-1]), TIES_EVERY), TIES_EVERY)
        pegs, ties = (
            np.stack([np.interp(one, way, line[:, 0]), np.interp(one, way, line[:, 1])], axis=1)
            for one in (at, ties)
        )
        found.append(Rail(thin, pegs, ties, line.min(axis=0), line.max(axis=0)))
    return found


def _thinned(line: Floats) -> Floats:
    """Without points at which a line hardly turns, whatever has been left out before."""
    steps = np.diff(line, axis=0)
    lengths = np.maximum(np.hypot(steps[:, 0], steps[:, 1]), 1e-12)
    turns = np.abs(np.diff(np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))))
    kept, off = [0], 0.0
    run = 0.0
    for k in range(len(turns)):
        run += float(lengths[k])
        off += float(turns[k])
        if off * (run + float(lengths[k + 1])) > 8.0 * FINE:
            kept.append(k + 1)
            run = off = 0.0
    return line[[*kept, len(line) - 1]]


def draw_rail_shadows(canvas: Canvas, rails: list[Rail], by: Floats, strength: float) -> None:
    """What they cast on the wall."""
    width = _width(canvas)
    for rail in _seen(canvas, rails):
        canvas.polyline(rail.line + by, pygame.Color(0, 0, 0), 1.5 * width, alpha=strength)


def draw_rails(canvas: Canvas, rails: list[Rail], dark: bool) -> None:
    """Rails, the ones behind them, and the pegs on which they lie."""
    edge, steel, light = (color_of(ink) for ink in TONES[dark])
    width = _width(canvas)
    behind = steel.lerp(edge, 0.35)
    for rail in _seen(canvas, rails):
        if len(rail.pegs):
            canvas.discs(rail.pegs + 0.5 * BACK_AT, PEG * 1.25, edge)
        if width > THIN:
            canvas.polyline(rail.line + BACK_AT, edge, 0.8 * width + 1.0)
            canvas.polyline(rail.line + BACK_AT, behind, 0.8 * width)
            canvas.segments(rail.ties, rail.ties + BACK_AT, behind, 0.55 * width)
        canvas.polyline(rail.line, edge, width + 1.4)
        canvas.polyline(rail.line, steel, width)
        canvas.polyline(rail.line + LIGHT_AT, light, max(0.3 * width, 0.7), alpha=0.8)


def _seen(canvas: Canvas, rails: list[Rail]) -> list[Rail]:
    seen = canvas.camera.visible()
    return [
        one for one in rails
        if one.low[0] < seen.right and one.high[0] > seen.left
        and one.low[1] - 0.3 < seen.top and one.high[1] > seen.bottom
    ]  # fmt: skip


def _width(canvas: Canvas) -> float:
    """Design px of a rail."""
    return max(BREADTH * canvas.pixels_per_unit / canvas.k, 1.4)

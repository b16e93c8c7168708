"""Colours as numbers 0xRRGGBB, one or arrays of them: their channels, shades and mixtures."""

from __future__ import annotations

from typing import Any

import numpy as np
import pygame

from game.arrays import Floats, Inks, Longs

OPAQUE = np.uint32(0xFF000000)


def color_of(ink: int) -> pygame.Color:
    """For the canvas."""
    return pygame.Color(ink >> 16 & 255, ink >> 8 & 255, ink & 255)


def scaled(ink: int, share: float) -> int:
    """With all channels times a share, cut off."""
    r, g, b = (min(int((ink >> shift & 255) * share), 255) for shift in (16, 8, 0))
    return r << 16 | g << 8 | b


def lighter(ink: int, share: float) -> int:
    """A share of the way to white, cut off."""
    r, g, b = (int((ink >> shift & 255) + share * (255 - (ink >> shift & 255))) for shift in (16, 8, 0))
    return r << 16 | g << 8 | b


def channels(inks: Any, kind: Any = np.float64) -> Any:
    """(..., 3) red, green, blue from 0 to 255, of one ink or an array of them."""
    return np.stack([np.asarray(inks) >> shift & 255 for shift in (16, 8, 0)], axis=-1).astype(kind)


def packed(colors: Any) -> Longs:
    """Colours (..., 3) 0 to 255 as numbers, rounded."""
    whole = (colors + 0.5).astype(np.int64)
    return np.asarray(whole[..., 0] << 16 | whole[..., 1] << 8 | whole[..., 2])


def opaque(colors: Any) -> Inks:
    """Colours (..., 3) as pixels 0xFFRRGGBB, rounded and clipped."""
    whole = np.clip(colors + 0.5, 0.0, 255.0).astype(np.uint32)
    inks: Inks = whole[..., 0] << 16 | whole[..., 1] << 8 | whole[..., 2] | OPAQUE
    return np.ascontiguousarray(inks, dtype=np.uint32)


def shaded(inks: Longs, shares: float | Floats) -> Longs:
    """Colours so far on their way to white (above 0) or to black (below)."""
    shares = np.asarray(shares)
    return mixed(inks, np.where(shares > 0.0, 0xFFFFFF, 0), np.abs(shares))


def mixed(inks: Longs, others: Any, shares: float | Floats) -> Longs:
    """Colours with a share of others."""
    own = channels(inks)
    return packed(own + np.asarray(shares)[..., None] * (channels(others) - own))

"""Colours as numbers: channels and back, shades and mixtures."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from game.worlds.painting.inks import channels, color_of, lighter, mixed, opaque, packed, scaled, shaded

INK = st.integers(0, 0xFFFFFF)


@given(INK)
def test_channels_come_back(ink: int) -> None:
    assert packed(channels(ink)) == ink and opaque(channels(np.array([ink])))[0] == 0xFF000000 | ink
    color = color_of(ink)
    assert (color.r, color.g, color.b) == tuple(channels(ink, int).tolist())


@given(INK)
def test_shades_end_at_white_and_black(ink: int) -> None:
    inks = np.array([ink])
    assert shaded(inks, 1.0)[0] == 0xFFFFFF and shaded(inks, -1.0)[0] == 0 and shaded(inks, 0.0)[0] == ink
    assert lighter(ink, 1.0) == 0xFFFFFF and scaled(ink, 0.0) == 0 and scaled(ink, 1.0) == ink


def test_a_mixture_lies_between() -> None:
    assert mixed(np.array([0x102030]), 0x305070, 0.5).tolist() == [0x203850]
    assert shaded(np.array([0x808080, 0x808080]), np.array([0.5, -0.5])).tolist() == [0xC0C0C0, 0x404040]
    assert scaled(0x8040FF, 2.0) == 0xFF80FF  # cut off

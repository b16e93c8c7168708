"""The room in the light of its fire, against the same sums in whole arrays."""

from __future__ import annotations

import numpy as np
import pytest

from game.scenes.fireplace.room import paint_room


@pytest.mark.parametrize("warm", [(0, 0, 0), (200, 120, 60), (480, 288, 144)])
@pytest.mark.parametrize("own", [(58, 64, 80), (232, 232, 232), (256, 200, 0)])
def test_each_pixel_is_its_colour_in_the_light_there(own, warm):
    rng = np.random.default_rng(3)
    colors = rng.integers(0, 1 << 24, (11, 29)).astype(np.uint32) | np.uint32(0xFF000000)
    lit = rng.integers(0, 256, (11, 29)).astype(np.uint8)
    pixels, clip = np.full((20, 40), 0xFF123456, np.uint32), np.array((5, 4, 34, 15), np.int64)
    paint_room(pixels, clip, colors, lit, np.array(own), np.array(warm, np.int64))
    inside = pixels[4:15, 5:34]
    for shift, lamp, strength in zip((16, 8, 0), own, warm, strict=True):
        channel = colors.astype(np.int64) >> shift & 255
        wanted = np.minimum(channel * (lamp + (strength * lit.astype(np.int64) >> 8)) >> 8, 255)
        assert ((inside >> np.uint32(shift) & np.uint32(255)) == wanted).all()
    assert (inside >> np.uint32(24) == 255).all()
    pixels[4:15, 5:34] = 0xFF123456
    assert (pixels == 0xFF123456).all()

"""Outlines: how far their corners lie from their own place."""

import pytest

from game.scenes.shared.outlines.outline import outline_through, size_of


def test_the_size_is_that_of_the_farthest_corner():
    outline = outline_through([(10.0, 5.0), (16.0, 5.0), (16.0, 13.0), (10.0, 13.0)], True)
    assert outline.position == (13.0, 9.0)
    assert size_of(outline) == pytest.approx(5.0)
    assert size_of(outline_through([(2.0, 3.0)], False)) == 0.0

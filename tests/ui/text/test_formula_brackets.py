"""Brackets of formulas: as high as they are asked to be, alike above and below, and in pairs."""

from __future__ import annotations

import pytest

from game.ui.text.formula_brackets import bracket


def ends(sign: str, half: float = 20.0) -> set[tuple[float, float]]:
    """Where the strokes of a sign begin and end, to a thousandth of a pixel."""
    strokes, _ = bracket(sign, half, 16.0, 1.0)
    return {(round(x, 3), round(y, 3)) for one in strokes for x, y in (one[:2], one[2:4])}


@pytest.mark.parametrize("sign", "()[]{}|‖")
def test_a_bracket_reaches_as_far_up_as_down(sign):
    places = ends(sign)
    assert places == {(x, -y) for x, y in places}
    assert max(y for _, y in places) == pytest.approx(20.0, abs=0.5)
    assert max(y for _, y in ends(sign, 40.0)) == pytest.approx(40.0, abs=0.5)
    assert all(0.0 <= x <= bracket(sign, 20.0, 16.0, 1.0)[1] for x, _ in places)


@pytest.mark.parametrize("pair", ["()", "[]", "{}"])
def test_an_opening_and_a_closing_one_are_mirrored(pair):
    opening, closing = pair
    width = bracket(opening, 20.0, 16.0, 1.0)[1]
    assert bracket(closing, 20.0, 16.0, 1.0)[1] == width
    mirrored = {(round(width - x, 2), round(y, 2)) for x, y in ends(opening)}
    assert mirrored == {(round(x, 2), round(y, 2)) for x, y in ends(closing)}

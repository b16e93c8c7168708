"""The small chart in a corner of a story's picture."""

from __future__ import annotations

import numpy as np
import pygame
import pytest

from game.stage import Comparison
from game.ui.charts.comparison import EXPECTED, LIMIT, MEASURED, chart_rect, close_axis, draw_comparison
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

LOOK = Look(theme_named("dark"), 1.0)
X = np.linspace(0.0, 2.0, 60)


def drawn(shown: Comparison, opacity: float = 1.0) -> np.ndarray:
    """Pixels of a chart alone, (w, h, 3)."""
    surface = pygame.Surface((320, 200), 0, 32)
    draw_comparison(surface, LOOK, surface.get_rect(), shown, opacity)
    return pygame.surfarray.array3d(surface).astype(int)


def inked(pixels: np.ndarray, color: str, below: int = 40) -> np.ndarray:
    """Places (n, 2) of pixels near a colour, below the key."""
    ink = LOOK.color(color)
    near = np.abs(pixels - (ink.r, ink.g, ink.b)).sum(axis=2) < 60
    found = np.argwhere(near)
    return found[found[:, 1] > below]


def curve(values: np.ndarray, expected: np.ndarray) -> Comparison:
    return Comparison(
        np.stack([X, values], axis=1), np.stack([X, expected], axis=1), ("it", "law"), "m", "time", "s"
    )


def test_what_is_more_stands_higher_and_both_are_seen():
    pixels = drawn(curve(X, 0.5 * X))
    right = pixels[250:]
    assert inked(right, MEASURED)[:, 1].mean() < inked(right, EXPECTED)[:, 1].mean() - 20
    assert len(inked(pixels, MEASURED)) > 200
    assert 40 < len(inked(pixels, EXPECTED)) < len(inked(pixels, MEASURED))  # it is dashed


def test_a_value_lies_on_its_place_of_the_axis():
    """A level curve at the middle of its axis is as far from the uppermost rule as from the lowest."""
    pixels = drawn(curve(np.where(X < 1.0, 1.0, 2.0), np.zeros(60)))
    left, right = inked(pixels[60:150], MEASURED), inked(pixels[200:280], MEASURED)
    foot = inked(pixels[60:280], EXPECTED)[:, 1].mean()
    assert foot - np.median(left[:, 1]) == pytest.approx(0.5 * (foot - np.median(right[:, 1])), abs=2.0)


def test_a_limit_is_ruled_across_at_its_value_and_the_axis_keeps_near():
    """From 21 to 17 beside a limit of 16 the curve falls over most of the chart, to just above the rule."""
    shown = curve(21.0 - 2.0 * X, 21.0 - 2.0 * X)._replace(limit=("limit", 16.0))
    pixels, plain = drawn(shown), drawn(shown._replace(limit=None))
    rule = inked(pixels[150:], LIMIT)[:, 1]
    assert (
        len(rule) > 100
        and np.ptp(np.quantile(rule, [0.1, 0.9])) < 4.0
        and len(inked(plain[150:], LIMIT)) < 30
    )
    heights = [inked(one[60:300], MEASURED)[:, 1] for one in (pixels, plain)]
    assert np.ptp(heights[0]) > 2.5 * np.ptp(heights[1])
    low, high = close_axis(np.array([21.0, 17.0, 16.0]))
    foot, head = heights[0].max(), heights[0].min()
    unit = (foot - head) / 4.0
    assert np.median(rule) - foot == pytest.approx(unit, abs=4.0) and (low, high) == (15.0, 21.0)


@pytest.mark.parametrize("values", [(0.0, 0.001), (-3.0, 8.0), (15.9, 20.95), (1e6, 1e6), (99.0, 101.0)])
def test_a_close_axis_holds_its_values_and_its_middle_is_round(values: tuple[float, float]):
    axis = close_axis(np.array(values))
    assert axis.low <= values[0] and values[1] <= axis.high and axis.high > axis.low
    middle = 0.5 * (axis.low + axis.high)
    assert float(f"{middle:.5g}") == pytest.approx(middle, rel=1e-9)


def test_bars_are_as_long_as_their_values():
    row = np.array([[0.0, 4.0]])
    pixels = drawn(Comparison(row, 0.5 * row, ("it", "law"), "m/s"))
    lengths = []
    for color in (MEASURED, EXPECTED):
        counts = np.bincount(inked(pixels, color, below=0)[:, 1], minlength=200)
        lengths.append(counts.max())
    assert lengths[0] == pytest.approx(2 * lengths[1], abs=3)


@pytest.mark.parametrize("corner", ["top right", "top left", "bottom right", "bottom left"])
@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (1920, 1080)])
def test_it_keeps_out_of_the_middle_of_the_picture(corner: str, size: tuple[int, int]):
    picture = pygame.Rect(0, 0, *size)
    look = Look(theme_named("dark"), auto_scale(*size))
    place = chart_rect(look, picture, corner)
    assert picture.contains(place)
    middle = picture.inflate(-round(0.6 * picture.w), -round(0.4 * picture.h))
    assert not place.colliderect(middle)
    assert ("left" in corner) == (place.centerx < picture.centerx)
    assert ("top" in corner) == (place.centery < picture.centery)


def test_nothing_is_drawn_of_what_has_gone():
    assert drawn(curve(X, X), 0.0).max() == 0


def test_values_that_are_no_numbers_are_left_out():
    """The rest of the curve stays where it is, and of a chart without values nothing is drawn."""
    gaps = np.where((X > 0.8) & (X < 1.2), np.nan, X)
    whole, holed = drawn(curve(X, 0.5 * X)), drawn(curve(gaps, 0.5 * X))
    assert 0 < len(inked(holed, MEASURED)) <= len(inked(whole, MEASURED))
    assert inked(holed, MEASURED)[:, 1].min() == inked(whole, MEASURED)[:, 1].min()
    nothing = drawn(
        Comparison(np.array([[1.0, np.nan]]), np.array([[1.0, 2.0]]), ("it", "law"), "m", "time", "s")
    )
    assert len(inked(nothing, MEASURED)) == 0

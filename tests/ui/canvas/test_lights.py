"""Verbs of light: they shine where the camera says, and the sky stays where it is."""

import numpy as np

from game.stage import Frame
from tests.ui.canvas.test_canvas import at, begun


def test_glow_is_where_the_camera_says_and_adds():
    canvas = begun()
    before = at(canvas, 1.0, 0.5)
    canvas.glow([(1.0, 0.5)], 0x402010, 2)
    once = at(canvas, 1.0, 0.5)
    assert once.r > before.r + 40 and once.g > before.g and at(canvas, -1.0, 0.5) == before
    canvas.glow([(1.0, 0.5)], 0x402010, 2)
    assert at(canvas, 1.0, 0.5).r > once.r + 40


def test_soft_glow_waits_for_the_bloom():
    canvas = begun()
    before = at(canvas, 0.5, 0.0)
    canvas.soft_glow([(0.0, 0.0)], 1.0, 0xFFFFFF, 0.5)
    assert at(canvas, 0.5, 0.0) == before
    canvas.bloom(1.0)
    assert at(canvas, 0.5, 0.0).g > before.g + 20
    after = at(canvas, 0.5, 0.0)
    canvas.bloom(1.0)
    assert at(canvas, 0.5, 0.0) == after


def test_the_sky_stays_when_the_camera_goes_sideways():
    skies = []
    for middle in (0.0, 7.0):
        canvas = begun(frame=Frame(middle - 2.0, -1.0, middle + 2.0, 1.0))
        ground = canvas.surface.get_at((0, 99))
        canvas.stars(0.0, 80, 3)
        skies.append(np.array([[canvas.surface.get_at((x, y)).g for x in range(200)] for y in range(100)]))
        assert canvas.surface.get_at((0, 99)) == ground
    assert (skies[0] == skies[1]).all() and (skies[0] > skies[0].min()).sum() > 30


def test_water_mirrors_from_the_shore_down():
    canvas = begun()
    canvas.polygon([(-2.0, 0.4), (2.0, 0.4), (2.0, 0.7), (-2.0, 0.7)], fill="amber")
    canvas.water(0.0, 1.0, 0.0, "stage", 0.9)
    assert at(canvas, 0.0, -0.55).r > at(canvas, 0.0, -0.05).r + 60
    assert at(canvas, 0.0, 0.55).r > at(canvas, 0.0, -0.55).r

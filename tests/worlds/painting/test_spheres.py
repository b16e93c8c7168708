"""Lit balls: smooth from pixel to pixel, brightest towards the lamp, round, and turning with their dots."""

import numpy as np

from game.worlds.painting.spheres import LIGHT, paint_spheres

SIDE, RADIUS = 120, 50.0


def painted(turn: float = 0.0, ink: int = 0x808080) -> np.ndarray:
    """Brightness (h, w) of one ball in the middle, before black."""
    pixels = np.zeros((SIDE, SIDE), np.uint32)
    paint_spheres(
        pixels, np.array((0, 0, SIDE, SIDE), np.int64), np.full((1, 2), 0.5 * SIDE), np.array((RADIUS,)),
        np.array(((np.cos(turn), np.sin(turn)),)), np.array((ink,)),
    )  # fmt: skip
    return (pixels >> 8 & 255).astype(float)


def test_a_ball_has_no_rings_in_its_shade() -> None:
    """Along a line without dots the light falls evenly: no step of more than a few of 255."""
    row = painted(turn=np.pi)[60, 62:104]  # the dot of that half lies on the other side
    assert np.abs(np.diff(row)).max() <= 6.0
    assert len(set(row.tolist())) > 20  # nine rings would leave nine tones


def test_it_is_brightest_where_it_faces_the_lamp_and_the_viewer() -> None:
    picture = painted()
    y, x = np.unravel_index(int(picture.argmax()), picture.shape)
    assert x < 60 and y < 60
    towards = (60 + 0.5 * RADIUS * LIGHT[0], 60 - 0.5 * RADIUS * LIGHT[1])
    assert np.hypot(x - towards[0], y - towards[1]) < 0.25 * RADIUS


def test_it_is_round_and_its_dots_turn() -> None:
    plain, turned = painted(), painted(turn=0.5)
    y, x = np.mgrid[0:SIDE, 0:SIDE] + 0.5
    away = np.hypot(x - 60.0, y - 60.0)
    assert np.all(plain[away < RADIUS - 1.5] > 0.0) and np.all(plain[away > RADIUS + 1.0] == 0.0)
    dot = (int(60 - 0.6 * RADIUS * np.sin(0.5)), int(60 + 0.6 * RADIUS * np.cos(0.5)))
    assert turned[dot] < 0.8 * plain[dot]

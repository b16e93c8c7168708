"""Tracks by formulas: where they begin and end, and the equation that each of them keeps."""

import numpy as np
import pytest

from game.worlds.entries.tracks import TrackEntry, curve_of

WIDTH, DEPTH = 2.0, 1.5


def points_of(form: str, size: tuple[float, float] = (WIDTH, DEPTH), **beside) -> np.ndarray:
    return np.asarray(curve_of(TrackEntry(form=form, size=size, count=41, **beside)).points)


@pytest.mark.parametrize("form", ["line", "parabola", "cycloid", "arc"])
@pytest.mark.parametrize("size", [(2.0, 1.5), (1.0, 2.0), (3.0, 0.9)])
def test_a_way_down_leads_from_its_place_through_its_size(form: str, size: tuple[float, float]):
    points = points_of(form, size)
    assert len(points) == 41
    np.testing.assert_allclose(points[[0, -1]], [(0.0, 0.0), (size[0], -size[1])], atol=1e-12)


def test_each_way_down_keeps_its_equation():
    x, y = points_of("line").T
    np.testing.assert_allclose(y, -DEPTH / WIDTH * x, atol=1e-14)
    x, y = points_of("parabola").T
    np.testing.assert_allclose(x / WIDTH, (y / DEPTH) ** 2, atol=1e-14)
    x, y = points_of("arc").T
    radius = (WIDTH**2 + DEPTH**2) / (2.0 * WIDTH)
    np.testing.assert_allclose(np.hypot(x - radius, y), radius, rtol=1e-14)
    x, y = points_of("cycloid").T  # its slope: (dy/dx)^2 = (2 a - depth) / depth
    slopes, middles = np.diff(y) / np.diff(x), 0.5 * (y[1:] + y[:-1])
    wheel = 0.5 * (slopes**2 + 1.0) * -middles
    np.testing.assert_allclose(wheel[10:], wheel[-1], rtol=1e-3)


def test_rounds_keep_their_radii():
    x, y = points_of("circle").T
    np.testing.assert_allclose((x / WIDTH) ** 2 + (y / DEPTH) ** 2, 1.0, rtol=1e-14)
    for form, middle in (("whirl", (0.0, 2.0)), ("spiral", (0.0, 0.0))):
        reach = np.hypot(*(points_of(form, (2.0, 0.5)) - middle).T)
        assert (reach[0], reach[-1]) == (pytest.approx(2.0), pytest.approx(0.5))
        assert (np.diff(reach) < 1e-12).all()


def test_a_loop_is_a_ramp_a_circle_and_a_way_on():
    points = points_of("loop", (1.0, 2.75))
    assert points[0].tolist() == pytest.approx([-1.6 * 2.75, 2.75])
    round_, way = points[20:62], points[62:]
    np.testing.assert_allclose(np.hypot(round_[:, 0], round_[:, 1] - 1.0), 1.0, atol=1e-12)
    assert way[-1].tolist() == pytest.approx([4.0, 0.0]) and (way[:, 1] == 0.0).all()


def test_eight_waves():
    x, y = points_of("waves", (2.0, 0.3)).T
    np.testing.assert_allclose(y, 0.3 * np.sin(np.pi * x), atol=1e-13)
    assert x[-1] == 16.0


def test_it_stands_at_its_place_mirrored_with_a_tail_and_beside_the_ball_it_carries():
    plain = points_of("arc")
    np.testing.assert_allclose(points_of("arc", at=(3.0, -1.0)), plain + np.array((3.0, -1.0)))
    np.testing.assert_allclose(points_of("arc", mirrored=True), plain * (-1.0, 1.0))
    tailed = points_of("arc", tail=((1.0, 0.5),))
    np.testing.assert_allclose(tailed[-1], plain[-1] + np.array((1.0, 0.5)))
    beside = points_of("line", carries=0.1)  # to the right of its way, the ball above it
    normal = np.array((-DEPTH, -WIDTH)) / np.hypot(WIDTH, DEPTH)
    np.testing.assert_allclose(beside - points_of("line"), np.tile(0.1 * normal, (41, 1)), atol=1e-12)

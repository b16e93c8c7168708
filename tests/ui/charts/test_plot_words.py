"""Words in the plot of a study keep off its marks and lines wherever there is room for them."""

import itertools
import math

import pygame
import pytest

from game.ui.charts.plot import WorkPrecisionPlot
from game.ui.charts.plot_data import PlotPoint, PlotSeries, Present
from game.ui.charts.plot_marks import _CORNERS, Brush
from game.ui.charts.plot_words import PlotWords
from game.ui.look.look import Look
from game.ui.look.theme import DARK

CELLS = tuple(10.0 ** (0.3 * i - 1.0) for i in range(10))


def times_of(shape):
    """Times over cell sizes as studies find them: through a minimum, falling, rising, with a peak."""
    turned = {
        "minimum": lambda c: c + 1.0 / c,
        "falling": lambda c: 1.0 / c,
        "rising": lambda c: c,
        "peak": lambda c: 1.0 / (c + 1.0 / c),
    }
    return tuple(1e-3 * turned[shape](c) for c in CELLS)


@pytest.mark.parametrize("shape", ("minimum", "falling", "rising", "peak"))
@pytest.mark.parametrize("present", range(len(CELLS)))
def test_no_line_runs_through_what_the_present_setting_is(shape, present, monkeypatch):
    pygame.font.init()
    one, two = times_of(shape), tuple(3.0 * t for t in times_of("falling"))
    series = [
        PlotSeries(name, tuple(PlotPoint(c, t) for c, t in zip(CELLS, times, strict=True)))
        for name, times in (("One cell", one), ("All covered", two))
    ]
    places = []
    freest = PlotWords._freest
    monkeypatch.setattr(
        PlotWords, "_freest", lambda self, wanted: places.append(freest(self, wanted)) or places[-1]
    )
    plot = WorkPrecisionPlot(Look(DARK))
    point = PlotPoint(CELLS[present], one[present], words="cell size 2.00, five hundred boxes")
    plot.show(series, Present(0, point, point.words), 1e-3)
    plot.draw(pygame.Surface((800, 520), 0, 32), pygame.Rect(80, 20, 680, 440))
    (box,) = places
    for i, method in enumerate(series):
        for a, b in itertools.pairwise(plot.place(i, p) for p in method.points):
            assert not box.clipline(a, b), (box, a, b)


@pytest.mark.parametrize("present", (1, 4, 8))
def test_the_leader_runs_from_the_ring_straight_to_the_words(present, monkeypatch):
    pygame.font.init()
    times = times_of("minimum")
    series = [PlotSeries("One cell", tuple(PlotPoint(c, t) for c, t in zip(CELLS, times, strict=True)))]
    leaders = []
    chain = Brush.chain

    def seen(self, points, width, color):
        if color == "amber":
            leaders.append(points)
        chain(self, points, width, color)

    monkeypatch.setattr(Brush, "chain", seen)
    plot = WorkPrecisionPlot(Look(DARK))
    point = PlotPoint(CELLS[present], times[present], words="cell size 2.00")
    plot.show(series, Present(0, point, point.words), 1e-3)
    plot.draw(pygame.Surface((800, 520), 0, 32), pygame.Rect(80, 20, 680, 440))
    ((begin, end),) = leaders
    ring = plot.place(0, series[0].points[present])
    assert math.dist(ring, begin) == pytest.approx(10.5, abs=1e-6)
    assert math.dist(ring, begin) + math.dist(begin, end) == pytest.approx(math.dist(ring, end), abs=1e-6)


@pytest.mark.parametrize("name", sorted(_CORNERS))
def test_marks_are_their_own_mirror_images_and_of_one_weight(name):
    """A point lies in the middle of its mark, and no method's mark is much larger than another's."""
    corners = _CORNERS[name]
    assert sorted((-x, y) for x, y in corners) == sorted(corners)
    turned = zip(corners, corners[1:] + corners[:1], strict=True)
    area = 0.5 * abs(sum(x * v - y * u for (x, y), (u, v) in turned))
    assert 2.5 < area < 4.1
    inside = [min(x for x, _ in corners), min(y for _, y in corners)]
    assert all(-1.4 < low < -0.9 for low in inside)


def test_one_triangle_is_the_other_upside_down():
    up, down = (_CORNERS[f"triangle-{way}"] for way in ("up", "down"))
    assert sorted((x, -y) for x, y in up) == sorted(down)

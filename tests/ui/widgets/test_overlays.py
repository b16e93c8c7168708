"""Help page and accuracy overlay: made from declarations and data, in any window, closed and clicked."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pygame
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from game.stage import Equation, Scene
from game.ui.charts.accuracy import AccuracyPage
from game.ui.charts.accuracy_data import AccuracyData, Progress, TableRow, sentence_for
from game.ui.charts.plot import WorkPrecisionPlot
from game.ui.charts.plot_data import PlotAxes, PlotPoint, PlotSeries, Present, decades
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.widgets.helppage import HelpPage, paragraphs_of
from game.ui.widgets.wishes import Wish
from tests.ui.pointing import click, down, event, move, press
from tests.ui.sample_scene import Sample

SIZES = [(1, 1), (90, 60), (320, 240), (700, 500), (1280, 720), (1920, 1080)]


def runs(cost, error, order, count=8, pending=0):
    good = [
        PlotPoint(
            cost * 2**i, error * 2 ** (-order * i), pending=i >= count - pending, parameters={"dt": 2.0**-i}
        )
        for i in range(count)
    ]
    return (PlotPoint(cost / 3, math.inf, diverged=True, parameters={"dt": 4.0}), *good)


SERIES = (
    PlotSeries("Explicit Euler", runs(1e-3, 0.5, 1.0), 1.0, "vermilion", "triangle-up"),
    PlotSeries("Verlet", runs(1.2e-3, 0.1, 2.0), 2.0, "chalk", "disc"),
    PlotSeries("Runge-Kutta 4", runs(4e-3, 0.05, 4.0, pending=3), 4.0, "violet", "diamond"),
)
ROWS = (
    TableRow("Explicit Euler", 1.0, 1.0, 0.5),
    TableRow("Verlet", 2.0, 2.0, 0.012),
    TableRow("Runge-Kutta 4", math.nan, 4.0, math.nan),
)
DATA = AccuracyData(
    "Bouncing ball", "Error of the height.", PlotAxes(), SERIES, ROWS,
    Present(1, SERIES[1].points[4], "Verlet"), 1e-3, sentence_for(ROWS, "one millimetre"),
    ("Click a point to set the scene to it.",),
)  # fmt: skip


# -- help ----------------------------------------------------------------------------------------------


def test_paragraphs_come_from_the_docstring():
    assert paragraphs_of(Sample)[0] == "A ball bounces on the ground."
    assert len(paragraphs_of(Sample)) == 2 and "\n" not in paragraphs_of(Sample)[1]


@pytest.mark.parametrize("size", SIZES)
def test_help_in_any_window(any_look, size):
    page = HelpPage(any_look, Sample, [(("Space",), "pause")])
    page.place(pygame.Rect(0, 0, *size), any_look)
    page.update(1.0)
    surface = pygame.Surface(size, 0, 32)
    page.draw(surface)
    for key in (pygame.K_END, pygame.K_HOME, pygame.K_PAGEDOWN, pygame.K_UP):
        page.handle(press(key))
        page.draw(surface)
    assert page.scroll >= 0


def test_help_scrolls_to_its_end_and_no_farther(look):
    page = HelpPage(look, Sample)
    page.place(pygame.Rect(0, 0, 700, 400), look)
    page.draw(pygame.Surface((700, 400), 0, 32))
    for _ in range(100):
        page.handle(event(pygame.MOUSEWHEEL, y=-1, x=0))
    assert page.scroll == page._sheet.get_height() - page._view().h > 0


def test_what_to_try_stands_above_the_keys(monkeypatch):
    look, places = Look(DARK, 1.0), {}
    draw = Look.text

    def note(self, surface, words, place, *style):
        places[words] = place
        return draw(self, surface, words, place, *style)

    monkeypatch.setattr(Look, "text", note)
    page = HelpPage(look, Sample)
    page.place(pygame.Rect(0, 0, 1280, 720), look)
    page.draw(pygame.Surface((1280, 720), 0, 32))
    assert places["Try this"][0] == places["Controls"][0]
    assert places["Try this"][1] < places["Controls"][1]


def test_help_closes_by_cross_and_by_a_press_beside_it(look):
    page = HelpPage(look, Sample)
    page.place(pygame.Rect(0, 0, 1280, 720), look)
    assert click(page, page.spots.spots[0].rect.center) == Wish("close")
    assert page.handle(down(5, 5)) == Wish("close")
    assert page.handle(down(640, 400)) is None
    page.leave()
    assert not page.update(1.0)


def test_in_place_of_a_formula_that_cannot_be_read_stands_what_is_wrong_with_it(look):
    class Odd(Scene):
        name, title = "odd", "Odd"
        equations = (
            Equation("Odd", r"\blob{", ""),
            Equation("Wide", "x = " + " + ".join("abcdefgh" * 9), ""),
        )

    page = HelpPage(look, Odd)
    page.place(pygame.Rect(0, 0, 1280, 720), look)
    surface = pygame.Surface((1280, 720), 0, 32)
    page.update(1.0)
    page.draw(surface)
    shown = {tuple(color) for color in np.unique(pygame.surfarray.array3d(surface).reshape(-1, 3), axis=0)}
    assert tuple(look.color("vermilion", words=True))[:3] in shown


# -- plot ----------------------------------------------------------------------------------------------


@given(st.lists(st.floats(allow_nan=True, allow_infinity=True), max_size=8))
@example([1.1e307])
@example([1.7e308, 1e300])
def test_decades_hold_what_can_be_held(values):
    found = decades(values)
    assert 2 <= found.high - found.low <= 16
    positive = [v for v in values if math.isfinite(v) and v > 0.0]
    if positive:
        assert 10.0**found.high >= max(positive) * (1 - 1e-6) or found.high == 308


def shown_plot(look):
    plot = WorkPrecisionPlot(look)
    plot.show(SERIES, DATA.present, 1e-3)
    plot.draw(pygame.Surface((700, 420), 0, 32), pygame.Rect(60, 20, 600, 360))
    return plot


def test_a_power_law_lies_on_a_straight_line(look):
    plot = shown_plot(look)
    places = [plot.place(0, point) for point in SERIES[0].points if not point.diverged]
    slopes = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in pairwise(places)]
    assert slopes == pytest.approx([slopes[0]] * len(slopes)) and slopes[0] > 0.0


def test_points_are_found_where_they_are_drawn(look):
    plot = shown_plot(look)
    for i, one in enumerate(SERIES):
        for j, point in enumerate(one.points):
            x, y = plot.place(i, point)
            assert plot.rect.collidepoint(x, y)
            found = plot.hit((round(x), round(y)))
            assert found is not None
            other = plot.place(found[0], SERIES[found[0]].points[found[1]])
            assert math.dist(other, (round(x), round(y))) <= math.dist((x, y), (round(x), round(y))) + 1e-9
            assert point.diverged == (y < plot.area.y) and j >= 0
    assert plot.hit((plot.rect.x + 2, plot.rect.bottom - 2)) is None


def test_zero_infinite_and_absent_errors(look):
    plot = WorkPrecisionPlot(look)
    odd = PlotSeries(
        "Odd",
        tuple(PlotPoint(c, e) for c in (0.0, 1e-3, math.nan, -1.0) for e in (0.0, math.inf, math.nan, -2.0)),
    )
    plot.show((odd,), Present(0, PlotPoint(math.nan, math.nan)), math.nan)
    plot.draw(pygame.Surface((300, 300), 0, 32), pygame.Rect(60, 20, 200, 200))
    assert plot.area.bottom - 8 <= plot.row(0.0) < plot.area.bottom
    plot.show((), None, 0.0)
    plot.draw(pygame.Surface((300, 300), 0, 32), pygame.Rect(60, 20, 200, 200))


# -- accuracy ------------------------------------------------------------------------------------------


def page_at(look, size=(1280, 720)):
    page = AccuracyPage(look, DATA)
    page.place(pygame.Rect(0, 0, *size), look)
    page.report(Progress(20, 27, "Runge-Kutta 4", 9.0, True))
    page.update(1.0)
    page.draw(pygame.Surface(size, 0, 32))
    return page


@pytest.mark.parametrize("size", SIZES)
def test_the_overlay_in_any_window(any_look, size):
    page = page_at(any_look, size)
    page.handle(move(size[0] / 2, size[1] / 2))
    page.show(AccuracyData("Empty", "", PlotAxes(y_unit="")))
    page.report(Progress())
    page.draw(pygame.Surface(size, 0, 32))
    assert pygame.Rect(0, 0, *size).contains(page.overlay.card)


def test_clicking_a_point_gives_its_parameters(look):
    page = page_at(look)
    x, y = page.plot.place(0, SERIES[0].points[3])
    place = (x + page.overlay.card.x, y + page.overlay.card.y)
    assert click(page, place) == Wish("point", {"dt": 0.25})
    words, rect = page.tip()
    assert words.startswith("Explicit Euler") and rect.collidepoint(place)
    page.handle(move(300, 600))
    assert page.tip() is None


def test_buttons_follow_the_runs(look):
    page = page_at(look)

    def press_button(name):
        return click(page, page.spots.find(name).rect.center)

    assert [press_button(n) for n in ("stop", "save-csv", "save-picture", "close")] == [
        Wish(n) for n in ("stop", "save-csv", "save-picture", "close")
    ]
    page.report(Progress(0, 27, "", math.nan, False))
    assert [press_button(n) for n in ("stop", "save-csv")] == [None, None]
    page.report(Progress(27, 27, "", math.nan, False))
    assert press_button("stop") is None and press_button("save-csv") == Wish("save-csv")


def test_the_sentence_compares_the_cheapest_with_the_most_expensive():
    assert (
        sentence_for(ROWS, "one millimetre")
        == "For one millimetre, Verlet is 42 times cheaper than Explicit Euler."
    )
    assert sentence_for(ROWS[2:], "x") == ""
    assert "about the same" in sentence_for((ROWS[0], ROWS[0]._replace(name="B", cost_s=0.55)), "x")


def test_the_picture_to_be_saved_is_the_card(look):
    page = page_at(Look(DARK))
    assert page.picture().get_size() == page.overlay.card.size

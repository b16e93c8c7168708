"""Strip charts: round axes that stay, labels pushed apart, charts of a stage in any window."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pygame
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from game.stage import Stage, Strip
from game.ui.charts.strip_axis import Axis, axis_for, end_text, round_top, spread
from game.ui.charts.strips import COLORS, Strips, _label, ends_of
from game.ui.look.layout import arrange
from game.ui.look.look import Look
from game.ui.look.numerals import MINUS
from game.ui.look.theme import DARK
from tests.ui.sample_scene import Sample


@given(st.floats(1e-12, 1e12))
def test_the_top_of_an_axis_is_round_and_a_little_above(value):
    top = round_top(value)
    assert 1.03 * value < top <= 1.9 * value
    assert float(f"{top:.2g}") == pytest.approx(top)


@given(st.floats(-1e9, 1e9), st.floats(0, 1e9))
def test_an_axis_holds_its_values_and_zero(low, span):
    assume(abs(low) > 1e-9 or span > 1e-9)
    axis = axis_for(low, low + span, None)
    assert axis.low <= min(low, 0.0) and axis.high >= max(low + span, 0.0) and axis.low < axis.high
    if axis.low < 0.0 < axis.high:
        assert axis.low == -axis.high  # the middle rule is zero


def test_an_axis_stays_until_it_is_too_small_or_far_too_large():
    axis = axis_for(0.0, 100.0, None)
    assert axis_for(0.0, 110.0, axis) == axis
    assert axis_for(0.0, 50.0, axis) == axis
    assert axis_for(0.0, 130.0, axis).high > axis.high
    assert axis_for(0.0, 10.0, axis).high < axis.high
    assert axis_for(math.nan, 1.0, axis) == axis and axis_for(math.inf, 1.0, None) == Axis(0.0, 1.0)


@given(st.lists(st.floats(0, 72), max_size=5))
def test_labels_are_apart_inside_and_in_order(places):
    put = spread(places, 15.0, 0.0, 72.0)
    order = sorted(range(len(places)), key=lambda i: places[i])
    assert all(put[b] - put[a] >= 15.0 - 1e-9 for a, b in pairwise(order))
    assert all(y <= 72.0 for y in put)
    if all(b - a >= 15.0 for a, b in pairwise(sorted(places))):
        assert put == places


def test_the_last_value_is_in_the_unit_of_its_axis_unless_it_would_read_zero():
    axis = Axis(0.0, 0.6)
    assert end_text(0.3, axis, "m") == "300" and end_text(0.0, axis, "m") == "0"
    assert end_text(1.6e-7, axis, "m") == "160 nm"
    assert end_text(-2e-5, axis, "m") == f"{MINUS}20.0 µm"
    assert end_text(1e-17, axis, "m") == "0"  # rounding
    assert end_text(1e-5, Axis(0.0, 100.0), "") == "0"  # without a unit there is none to change


@pytest.mark.parametrize(
    ("series", "name", "label"),
    [
        (("error",), "error", "now"),
        (("CCD time", "FABRIK time"), "CCD time", "CCD"),
        (("time",), "time of day", "time of day"),
    ],
)
def test_a_label_leaves_out_what_the_title_says(series, name, label):
    strip = Strip("Error" if series == ("error",) else "Time of it", "s", series)
    assert _label(name, strip) == label


@pytest.mark.parametrize(
    ("title", "series", "name", "label"),
    [
        ("Divergence that is left", ("divergence",), "divergence", "now"),
        ("Divergence that is left", ("div",), "div", "div"),
        ("Descent", ("descent", "descent, reference"), "descent, reference", "reference"),
        ("Descent", ("descent", "descent, reference"), "descent", "descent"),
    ],
)
def test_a_label_begins_where_the_title_ends(title, series, name, label):
    assert _label(name, Strip(title, "1/s", series)) == label


@pytest.fixture(scope="module")
def stage():
    made = Stage(Sample)
    for _ in range(240):
        made.advance(1 / 60)
    return made


def painted(look, size, stage, count=3):
    strips = Strips(look, Sample.strips[:count])
    strips.place(arrange(*size, look.k, strips=count), look)
    strips.update(0.1, stage)
    surface = pygame.Surface(size, 0, 32)
    strips.draw(surface)
    return strips, surface


@pytest.mark.parametrize("size", [(1, 1), (320, 240), (640, 480), (900, 720), (1280, 720), (1280, 560)])
def test_charts_in_any_window(any_look, stage, size):
    strips, surface = painted(any_look, size, stage)
    room = strips.layout.strips
    if room.h:
        assert len(set(pygame.image.tobytes(surface.subsurface(room), "RGB"))) > 10
        surface.fill("black", room)
    assert not pygame.surfarray.array3d(surface).any()  # nothing beside them


def test_a_curve_ends_at_its_last_value(stage):
    look = Look(DARK)
    strips, surface = painted(look, (1280, 720), stage)
    column, axis = strips.layout.charts[1], strips._axes[1]
    height = stage.readouts()[3].value
    x, y = column.x + column.w - strips._labels[1], column.y + 32 + 72.5 - height / axis.high * 72
    assert surface.get_at((x, round(y - 0.5)))[:3] == DARK.chalk.mark[:3]


def test_a_full_chart_leaves_its_numbers_alone(any_look, stage):
    """Ten seconds and more of a curve: it begins right of the numbers at the rules."""
    full = Stage(Sample)
    for _ in range(11 * 60):
        full.advance(1 / 60)
    for one in (stage, full):  # as the chart fills, and when it is full
        strips, surface = painted(any_look, (any_look.px(1280), any_look.px(720)), one)
        for i, column in enumerate(strips.layout.charts):
            left = strips._numbers[i]
            px = any_look.px
            room = pygame.Rect(column.x, column.y + px(24), left - px(5), px(72 + 14))
            tones = {tuple(surface.get_at((x, y))[:3]) for x in range(room.x, room.right)
                     for y in range(room.y, room.bottom)}  # fmt: skip
            marks = {tuple(any_look.color(name)[:3]) for name in COLORS}
            assert len(tones) > 3 and not tones & marks


def test_the_room_of_the_numbers_only_grows(stage):
    strips, _ = painted(Look(DARK), (1280, 720), stage)
    narrow = strips._number_space(0, ["1", "0.5", "0"])
    wide = strips._number_space(0, ["0.0016", "0.0008", "0"])
    assert narrow <= wide == strips._number_space(0, ["1", "0.5", "0"])
    strips.place(strips.layout, Look(DARK))
    assert strips._number_space(0, ["1", "0.5", "0"]) < wide


def test_a_frame_draws_one_chart_anew_and_only_for_new_steps(stage):
    strips, surface = painted(Look(DARK), (1280, 720), stage)

    def frame(dt):
        """Numbers of the charts that a frame draws again."""
        before = [pygame.image.tobytes(surface.subsurface(chart), "RGB") for chart in strips.layout.charts]
        strips.update(dt, stage)
        strips.draw(surface)
        after = [pygame.image.tobytes(surface.subsurface(chart), "RGB") for chart in strips.layout.charts]
        return [i for i in range(3) if before[i] != after[i]]

    assert frame(1.0) == frame(1.0) == []
    for _ in range(30):
        stage.step()
    changed = [frame(0.02) for _ in range(3)]
    assert all(len(one) == 1 for one in changed) and {one[0] for one in changed} == {0, 1, 2}
    for _ in range(30):
        stage.step()
    assert frame(0.001) == []


def test_no_samples_yet_and_names_that_are_not_given():
    class Quiet(Sample):
        name = "quiet"

        def readouts(self):
            return ()

    _, surface = painted(Look(DARK), (1280, 720), Stage(Quiet))
    assert pygame.surfarray.array3d(surface).any()  # titles and rules stand without a curve


def test_a_written_value_stands_until_it_is_fresh(monkeypatch):
    """The curve goes on; the values at its end change when all numbers in the window do."""
    stage = Stage(Sample)
    stage.advance(1 / 60)
    written = []
    paint = Strips._paint_labels
    monkeypatch.setattr(
        Strips, "_paint_labels", lambda self, *rest: written.append(list(rest[5])) or paint(self, *rest)
    )
    strips, surface = painted(Look(DARK), (1280, 720), stage, 1)
    (first,), before = written, pygame.image.tobytes(surface, "RGB")
    for _ in range(6):
        stage.advance(1 / 60)
        strips.update(1 / 60, stage, fresh=False)
        strips.draw(surface)
    assert len(written) > 1 and all(one == first for one in written)
    assert pygame.image.tobytes(surface, "RGB") != before
    strips.update(1.0, stage, fresh=True)
    strips.draw(surface)
    assert written[-1] != first


def test_a_long_first_step_does_not_flatten_a_chart_of_times():
    slow = np.array([0.5, *([1e-3] * 200)])
    usual = np.array([1e-3] * 200)
    assert ends_of(slow, "s")[1] < 2.0 * ends_of(usual, "s")[1]
    assert ends_of(slow, "m")[1] == 0.5  # a length is what it is
    growing = np.linspace(0.0, 1.0, 200)
    assert ends_of(growing, "s")[1] == 1.0
    assert ends_of(np.full(3, np.nan), "s")[:2] == (np.inf, -np.inf)

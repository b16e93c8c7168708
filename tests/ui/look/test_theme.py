"""The themes hold what they promise: contrast, distance for dichromats, whole measures at every scale."""

import itertools
import json

import numpy as np
import pygame
import pytest

from game.ui.look.assets import asset
from game.ui.look.look import Look
from game.ui.look.theme import (
    BALL_COLORS,
    DARK,
    FELT,
    LIGHT,
    SERIES,
    auto_scale,
    gui_theme,
    metrics,
    theme_named,
)
from tests.ui.look.colorimetry import difference, lab, linear_rgb


def luminance(color):
    """Relative luminance of WCAG 2."""
    return float(np.dot(linear_rgb(color), (0.2126, 0.7152, 0.0722)))


def contrast(a, b):
    light, dark = sorted((luminance(a), luminance(b)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=lambda t: t.name)
def test_text_is_legible_on_every_surface(theme):
    surfaces = (theme.bg, theme.stage, theme.panel, theme.inset, theme.hover, theme.accent_soft)
    for text in (theme.text1, theme.text2, theme.text3, theme.accent):
        assert min(contrast(text, s) for s in surfaces) >= 4.5
    assert contrast(theme.on_accent, theme.accent) >= 4.5
    assert contrast(theme.ink_on_amber, theme.amber.mark) >= 4.5
    assert contrast(theme.line2, theme.panel) >= 2.9


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=lambda t: t.name)
def test_data_colours_stand_out_and_apart(theme):
    pairs = [theme.data(row.color) for row in SERIES]
    assert min(contrast(p.mark, theme.stage) for p in pairs) >= 3.0
    assert min(contrast(p.text, theme.panel) for p in pairs) >= 4.5
    assert len({row.marker for row in SERIES}) == len(SERIES)
    for vision, least in (("normal", 18.0), ("protan", 12.5), ("deutan", 11.5), ("tritan", 9.0)):
        seen = [lab(p.mark, vision) for p in pairs]
        assert min(difference(a, b) for a, b in itertools.combinations(seen, 2)) >= least - 0.05, vision


def test_balls_and_felt_stay_apart():
    solids = [*BALL_COLORS[:9], FELT]
    for vision, least in (("normal", 19.0), ("protan", 16.0), ("deutan", 13.5)):
        seen = [lab(c, vision) for c in solids]
        assert min(difference(a, b) for a, b in itertools.combinations(seen, 2)) >= least, vision


def test_difference_agrees_with_a_published_pair():
    # Sharma, Wu, Dalal (2005), table 1, pairs 1 and 17
    assert difference((50, 2.6772, -79.7751), (50, 0, -82.7485)) == pytest.approx(2.0425, abs=1e-4)
    assert difference((50, 2.5, 0), (73, 25, -18)) == pytest.approx(27.1492, abs=1e-4)


def test_themes_are_found_by_name_and_only_so():
    assert theme_named("dark") is DARK
    assert theme_named("light") is LIGHT
    with pytest.raises(ValueError, match="'sepia'"):
        theme_named("sepia")
    with pytest.raises(ValueError, match="no data colour"):
        DARK.data("bg")


def test_series_repeat_after_the_last():
    assert DARK.series(0) == DARK.series(len(SERIES))


@pytest.mark.parametrize(
    ("height", "k"), [(1, 1), (720, 1), (899, 1), (900, 1.25), (1080, 1.25), (1200, 1.5), (1600, 2)]
)
def test_automatic_scale(height, k):
    assert auto_scale(height) == k


def test_measures_scale_and_hairlines_wait():
    assert metrics(1).panel == 320
    assert metrics(2).panel == 640
    assert [metrics(k).border for k in (0.75, 1, 1.25, 1.49, 1.5, 2, 3)] == [1, 1, 1, 1, 2, 2, 3]
    for bad in (0, -1, float("nan"), float("inf"), 100):
        with pytest.raises(ValueError, match="scale"):
            metrics(bad)


@pytest.mark.parametrize("theme", [DARK, LIGHT], ids=lambda t: t.name)
def test_gui_theme_at_scale_one_is_the_file(theme):
    assert gui_theme(theme, 1.0) == json.loads(
        asset("theme", f"{theme.name}.json").read_text(encoding="utf-8")
    )


def test_gui_theme_scales_lengths_only():
    one, two = gui_theme(DARK, 1.0), gui_theme(DARK, 2.0)
    assert two["button"]["font"]["size"] == "26"
    assert two["#number"]["misc"]["padding"] == "8,4"
    assert two["button"]["misc"]["border_width"] == "2"
    assert two["button"]["misc"]["tool_tip_delay"] == one["button"]["misc"]["tool_tip_delay"]
    assert two["button"]["colours"] == one["button"]["colours"]
    assert two["vertical_scroll_bar"]["misc"]["enable_arrow_buttons"] == "0"


@pytest.mark.parametrize("k", [1.25, 1.5, 2.0, 3.0])
def test_gui_theme_scales_each_length_and_each_font_by_that_and_no_more(k):
    """What is a length is known by its name; outlines have a rule of their own."""
    seen = set()
    one, larger = gui_theme(DARK, 1.0), gui_theme(DARK, k)
    for name, block in one.items():
        if "font" in block:
            assert int(larger[name]["font"]["size"]) == round(k * int(block["font"]["size"])), name
        for key, value in block.get("misc", {}).items():
            now = larger[name]["misc"][key]
            if key == "padding":
                assert now == ",".join(str(round(k * int(part))) for part in value.split(",")), name
            elif key == "border_width" and value == "1":
                assert int(now) == max(1, int(k + 0.5))
            elif key.endswith(("_height", "_width", "_radius", "_padding")):
                assert int(now) == round(k * int(value)), (name, key)
            else:
                assert now == value, (name, key)
            seen.add(key)
    assert {"padding", "border_width", "shape_corner_radius"} <= seen


def test_an_unknown_colour_name_is_told_with_those_that_there_are():
    look = Look(DARK)
    with pytest.raises(ValueError, match="colour 'purple': expected one of ") as caught:
        look.color("purple")
    names = str(caught.value).partition("expected one of ")[2].split(", ")
    assert {"text1", "accent", "amber", "chalk", "vermilion", "stage"} <= set(names)
    assert "name" not in names and all(isinstance(look.color(name), pygame.Color) for name in names)

"""Formulas: what is read, what is refused with its place, and the geometry of what is set."""

from __future__ import annotations

import pygame
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.scenes import CATALOGUE
from game.ui.look.fonts import FontBook
from game.ui.text.formula import _row, _Setter, measure, render_formula
from game.ui.text.formula_boxes import Stroke
from game.ui.text.markup import FormulaError, parse

INK = pygame.Color("#ECE8DE")
GOOD = (
    r"m\v{a} = m\v{g} - k|\v{v} - \v{w}|(\v{v} - \v{w})",
    r"\v{x}_{n+1} = \v{x}_n + h\v{v}_n + \frac{1}{2}h^2\v{a}_n",
    r"\alpha = \arctan\frac{y_2 - y_1}{x_2 - x_1},\quad d = \sqrt{\Delta x^2 + \Delta y^2}",
    r"\matrix{v_n \\ v_t} = \matrix{\cos\alpha & \sin\alpha \\ -\sin\alpha & \cos\alpha}\matrix{v_x \\ v_y}",
    r"E = \sum_{i=1}^n \frac{1}{2}m_i\abs{\v{v}_i}^2 \le \left(\frac{a}{b}\right)^2",
    r"v = \cases{0 & \text{if }v < v_{min} \\ fv & \text{else}}",
    r"\dot{x} \approx \bar{v}, \hat{n} \cdot \norm{\tilde{p}} \ne 50\percent",
    "",
    "x'",
    r"\atan2(y, x)".replace("\\atan2", "\\atan2"),
)


@pytest.mark.parametrize("text", GOOD)
@pytest.mark.parametrize("k", [1.0, 2.0])
def test_formulas_of_the_course_are_set(text, k):
    picture = render_formula(FontBook(k), text, INK)
    assert picture.get_width() > 0 and picture.get_height() > 0


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (r"\frac{1}", "missing"),
        (r"\blob", "not known"),
        ("a^", "missing"),
        ("{a", "missing"),
        ("a}", "without a beginning"),
        ("a_1_2", "second script"),
        (r"\matrix a", "expected"),
        (r"\text abc", "expected"),
        (r"\left( a", "missing"),
        ("{" * 200 + "}" * 200, "deep"),
        ("x" * 5000, "longer"),
        ("\\", "not known"),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_line(text, reason):
    with pytest.raises(FormulaError, match=reason) as caught:
        parse(text)
    assert "\n" not in str(caught.value)


@settings(max_examples=200, deadline=None)
@given(st.text(alphabet=r"\{}^_&ab12+-=()|fracsqtv ,'", max_size=40))
def test_any_text_is_set_or_refused(text):
    try:
        picture = render_formula(FontBook(1.0), text, INK)
    except FormulaError:
        return
    assert picture.get_width() >= 1


def test_a_letter_the_font_lacks_is_refused():
    with pytest.raises(FormulaError, match="no"):
        render_formula(FontBook(1.0), "\U0010fffd", INK)


def test_geometry():
    fonts = FontBook(2.0)

    def parts(text):
        return measure(fonts, text)

    assert parts("x^2")[1] > parts("x")[1]  # a superscript rises
    assert parts("x_2")[2] > parts("x")[2]  # a subscript falls
    assert parts(r"\frac{a}{b}")[1] > 1.3 * parts("a")[1]
    assert parts(r"\frac{a}{bbbb}")[0] == pytest.approx(parts(r"\frac{bbbb}{a}")[0], abs=2)
    assert parts("a+b")[0] > parts("ab")[0] + parts("+")[0]  # an operation stands off
    assert parts("-b")[0] < parts("a-b")[0] - parts("a")[0]  # a sign does not
    assert parts(r"\sqrt{x}")[1] > parts("x")[1]
    rows = parts(r"\matrix{a\\b\\c\\d}")
    assert rows[1] + rows[2] > 3.5 * (parts("a")[1] + parts("a")[2])


def test_scripts_hold_their_order():
    assert parse("x_1^2") == parse("x^2_1")


def test_pictures_are_kept_by_colour_and_scale():
    fonts = FontBook(1.0)
    assert render_formula(fonts, "x+y", INK) is render_formula(fonts, "x+y", INK)
    assert render_formula(fonts, "x+y", INK) is not render_formula(fonts, "x+y", pygame.Color("red"))


@pytest.mark.parametrize(
    ("text", "token", "meant"),
    [
        (r"\aplha + 1", r"\aplha", r"\alpha"),
        (r"\frc{a}{b}", r"\frc", r"\frac"),
        (r"a \rightarrow b", r"\rightarrow", r"\Rightarrow"),
        (r"\sqr{x}", r"\sqr", r"\sqrt"),
    ],
)
def test_a_misspelt_token_is_named_with_what_is_known(text, token, meant):
    with pytest.raises(FormulaError) as caught:
        parse(text)
    said = str(caught.value)
    assert f"{token} is not known; did you mean " in said and meant in said.partition("?")[0]
    known = said.partition("known are ")[2].split()
    assert {r"\alpha", r"\sum", r"\frac", r"\hat", r"\sin", r"\left", r"\right", r"\quad"} <= set(known)


@pytest.mark.parametrize("entry", tuple(CATALOGUE), ids=lambda entry: entry.name)
def test_every_equation_of_every_scene_is_set(entry):
    fonts = FontBook(1.0)
    for equation in entry.load().equations:
        assert render_formula(fonts, equation.formula, INK).get_width() > 1


@pytest.mark.parametrize("text", [r"\sqrt{x}", r"\sqrt{\frac{g}{l}}", r"\frac{a}{b}", r"\abs{x}"])
def test_strokes_lie_in_the_box_and_end_close_to_its_end(text: str):
    """Else what follows would stand upon them, or apart from them as if by a space."""
    at = _Setter(FontBook(4.0), 20.0)
    box = _row(parse(text), at)
    ends = [max(mark.ax, mark.bx) for mark in box.marks if isinstance(mark, Stroke)]
    assert min(min(mark.ax, mark.bx) for mark in box.marks if isinstance(mark, Stroke)) >= -0.02 * at.em
    assert 0.0 <= box.width + box.slant - max(ends) <= 0.2 * at.em


def test_a_root_ends_a_thin_line_behind_its_bar():
    at = _Setter(FontBook(4.0), 20.0)
    box = _row(parse(r"\sqrt{x}"), at)
    bar = max(mark.bx for mark in box.marks if isinstance(mark, Stroke))
    assert box.width - bar == pytest.approx(0.04 * at.em, abs=0.005 * at.em)

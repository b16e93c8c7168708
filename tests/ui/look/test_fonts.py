"""Text is measured, cut, wrapped, kept within bounds; numbers are written as people read them."""

import numpy as np
import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.ui.look import fonts
from game.ui.look.fonts import FACES, FontBook, format_number, format_si, quantity

WHITE = pygame.Color("white")


@pytest.fixture(scope="module")
def book():
    return FontBook(1.0)


def test_every_face_renders_what_it_measures(book):
    for weight in FACES:
        picture = book.render("Carom 147", 13, weight, WHITE)
        assert picture.get_size() == book.size("Carom 147", 13, weight)
        assert pygame.surfarray.array_alpha(picture).max() > 200


def test_numbers_do_not_jitter(book):
    for weight in ("medium", "semibold"):
        widths = {book.size(digit * 4, 13, weight)[0] for digit in "0123456789"}
        assert len(widths) == 1


def test_groups_are_narrower_than_a_space(book):
    plain, narrow, wide = (book.size(f"12{gap}112", 26, "medium")[0] for gap in ("", "\u202f", " "))
    assert plain < narrow < wide


def test_scale_is_applied_once():
    assert FontBook(2.0).size("width", 13)[0] == FontBook(1.0).size("width", 26)[0]


def test_pictures_are_kept_and_bounded(monkeypatch):
    monkeypatch.setattr(fonts, "KEPT_SURFACES", 5)
    book = FontBook(1.0)
    first = book.render("0", 13, "medium", WHITE)
    assert book.render("0", 13, "medium", WHITE) is first
    for i in range(20):
        book.render(str(i), 13, "medium", WHITE)
    assert len(book._kept) == 5
    assert book._pixels == sum(s.get_width() * s.get_height() for s in book._kept.values())


@given(st.text(max_size=40), st.integers(0, 200))
def test_fit_never_exceeds_its_width(text, width):
    book = FontBook(1.0)
    line = text.replace("\n", " ")
    shown = book.fit(line, 13, "medium", width)
    assert book.size(shown, 13)[0] <= max(width, 0)


def test_wrap_loses_no_word(book):
    text = "a sentence of some words, and then a\nsecond paragraph"
    lines = book.wrap(text, 13, "medium", 90)
    assert " ".join(lines).split() == text.split()
    assert all(book.size(line, 13)[0] <= 90 or " " not in line for line in lines)


def test_odd_text_renders(book):
    for text in ("", "\x00", "\ud800", "🎱", "a\nb"):
        assert isinstance(book.render(text, 13, "medium", WHITE), pygame.Surface)


def test_halo_surrounds_the_letters(book):
    halo = pygame.Color("#102030")
    picture = book.render_on_halo("I", 20, "bold", WHITE, halo)
    alpha = pygame.surfarray.array_alpha(picture)
    bare = pygame.surfarray.array_alpha(book.render("I", 20, "bold", WHITE))
    assert np.count_nonzero(alpha > 128) > 2 * np.count_nonzero(bare > 128)


def test_draw_places_by_the_middle_and_survives_absurd_places(book):
    surface = pygame.Surface((100, 40))
    rect = book.draw(surface, "abc", (50, 20), 13, "medium", WHITE, align="center")
    assert abs(rect.centerx - 50) <= 1
    assert abs(rect.centery - 20) <= 1
    for bad in (float("nan"), float("inf"), 1e300):
        assert book.draw(surface, "abc", (bad, 5), 13, "medium", WHITE).w == 0


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (12112, "12\u202f112"),
        (np.int64(12112), "12\u202f112"),
        (12112.4, "12\u202f112"),
        (0.0, "0"),
        (-0.0, "0"),
        (-3.14159, "−3.14"),
        (9.996, "10.0"),
        (999.6, "1\u202f000"),
        (float("nan"), "–"),
        (float("-inf"), "−∞"),
        (1.2e12, "1.20\u202f×\u202f10¹²"),
        (-1e-7, "−1.00\u202f×\u202f10⁻⁷"),
    ],
)
def test_numbers(value, text):
    assert format_number(value) == text


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (1.84e-5, "s", "18.4 µs"),
        (9.996e-4, "s", "1.00 ms"),
        (0.5, "kg", "500 g"),
        (0.9999, "kg", "1.00 kg"),
        (0.0, "kg m/s", "0 kg m/s"),
        (1660.0, "kg", "1\u202f660 kg"),
        (2.0, "1/s", "2.00 1/s"),
        (16.0, "°", "16.0°"),
        (1.85e-11, "°", "1.85\u202f×\u202f10⁻¹¹ °"),  # close to its exponent it would be one digit more
        (2.5e-4, "m²", "0.000250 m²"),
        (0.0, "s", "0 s"),
        (5e-3, "m/s", "5.00 mm/s"),
        (2.48e-13, "m", "0.248 pm"),
        (2.48e-16, "m", "2.48\u202f×\u202f10⁻¹⁶ m"),
        (12, "", "12"),
        (12.0, "", "12.0"),
    ],
)
def test_units(value, unit, text):
    assert format_si(value, unit) == text


@given(st.floats(allow_nan=True, allow_infinity=True))
def test_a_live_number_is_short(value):
    assert len(format_number(value)) <= 15
    number, unit = quantity(value, "s")
    assert number
    assert unit.endswith("s")


@given(st.floats(1e-11, 9e11))
def test_prefixes_keep_three_digits(value):
    number, unit = quantity(value, "J")
    factor = {"p": 1e-12, "n": 1e-9, "µ": 1e-6, "m": 1e-3, "": 1.0, "k": 1e3, "M": 1e6, "G": 1e9}[unit[:-1]]
    assert float(number.replace("\u202f", "")) * factor == pytest.approx(value, rel=5.01e-3)
    assert len(number.replace(".", "").lstrip("0")) >= 3

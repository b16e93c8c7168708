"""Words of a story over its picture."""

import pygame
import pytest

from game.ui.look.look import Look
from game.ui.look.theme import theme_named
from game.ui.painters.story_words import SIZE, _even_lines, draw_card
from game.ui.widgets.timebar import TimeBar


def luminance(color: pygame.Color) -> float:
    """Relative (WCAG 2.1), 0 to 1."""
    parts = [part / 255.0 for part in (color.r, color.g, color.b)]
    linear = [p / 12.92 if p <= 0.03928 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_a_card_can_be_read_over_whatever_is_behind_it(theme):
    """3 : 1, as for large words, over the darkest and the brightest picture."""
    look = Look(theme_named(theme), 1.0)
    for ground in (0x10, 0x60, 0xA0):
        surface = pygame.Surface((320, 180), 0, 32)
        surface.fill((ground, ground, ground))
        draw_card(surface, look, surface.get_rect(), [("A", 40, "semibold", "text1")], 1.0)
        behind, words = luminance(surface.get_at((2, 2))), luminance(look.color("text1", words=True))
        low, high = min(behind, words), max(behind, words)
        assert (high + 0.05) / (low + 0.05) > 3.0, ground


def test_nothing_shines_through_the_time_bar():
    look = Look(theme_named("dark"), 1.0)
    bar = TimeBar(look)
    pictures = []
    for ground in ((255, 0, 0), (0, 0, 255)):
        surface = pygame.Surface((640, 60), 0, 32)
        surface.fill(ground)
        bar.place(surface.get_rect(), look)
        bar.draw(surface)
        pictures.append(surface.get_at((320, 56)))
    assert pictures[0] == pictures[1]


def test_a_caption_of_two_lines_leaves_no_word_alone_and_takes_no_line_more():
    look = Look(theme_named("dark"), 1.0)
    words = "Radius, depth and drag: of each caption both lines are about as long, however it is cut, m/s."
    greedy = look.fonts.wrap(words, SIZE, "semibold", 700)
    even = _even_lines(look.fonts, look.k, words, 700)
    assert " ".join(even) == words and len(even) == len(greedy) == 2
    wide = [look.fonts.size(line, SIZE, "semibold")[0] for line in even]
    assert max(wide) <= 700 and min(wide) > 0.7 * max(wide)
    for width in range(120, 400, 20):
        lines = _even_lines(look.fonts, look.k, "It errs by 588 nm at the most in 1/120 s of it", width)
        assert not any(line[-1].isdigit() for line in lines) and "588\u00a0nm" in "".join(lines)
    assert _even_lines(look.fonts, look.k, "Short.", 700) == ["Short."]
    assert _even_lines(look.fonts, look.k, "", 700) == [""]

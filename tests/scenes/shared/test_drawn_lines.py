"""Where words stand beside lines."""

import numpy as np
import pygame
import pytest

from game.scenes.shared.outlines.drawn_lines import SPACING, DrawnLines
from game.stage import Frame
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

SIZE = (40.0, 12.0)


@pytest.fixture
def canvas() -> Canvas:
    pygame.font.init()
    surface, camera = pygame.Surface((400, 400), 0, 32), Camera()
    camera.fit(Frame(-2.0, -2.0, 2.0, 2.0), surface.get_rect(), 0)
    made = Canvas(Look(theme_named("dark"), 1.0))
    made.begin(surface, surface.get_rect(), camera)
    return made


def test_a_line_counts_by_its_length_under_the_words(canvas):
    lines = DrawnLines(canvas, [(np.array([(-1.0, 0.0), (1.0, 0.0)]), False)])
    assert lines.under((0.0, 0.0), SIZE, (0.0, 0.0)) == pytest.approx(SIZE[0] / SPACING, abs=1.0)
    assert lines.under((0.0, 0.0), SIZE, (0.0, 30.0)) == 0


def test_a_closed_line_leads_back(canvas):
    corners = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
    for closed in (True, False):
        found = DrawnLines(canvas, [(corners, closed)]).under((-1.0, 0.0), (12.0, 40.0), (0.0, 0.0))
        assert (found > 0) == closed


def test_the_place_kept_is_left_only_for_a_clearer_one(canvas):
    lines = DrawnLines(canvas, [(np.array([(-1.0, 0.0), (1.0, 0.0)]), False)])
    offsets = ((0.0, 0.0), (0.0, -30.0), (0.0, 30.0))
    assert lines.clearest((0.0, 0.0), SIZE, offsets) == 1
    assert lines.clearest((0.0, 0.0), SIZE, offsets, kept=2) == 2
    assert lines.clearest((0.0, 1.0), SIZE, offsets) == 0


def test_words_do_not_reach_over_the_edge(canvas):
    lines = DrawnLines(canvas, [])
    assert lines.clearest((1.9, 0.0), SIZE, ((30.0, 0.0), (-30.0, 0.0))) == 1


def test_points_count_as_lines_and_what_is_not_finite_is_left_out(canvas):
    lines = DrawnLines(canvas, [(np.zeros((1, 2)), True), (np.array([(0.0, np.inf), (0.0, 0.0)]), False)])
    assert lines.clearest((0.0, 0.0), SIZE, ((0.0, 0.0), (0.0, 30.0))) == 1
    assert np.isfinite(lines.points).all()

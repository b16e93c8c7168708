"""Numbers change together: four times a second, and at once where the scene jumps."""

import pygame
import pytest

from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.beat import BEAT_S, Beat
from game.ui.look.look import Look
from game.ui.look.theme import DARK


def test_the_first_picture_has_numbers_and_the_next_ones_keep_them():
    beat, dt = Beat(), BEAT_S / 8.0
    fresh = [beat.pass_time(dt, step) for step in range(1, 18)]
    assert [i for i, taken in enumerate(fresh) if taken] == [0, 8, 16]


def test_a_long_frame_gives_numbers_once():
    beat = Beat()
    beat.pass_time(0.0)
    assert beat.pass_time(10.0) and not beat.pass_time(BEAT_S / 2.0)


@pytest.mark.parametrize(("step", "still", "fresh"), [(7, False, False), (7, True, True), (5, False, True)])
def test_steps_by_hand_and_steps_back_are_seen_at_once(step, still, fresh):
    beat = Beat()
    beat.pass_time(0.0, 6)
    assert beat.pass_time(0.01, step, still) is fresh
    assert beat.fresh is fresh
    assert not beat.pass_time(0.01, step, still)


def test_a_figure_in_the_picture_stands_until_numbers_are_fresh():
    canvas, surface = Canvas(Look(DARK)), pygame.Surface((64, 64), 0, 32)
    shown = []
    for fresh, count in ((True, "1"), (False, "2"), (False, "3"), (True, "4")):
        canvas.fresh = fresh
        canvas.begin(surface, surface.get_rect(), Camera())
        shown.append(canvas.figure("pairs", count))
        canvas.end()
    assert shown == ["1", "1", "1", "4"]

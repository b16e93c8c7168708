"""What stands is painted when something of it has changed, and is laid as it was when nothing has."""

from __future__ import annotations

import numpy as np
import pytest

from game.stage import Frame
from game.ui.canvas.standing import Standing
from game.ui.look.look import Look
from game.ui.look.theme import LIGHT
from tests.ui.canvas.test_canvas import begun


class Painter:
    """Counts how often it is asked."""

    def __init__(self) -> None:
        self.times = 0

    def __call__(self, canvas) -> None:
        self.times += 1
        canvas.fill("panel")
        canvas.circle((0.3, 0.2), 0.4, fill="amber")


def shown(standing, painter, canvas, *depends):
    """The picture (h, w) after it is drawn over something else."""
    canvas.fill("vermilion")
    standing.draw(canvas, painter, *depends)
    return canvas.raster_target[0].copy()


def test_what_stands_is_painted_twice_and_then_laid():
    standing, painter, canvas = Standing(), Painter(), begun()
    pictures = [shown(standing, painter, canvas) for _ in range(5)]
    assert painter.times == 2
    assert all((one == pictures[0]).all() for one in pictures)


def moved(canvas):
    canvas.camera.pan(3.0, 0.0)
    canvas._look_through(canvas.camera)
    return ()


def another_look(canvas):
    canvas.look = Look(LIGHT)
    return ()


def without_words(canvas):
    canvas.words = False
    return ()


def without_teaching(canvas):
    canvas.teaching = False
    return ()


def other_data(canvas):
    return (1,)


@pytest.mark.parametrize("change", [moved, another_look, without_words, without_teaching, other_data])
def test_it_is_painted_again_when_something_changes(change):
    standing, painter, canvas = Standing(), Painter(), begun()
    for _ in range(3):
        shown(standing, painter, canvas)
    depends = change(canvas)
    fresh = shown(Standing(), painter, canvas, *depends)
    before = painter.times
    assert (shown(standing, painter, canvas, *depends) == fresh).all()
    assert painter.times == before + 1


def test_while_the_view_moves_each_picture_is_painted():
    standing, painter, canvas = Standing(), Painter(), begun()
    for _ in range(6):
        moved(canvas)
        fresh = shown(Standing(), painter, canvas)
        assert (shown(standing, painter, canvas) == fresh).all()
    assert painter.times == 12


def test_only_the_clip_is_laid():
    canvas = begun(frame=Frame(-2.0, -1.0, 2.0, 1.0))
    standing, painter = Standing(), Painter()
    with canvas.within((-1.0, -0.5), (1.0, 0.5)):
        for _ in range(3):
            shown(standing, painter, canvas)
    pixels, _ = canvas.raster_target
    assert painter.times == 2
    assert len(np.unique(pixels[:10])) == 1 and pixels[0, 0] == begun().raster_target[0][0, 0]

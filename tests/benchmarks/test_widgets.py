"""What the widgets round the stage cost a frame. Figures for a person; nothing fails on a slow machine."""

from __future__ import annotations

import pygame
import pytest

from game.ui.charts.strips import Strips
from game.ui.look.layout import arrange
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.panel.panel import Panel
from game.ui.widgets.hintbar import HintBar
from game.ui.widgets.topbar import BarState, TopBar
from tests.ui import gallery
from tests.ui.sample_scene import Sample

SIZE = (1280, 720)


@pytest.fixture(scope="module")
def parts():
    pygame.display.init()
    pygame.display.set_mode(SIZE)
    look, layout, stage = Look(DARK), arrange(*SIZE, 1.0), gallery.sample_stage()
    panel, strips, bar, hints = (
        Panel(look, Sample, gallery.LEVELS),
        Strips(look, Sample.strips),
        TopBar(look),
        HintBar(look),
    )
    panel.place(layout.panel, look)
    strips.place(layout, look)
    bar.place(layout.top_bar, look)
    hints.place(layout.hint_bar, look)
    hints.show(gallery.HINTS)
    surface = pygame.Surface(SIZE, 0, 32)
    state = BarState("C04", "Bouncing ball", readouts=(("time", 1.0, "s"),))
    yield {
        "panel": lambda: (panel.update(1e-4, stage, gallery.METER, False), panel.draw(surface)),
        "strips": lambda: (strips.update(1 / 60, stage), strips.draw(surface)),
        "charts": lambda: (stage.step(), strips.update(1 / 60, stage), strips.draw(surface)),
        "bar": lambda: (bar.update(1e-4, state, False), bar.draw(surface)),
        "hints": lambda: (hints.update(1e-4), hints.draw(surface)),
    }
    panel.close()


@pytest.mark.parametrize("name", ["panel", "strips", "charts", "bar", "hints"])
def test_cost_of_a_frame(benchmark, parts, name):
    for _ in range(40):
        parts[name]()  # come to rest
    benchmark.pedantic(parts[name], rounds=200)
    assert benchmark.disabled or benchmark.stats.stats.rounds == 200

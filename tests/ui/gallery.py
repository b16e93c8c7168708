"""Draws every widget into pictures, to be looked at: ``python -m tests.ui.gallery FOLDER``."""

from __future__ import annotations

import math
import os
import sys
from pathlib import Path
from types import SimpleNamespace

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
os.environ.setdefault("SDL_AUDIODRIVER", "dummy")

import pygame

from game.stage import Stage
from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.charts.accuracy import AccuracyPage
from game.ui.charts.accuracy_data import AccuracyData, Progress, TableRow, sentence_for
from game.ui.charts.plot_data import PlotAxes, PlotPoint, PlotSeries, Present
from game.ui.charts.strips import Strips
from game.ui.look.layout import arrange, auto_scale
from game.ui.look.look import Look
from game.ui.look.theme import DARK, LIGHT, SERIES
from game.ui.panel.panel import Panel
from game.ui.widgets.helppage import HelpPage
from game.ui.widgets.hintbar import HintBar
from game.ui.widgets.legend import Legend
from game.ui.widgets.loading import LoadingCard, draw_shell
from game.ui.widgets.toasts import Toasts
from game.ui.widgets.topbar import BarState, TopBar
from tests.ui.sample_scene import Sample

HINTS = (
    (("Space",), "pause"), ((".",), "step"), ((",",), "step back"), (("Drag",), "move stone"),
    (("Wheel",), "zoom"), (("A",), "accuracy"), (("L",), "levels"), (("F1",), "help"),
)  # fmt: skip
LEVELS = (
    SimpleNamespace(title="Fountain over a stone", value="a"),
    SimpleNamespace(title="Storm: 100 000 particles", value="b"),
    SimpleNamespace(title="Hard: grazing contact", value="c"),
)
METER = SimpleNamespace(
    costs={"test-gravity": 4.6e-6, "test-ground": 21.3e-6, "test-drag": 9.8e-6}, bare=26.1e-6
)


def sample_stage() -> Stage:
    """The sample scene after twelve seconds."""
    stage = Stage(Sample, parameters={"restitution": 0.62}, effects_off=("test-drag",))
    for _ in range(750):
        stage.advance(1 / 60)
    return stage


def draw_scene(surface: pygame.Surface, look: Look, stage: Stage) -> None:
    """The whole screen of a scene."""
    layout = arrange(*surface.get_size(), look.k)
    camera = Camera()
    camera.fit(stage.scene.frame(), layout.free_stage, 20 * look.k)
    canvas = Canvas(look)
    canvas.begin(surface, layout.free_stage, camera)
    stage.scene.draw(canvas, 1.0)
    canvas.end()
    Legend(look).draw(surface, layout.free_stage, stage.scene.legend())
    strips = Strips(look, stage.scene.strips)
    strips.place(layout, look)
    strips.update(0.1, stage)
    strips.draw(surface)
    hints = HintBar(look)
    hints.place(layout.hint_bar, look)
    hints.show(HINTS)
    hints.draw(surface)
    panel = Panel(look, Sample, LEVELS)
    panel.place(layout.panel, look)
    panel.update(0.3, stage, METER)
    panel.update(0.3, stage, METER)
    panel.draw(surface)
    panel.close()
    bar = TopBar(look)
    bar.place(layout.top_bar, look)
    readouts = (
        ("time", 12.48, "s"),
        ("particles", 12112.0, ""),
        ("step", 52e-6, "s"),
        ("frame", 0.0031, "s"),
    )
    bar.update(0.3, BarState("C04", "Particle fountain", readouts=readouts))
    bar.draw(surface)


def draw_loading(surface: pygame.Surface, look: Look, stage: Stage) -> None:
    """The loading card on its shell."""
    layout = arrange(*surface.get_size(), look.k)
    draw_shell(surface, layout, look)
    card = LoadingCard(look)
    for _ in range(100):
        card.update(0.1, 5, 12)
    card.draw(surface, layout.stage, "Sweep and prune", 5, 12, "sort_endpoints", 2.3)
    bar = TopBar(look)
    bar.place(layout.top_bar, look)
    bar.update(0.1, BarState("C07", "Sweep and prune", ready=False, readouts=(("time", 0.0, "s"),) * 4))
    bar.draw(surface)
    hints = HintBar(look)
    hints.place(layout.hint_bar, look)
    hints.show(((("Esc",), "back to the menu"),))
    hints.draw(surface)
    toasts = Toasts(look)
    toasts.add("Foul by Ada.", "The 12 was touched first. Ball in hand for Ben.", "warning")
    toasts.update(0.3)
    toasts.draw(surface, layout.hint_bar)


def draw_help(surface: pygame.Surface, look: Look, stage: Stage) -> None:
    """The help page over the scene."""
    draw_scene(surface, look, stage)
    controls = ((("Space",), "pause and go on"), ((".",), "one step"), (("A",), "what accuracy costs"))
    page = HelpPage(look, Sample, controls)
    page.place(surface.get_rect(), look)
    page.update(1.0)
    page.draw(surface)


def draw_accuracy(surface: pygame.Surface, look: Look, stage: Stage) -> None:
    """The accuracy overlay over the scene, with a made-up study."""
    draw_scene(surface, look, stage)
    styles = (("Explicit Euler", 1.0, 0), ("Midpoint", 2.0, 2), ("Verlet", 2.0, 1), ("Runge-Kutta 4", 4.0, 3))
    series, rows = [], []
    for i, (name, order, style) in enumerate(styles):
        cost, error = 4e-4 * (1.0 + 0.7 * i), 0.6 / (1.0 + i)
        failed = [PlotPoint(cost / 2.0 ** (1 + n), math.inf, diverged=True) for n in range(3)]
        runs = [
            PlotPoint(
                cost * 2.0**n, error * 2.0 ** (-order * n), pending=i == 3 and n > 4, parameters={"n": n}
            )
            for n in range(9)
        ]
        series.append(PlotSeries(name, (*failed, *runs), order, SERIES[style].color, SERIES[style].marker))
        rows.append(TableRow(name, order, order, cost * (error / 1e-3) ** (1.0 / order)))
    data = AccuracyData(
        "Bouncing ball, from three metres", "Error of the height after 1.2 s", PlotAxes(), tuple(series),
        tuple(rows), Present(2, series[2].points[7], "Verlet, 240 steps a second"), 1e-3,
        sentence_for(rows, "one millimetre"),
        ("Hollow: still to be measured.", "Click a point to set the scene to it."),
    )  # fmt: skip
    page = AccuracyPage(look, data)
    page.place(surface.get_rect(), look)
    page.report(Progress(32, 36, "Runge-Kutta 4", 9.0, True))
    page.update(1.0)
    page.draw(surface)


def main(folder: Path) -> None:
    """Draw all pictures in both themes and several sizes."""
    pygame.display.init()
    pygame.display.set_mode((1280, 720))
    stage = sample_stage()
    looks = (
        (DARK, (1280, 720)),
        (LIGHT, (1280, 720)),
        (DARK, (1920, 1080)),
        (DARK, (2560, 1440)),
        (DARK, (760, 480)),
    )
    for theme, size in looks:
        look = Look(theme, auto_scale(*size))
        for draw in (draw_scene, draw_loading, draw_help, draw_accuracy):
            surface = pygame.Surface(size, 0, 32)
            draw(surface, look, stage)
            name = draw.__name__.removeprefix("draw_")
            pygame.image.save(surface, folder / f"canvas-{name}-{theme.name}-{size[0]}.png")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "/tmp"))

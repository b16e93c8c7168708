"""A scene's first frames out of sight, so that nothing is left to compile in the window's own."""

from __future__ import annotations

import pygame

from game.app.stagehand.view import StageView
from game.stage import Stage
from game.ui.charts.accuracy import AccuracyPage
from game.ui.charts.accuracy_data import AccuracyData, TableRow
from game.ui.charts.plot_data import PlotAxes, PlotPoint, PlotSeries
from game.ui.charts.strips import Strips
from game.ui.look.layout import arrange
from game.ui.look.look import Look

SIZE = (1280, 720)  # px
STEPS = 24  # enough for two samples of the charts


def rehearse(stage: Stage, look: Look, rect: pygame.Rect) -> None:
    """Step, draw where it will be drawn, chart, and open the plot of a study.

    ``look`` must not be the window's own, whose fonts another thread is using.
    """
    surface = pygame.Surface((max(rect.right, SIZE[0]), max(rect.bottom, SIZE[1])), 0, 32)
    view = StageView(stage, look)
    view.place(rect, look)
    view.draw(surface)
    stage.run(STEPS)
    view.draw(surface)
    scene_type = stage.scene_type
    strips = Strips(look, scene_type.strips)
    strips.place(arrange(*SIZE, look.k, strips=len(scene_type.strips)), look)
    strips.update(1.0, stage)
    strips.draw(surface)
    if scene_type.study is not None:
        page = AccuracyPage(look, _two_points())
        page.place(surface.get_rect(), look)
        page.show(_two_points())
        page.picture()


def _two_points() -> AccuracyData:
    points = (PlotPoint(1e-3, 1e-2), PlotPoint(1e-2, 1e-3), PlotPoint(1e-2, 1.0, diverged=True))
    return AccuracyData(
        "", "", PlotAxes(), (PlotSeries("", points, 1.0),), (TableRow("", 1.0, 1.0, 1e-3),), target=1e-2
    )

"""A canvas that notes its labels, for tests of what stands in a picture."""

from __future__ import annotations

import pygame

from game.ui.canvas.camera import Camera
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import theme_named


class Labels(Canvas):
    """A canvas that notes the words drawn, and how."""

    def __init__(self):
        super().__init__(Look(theme_named("dark"), 1.0))
        self.drawn = {}

    def label(self, place, words, *style, **more):
        self.drawn[words] = (tuple(place), *style)
        super().label(place, words, *style, **more)


def labels_of(stage, size=(1000, 600)):
    """Labels on an empty picture that shows the scene's frame."""
    pygame.font.init()
    surface, camera = pygame.Surface(size, 0, 32), Camera()
    camera.fit(stage.scene.frame(), surface.get_rect(), 0)
    canvas = Labels()
    canvas.begin(surface, surface.get_rect(), camera)
    return canvas

"""The ledger's card: the last collisions in figures, where the spheres begin farthest from it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pygame
from numpy.typing import NDArray

from game.physics.fields import GRAVITY
from game.physics.rigid import ledger
from game.ui.canvas import Canvas
from game.ui.numerals import format_si
from game.ui.shapes import draw_box

if TYPE_CHECKING:
    from game.scenes.c13_sphere_collisions import SphereCollisions

Array = NDArray[np.float64]
ROWS = 6
MOST_SPHERES = 60  # with more, the ledger would say nothing
COLUMNS = (
    ("pair", 0.0), ("J", 84.0), ("v before", 156.0), ("after", 228.0), ("ΔE", 300.0), ("P lost", 362.0),
)  # fmt: skip
WIDTH, LINE, MARGIN = 424.0, 16.0, 8.0  # design px
ROUNDING = 1e-12  # of an impulse: momentum of which no more is lost is kept
SHARE = np.array((0.5, 0.3))  # of the window that the card takes, about
LOWER_LEFT, LOWER_RIGHT, UPPER_RIGHT = (0, 0), (1, 0), (1, 1)  # the upper left corner is the legend's


class LedgerCard:
    """Draws the ledger on a card that lets spheres shine through, in a corner that it chooses once."""

    def __init__(self, scene: SphereCollisions) -> None:
        falls = GRAVITY in scene.active
        corners = (UPPER_RIGHT, LOWER_LEFT, LOWER_RIGHT) if falls else (LOWER_LEFT, LOWER_RIGHT, UPPER_RIGHT)
        self._right, self._top = min(corners, key=lambda corner: _in_corner(scene, corner))

    def draw(self, scene: SphereCollisions, canvas: Canvas) -> None:
        """The card, if there is something to enter."""
        world = scene.world
        if not world.collisions or len(world.bodies.makeup.radii) > MOST_SPHERES:
            return
        entries = world.ledger()[-ROWS:][::-1]
        window = world.surroundings.window
        corner = (float(window[2 * self._right]), float(window[1 + 2 * self._top]))
        height = LINE * (len(entries) + 1) + 10.0
        left = -WIDTH - MARGIN if self._right else MARGIN
        top = MARGIN if self._top else -height - MARGIN
        look, (x, y) = canvas.look, canvas.place(corner)
        card = pygame.Rect(x + look.px(left), y + look.px(top), look.px(WIDTH), look.px(height))
        ground = pygame.Color(look.theme.panel)
        ground.a = 216
        draw_box(canvas.surface, card, look.px(8), ground, look.theme.line, look.border)
        lines = [tuple(word for word, _ in COLUMNS), *map(_figures, entries)]
        for i, words in enumerate(lines):
            tone = "text1" if i == 1 else "text3"
            for (_, column), word in zip(COLUMNS, words, strict=True):
                place = (left + 6.0 + column, top + 6.0 + LINE * i)
                canvas.label(corner, word, tone, 11, anchor="topleft", offset=place)


def _in_corner(scene: SphereCollisions, corner: tuple[int, int]) -> int:
    """How many spheres and ties of strings the card would cover in a corner of the window."""
    world = scene.world
    window, radii = world.surroundings.window, world.bodies.makeup.radii
    low, size = window[:2], window[2:] - window[:2]
    places = np.concatenate((world.bodies.state.positions[world.bodies.makeup.owners, :2], _ties(scene)))
    reach = np.concatenate((radii, np.zeros(len(places) - len(radii))))[:, None] / size
    share = (places - low) / size
    inwards = np.where(np.array(corner) > 0, 1.0 - share, share)  # of the window, from that corner
    return int((inwards - reach < SHARE).all(axis=1).sum())


def _ties(scene: SphereCollisions) -> Array:
    around = scene.world.surroundings
    return around.strings[: len(around.hung), :2]


def _figures(entry: Array) -> tuple[str, ...]:
    """One entry of the ledger in words."""
    other = int(entry[ledger.OTHER])
    size = math.sqrt(float((entry[ledger.JX : ledger.JZ + 1] ** 2).sum()))
    pair = f"{int(entry[ledger.ONE])} and {other if other >= 0 else 'wall'}"
    lost = float(entry[ledger.LOST_MOMENTUM])
    return (
        pair, format_si(size, "N s"), format_si(float(entry[ledger.BEFORE]), "m/s"),
        format_si(float(entry[ledger.AFTER]), "m/s"), format_si(float(entry[ledger.CHANGE]), "J", 2),
        "rounding" if 0.0 < lost <= ROUNDING * size else format_si(lost, "N s", 2),
    )  # fmt: skip

"""How charges are drawn: packs on the columns that are cut first, and for a moment the light of each."""

from __future__ import annotations

import math

import numpy as np
import pygame

from game.arrays import Floats
from game.scenes.tower.building import column_place, floor_height
from game.scenes.tower.tables import COLUMN, GONE, NOT_YET
from game.scenes.tower.world import TowerWorld
from game.ui.canvas.canvas import Canvas

PACK, STRAP = (0.5, 0.36), 0.08  # m: half a pack's width and height, half a strap's height
LAMP_PX, HALO_PX = 2.4, 6.5  # design px, of the lamp on a pack and of the light about it
BLINK_S, DIM = 0.8, 0.3  # s from one light of a lamp to the next; what it gives between them
FLASH_S, FLASH_M, LEAST = 0.07, 9.0, 0.02  # s in which a flash is weaker by e; m it reaches; what is not seen
BOARD, BAND = pygame.Color(176, 128, 62), pygame.Color(58, 44, 32)
LAMP, FIRE = pygame.Color(255, 74, 58), pygame.Color(255, 206, 140)


def packs_of(model: TowerWorld) -> Floats:
    """Where charges still lie (n, 2), m."""
    frame = model.frame
    return model.world.bodies.positions[frame.bodies((COLUMN,), (model.first_storey(),))]


def flashes_of(model: TowerWorld) -> tuple[Floats, Floats]:
    """Where charges have gone off a moment ago (n, 2) m, and what is left (n,) of the light of each."""
    content, parts, first = model.content, model.frame.parts, model.first_storey()
    if model.course.fired == NOT_YET:
        return np.zeros((0, 2)), np.zeros(0)
    own = np.flatnonzero((parts.kind == COLUMN) & (parts.storey == first) & (parts.body == GONE))
    age = model.time - model.course.fired - model.parameters.delay * parts.place[own]
    left = np.array([math.exp(-max(each, 0.0) / FLASH_S) for each in age.tolist()])
    seen = left > LEAST
    y = floor_height(content, first) - content.slab - 0.5 * (content.storey - content.slab)
    places = [(column_place(content, k), y) for k in parts.place[own][seen].tolist()]
    return np.array(places).reshape(-1, 2), left[seen]


def draw_packs(canvas: Canvas, model: TowerWorld) -> None:
    """A pack on each column that is cut first, with a lamp that blinks."""
    bright = 1.0 if model.time % BLINK_S < 0.5 * BLINK_S else DIM
    wide, tall = PACK
    for x, y in packs_of(model).tolist():
        for high, ink in ((tall, BOARD), (STRAP, BAND)):
            corners = [(x - wide, y - high), (x + wide, y - high), (x + wide, y + high), (x - wide, y + high)]
            canvas.polygon(np.array(corners), fill=ink)
        for size, veil in ((HALO_PX, 0.3), (LAMP_PX, 1.0)):
            canvas.dot((x, y), size, LAMP, veil * bright)


def draw_flashes(canvas: Canvas, model: TowerWorld) -> None:
    """The light of charges that have gone off a moment ago."""
    places, left = flashes_of(model)
    if not len(places):
        return
    canvas.soft_glow(places, FLASH_M, np.uint32(FIRE.r << 16 | FIRE.g << 8 | FIRE.b), left)
    for place, share in zip(places.tolist(), left.tolist(), strict=True):
        canvas.discs([place], 0.7 + 0.6 * share, FIRE, share)
    canvas.bloom(0.8)

"""The colours of cloths, and what a table wears with them."""

from __future__ import annotations

import pygame

from game.scenes.shared.tables.furnishing.choices import HOUSE
from game.ui.look.theme import FELT_BLUE, FELT_OLIVE, FELT_SLATE
from game.ui.painters.table import Dress, carom_dress

FELTS: dict[str, pygame.Color] = {"blue": FELT_BLUE, "olive": FELT_OLIVE, "slate": FELT_SLATE}


def dresses(house: Dress) -> dict[str, Dress]:
    """What a table wears with each cloth, by its name; `house` is its own dress."""
    others = {
        name: carom_dress(felt, house.spots)._replace(line=house.line, sights=house.sights)
        for name, felt in FELTS.items()
    }
    return {HOUSE: house, **others}

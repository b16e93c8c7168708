"""What the pool table wears, by the cloth that was chosen."""

from __future__ import annotations

from game.scenes.billiards.play import Play
from game.scenes.shared.tables.furnishing.felts import dresses
from game.ui.painters.table import POOL, Dress

DRESSES = dresses(POOL)


def dress_of(play: Play) -> Dress:
    """The dress of the table that is played on."""
    return DRESSES[str(play.parameters.felt)]

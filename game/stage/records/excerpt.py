"""A part of a session that stands for itself, such as one stroke, as a recording of its own."""

from __future__ import annotations

from typing import NamedTuple

from game.levels import Level
from game.physics.effects import EffectSet
from game.stage.events import StageEvent


class Excerpt(NamedTuple):
    """What a scene gives out of a session: its state before, as a level, what then acts, and for how long.

    name: what it is, in a word or two ("stroke"). seed: of the scene. active: effects; events: before the
    first step; steps: until it is over.
    """

    name: str
    level: Level
    seed: int
    active: EffectSet
    events: tuple[StageEvent, ...]
    steps: int

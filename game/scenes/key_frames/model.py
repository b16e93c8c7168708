"""The box on its motion: the document, the player, and where the box is by both."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.animation import EASING
from game.physics.effects import EffectSet
from game.scenes.key_frames import editing
from game.scenes.key_frames.animation import Animation, Settings
from game.scenes.key_frames.document import NOTHING, Document
from game.scenes.key_frames.level import Motion
from game.scenes.key_frames.parameters import CHOSEN, SHAPING, KeyFrameParameters
from game.scenes.key_frames.player import Player
from game.stage.part import Part


class KeyFrameState(NamedTuple):
    """The box and what it moves by. pose: x, y m, angle rad. clock: see clock.py. timing: x1, y1, x2, y2."""

    pose: Floats

    clock: Floats
    keys: Floats
    timing: Floats


class KeyFrameModel(Part):
    """pose (3,): x, y m, angle rad of the box. active: the effects that are on."""

    def __init__(self, parameters: KeyFrameParameters, active: EffectSet, motion: Motion) -> None:
        self.parameters, self.active = parameters, active
        self.document = Document(parameters, motion)
        self.player = Player(parameters)
        self.pose = np.zeros(3)
        self._kept: dict[str, tuple[Any, Animation]] = {}
        self._timing = np.array(self.motion.timing)
        self.place_box()

    @property
    def motion(self) -> Motion:
        """The motion as it is edited."""
        return self.document.motion

    def animation(self, interpolation: str | None = None) -> Animation:
        """The motion made ready (or the same with another interpolation); made again when it changes."""
        shown = self.parameters
        name = interpolation or shown.interpolation
        settings = Settings(name, shown.closed, shown.shortest, shown.turning == "path", shown.easing)
        place = "compared" if interpolation else ""
        kept = self._kept.get(place)
        if kept is not None and kept[0][0] is self.motion and kept[0][1:] == (settings, self.active):
            return kept[1]
        made = Animation(self.motion, settings, self.active)
        self._kept[place] = ((self.motion, settings, self.active), made)
        return made

    def place_box(self) -> None:
        """Put the box where it is at the present time, or where the key in the hand is."""
        what, index = self.document.held
        if what in ("key", "turn") and 0 <= index < len(self.motion.keys):
            key = self.motion.keys[index]
            self.pose[:] = (*key.position, math.radians(key.angle))
        else:
            self.pose[:] = self.animation().pose(self.player.shown_part())

    def advance(self, dt: float) -> None:
        """One step; playback waits for the hand."""
        if self.document.held == NOTHING and self.player.advance(dt):
            self.place_box()

    def change_parameter(self, name: str) -> None:
        """A parameter has a new value."""
        document, player = self.document, self.player
        if name in SHAPING or name in CHOSEN:
            document.let_go()
        if name == "time":
            player.pause_at(self.parameters.time)
        elif name in ("duration", "repeat"):
            player.begin_here()
        elif name == "playing":
            player.follow_playing()
        elif name in SHAPING:
            document.note_shaping()
            if name == "easing" and EASING not in self.active:
                document.tell_once("The timing curve counts while easing is on: see the effects.")
        elif name in CHOSEN and document.chosen >= 0:
            document.take_chosen(name)
        elif name in CHOSEN:
            document.tell_once("No key is chosen: click one first.")
        self.place_box()

    def change_effects(self, active: EffectSet) -> None:
        """Other effects are on."""
        self.active = active
        self.place_box()

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> KeyFrameState:
        """The arrays that later steps depend on."""
        if tuple(self._timing) != self.motion.timing:
            self._timing = np.array(self.motion.timing)
        return KeyFrameState(self.pose, self.player.clock, self.animation().rows, self._timing)

    def restore(self, state: KeyFrameState) -> None:
        """Take over a state."""
        self.player.restore(state.clock)
        document = self.document
        same = np.array_equal(state.keys, editing.as_rows(document.motion))
        if not same or tuple(state.timing) != document.motion.timing:
            document.motion = editing.from_rows(document.motion, state.keys, state.timing)
        document.shaped = document.shaping()
        self.pose[:] = state.pose

"""What has been tapped, the shot that meets it, and how far it has been played."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.billiards.rhythm.candidates import FARTHEST_MISS, STROKE, Candidates
from game.billiards.rhythm.hearing import clicks_of
from game.billiards.rhythm.search import LEAST_GAP, MOST_BEATS, MOST_SECONDS, Rhythm, rhythm_of
from game.billiards.shot.physics import Physics
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import simulate_exact
from game.billiards.table.table import Table
from game.scenes.beat import state
from game.scenes.beat.level import MOST_NUMBERS, BeatContent, check_content
from game.scenes.beat.parameters import BeatParameters
from game.scenes.beat.state import BeatState
from game.scenes.shared.tables.sounds import sounds_of
from game.stage import Part, Sound
from game.stage.messages import Messages

PAUSE_S = 1.5  # between one playing and the next
SHOWN_S = 0.8  # that balls go on after the last beat


class Shown(NamedTuple):
    """A shot as it is played: how it meets the beat, the times of its clicks (s), its sounds."""

    trajectory: Trajectory
    rhythm: Rhythm
    clicks: tuple[float, ...]
    sounds: tuple[Sound, ...]

    @property
    def after(self) -> int:
        """Clicks that are heard after those for the last beat, until the shot is shown no more."""
        last = self.rhythm.beats[-1]
        return sum(click <= last + SHOWN_S for click in self.clicks) - len(self.rhythm.impacts)


class BeatModel(Part):
    """The beat and its shot."""

    def __init__(self, content: BeatContent, parameters: BeatParameters, seed: int) -> None:
        check_content(content)
        self.content, self.parameters, self.seed = content, parameters, seed
        self.table, self.physics = Table.pool(), Physics()
        self.messages = Messages()
        self.data = BeatState(np.zeros(MOST_BEATS), np.zeros(MOST_NUMBERS), np.zeros(4))
        self._known = b""
        self._shown: Shown | None = None
        self.data.taps[: len(content.beats)] = content.beats
        self.data.numbers[state.COUNT] = len(content.beats)
        self.data.numbers[state.PHASE] = state.SEARCHING if content.beats else state.SILENT
        if content.layout:
            self.take_layout(np.array(content.layout))

    @property
    def phase(self) -> int:
        """One of `state`'s."""
        return int(self.data.numbers[state.PHASE])

    @property
    def clock(self) -> float:
        """s since the first tap, or since the stroke."""
        return float(self.data.numbers[state.CLOCK])

    @property
    def beats(self) -> tuple[float, ...]:
        """What has been tapped, s since the first."""
        return tuple(self.data.taps[: int(self.data.numbers[state.COUNT])].tolist())

    def advance(self, dt: float) -> None:
        """Go on by dt (s)."""
        numbers = self.data.numbers
        numbers[state.CLOCK] += dt
        if self.phase == state.TAPPING and self.clock - self.beats[-1] > self.parameters.rest:
            if len(self.beats) > 1:
                numbers[state.PHASE] = state.SEARCHING
            else:
                numbers[state.PHASE] = state.SILENT
                self.messages.say("One tap is no beat: tap two or more.")
        elif self.phase == state.PLAYING and self.clock > self.beats[-1] + SHOWN_S + PAUSE_S:
            numbers[state.CLOCK] = 0.0

    def tap(self) -> None:
        """A tap: the first of a new beat, or one more."""
        numbers = self.data.numbers
        if self.phase != state.TAPPING:
            numbers[state.COUNT], numbers[state.CLOCK], numbers[state.PHASE], numbers[state.SIZE] = (
                1.0,
                0.0,
                state.TAPPING,
                0.0,
            )
            self.data.taps[:] = 0.0
        elif len(self.beats) == MOST_BEATS or self.clock > MOST_SECONDS:
            self.messages.say(f"At most {MOST_BEATS} taps in {MOST_SECONDS:g} s: these are searched for.")
            numbers[state.PHASE] = state.SEARCHING
        elif self.clock - self.beats[-1] >= LEAST_GAP:
            self.data.taps[len(self.beats)] = self.clock
            numbers[state.COUNT] += 1.0

    def search_again(self) -> None:
        """Look for another shot for the same beat."""
        if len(self.beats) > 1 and self.phase in (state.PLAYING, state.SILENT):
            self.data.numbers[state.PHASE], self.data.numbers[state.SIZE] = state.SEARCHING, 0.0

    def take_layout(self, layout: np.ndarray) -> None:
        """Play a layout from its stroke on. ValueError if it does not fit the beat or is no shot."""
        if len(layout) != STROKE + 2 * len(self.beats):
            raise ValueError(f"layout: expected {STROKE + 2 * len(self.beats)} numbers, got {len(layout)}")
        Candidates(self.table, self.physics, len(self.beats)).shot(layout)
        self.data.layout[: len(layout)] = layout
        self.data.numbers[state.SIZE], self.data.numbers[state.PHASE] = len(layout), state.PLAYING
        self.data.numbers[state.CLOCK] = -PAUSE_S

    def found_nothing(self) -> None:
        """The search came to no shot."""
        self.data.numbers[state.PHASE] = state.SILENT
        self.messages.say("No shot was found for this beat: tap another, or change the seed.")

    @property
    def shown(self) -> Shown | None:
        """The shot that is played; None while there is none."""
        size = int(self.data.numbers[state.SIZE])
        if not size:
            return None
        key = self.data.layout[:size].tobytes() + self.data.taps.tobytes()
        if self._shown is None or key != self._known:
            layout = self.data.layout[:size]
            shot = Candidates(self.table, self.physics, len(self.beats)).shot(layout)
            trajectory = simulate_exact(shot, until=self.beats[-1] + max(SHOWN_S, FARTHEST_MISS))
            found = rhythm_of(trajectory, self.beats, layout)
            sounds = sounds_of(trajectory, float(layout[0]))
            self._known, self._shown = key, Shown(trajectory, found, clicks_of(trajectory), sounds)
        return self._shown

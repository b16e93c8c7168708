"""The sound of a film: impacts at their moments, given out piece by piece with the pictures."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

import numpy as np

from game.arrays import Floats, Samples
from game.stage import Sound, Steady
from game.ui.sound import MASTER, SoundPlayer, mixed
from game.ui.steady import RATE, Bed


class Soundtrack:
    """Sounds waiting for their moment. Times are those of the film, s."""

    def __init__(self, volume: float = 0.8) -> None:
        self.volume = volume
        self._waiting: deque[Sound] = deque()
        self._tail = np.zeros((0, 2))  # of sounds that have begun, from the present moment on
        self._given = 0  # samples

    def schedule(self, sounds: Sequence[Sound], start: float) -> None:
        """Sounds of a shot that begins at ``start``; they are later than all that were scheduled before."""
        self._waiting.extend(sound._replace(time=sound.time + start) for sound in sounds)

    def take(self, until: float) -> Samples:
        """Samples (n, 2) from where the last ones ended to a moment of the film."""
        end = round(until * RATE)
        due = []
        while self._waiting and self._waiting[0].time * RATE < end:
            due.append(self._waiting.popleft())
        if due:
            self._add(mixed(due, self._given / RATE, self.volume).astype(np.float64))
        count = max(end - self._given, 0)
        out = np.zeros((count, 2))
        here = min(count, len(self._tail))
        out[:here] = self._tail[:here]
        self._tail = self._tail[here:]
        self._given += count
        return np.clip(np.rint(out), -32768, 32767).astype(np.int16)

    def add(self, piece: Samples, later: int = 0) -> None:
        """Samples (n, 2) that begin where the last ones given out ended, or so many samples later."""
        self._add(piece.astype(np.float64), later)

    @property
    def given(self) -> int:
        """How many samples have been given out."""
        return self._given

    def _add(self, piece: Floats, later: int = 0) -> None:
        missing = later + len(piece) - len(self._tail)
        if missing > 0:
            self._tail = np.concatenate([self._tail, np.zeros((missing, 2))])
        self._tail[later : later + len(piece)] += piece


class Ear(SoundPlayer):
    """Hears a scene's sounds for a sound track instead of a card."""

    def __init__(self, track: Soundtrack) -> None:
        super().__init__(track.volume)
        self._ready = True
        self._track = track
        self._bed = Bed()
        self._passed = 0.0  # s of the film

    def _play(self, samples: Samples) -> None:
        self._track.add(samples)

    def _go_on(self, steady: Sequence[Steady], elapsed_s: float) -> None:
        begin = max(round(self._passed * RATE), self._track.given)
        self._passed = begin / RATE + elapsed_s
        piece = self._bed.piece(steady, round(self._passed * RATE) - begin, self.volume * MASTER, self._pitch)
        if piece.any():
            self._track.add(np.rint(32767.0 * np.tanh(piece)).astype(np.int16), begin - self._track.given)

    def close(self) -> None:
        """There is no card to be given back."""

"""The sound of a film: impacts at their moments, given out piece by piece with the pictures."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from game.stage import Sound
from game.ui.sound import RATE, SoundPlayer, mixed


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

    def take(self, until: float) -> NDArray[np.int16]:
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

    def add(self, piece: NDArray[np.int16]) -> None:
        """Samples (n, 2) that begin where the last ones given out ended."""
        self._add(piece.astype(np.float64))

    def _add(self, piece: NDArray[np.float64]) -> None:
        if len(piece) > len(self._tail):
            piece[: len(self._tail)] += self._tail
            self._tail = piece
        else:
            self._tail[: len(piece)] += piece


class Ear(SoundPlayer):
    """Hears a scene's sounds for a sound track instead of a card."""

    def __init__(self, track: Soundtrack) -> None:
        super().__init__(track.volume)
        self._ready = True
        self._track = track

    def _play(self, samples: NDArray[np.int16]) -> None:
        self._track.add(samples)

    def close(self) -> None:
        """There is no card to be given back."""

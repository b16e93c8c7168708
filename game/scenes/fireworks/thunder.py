"""Sound that comes later: each event's wave goes out at the speed of sound until it meets the listener.

An event is heard when its wave is as far as the listener is from it. The listener walks slower than sound, so
each wave passes once: none is lost and none is heard twice, however the listener goes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels import elementary
from game.stage import Sound
from game.worlds.world import Member

SPEED_OF_SOUND = 343.2  # m/s, at 20 °C
WALKING = 100.0  # m/s at most, so that a hand is followed at once and no wave is overtaken
EAR = 1.7  # m above the ground
MOST_WAVES = 2_048
KEPT = 64  # of those heard last
HALVINGS = 40
SOUNDS = ("mortar", "burst", "crackle")
EMITTED, AT_X, AT_Y, AT_DEPTH, LOUD, KIND = range(6)  # columns of a wave
HEARD, HEARD_KIND, HEARD_LOUD, HEARD_PAN, HEARD_AFTER = range(5)  # columns of what was heard
WAITING, LAST, LOST = range(3)  # counts: waves on their way, heard so far, without a place
NEAR = 120.0  # m, at which an event is as loud as it is


class Thunder(Member):
    """Waves on their way to the listener, and what was heard last. All of it is state."""

    kept = ("waves", "heard", "counts", "ear")

    def __init__(self, listener: float, distance: float) -> None:
        self.waves = np.zeros((MOST_WAVES, 6))
        self.heard = np.zeros((KEPT, 5))
        self.counts = np.zeros(3, dtype=np.int64)
        self.ear = np.array((listener, distance))  # along the bank and before the shore, m

    def emit(self, instant: float, place: tuple[float, float, float], kind: str, loud: float) -> None:
        """A sound leaves a place (x, y, depth m) at an instant (s); without space it is lost and counted."""
        at = int(self.counts[WAITING])
        if at == MOST_WAVES:
            self.counts[LOST] += 1
            return
        self.waves[at] = instant, *place, loud, SOUNDS.index(kind)
        self.counts[WAITING] = at + 1

    def distances(self, waves: NDArray[np.float64], ear: NDArray[np.float64]) -> NDArray[np.float64]:
        """How far (n,) m the sources of some waves are from the listener."""
        across, up, back = waves[:, AT_X] - ear[0], waves[:, AT_Y] - EAR, waves[:, AT_DEPTH] + ear[1]
        return np.sqrt(across * across + up * up + back * back)

    def go_on(self, now: float, dt: float, walk_to: tuple[float, float]) -> None:
        """Let waves and listener go on from ``now`` by dt (s); who is met is heard, in the order of time."""
        before = self.ear.copy()
        way = np.array(walk_to) - before
        length = elementary.length(*way.tolist())
        if length > 0.0:
            self.ear += way * min(1.0, WALKING * dt / length)
        count = int(self.counts[WAITING])
        waves = self.waves[:count]
        if not count:
            return
        ahead = SPEED_OF_SOUND * (now + dt - waves[:, EMITTED]) - self.distances(waves, self.ear)
        met = ahead >= 0.0
        if not met.any():
            return
        found = []
        for wave in waves[met]:
            instant = self._meeting(wave, before, (now, dt))
            found.append((instant, *self._impression(wave, before, (instant - now) / dt, instant)))
        for row in sorted(found):
            last = int(self.counts[LAST])
            self.heard[last % KEPT] = row
            self.counts[LAST] = last + 1
        left = waves[~met].copy()
        self.waves[: len(left)] = left
        self.waves[len(left) : count] = 0.0
        self.counts[WAITING] = len(left)

    def _ear_at(self, before: NDArray[np.float64], share: float) -> NDArray[np.float64]:
        return before + share * (self.ear - before)

    def _meeting(
        self, wave: NDArray[np.float64], before: NDArray[np.float64], step: tuple[float, float]
    ) -> float:
        """The instant (s) within a step (its beginning and length, s) at which a wave meets the listener."""
        now, dt = step
        low, high = max(0.0, (float(wave[EMITTED]) - now) / dt), 1.0
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            way = self.distances(wave[None], self._ear_at(before, middle))[0]
            if SPEED_OF_SOUND * (now + middle * dt - wave[EMITTED]) >= way:
                high = middle
            else:
                low = middle
        return float(now + high * dt)

    def _impression(
        self, wave: NDArray[np.float64], before: NDArray[np.float64], share: float, instant: float
    ) -> tuple[float, float, float, float]:
        """Kind, loudness, where between left (-1) and right (1), and how long it took (s)."""
        ear = self._ear_at(before, share)
        way = max(float(self.distances(wave[None], ear)[0]), 1.0)
        loud = float(wave[LOUD]) * NEAR / max(way, 0.25 * NEAR)
        return float(wave[KIND]), loud, float(wave[AT_X] - ear[0]) / way, instant - float(wave[EMITTED])

    def sounds(self) -> list[Sound]:
        """What was heard last, in the order of time."""
        last = int(self.counts[LAST])
        rows = [self.heard[i % KEPT] for i in range(max(last - KEPT, 0), last)]
        return [
            Sound(
                float(row[HEARD]), SOUNDS[int(row[HEARD_KIND])], float(row[HEARD_LOUD]), float(row[HEARD_PAN])
            )
            for row in rows
        ]

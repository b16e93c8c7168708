"""Sounds that go on: rolling, sliding, flames, wind, rustling, falling rubble, water, the tone of a place.

Each kind is a loop of noise whose spectrum falls off on both sides of a band and whose loudness swells at
random. A loop is made by an inverse Fourier transform of random phases, so its end meets its beginning. Where
a picture is slow, the loop runs slower and sounds lower.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame

from game.arrays import Floats
from game.stage import Steady

RATE = 44_100  # Hz
LOOP_S = 17.0  # so long that no crackle is recognised when it comes again
BRIGHTS = 3  # a loop is kept in so many degrees of brightness
PITCHES = (1.0, 0.71, 0.5)  # of slow pictures: a loop is kept at these
LEAST_LEVEL = 0.004  # what is quieter is not heard
FADE_MS = 120  # of a loop that begins or ends on a card


class Band(NamedTuple):
    """Noise between two frequencies (Hz) that swells at some rates (Hz), by which share of its loudness.

    grains: how peaked its swelling is; 1 is even, larger ones are single crackles.
    """

    low: float
    high: float
    swell_low: float
    swell_high: float
    share: float
    grains: float = 1.0


BANDS = {
    "rolling": (Band(70.0, 620.0, 6.0, 30.0, 0.6), Band(900.0, 2400.0, 10.0, 40.0, 0.8, 2.0)),
    "sliding": (Band(700.0, 5200.0, 14.0, 60.0, 0.7, 1.5),),
    "flame": (Band(45.0, 320.0, 2.0, 12.0, 0.7), Band(1500.0, 6000.0, 3.0, 25.0, 1.0, 9.0)),
    "wind": (Band(130.0, 900.0, 0.3, 1.2, 0.6), Band(900.0, 2600.0, 0.3, 1.5, 0.9, 2.0)),
    "rustle": (Band(2200.0, 9000.0, 8.0, 45.0, 1.0, 5.0),),
    "rubble": (Band(24.0, 130.0, 1.5, 9.0, 0.6), Band(300.0, 1900.0, 6.0, 40.0, 1.0, 4.0)),
    "hiss": (Band(2800.0, 11_000.0, 0.5, 4.0, 0.4),),
    "room": (Band(30.0, 420.0, 0.3, 1.0, 0.2),),
    "water": (Band(90.0, 900.0, 0.8, 6.0, 0.4), Band(900.0, 5200.0, 4.0, 30.0, 0.6, 2.0)),
}
STEADY_KINDS = tuple(BANDS)


@lru_cache(maxsize=len(BANDS) * BRIGHTS)
def loop_of(kind: str, bright: int) -> Floats:
    """One turn of a loop (n,) of mean square 1/9; ``bright``: 0 to BRIGHTS - 1.

    ValueError for another kind.
    """
    if kind not in BANDS:
        raise ValueError(f"steady sound {kind!r}: expected one of {', '.join(STEADY_KINDS)}")
    count = round(LOOP_S * RATE)
    shift = 2.0 ** (0.7 * (bright - 1))
    made = np.zeros(count)
    for number, band in enumerate(BANDS[kind]):
        chance = np.random.default_rng([STEADY_KINDS.index(kind), number])
        noise = _banded(chance, count, band.low * shift, band.high * shift)
        swell = _banded(chance, count, band.swell_low, band.swell_high)
        lifted = np.maximum(1.0 + band.share * swell, 0.0) ** band.grains
        made += noise * lifted / math.sqrt(float(np.mean(lifted**2))) / (1.0 + number)
    made /= 3.0 * math.sqrt(float(np.mean(made**2)))
    made.setflags(write=False)
    return made


def _banded(chance: np.random.Generator, count: int, low: float, high: float) -> Floats:
    """Noise (count,) of mean square 1 that repeats itself, 12 dB an octave weaker outside of a band."""
    hertz = np.fft.rfftfreq(count, 1.0 / RATE)
    with np.errstate(divide="ignore"):
        gain = np.minimum(1.0, (hertz / low) ** 2) * np.minimum(1.0, (high / np.maximum(hertz, 1e-9)) ** 2)
    phases = np.exp(2j * math.pi * chance.random(len(hertz)))
    made: Floats = np.fft.irfft(gain * phases, count)
    return made / math.sqrt(float(np.mean(made**2)))


def bright_of(steady: Steady) -> int:
    """Which loop of its kind a sound takes."""
    return min(max(int(steady.bright * BRIGHTS), 0), BRIGHTS - 1)


def sides(pan: float) -> tuple[float, float]:
    """Gains of the left and the right, of equal power together."""
    angle = 0.25 * math.pi * (1.0 + min(max(pan, -1.0), 1.0) * 0.8)
    return math.cos(angle), math.sin(angle)


class Bed:
    """What goes on in a film: pieces that follow each other without a seam."""

    def __init__(self) -> None:
        self._gains: dict[tuple[str, int], tuple[float, float]] = {}  # of the last piece's end
        self._places: dict[tuple[str, int], float] = {}  # in the loops, samples

    def piece(self, steady: Sequence[Steady], count: int, volume: float, pitch: float) -> Floats:
        """The next ``count`` samples (count, 2), -1 to 1; gains go linearly to what they are now."""
        wanted: dict[tuple[str, int], tuple[float, float]] = {}
        for one in steady:
            if one.level >= LEAST_LEVEL:
                left, right = sides(one.pan)
                loud = min(one.level, 1.0) * volume
                before = wanted.get((one.kind, bright_of(one)), (0.0, 0.0))
                wanted[one.kind, bright_of(one)] = (before[0] + loud * left, before[1] + loud * right)
        out = np.zeros((count, 2))
        ramp = np.arange(1, count + 1) / max(count, 1)
        for key in sorted(wanted.keys() | self._gains.keys()):
            old, new = self._gains.get(key, (0.0, 0.0)), wanted.get(key, (0.0, 0.0))
            loop, begin = loop_of(*key), self._places.get(key, 0.0)
            at = (begin + pitch * np.arange(count)) % len(loop)
            first = at.astype(np.int64)
            share = at - first
            heard = (1.0 - share) * loop[first] + share * loop[(first + 1) % len(loop)]
            for side in range(2):
                out[:, side] += heard * (old[side] + (new[side] - old[side]) * ramp)
            self._places[key] = (begin + pitch * count) % len(loop)
        self._gains = {key: gains for key, gains in wanted.items() if max(gains) > 0.0}
        return out


class Loops:
    """What goes on, on a sound card: a channel for each loop, from channel ``first`` on, at most ``most``."""

    def __init__(self, first: int, most: int) -> None:
        self._free = list(range(first, first + most))
        self._playing: dict[tuple[str, int, int], int] = {}

    def follow(self, steady: Sequence[Steady], volume: float, pitch: float) -> None:
        """Set each loop's loudness; begin what is new, end what is over. ValueError for an unknown kind."""
        step = int(np.argmin([abs(pitch - kept) for kept in PITCHES]))
        loudest = sorted((one for one in steady if one.level >= LEAST_LEVEL), key=lambda one: -one.level)
        wanted: dict[tuple[str, int, int], Steady] = {}
        for one in loudest[: len(self._free) + len(self._playing)]:
            wanted.setdefault((one.kind, bright_of(one), step), one)
        for key in [key for key in self._playing if key not in wanted]:
            number = self._playing.pop(key)
            pygame.mixer.Channel(number).fadeout(FADE_MS)
            self._free.append(number)
        for key, one in wanted.items():
            if key not in self._playing:
                if not self._free:
                    continue
                self._playing[key] = number = self._free.pop(0)
                pygame.mixer.Channel(number).play(_card_loop(*key), loops=-1, fade_ms=FADE_MS)
            loud = min(one.level, 1.0) * volume
            left, right = sides(one.pan)
            pygame.mixer.Channel(self._playing[key]).set_volume(loud * left, loud * right)

    def stop(self) -> None:
        """Nothing goes on any more."""
        for number in self._playing.values():
            pygame.mixer.Channel(number).fadeout(FADE_MS)
            self._free.append(number)
        self._playing.clear()


@lru_cache(maxsize=len(BANDS) * BRIGHTS * len(PITCHES))
def _card_loop(kind: str, bright: int, step: int) -> pygame.mixer.Sound:
    """A loop as a card plays it."""
    loop = loop_of(kind, bright)
    at = np.arange(int(len(loop) / PITCHES[step])) * PITCHES[step]
    heard = np.interp(at, np.arange(len(loop) + 1), np.append(loop, loop[0]))
    both = np.rint(32767.0 * np.tanh(np.repeat(heard[:, None], 2, axis=1))).astype(np.int16)
    return pygame.mixer.Sound(buffer=np.ascontiguousarray(both).tobytes())

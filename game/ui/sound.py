"""Sounds of impacts, made of damped tones and noise, and a player that follows a line of them.

Nothing is read from files. What is heard in a frame is mixed into one short piece, each sound at its own
moment within the frame. It is as loud and as bright as the impact was fast, and comes from its place on the
table. Without a sound card all of it is silent. The player hears what a scene says of itself and never
changes it. In slow motion all of it sounds lower.
"""

from __future__ import annotations

import contextlib
import math
import os
import threading
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame

from game.arrays import Floats, Samples
from game.stage import Hearing, Sound, Steady
from game.ui.steady import RATE, Loops

VOICES = 12  # most sounds that are mixed into one piece: the loudest
WIND_S = 0.38  # s, a grain of the sound of wind
CHANNELS = 16  # pieces that may sound at a time
STEADY_CHANNELS = 8  # sounds that go on beside them
LOWEST_PITCH = 0.35  # of slow motion
PITCH_STEPS = 4  # an octave, at which a sample of slow motion is kept
LOUD_SPEED = 4.0  # m/s, of an impact at full gain
QUIETEST = 0.05  # m/s; what is slower is not heard
LOUDEST = 1.6  # gain beyond which nothing grows louder
MASTER = 0.42
LAYERS = 4  # a sound is kept in so many degrees of brightness
LONGEST_GAP_S = 0.3  # of a scene's time between two frames; what is skipped is not heard
LATE_S = 0.1  # a line joined later than this after its beginning is joined where it is


class _Tone(NamedTuple):
    """A damped tone: frequency Hz, share, time constant s."""

    hertz: float
    share: float
    fades_s: float


BALL = (_Tone(3100.0, 1.0, 0.0045), _Tone(4900.0, 0.65, 0.0035), _Tone(7300.0, 0.40, 0.0025))
TIP = (_Tone(700.0, 1.0, 0.008), _Tone(2200.0, 0.55, 0.005))
MISCUE = (_Tone(1900.0, 1.0, 0.006), _Tone(3300.0, 0.8, 0.005), _Tone(5800.0, 0.5, 0.003))
WOOD = (_Tone(1250.0, 1.0, 0.011), _Tone(2680.0, 0.55, 0.007), _Tone(4300.0, 0.3, 0.004))
STEEL = (_Tone(4150.0, 1.0, 0.02), _Tone(6870.0, 0.6, 0.014), _Tone(9300.0, 0.35, 0.009))
RAIL = (
    _Tone(1480.0, 1.0, 0.05),
    _Tone(2310.0, 0.7, 0.04),
    _Tone(3920.0, 0.5, 0.025),
    _Tone(5400.0, 0.3, 0.015),
)
GLASS = (_Tone(2350.0, 1.0, 0.11), _Tone(5480.0, 0.7, 0.07), _Tone(9100.0, 0.4, 0.035))
GROUND = (_Tone(54.0, 1.0, 0.13), _Tone(97.0, 0.7, 0.08), _Tone(171.0, 0.5, 0.045))
STONE = (_Tone(980.0, 1.0, 0.007), _Tone(1710.0, 0.7, 0.005), _Tone(3350.0, 0.4, 0.003))
KINDS = (
    "tip", "miscue", "ball", "cushion", "pocket", "wood", "thud", "stone", "mortar", "burst", "crackle",
    "steel", "rail", "wind", "rustle", "glass", "ground",
    "splash", "bubble",
)  # fmt: skip


def gain_of(speed: float) -> float:
    """How loud an impact is; 0 for one that is not heard."""
    return min((speed / LOUD_SPEED) ** 0.7, LOUDEST) if speed >= QUIETEST else 0.0


def layer_of(speed: float) -> int:
    """Which brightness an impact has, 0 to LAYERS - 1."""
    share = math.log2(max(speed, QUIETEST) / 0.25) / 5.0
    return min(max(int(share * LAYERS), 0), LAYERS - 1)


@lru_cache(maxsize=len(KINDS) * LAYERS)
def sample_of(kind: str, layer: int) -> Floats:
    """A sound (n,) of largest value 1. ValueError for a kind that there is none of."""
    bright = (layer + 1.0) / LAYERS
    if kind == "ball":
        made = _tones(BALL, 0.030, bright)
    elif kind == "tip":
        made = _tones(TIP, 0.045, bright) + 0.15 * bright * _noise(0.045, 3000.0, 0.002, 1)
    elif kind == "miscue":  # the ferrule clicks on the ball, and the tip scrapes along it
        scrape = _noise(0.07, 5200.0, 0.016, 13)
        made = 0.6 * _tones(MISCUE, 0.07, bright) + (0.6 + 0.4 * bright) * scrape
    elif kind == "cushion":
        thump = _tones((_Tone(120.0, 1.0, 0.028),), 0.11, 1.0)
        made = thump + (0.5 + 0.5 * bright) * _noise(0.11, 350.0 + 900.0 * bright, 0.018, 2)
    elif kind == "wood":
        made = _tones(WOOD, 0.06, bright) + 0.12 * bright * _noise(0.06, 4000.0, 0.002, 4)
    elif kind == "stone":
        made = _tones(STONE, 0.05, bright) + 0.35 * bright * _noise(0.05, 2600.0, 0.003, 8)
    elif kind == "thud":
        made = _tones((_Tone(310.0, 1.0, 0.02), _Tone(160.0, 0.6, 0.03)), 0.12, 1.0) + 0.3 * bright * _noise(
            0.12, 900.0, 0.01, 5
        )
    elif kind == "pocket":
        made = _pocket(bright)
    elif kind == "steel":
        made = _tones(STEEL, 0.11, bright)
    elif kind == "glass":
        made = _tones(GLASS, 0.4, bright) + 0.1 * bright * _noise(0.4, 6000.0, 0.002, 10)
    elif kind == "ground":  # what is heavy falls on earth: the ground gives way and swings
        made = _tones(GROUND, 0.6, 1.0) + 0.7 * bright * _noise(0.6, 700.0, 0.05, 9)
    elif kind == "rail":
        made = _tones(RAIL, 0.24, bright) + 0.1 * bright * _noise(0.24, 3000.0, 0.003, 8)
    elif kind == "wind":
        made = _breath(bright)
    elif kind == "rustle":
        made = _rustle(bright)
    elif kind == "splash":
        made = _splash(bright)
    elif kind == "bubble":  # air under water swings; its tone rises as it comes up
        t = np.arange(int(0.12 * RATE)) / RATE
        made = np.sin(math.tau * (900.0 + 900.0 * bright) * t * (1.0 + 1.6 * t)) * np.exp(-t / 0.022)
    elif kind in ("mortar", "burst", "crackle"):
        made = _explosion(kind, bright)
    else:
        raise ValueError(f"sound {kind!r}: expected one of {', '.join(KINDS)}")
    made = made / np.abs(made).max()
    made.setflags(write=False)
    return made


def pitch_of(pace: float) -> float:
    """How much lower things sound where time runs at ``pace`` times life's: 1 at full pace and above."""
    return min(max(math.sqrt(max(pace, 0.0)), LOWEST_PITCH), 1.0)


@lru_cache(maxsize=len(KINDS) * LAYERS * 2 * PITCH_STEPS)
def lowered(kind: str, layer: int, steps: int) -> Floats:
    """A sound (n,) played slower: by so many steps, PITCH_STEPS an octave. ValueError as `sample_of`."""
    sample, pitch = sample_of(kind, layer), 2.0 ** (-steps / PITCH_STEPS)
    at = np.arange(int(len(sample) / pitch)) * pitch
    made: Floats = np.interp(at, np.arange(len(sample)), sample, right=0.0)
    made.setflags(write=False)
    return made


def _pocket(bright: float) -> Floats:
    """A thud on leather, and the click of the ball on those that lie there."""
    made = np.zeros(int(0.36 * RATE))
    thud = _tones((_Tone(110.0, 1.0, 0.045), _Tone(64.0, 0.5, 0.06)), 0.22, 1.0)
    made[: len(thud)] += thud
    rustle = _noise(0.22, 600.0 + 600.0 * bright, 0.03, 3)
    made[: len(rustle)] += 0.5 * rustle
    click = 0.22 * _tones(BALL, 0.03, 0.4)
    start = int(0.19 * RATE)
    made[start : start + len(click)] += click
    return made


def _breath(bright: float) -> Floats:
    """A grain of the sound of wind: noise that swells and fades, higher as it is faster; grains overlap."""
    t = np.linspace(0.0, 1.0, int(WIND_S * RATE))
    noise = _noise(WIND_S, 160.0 + 520.0 * bright, 1e3, 11) - 0.7 * _noise(WIND_S, 60.0, 1e3, 11)
    made: Floats = noise * np.sin(math.pi * t[: len(noise)]) ** 2
    return made


def _rustle(bright: float) -> Floats:
    """A dry leaf that is moved: a handful of ticks of high noise within a twentieth of a second."""
    chance, made = np.random.default_rng(12), np.zeros(int(0.09 * RATE))
    for _ in range(7):
        tick = _noise(0.02, 3000.0 + 4000.0 * bright, 0.0025, int(chance.integers(1000)))
        start = int(chance.random() * (len(made) - len(tick)))
        made[start : start + len(tick)] += chance.uniform(0.3, 1.0) * tick
    return made - np.convolve(made, np.full(24, 1.0 / 24.0), "same")


def _splash(bright: float) -> Floats:
    """A body of water is struck: a slap, a rush that fades, and bubbles that ring (Minnaert 1933), the more
    and the higher the harder it was.
    """
    length = 0.7
    made = _noise(length, 500.0 + 2600.0 * bright, 0.03, 14) + 0.7 * _noise(length, 1800.0, 0.16, 15)
    made += (0.3 + 0.3 * bright) * _noise(length, 260.0, 0.07, 16)
    chance = np.random.default_rng(17)
    for _ in range(4 + int(10 * bright)):
        tone = _Tone(float(chance.uniform(420.0, 1500.0 + 1400.0 * bright)), 1.0, 0.012)
        ring = _tones((tone,), 0.08, 1.0)
        start = int(chance.uniform(0.03, 0.75) * (len(made) - len(ring)))
        made[start : start + len(ring)] += chance.uniform(0.05, 0.2) * ring
    return made


def _explosion(kind: str, bright: float) -> Floats:
    """A thump out of a mortar, the boom of a shell with its roll over the land, or a small crack."""
    if kind == "crackle":
        return _noise(0.06, 2500.0 + 2500.0 * bright, 0.008, 6)
    if kind == "mortar":
        thump = _tones((_Tone(72.0, 1.0, 0.07), _Tone(131.0, 0.4, 0.04)), 0.4, 1.0)
        return thump + 0.4 * _noise(0.4, 300.0 + 500.0 * bright, 0.03, 4)
    boom = _tones((_Tone(46.0, 1.0, 0.16), _Tone(83.0, 0.6, 0.09)), 1.4, 1.0)
    crack = _noise(1.4, 500.0 + 1600.0 * bright, 0.02, 5)
    return boom + 0.8 * crack + 0.35 * _noise(1.4, 140.0, 0.35, 7)


def _tones(tones: Sequence[_Tone], length_s: float, bright: float) -> Floats:
    """Damped tones; the higher ones are weaker where it is less bright."""
    t = np.arange(int(length_s * RATE)) / RATE
    attack = np.minimum(t / 0.0004, 1.0)
    total = np.zeros_like(t)
    for rank, tone in enumerate(tones):
        share = tone.share * bright ** (0.8 * rank)
        total += share * np.exp(-t / tone.fades_s) * np.sin(2.0 * np.pi * tone.hertz * t)
    return total * attack * np.minimum((t[-1] - t) / 0.003, 1.0)


def _noise(length_s: float, hertz: float, fades_s: float, seed: int) -> Floats:
    """Noise below a frequency (one pole), fading."""
    t = np.arange(int(length_s * RATE)) / RATE
    raw = np.random.default_rng(seed).normal(size=len(t))
    keep = math.exp(-2.0 * math.pi * hertz / RATE)
    reach = min(int(8.0 / (1.0 - keep)) + 1, len(t))
    low = np.convolve(raw, (1.0 - keep) * keep ** np.arange(reach))[: len(t)]
    shape = np.minimum(t / 0.0004, 1.0) * np.exp(-t / fades_s) * np.minimum((t[-1] - t) / 0.003, 1.0)
    return low / np.abs(low).max() * shape


def mixed(sounds: Sequence[Sound], start: float, volume: float, pitch: float = 1.0) -> Samples:
    """Sounds as samples (n, 2) from the moment ``start`` (s) on; none: (0, 2). ``pitch``: see `pitch_of`."""
    heard = [sound for sound in sounds if gain_of(sound.speed) > 0.0]
    heard.sort(key=lambda sound: -gain_of(sound.speed))
    parts, steps = [], round(-PITCH_STEPS * math.log2(pitch))
    for sound in heard[:VOICES]:
        first = max(int((sound.time - start) * RATE), 0)
        parts.append((first, lowered(sound.kind, layer_of(sound.speed), steps), sound))
    if not parts:
        return np.zeros((0, 2), np.int16)
    total = np.zeros((max(first + len(sample) for first, sample, _ in parts), 2))
    for first, sample, sound in parts:
        loud = gain_of(sound.speed) * volume * MASTER
        angle = 0.25 * math.pi * (1.0 + min(max(sound.pan, -1.0), 1.0) * 0.8)  # equal power
        total[first : first + len(sample), 0] += loud * math.cos(angle) * sample
        total[first : first + len(sample), 1] += loud * math.sin(angle) * sample
    return np.rint(32767.0 * np.tanh(total)).astype(np.int16)


class SoundPlayer:
    """Plays what a scene's line of sounds reaches, frame by frame. ``volume``: 0 to 1."""

    def __init__(self, volume: float = 0.7) -> None:
        self.volume = volume
        self.pieces = 0  # played so far
        self._key: object = None
        self._time = 0.0
        self._pitch = 1.0
        self._loops = Loops(0, STEADY_CHANNELS)
        self._ready = False
        self._opening: threading.Thread | None = None

    @property
    def ready(self) -> bool:
        """True if there is a card that sounds."""
        return self._ready

    def prepare(self) -> None:
        """Open the sound card in the background; without one, or without a screen, all stays silent."""
        if self._opening is None and self.volume > 0.0 and _wanted():
            self._opening = threading.Thread(target=self._open, daemon=True, name="sound")
            self._opening.start()

    def _open(self) -> None:
        with contextlib.suppress(pygame.error, NotImplementedError):
            pygame.mixer.init(RATE, -16, 2, 512, allowedchanges=0)
            pygame.mixer.set_num_channels(STEADY_CHANNELS + CHANNELS)
            pygame.mixer.set_reserved(STEADY_CHANNELS)
            for kind in KINDS:
                for layer in range(LAYERS):
                    sample_of(kind, layer)
            self._ready = True

    def follow(self, hearing: Hearing | None, elapsed_s: float = 0.0) -> None:
        """Play what lies between the last frame's moment and this one's.

        ``elapsed_s``: real time between the two, by which slow motion is known; 0 where it is not known.
        """
        if hearing is None:
            self._key = None
            self._go_on((), elapsed_s)
            return
        now = hearing.time
        if hearing.key != self._key:
            self._key = hearing.key
            self._time = now if now > LATE_S else -1e-9
        since, self._time = self._time, now
        if since < now <= since + LONGEST_GAP_S:
            if elapsed_s > 0.0 and since >= 0.0:
                self._pitch += 0.3 * (pitch_of((now - since) / elapsed_s) - self._pitch)
            due = [sound for sound in hearing.sounds if since < sound.time <= now]
            if due and self._ready and self.volume > 0.0:
                self._play(mixed(due, since, self.volume, self._pitch))
        self._go_on(hearing.steady, elapsed_s)

    def _go_on(self, steady: Sequence[Steady], elapsed_s: float) -> None:
        """What goes on sounds as it is now."""
        if self._ready:
            with contextlib.suppress(pygame.error):
                self._loops.follow(steady if self.volume > 0.0 else (), self.volume * MASTER, self._pitch)

    def _play(self, samples: Samples) -> None:
        if not len(samples):
            return
        with contextlib.suppress(pygame.error):
            channel = pygame.mixer.find_channel()
            if channel is not None:
                channel.play(pygame.mixer.Sound(buffer=samples.tobytes()))
                self.pieces += 1

    def close(self) -> None:
        """Give the card back."""
        if self._opening is not None:
            self._opening.join()
            self._opening = None
        if self._ready:
            self._ready = False
            pygame.mixer.quit()


def _wanted() -> bool:
    """False where pictures are made without a screen, unless a sound driver was named on purpose."""
    named = os.environ.get("SDL_AUDIODRIVER", "")
    return bool(named) or os.environ.get("SDL_VIDEODRIVER", "") not in ("dummy", "offscreen")

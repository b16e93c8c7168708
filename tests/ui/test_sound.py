"""Sounds: made of tones, as loud as the impact, at their moment; silent without a card."""

import itertools
import math

import numpy as np
import pygame
import pytest

from game.stage import Hearing, Sound
from game.ui import sound as sounds
from game.ui.sound import KINDS, LAYERS, RATE, SoundPlayer, gain_of, layer_of, mixed, sample_of

LONGEST_S = {
    "mortar": 0.45,
    "burst": 1.5,
    "ground": 0.65,
    "glass": 0.45,
    "splash": 0.75,
}  # what rolls over open land or rings; all else is of a small room


@pytest.mark.parametrize("kind", KINDS)
def test_samples_begin_and_end_in_silence_and_do_not_clip(kind):
    for layer in range(LAYERS):
        sample = sample_of(kind, layer)
        assert np.abs(sample).max() == pytest.approx(1.0)
        assert abs(sample[0]) < 0.05 and abs(sample[-1]) < 0.01
        assert np.isfinite(sample).all()
        assert len(sample) < LONGEST_S.get(kind, 0.4) * RATE


def spectrum_peak(sample) -> float:
    spectrum = np.abs(np.fft.rfft(sample))
    return float(np.fft.rfftfreq(len(sample), 1.0 / RATE)[spectrum.argmax()])


def test_balls_ring_high_cushions_low():
    assert spectrum_peak(sample_of("ball", 0)) == pytest.approx(3100.0, rel=0.05)
    assert spectrum_peak(sample_of("cushion", 0)) < 300.0
    assert spectrum_peak(sample_of("pocket", 0)) < 300.0


def test_explosions_are_low_and_crackle_is_high():
    assert spectrum_peak(sample_of("burst", 0)) < 60.0 and spectrum_peak(sample_of("mortar", 0)) < 90.0
    assert spectrum_peak(sample_of("crackle", 3)) > 300.0


def test_a_faster_impact_is_louder_and_brighter():
    speeds = np.geomspace(0.06, 10.0, 20)
    gains = [gain_of(speed) for speed in speeds]
    assert all(a < b or b == sounds.LOUDEST for a, b in itertools.pairwise(gains))
    assert gain_of(4.0) == pytest.approx(1.0)
    assert gain_of(2.0) == pytest.approx(0.5**0.7)
    assert gain_of(0.049) == 0.0
    layers = [layer_of(speed) for speed in speeds]
    assert layers == sorted(layers) and layers[0] == 0 and layers[-1] == LAYERS - 1

    def centre(sample) -> float:
        spectrum = np.abs(np.fft.rfft(sample)) ** 2
        return float((spectrum * np.fft.rfftfreq(len(sample), 1 / RATE)).sum() / spectrum.sum())

    for kind in ("ball", "cushion"):
        centres = [centre(sample_of(kind, layer)) for layer in range(LAYERS)]
        assert centres == sorted(centres)


def test_a_sound_begins_at_its_moment_in_the_piece():
    early, late = Sound(1.000, "ball", 3.0), Sound(1.010, "ball", 3.0)
    alone, both = mixed([early], 1.0, 1.0), mixed([early, late], 1.0, 1.0)
    start = int(0.010 * RATE)
    quiet = int(0.002 * RATE)
    assert np.array_equal(alone[: start - quiet], both[: start - quiet])
    shifted = mixed([late], 1.0, 1.0)
    assert not shifted[: start - quiet].any() and np.abs(shifted[start : start + 100]).max() > 1000


def test_the_pan_moves_a_sound_to_its_side_with_equal_power():
    def powers(pan):
        piece = mixed([Sound(0.0, "ball", 1.0, pan)], 0.0, 0.3).astype(float)
        return (piece**2).sum(axis=0)

    left, middle, right = powers(-1.0), powers(0.0), powers(1.0)
    assert left[0] > 5.0 * left[1] and right[1] > 5.0 * right[0]
    assert middle[0] == pytest.approx(middle[1], rel=1e-3)
    assert left.sum() == pytest.approx(middle.sum(), rel=0.05)


def test_a_break_does_not_overflow():
    crowd = [Sound(0.001 * k, "ball", 10.0, math.sin(k)) for k in range(200)]
    piece = mixed(crowd, 0.0, 1.0)
    assert piece.dtype == np.int16 and np.abs(piece.astype(int)).max() <= 32767
    assert mixed([], 0.0, 1.0).shape == (0, 2)
    assert mixed([Sound(0.0, "ball", 0.01)], 0.0, 1.0).shape == (0, 2)


class Heard(SoundPlayer):
    """Keeps what would be played."""

    def __init__(self):
        super().__init__(0.7)
        self._ready = True
        self.played = []

    def _play(self, samples):
        self.played.append(len(samples))


LINE = (
    Sound(0.0, "tip", 3.0),
    Sound(0.5, "ball", 2.0),
    Sound(0.505, "cushion", 2.0),
    Sound(2.0, "pocket", 1.0),
)


def test_each_sound_of_a_line_is_played_once():
    player = Heard()
    for frame in range(200):
        player.follow(Hearing("shot", (frame + 0.5) / 60.0, LINE))
    assert len(player.played) == 3  # the second and third in one piece


def test_what_is_skipped_or_gone_back_over_is_not_played():
    player = Heard()
    player.follow(Hearing("shot", 0.01, LINE))
    assert len(player.played) == 1
    player.follow(Hearing("shot", 2.5, LINE))
    player.follow(Hearing("shot", 0.2, LINE))
    assert len(player.played) == 1
    player.follow(Hearing("shot", 0.3, LINE))
    player.follow(None)
    player.follow(Hearing("shot", 0.52, LINE))  # joined in its midst
    assert len(player.played) == 1


def test_without_a_card_everything_is_silent(monkeypatch):
    pygame.mixer.quit()  # whatever another test has opened
    monkeypatch.setenv("SDL_AUDIODRIVER", "no such driver")
    player = SoundPlayer(0.7)
    player.prepare()
    player.follow(Hearing("shot", 0.01, LINE))
    player.close()
    assert not player.ready and player.pieces == 0


def test_with_the_dummy_driver_pieces_are_played(monkeypatch):
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    player = SoundPlayer(0.7)
    player.prepare()
    player._opening.join()
    assert player.ready
    player.follow(Hearing("shot", 0.01, LINE))
    assert player.pieces == 1
    player.volume = 0.0
    player.follow(Hearing("shot", 0.02, (Sound(0.015, "ball", 3.0),)))
    assert player.pieces == 1
    player.close()
    assert pygame.mixer.get_init() is None


def test_no_card_is_opened_without_a_screen(monkeypatch):
    monkeypatch.delenv("SDL_AUDIODRIVER", raising=False)
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    player = SoundPlayer(0.7)
    player.prepare()
    assert player._opening is None

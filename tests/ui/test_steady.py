"""Sounds that go on: loops without a seam, as loud as they are said to be, lower in slow motion."""

import numpy as np
import pygame
import pytest

from game.app.film.soundtrack import Ear, Soundtrack
from game.stage import Hearing, Sound, Steady
from game.ui.sound import MASTER, SoundPlayer, mixed, pitch_of
from game.ui.steady import BRIGHTS, LOOP_S, RATE, STEADY_KINDS, Bed, loop_of


def centre(samples) -> float:
    """Mean frequency of the power, Hz."""
    spectrum = np.abs(np.fft.rfft(samples)) ** 2
    return float((spectrum * np.fft.rfftfreq(len(samples), 1.0 / RATE)).sum() / spectrum.sum())


@pytest.mark.parametrize("kind", STEADY_KINDS)
def test_a_loop_has_no_seam_and_is_as_loud_as_any_other(kind):
    for bright in range(BRIGHTS):
        loop = loop_of(kind, bright)
        assert np.sqrt(np.mean(loop**2)) == pytest.approx(1.0 / 3.0)
        steps = np.abs(np.diff(loop))
        assert abs(loop[0] - loop[-1]) <= steps.max()


@pytest.mark.parametrize("kind", STEADY_KINDS)
def test_a_brighter_loop_is_higher(kind):
    centres = [centre(loop_of(kind, bright)) for bright in range(BRIGHTS)]
    assert centres == sorted(centres) and centres[-1] > 1.3 * centres[0]


def test_an_unknown_kind_is_named():
    with pytest.raises(ValueError, match="steady sound 'purr'"):
        loop_of("purr", 0)


def test_pieces_of_a_film_follow_each_other_without_a_seam():
    steady = [Steady("wind", 0.5), Steady("rolling", 0.2, bright=0.9, pan=-1.0)]
    bed, whole = Bed(), Bed()
    bed.piece(steady, 10, 1.0, 1.0)
    whole.piece(steady, 10, 1.0, 1.0)
    parts = [bed.piece(steady, count, 1.0, 1.0) for count in (700, 1, 1469, 735)]
    assert np.allclose(np.concatenate(parts), whole.piece(steady, 2905, 1.0, 1.0))


def test_what_ends_fades_within_a_piece_and_what_is_faint_is_silent():
    bed = Bed()
    bed.piece([Steady("hiss", 0.8)], 735, 1.0, 1.0)
    ending = bed.piece([], 735, 1.0, 1.0)
    assert np.abs(ending[:100]).max() > 0.01 and np.abs(ending[-5:]).max() < 0.01
    assert not bed.piece([Steady("flame", 0.001)], 735, 1.0, 1.0).any()


def test_twice_the_level_is_twice_the_amplitude_on_its_side():
    def powers(level, pan):
        bed = Bed()
        bed.piece([Steady("sliding", level, pan=pan)], 10, 1.0, 1.0)
        return np.sqrt(np.mean(bed.piece([Steady("sliding", level, pan=pan)], RATE, 1.0, 1.0) ** 2, axis=0))

    quiet, loud = powers(0.2, 0.0), powers(0.4, 0.0)
    assert loud == pytest.approx(2.0 * quiet)
    left = powers(0.2, -1.0)
    assert left[0] > 5.0 * left[1]


def test_slow_motion_is_lower():
    assert pitch_of(1.0) == pitch_of(4.0) == 1.0
    assert pitch_of(0.25) == pytest.approx(0.5) and pitch_of(0.0) > 0.0
    sound = [Sound(0.0, "ball", 3.0)]
    full, half = (mixed(sound, 0.0, 1.0, pitch)[:, 0].astype(float) for pitch in (1.0, 0.5))
    assert centre(half) == pytest.approx(0.5 * centre(full), rel=0.1)
    bed = Bed()
    bed.piece([Steady("wind", 1.0)], 10, 1.0, 1.0)
    normal = centre(bed.piece([Steady("wind", 1.0)], 2 * RATE, 1.0, 1.0)[:, 0])
    assert centre(bed.piece([Steady("wind", 1.0)], 2 * RATE, 1.0, 0.5)[:, 0]) < 0.7 * normal


def film_of(pace: float, seconds: float = 1.0, rate: int = 30, asked: int = 1):
    """The sound of a film of something that goes on, at ``pace``; asked so often a picture."""
    track = Soundtrack()
    ear = Ear(track)
    parts = []
    for picture in range(round(seconds * rate)):
        for part in range(asked):
            shown = (picture * asked + part) / (rate * asked)
            ear.follow(Hearing("bed", 0.5 + pace * shown, (), [Steady("rubble", 0.6)]), 1.0 / (rate * asked))
        parts.append(track.take((picture + 1) / rate))
    return np.concatenate(parts).astype(float)


def test_a_film_hears_what_goes_on_all_the_time():
    heard = film_of(1.0)
    windows = heard[: len(heard) // 20 * 20].reshape(20, -1)
    assert len(heard) == RATE and (np.abs(windows).max(axis=1) > 100.0).all()
    assert np.sqrt(np.mean(heard**2)) == pytest.approx(
        32767.0 * 0.6 * 0.8 * MASTER / 3.0 / np.sqrt(2.0), rel=0.3
    )


def test_two_frames_for_a_picture_are_not_heard_twice():
    once, twice = film_of(1.0), film_of(1.0, asked=2)
    assert np.sqrt(np.mean(twice**2)) == pytest.approx(np.sqrt(np.mean(once**2)), rel=0.1)


def test_slow_motion_of_a_film_is_lower_but_not_silent():
    """Over a whole turn of the loop, so that the same crackles are in both."""
    full, slow = film_of(1.0, LOOP_S), film_of(0.125, LOOP_S)
    assert np.sqrt(np.mean(slow**2)) > 0.5 * np.sqrt(np.mean(full**2))
    assert centre(slow[RATE:, 0]) < 0.7 * centre(full[RATE:, 0])


def test_no_crackle_comes_again_within_ten_seconds():
    """What is heard is like what was heard before by no more than chance; after a turn it is the same."""
    bed = Bed()
    bed.piece([Steady("flame", 1.0)], 10, 1.0, 1.0)
    heard = bed.piece([Steady("flame", 1.0)], 20 * RATE, 1.0, 1.0)[:, 0]
    loud = np.sqrt(np.mean(heard.reshape(-1, RATE // 50) ** 2, axis=1))  # of 20 ms

    def alike(seconds):
        away = round(seconds * 50.0)
        return float(np.corrcoef(loud[:-away], loud[away:])[0, 1])

    assert max(alike(s) for s in np.arange(1.0, 10.0, 0.02)) < 0.3 and alike(LOOP_S) > 0.99


def test_a_card_plays_a_loop_until_it_is_over(monkeypatch):
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    player = SoundPlayer(0.7)
    player.prepare()
    player._opening.join()
    assert player.ready

    def busy() -> int:
        return sum(pygame.mixer.Channel(k).get_busy() for k in range(pygame.mixer.get_num_channels()))

    for frame in range(3):
        player.follow(Hearing("fire", 1.0 + frame / 60.0, (), [Steady("flame", 0.5)]), 1.0 / 60.0)
    assert busy() == 1
    player.follow(Hearing("fire", 1.1, (), [Steady("flame", 0.5), Steady("wind", 0.3)]), 1.0 / 60.0)
    assert busy() == 2
    player.follow(None)
    player._loops.stop()
    player.close()

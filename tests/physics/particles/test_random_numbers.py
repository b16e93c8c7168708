"""Counter-based random numbers."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.particles.random_numbers import threefry, uniform_pair


@pytest.mark.parametrize(
    ("key", "counter", "words"),
    [
        # known answers of Random123 for Threefry-2x32 with 20 rounds
        ((0, 0), (0, 0), (0x6B200159, 0x99BA4EFE)),
        ((0xFFFFFFFF, 0xFFFFFFFF), (0xFFFFFFFF, 0xFFFFFFFF), (0x1CB996FC, 0xBB002BE7)),
        ((0x13198A2E, 0x03707344), (0x243F6A88, 0x85A308D3), (0xC4923A9C, 0x483DF7A0)),
    ],
)
def test_known_answers(key, counter, words):
    assert threefry(*key, *counter) == words


def test_plain_python_gives_the_same_words():
    plain = getattr(threefry, "py_func", threefry)
    for number in (0, 1, 2**31, 2**32 - 1, 2**40 + 7):
        assert plain(3, 5, number & 0xFFFFFFFF, number >> 32) == threefry(
            3, 5, number & 0xFFFFFFFF, number >> 32
        )


def test_uniform_within_four_standard_errors():
    n = 20_000
    draws = np.array([uniform_pair(7, 1, i) for i in range(n)])
    assert draws.min() > 0.0
    assert draws.max() < 1.0
    assert np.all(np.abs(draws.mean(axis=0) - 0.5) < 4.0 / np.sqrt(12.0 * n))
    assert abs(np.corrcoef(draws.T)[0, 1]) < 4.0 / np.sqrt(n)
    assert abs(np.corrcoef(draws[1:, 0], draws[:-1, 0])[0, 1]) < 4.0 / np.sqrt(n)
    counts = np.histogram(draws[:, 0], bins=64, range=(0, 1))[0]
    chi_square = np.sum((counts - n / 64) ** 2) / (n / 64)
    assert abs(chi_square - 63) < 4.0 * np.sqrt(2 * 63)


def test_another_seed_stream_or_index_is_another_number():
    seen = {uniform_pair(seed, stream, i) for seed in range(5) for stream in range(5) for i in range(40)}
    assert len(seen) == 1000

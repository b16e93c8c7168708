"""Is an array finite? By the bits of its numbers, and by numpy where bits do not serve."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.kernels.finite import finite_doubles, finite_singles, finite_test, finite_together

BAD = (math.inf, -math.inf, math.nan)


@pytest.mark.parametrize(
    ("test", "kind", "word"),
    [(finite_doubles, np.float64, np.uint64), (finite_singles, np.float32, np.uint32)],
)
def test_bits_say_what_isfinite_says(test, kind, word):
    limits = np.finfo(kind)
    numbers = np.array(
        [0.0, -0.0, 1.0, limits.max, -limits.max, limits.tiny, limits.smallest_subnormal], kind
    )
    assert test(numbers.view(word))
    for place in range(len(numbers)):
        for bad in BAD:
            wrong = numbers.copy()
            wrong[place] = bad
            assert not test(wrong.view(word))
    assert test(numbers[:0].view(word))


def test_several_at_once():
    good, bad = np.ones(5), np.array([1.0, math.nan])
    words = [array.view(np.uint64) for array in (good, good[:0], bad)]
    assert finite_together((words[0], words[1]))
    assert not finite_together((words[0], words[2]))


@pytest.mark.parametrize("kind", ["<f8", ">f8", "f4", "f2", "c16"])
def test_every_kind_of_float_has_a_test(kind):
    for array in (np.ones((3, 4), kind), np.ones((3, 8), kind)[:, ::2]):
        test, view = finite_test(array)
        assert test(view)
        array[1, 2] = math.inf
        assert not test(view), "the view shares the memory"


@pytest.mark.parametrize("array", [np.ones(3, int), np.ones(3, bool), np.array(["a"])])
def test_what_holds_no_floats_has_none(array):
    assert finite_test(array) is None

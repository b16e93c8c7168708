"""Words on a cloth: where they lie, how thick the brush is, where a match is held to each letter."""

from __future__ import annotations

import numpy as np
import pytest

from game.scenes.burning_cloth.letters import GAP, MOST, NARROW, TALL, WIDE, lettering

SHAPE, SIZE, STROKE = (60, 100), 0.02, 0.06


def test_a_stroke_is_in_the_middle_as_tall_and_thick_as_asked():
    """An I is one line from foot to head."""
    share, of, feet = lettering("I", SHAPE, SIZE, STROKE, tall=0.5)
    rows = np.flatnonzero(share.max(axis=1) > 0.5)
    assert rows.mean() == pytest.approx(29.5, abs=0.5)
    assert len(rows) * SIZE == pytest.approx(0.5 * 60 * SIZE + STROKE, abs=SIZE)
    thick = share[30].sum() * SIZE
    assert thick == pytest.approx(STROKE, rel=0.05)
    assert (share[30] * np.arange(100)).sum() / share[30].sum() == pytest.approx(49.5, abs=0.6)
    # a foot: m to the right and down from the upper left corner, at the lower end
    unit = 0.5 * 60 * SIZE / TALL
    assert feet.shape == (1, 2) and feet[0, 1] == pytest.approx(0.5 * (60 * SIZE + TALL * unit))
    assert feet[0, 0] == pytest.approx(50 * SIZE, abs=0.5 * unit * NARROW.get("I", WIDE))
    assert set(np.unique(of)) == {-1, 0} and np.array_equal(of == 0, share > 0.5)


def test_up_is_up_and_letters_are_named_from_the_left():
    share, of, feet = lettering("LT", SHAPE, SIZE, STROKE)
    left, right = share * (of == 0), share * (of == 1)
    half = len(share) // 2
    assert left[half:].sum() > 1.5 * left[:half].sum()  # an L has its bar at the foot, a T at the head
    assert right[:half].sum() > 1.5 * right[half:].sum()
    assert left.nonzero()[1].max() < right.nonzero()[1].max() and feet[0, 0] < feet[1, 0]
    columns = np.flatnonzero(share.max(axis=0) > 0.5)
    assert columns.mean() == pytest.approx(49.5, abs=3.0)


def test_long_words_are_as_wide_as_they_may_be_and_no_longer_than_the_most():
    for words in ("H" * 12, "H" * (MOST + 5)):
        share, _, feet = lettering(words, (60, 300), SIZE, STROKE, fills=0.8)
        columns = np.flatnonzero(share.max(axis=0) > 0.5)
        count = min(len(words), MOST)
        unit = (0.8 * 300 * SIZE - STROKE) / (count * NARROW.get("H", WIDE) + GAP * (count - 1))
        if unit < 0.6 * 60 * SIZE / TALL:
            assert len(columns) * SIZE <= 0.8 * 300 * SIZE + 2.0 * SIZE
        assert len(feet) == count
        assert np.diff(feet[:, 0]) == pytest.approx(np.full(count - 1, np.diff(feet[:, 0])[0]))


def test_without_a_sign_nothing_is_written():
    share, of, feet = lettering("  ", SHAPE, SIZE, STROKE)
    assert not share.any() and np.all(of == -1) and feet.shape == (0, 2)

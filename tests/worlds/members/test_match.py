"""A match that is led: where it is, when it burns, and how brightly."""

from __future__ import annotations

import math

import pytest

from game.physics.animation.keyframes import Keyframes
from game.worlds.members.match import FLARE_S, LedMatch, Way

KEYS = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.5), (1.0, 2.0, 1.0))


class Short(LedMatch):
    """Struck after 1 s, out after 3 s, away after 4 s."""

    long, rest, tilt, flares = 0.1, (0.0, 0.0, 0.0), 0.25 * math.pi, 0.5

    def way(self) -> Way:
        return Way(Keyframes((0.0, 2.0, 4.0), KEYS, "centripetal", geometry=(0, 1)), 1.0, 3.0, 4.0)


def test_it_burns_from_the_strike_until_it_is_shaken_out() -> None:
    match = Short()
    assert match.is_away(5.0) and not match.lit(5.0) and match.place(5.0)[0] == (0.0, 0.0)
    match.began = 5.0
    lit = [match.lit(5.0 + since) for since in (0.9, 1.1, 2.9, 3.1)]
    assert lit == [False, True, True, False]
    assert not match.is_away(8.9) and match.is_away(9.1)
    assert match.strength(5.9) == 0.0
    assert match.strength(6.0 + FLARE_S) == pytest.approx(1.0 + 0.5 / math.e)


def test_its_head_follows_the_curve_and_its_wood_the_angle() -> None:
    match = Short()
    match.began = 5.0
    head, end = match.place(7.0)
    assert head == pytest.approx((1.0, 0.0))
    assert end == pytest.approx((1.0 + 0.1 * math.cos(0.5), 0.1 * math.sin(0.5)))
    assert match.place(99.0)[0] == pytest.approx((1.0, 2.0))


def test_in_the_hand_it_burns_steadily_where_that_is() -> None:
    match = Short()
    match.held = (0.3, 0.4)
    head, end = match.place(0.0)
    assert head == (0.3, 0.4) and match.lit(0.0) and match.strength(0.0) == 1.0
    assert end == pytest.approx((0.3 + 0.1 * math.sqrt(0.5), 0.4 + 0.1 * math.sqrt(0.5)))

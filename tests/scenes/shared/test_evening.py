"""A short evening: a rack of each registered game but long snooker, by programs, without a fault."""

import pytest

from game.billiards.game.register import REGISTER
from tests.scenes.shared.evening import play_one

LONG = ("snooker", "six-red")  # of a hundred strokes and more; the whole evening plays them too


@pytest.mark.parametrize("name", [name for name in REGISTER if name not in LONG])
def test_a_rack_between_programs_comes_to_its_end(name):
    assert play_one(REGISTER[name], 1) > 0


@pytest.mark.parametrize("name", ["ten-ball", "balkline-47-2", "artistic"])
def test_so_does_one_with_a_program_that_has_a_pointer(name):
    assert play_one(REGISTER[name], 2) > 0

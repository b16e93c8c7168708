"""A short evening: a rack of each registered game but long snooker, by programs, without a fault."""

import pytest

from game.billiards.game.register import REGISTER
from tests.scenes.shared.evening import parser, play_one

LONG = ("snooker", "six-red")  # of a hundred strokes and more; the whole evening plays them too


def test_an_evening_says_what_it_may_be_asked_for(capsys):
    with pytest.raises(SystemExit) as end:
        parser().parse_args(["--help"])
    assert end.value.code == 0 and "racks" in capsys.readouterr().out
    asked = parser().parse_args(["12", "5"])
    assert (asked.racks, asked.seed) == (12, 5)
    assert vars(parser().parse_args([])) == {"racks": 200, "seed": 0}
    with pytest.raises(SystemExit) as end:
        parser().parse_args(["many"])
    assert end.value.code == 2


@pytest.mark.parametrize("name", [name for name in REGISTER if name not in LONG])
def test_a_rack_between_programs_comes_to_its_end(name):
    assert play_one(REGISTER[name], 1) > 0


@pytest.mark.parametrize("name", ["ten-ball", "balkline-47-2", "artistic"])
def test_so_does_one_with_a_program_that_has_a_pointer(name):
    assert play_one(REGISTER[name], 2) > 0

"""What players of the ladder say: who speaks of what, and that each has words of its own."""

import pytest

from game.billiards.game.register import REGISTER
from game.billiards.players.ladder import LADDER
from game.billiards.players.remarks import (
    CAUSES,
    FOUL,
    LONG_RUN,
    LOST,
    MISSED,
    OWN_RUN,
    REMARKS,
    RUN,
    WON,
    Happened,
    cause_of,
    remark_of,
)


@pytest.mark.parametrize(
    ("happened", "family", "cause"),
    [
        (Happened(0, True, False, 4, 3), "billiards", RUN),
        (Happened(0, True, False, 3, 2), "billiards", ""),
        (Happened(0, True, False, 5, 4), "billiards", ""),
        (Happened(0, True, False, 9, 7), "billiards", RUN),
        (Happened(1, True, False, 4, 3), "billiards", OWN_RUN),
        (Happened(0, True, False, 22, 15), "snooker", RUN),
        (Happened(0, True, False, 15, 8), "snooker", ""),
        (Happened(1, True, False, 3, 2), "carom", OWN_RUN),
        (Happened(0, False, True, 0, 3), "carom", FOUL),
        (Happened(1, False, True, 0, 3), "carom", ""),
        (Happened(0, True, True, 4, 3), "billiards", FOUL),
        (Happened(1, False, False, 0, 3), "billiards", MISSED),
        (Happened(1, False, False, 0, 3, safe=True), "billiards", ""),
        (Happened(0, False, False, 0, 3), "billiards", ""),
        (Happened(0, True, False, 8, 7, winner=0), "billiards", LOST),
        (Happened(0, False, True, 0, 7, winner=1), "billiards", WON),
    ],
)
def test_what_is_spoken_of(happened: Happened, family: str, cause: str):
    assert cause_of(happened, family) == cause


def test_each_of_the_ladder_has_short_words_of_its_own_for_everything():
    assert set(REMARKS) == {one.name for one in LADDER}
    everything = []
    for name, by_cause in REMARKS.items():
        assert set(by_cause) == set(CAUSES), name
        for words in by_cause.values():
            assert words and all(one[-1] in ".?!" and len(one) <= 44 for one in words)
            everything += words
    assert len(everything) == len(set(everything)), "nobody says what another says"
    assert set(LONG_RUN) == {entry.family for entry in REGISTER.values()}


def test_words_change_from_stroke_to_stroke_and_others_are_silent():
    assert remark_of("tom", MISSED, 0) != remark_of("tom", MISSED, 1) != remark_of("tom", MISSED, 2)
    assert remark_of("tom", MISSED, 3) == remark_of("tom", MISSED, 0)
    assert remark_of("novice", MISSED, 0) == "" == remark_of("tom", "", 0)

"""One's own hand, as a match has measured it, for the person's file."""

from __future__ import annotations

import math

import pytest

from game.app.screens.career_parts import hand_words
from game.app.stagehand.career_file import keep_career, read_career
from game.app.stagehand.career_keeper import CareerKeeper
from game.billiards.career.career import Career, Hand, Match, Player
from game.billiards.game.arrangement import Stroke
from game.billiards.map.hand import FEWEST
from game.scenes.shared.tables.minds.contest import hand_of
from game.stage.records.contested import Contested, HandMeasured

MEANT = Stroke(2.0, 1.0)


def test_the_hand_is_told_from_strokes_that_strayed():
    right = [(MEANT, MEANT._replace(azimuth=1.01, cue_speed=2.2))] * FEWEST
    left = [(MEANT, MEANT._replace(azimuth=0.99, cue_speed=1.8))] * FEWEST
    found = hand_of([*right, *left, (MEANT, MEANT)])
    assert found.azimuth == pytest.approx(0.01) and found.speed == pytest.approx(0.2)
    assert found.strokes == 2 * FEWEST
    assert hand_of([(MEANT, MEANT)] * 50) is None and hand_of(right[:-1]) is None


class Played:
    """A stage at which a match stands as it is told."""

    def __init__(self, hand, over=True):
        self.scene = self
        self.contest = Contested("eight-ball", "Mia", "tom", 0, (3, 1), over, over, 0, 9, hand)

    def stroke_measured(self):
        return None


def test_the_end_of_a_match_keeps_it_and_a_match_without_one_leaves_it(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    for hand in (HandMeasured(0.004, 0.1, 12), None):
        player = (read_career().player or Player("Mia")).replace(pending=Match("eight-ball", "tom"))
        keep_career(Career((player,)))
        keeper = CareerKeeper()
        keeper.update(Played(None, over=False))
        assert keeper.update(Played(hand)).complaint == ""
        assert read_career().player.hand == Hand(0.004, 0.1, 12)
    assert len(read_career().player.results) == 2
    assert hand_words(Hand(math.radians(0.25), 0.1, 12)) == "±0.25°, ±0.10 m/s, 12 strokes"

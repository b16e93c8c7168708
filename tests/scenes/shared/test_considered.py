"""Shots that a computer player considered: what is written beside them, and how strongly they are drawn."""

from __future__ import annotations

import pytest

from game.billiards import Table
from game.billiards.game.arrangement import Stroke
from game.billiards.search.finding import FoundShot
from game.scenes.shared.tables.sight import draw_considered

TABLE = Table.pool()
PLACES = ((0, 0.6, 0.6), (1, 0.4, 1.0), (2, 0.9, 1.4), (3, 0.3, 2.0))


class Sheet:
    """A canvas that keeps lines and labels."""

    def __init__(self) -> None:
        self.labels: list[tuple[tuple[float, float], str, float]] = []
        self.lines: list[tuple[tuple[float, float], float]] = []

    def line(self, start, end, color, width, dash=None, alpha=1.0):
        self.lines.append((tuple(start), alpha))

    def label(self, place, words, color, size, weight, offset, alpha):
        self.labels.append((place, words, alpha))


def shot(ball, chance, kind="direct", via=None, pocket=0):
    return FoundShot(Stroke(0.3, 2.0), ball, pocket, kind, via, chance, chance)


# the best first; two for ball 1, one by way of ball 3, and a safe stroke
SHOTS = (shot(1, 0.7), shot(2, 0.5), shot(1, 0.4, "bank"), shot(3, 0.3, "combination", via=2))
SAFE = shot(None, 0.0, "safety", pocket=None)


def drawn(shots, played):
    sheet = Sheet()
    draw_considered(sheet, shots, PLACES, TABLE, played)
    return sheet


def test_each_ball_bears_the_chance_of_its_best_shot():
    """Written last, so on top: the best of all."""
    said = [(words, alpha) for _, words, alpha in drawn(SHOTS, played=False).labels]
    assert said == [("combination 30 %", 0.7), ("direct 50 %", 0.7), ("direct 70 %", 1.0)]
    places = [place for place, _, _ in drawn(SHOTS, played=False).labels]
    assert places == [(0.3, 2.0), (0.9, 1.4), (0.4, 1.0)]


def test_while_a_shot_is_played_it_alone_is_named():
    assert [words for _, words, _ in drawn(SHOTS, played=True).labels] == ["direct 70 %"]


@pytest.mark.parametrize("played", [False, True])
def test_a_line_from_the_cue_ball_for_each_and_the_best_is_strongest(played):
    sheet = drawn((*SHOTS, SAFE), played)
    from_cue_ball = [alpha for start, alpha in sheet.lines if start == (0.6, 0.6)]
    assert len(from_cue_ball) == 5 and from_cue_ball[-1] > max(from_cue_ball[:-1])
    # to the pocket of each that has one, and from the ball in between to the ball
    assert len(sheet.lines) == 5 + 4 + 1


def test_nothing_without_a_cue_ball():
    sheet = Sheet()
    draw_considered(sheet, SHOTS, PLACES[1:], TABLE, False)
    assert not sheet.lines and not sheet.labels

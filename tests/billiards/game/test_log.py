"""The log of a game: strokes in their order, branches, racks, and the way back."""

import pytest

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import new_frame
from game.billiards.game.games import NineBall
from game.billiards.game.log import MOST_LOGGED, Log


def after(log: Log, frame, stroke: Stroke):
    """Log and frame after a stroke."""
    struck = frame.strike(stroke)
    played = struck.outcome()
    return log.with_stroke(struck.last, played), played.frame.with_cue_ball()


@pytest.fixture(scope="module")
def game():
    """A break and two strokes: the frames before each and after the last, and the log."""
    frame, log, frames = new_frame(NineBall(), seed=3), Log(), []
    for stroke in (Stroke(7.0, 1.58), Stroke(2.0, 0.4), Stroke(2.5, 2.0)):
        frames.append(frame)
        log, frame = after(log, frame, stroke)
    return log, [*frames, frame]


def test_each_stroke_stands_in_it_with_the_frame_before(game):
    log, frames = game
    assert [entry.number for entry in log.entries] == [1, 2, 3] and log.at == 3
    for entry, frame in zip(log.entries, frames, strict=False):
        assert entry.struck.frame.layout.places == frame.layout.places and not entry.branches
        again = entry.struck.frame.play(entry.struck.stroke, entry.struck.call)
        assert again.summary.balls_down == entry.down and tuple(again.verdict.words) == entry.words


def test_what_is_taken_back_stays_and_what_follows_is_a_branch(game):
    log, frames = game
    back = log.taken_back(2)
    assert back.at == 1 and len(back.entries) == 3
    branched, _ = after(back, frames[1], Stroke(1.0, 1.0))
    assert [entry.after for entry in branched.entries] == [0, 1, 2, 1]
    assert branched.entries[-1].branches and branched.at == 4
    assert log.taken_back(99).at == 0


def test_one_goes_back_to_a_stroke_and_on_to_where_one_was(game):
    log, frames = game
    back = log.gone_back(2, frames[3])
    assert back.at == 1 and back.left[1] == 3 and back.left[0].layout.places == frames[3].layout.places
    farther = back.gone_back(1, frames[1])
    assert farther.at == 0 and farther.left is back.left
    played, _ = after(farther, frames[0], Stroke(6.0, 1.5))
    assert played.left is back.left and played.entries[-1].after == 0 and played.entries[-1].number == 4
    assert (
        played.returned().at == 3 and played.returned().left is None and len(played.returned().entries) == 4
    )
    with pytest.raises(ValueError, match="no stroke 9"):
        log.gone_back(9, frames[3])


def test_racks_are_told_apart_by_their_breaks(game):
    log, _ = game
    assert [(one.rack, one.strokes, one.winner) for one in log.racks] == [(1, 3, "")]
    longer, _ = after(log, new_frame(NineBall(), seed=4), Stroke(7.0, 1.57))
    assert [(one.rack, one.strokes) for one in longer.racks] == [(1, 3), (2, 1)]


def test_of_very_many_the_oldest_are_given_up(game):
    log, _ = game
    entry = log.entries[-1]
    many = Log(tuple(log.entries) * (MOST_LOGGED // 3 + 2), 3)
    struck = entry.struck
    longer = many.with_stroke(struck, struck.frame.strike(struck.stroke).outcome())
    assert len(longer.entries) == MOST_LOGGED and longer.entries[-1].number == 4

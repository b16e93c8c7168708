"""Who thinks for a computer player: what failed is told until thinking succeeds."""

from __future__ import annotations

import time

from game.scenes.shared.thinker import Question, Thinker, Thought


def answer_to(thinker: Thinker, question: Question) -> Thought:
    end = time.monotonic() + 600.0
    while (thought := thinker.ask(question)) is None:
        assert time.monotonic() < end
        time.sleep(0.001)
    return thought


def think(question: Question) -> Thought:
    if question.frame is None:
        raise ValueError("no table")
    return Thought((), (question.frame,))


def test_a_failure_is_told_until_the_next_question():
    thinker = Thinker(think)
    assert answer_to(thinker, Question("a", None, "novice", 1)) == Thought(())
    assert thinker.failure == "ValueError: no table"
    assert answer_to(thinker, Question("b", 7, "novice", 1)) == Thought((), (7,))
    assert thinker.failure == ""

"""The grades of computer players, and how one of them thinks about a frame."""

from __future__ import annotations

from game.billiards.arrangement import Stroke
from game.scenes.billiards_opponent import Question, Thought
from game.scenes.demo_shots import choose_stroke
from game.stage import Decision

GRADES = ("beginner",)


def think(question: Question) -> Thought:
    """The decisions of a player of some grade."""
    frame = question.frame
    if frame.game.options:
        return Thought((Decision("option", (0.0,)),))
    return Thought((decision_of(simple_stroke(frame, question.seed)),))


def simple_stroke(frame, seed: int) -> Stroke:
    """The straightest open pot of a ball that counts, or a hit at the nearest ball; deterministic."""
    lie, wanted = frame.lie, set(frame.game.targets())
    import numpy as np

    in_play = np.array([number == 0 or number in wanted for number in lie.numbers])
    chosen = choose_stroke(
        lie.positions, lie.radii, in_play, frame.table, seed, 0 if frame.game.opening else 1
    )
    return Stroke(chosen.speed / 1.54, chosen.aim)


def decision_of(
    stroke: Stroke, ball: int = -1, pocket: int = -1, safety: bool = False, push: bool = False
) -> Decision:
    """A stroke as a decision."""
    return Decision("stroke", (*stroke, float(ball), float(pocket), float(safety), float(push)))

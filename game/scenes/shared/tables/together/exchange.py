"""Giving the last stroke away as a text, and taking that of another table, which proves itself first."""

from __future__ import annotations

from typing import Any

from game.scenes.shared.tables.course import AIMING
from game.scenes.shared.tables.together.stroke_text import StrokeText, packed_stroke, read_stroke
from game.stage import Decision

ELSEWHERE = "before: it was played from another position than this table's, or an option was chosen there"
OTHERWISE = "after: played here it comes to another end; the programs differ, or the text was changed"


class Exchange:
    """Of one table. Subclasses say how a stroke is told as decisions, and how it is tried out.

    scene: its name. course: with phase and model; the model has frame, played and word_of.
    """

    def __init__(self, scene: str, course: Any) -> None:
        self.scene = scene
        self.course = course

    # -- for subclasses -----------------------------------------------------------------------------

    def decision_of(self, struck: Any) -> Decision:
        """A stroke with what was announced. ValueError if it cannot be told."""
        raise NotImplementedError

    def tried(self, frame: Any, decision: Decision) -> Any:
        """What comes of a stroke from a frame. ValueError if it cannot be played."""
        raise NotImplementedError

    def put_down(self, frame: Any, place: tuple[float, float]) -> Any:
        """A frame with the cue ball in hand put at a place, m. ValueError if it may not lie there."""
        return frame.place_cue_ball(*place)

    def like_new(self, frame: Any) -> Any:
        """A frame without what earlier tries at the same position have left in it."""
        return frame

    # -- both ways ----------------------------------------------------------------------------------

    def given(self) -> str:
        """The last stroke as a text. ValueError if there is none."""
        frame = self.course.model.frame
        last, played = frame.last, self.course.model.played
        if last is None or played is None:
            raise ValueError("stroke: none has been played yet")
        before, steps = self.like_new(last.frame), []
        if getattr(before.game, "in_hand", ""):
            steps.append(("white", before.cue_ball))
        decision = self.decision_of(last)
        steps.append((decision.name, decision.values))
        after = played.frame if before is last.frame else self.tried(before, decision).frame
        stroke = StrokeText(self._word(before), self._word(after), tuple(steps))
        return packed_stroke(self.scene, stroke)

    def taken(self, text: str) -> tuple[Decision, ...]:
        """The decisions of a text, once the stroke has come to the same end here.

        ValueError, "field: reason" in one line: of what is wrong with it. Nothing of the table changes.
        """
        told = read_stroke(text, self.scene)
        if self.course.phase != AIMING:
            raise ValueError("table: wait until the balls lie still")
        frame, played = self.like_new(self.course.model.frame), None
        decisions = tuple(Decision(name, values) for name, values in told.steps)
        for decision in decisions:
            if played is not None:
                raise ValueError("steps: something follows the stroke")
            if decision.name == "white" and len(decision.values) == 2:
                frame = self._with_ball_in_hand(frame, (decision.values[0], decision.values[1]))
                continue
            if self._word(frame) != told.before:
                raise ValueError(ELSEWHERE)
            played = self.tried(frame, decision)
        if played is None:
            raise ValueError("steps: there is no stroke in it")
        if self._word(played.frame) != told.after:
            raise ValueError(OTHERWISE)
        return decisions

    def _with_ball_in_hand(self, frame: Any, place: tuple[float, float]) -> Any:
        try:
            return self.put_down(frame, place)
        except ValueError:
            raise ValueError(ELSEWHERE) from None

    def _word(self, frame: Any) -> str:
        """The word of a frame without what led to it."""
        word: str = self.course.model.word_of(frame.replace(last=None))
        return word

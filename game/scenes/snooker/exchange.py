"""A stroke of snooker that travels as a text."""

from __future__ import annotations

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame, Played, Struck
from game.billiards.game.rules import Call
from game.scenes.shared.tables.together.exchange import Exchange
from game.scenes.snooker.opponents import decision_of
from game.stage import Decision


class SnookerExchange(Exchange):
    """Strokes with the colour that is nominated."""

    def decision_of(self, struck: Struck) -> Decision:
        return decision_of(struck.stroke, struck.call)

    def tried(self, frame: Frame, decision: Decision) -> Played:
        if decision.name != "stroke" or len(decision.values) != 6:
            raise ValueError("steps: expected a stroke of six numbers")
        ball = None if decision.values[5] < 0.0 else int(decision.values[5])
        return frame.play(Stroke(*decision.values[:5]), Call(ball))

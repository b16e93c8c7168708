"""A stroke of carom that travels as a text."""

from __future__ import annotations

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromFrame, CaromPlayed, CaromStruck
from game.scenes.shared.tables.together.exchange import Exchange
from game.stage import Decision


class CaromExchange(Exchange):
    """Strokes without a safety."""

    def decision_of(self, struck: CaromStruck) -> Decision:
        if struck.safety:
            raise ValueError("stroke: a safety does not travel as a text")
        return Decision("play", (*struck.stroke,))

    def tried(self, frame: CaromFrame, decision: Decision) -> CaromPlayed:
        if decision.name != "play" or len(decision.values) != 5:
            raise ValueError("steps: expected a stroke of five numbers")
        return frame.play(Stroke(*decision.values))

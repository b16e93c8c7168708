"""A stroke of pool that travels as a text."""

from __future__ import annotations

import msgspec

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame, Played, Struck
from game.billiards.game.games import Drill
from game.billiards.game.rules import Call
from game.scenes.billiards.opponents.thinking import decision_of
from game.scenes.shared.tables.together.exchange import Exchange
from game.stage import Decision


class PoolExchange(Exchange):
    """Strokes with ball and pocket that are called."""

    def decision_of(self, struck: Struck) -> Decision:
        return decision_of(struck.stroke, struck.call)

    def like_new(self, frame: Frame) -> Frame:
        game = frame.game
        if not isinstance(game, Drill):
            return frame
        fresh = msgspec.structs.replace(game, attempts=0, made=0, streak=0, best=0)
        return Frame(fresh, frame.layout, frame.table, frame.physics)

    def tried(self, frame: Frame, decision: Decision) -> Played:
        if decision.name != "stroke" or len(decision.values) != 9:
            raise ValueError("steps: expected a stroke of nine numbers")
        ball, pocket = (None if value < 0.0 else int(value) for value in decision.values[5:7])
        call = Call(ball, pocket, bool(decision.values[7]), bool(decision.values[8]))
        return frame.play(Stroke(*decision.values[:5]), call)

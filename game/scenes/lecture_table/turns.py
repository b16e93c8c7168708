"""Turns on the lecture's table: whose cue it is, the cue ball's return, and play without a person."""

from __future__ import annotations

import math

from game.scenes.lecture_table.level import LectureTableContent
from game.scenes.lecture_table.model import LectureTableModel
from game.scenes.shared.tables.cue import AIMING, STRIKING, CueControl
from game.scenes.shared.tables.demo_shots import choose_stroke
from game.stage import Part
from game.stage.messages import Messages

TURN_ENDS_S = 0.4  # s of rest before the turn is over
NEXT_STROKE_S = 1.2  # s of rest before the table's own next stroke
NEW_RACK_S = 2.0  # s of rest on an empty table before the balls come back


class Turns(Part):
    """Two players with a cue each, or a table that plays itself. seed: of its own strokes."""

    def __init__(
        self, model: LectureTableModel, cue: CueControl, content: LectureTableContent, seed: int
    ) -> None:
        self.model = model
        self.cue = cue
        self.seed = seed
        self.stroke = content.stroke
        self.plays_itself = content.plays_itself
        self.player = 0
        self.down_before = 0
        self.rest_s = 0.0
        self.turn_open = False
        self.messages = Messages()

    def take_over(self) -> None:
        """A person takes the cue of a table that plays itself."""
        self.plays_itself = False
        self.messages.say("The cue is yours: pull back and let go.")

    def advance(self, dt: float) -> bool:
        """After a step: the turn ends, or the table strikes; True if it is time for a new rack."""
        if self.model.table.moving or self.cue.phase == STRIKING:
            self.rest_s = 0.0
            self.turn_open = True
            return False
        self.rest_s += dt
        if self.turn_open and self.rest_s > TURN_ENDS_S:
            self._end_turn()
        if self.down_before and self.down_before == len(self.model.numbers) - 1:
            return self.rest_s > NEW_RACK_S
        if self.model.cue_ball_ready and self.cue.phase == AIMING:
            self._play_by_itself()
        return False

    def _end_turn(self) -> None:
        """All balls have come to rest: the cue ball comes back, and who potted nothing passes the cue."""
        model = self.model
        self.turn_open = False
        down = model.balls_down
        if model.has_cue_ball and not model.table.state.in_play[0]:
            model.put_back_cue_ball()
            self.messages.say("The cue ball comes back to the head spot.")
            self.player = 1 - self.player
        elif down == self.down_before:
            self.player = 1 - self.player
        if down and down == len(model.numbers) - 1 and len(model.numbers) > 2:
            self.messages.say(f"The table is empty after {model.strokes} strokes.")
        self.down_before = down

    def _play_by_itself(self) -> None:
        """The stroke of the level, or strokes of the table's own."""
        model, table = self.model, self.model.table
        if self.stroke is not None:
            if self.rest_s >= self.stroke.after_s and model.strokes == 0:
                self.cue.strike(math.radians(self.stroke.angle_deg), self.stroke.speed)
        elif self.plays_itself and self.rest_s > NEXT_STROKE_S:
            chosen = choose_stroke(
                table.positions, table.state.radii, table.state.in_play, table.table, self.seed, model.strokes
            )
            self.cue.strike(chosen.aim, chosen.speed)

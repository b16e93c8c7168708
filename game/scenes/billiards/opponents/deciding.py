"""What players without a hand do: computer players decide, and the table plays by itself."""

from __future__ import annotations

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.players.ladder import POOL, ladder_of
from game.billiards.shot.cue import strike as struck_ball
from game.scenes.billiards.opponents.thinking import WARM_UPS, decision_of, simple_stroke, think
from game.scenes.billiards.play import AIMING, Play
from game.scenes.billiards.stroke.motion import PRACTISED
from game.scenes.shared.tables.choices import GRADES
from game.scenes.shared.tables.opponents import TableOpponents, check_option
from game.stage import Decision

NEW_RACK_S = 2.5


class Opponents(TableOpponents):
    """Computer players of pool, and the table by itself."""

    stays_s = NEW_RACK_S
    seed_bytes = 7

    def __init__(self, play: Play, seed: int) -> None:
        super().__init__(play, think, WARM_UPS, (*GRADES, *(one.name for one in ladder_of(POOL))))
        self._seed = seed

    def instead(self) -> list[Decision]:
        """A simple stroke."""
        frame = self.course.model.frame
        return [decision_of(simple_stroke(frame, frame.strokes))]

    def begin_again(self) -> None:
        """A new rack."""
        self.course.rack()

    def play_itself(self) -> None:
        """The first option, or a simple stroke of its own seed."""
        play, frame = self.course, self.course.model.frame
        if frame.game.options:
            play.take_option(0)
        elif frame.playable:
            play.begin_stroke(simple_stroke(frame, self._seed + frame.strokes), Call(), PRACTISED)

    def decide(self, event: Decision) -> None:
        """Let a decision act. ValueError for one that cannot be."""
        values, play = event.values, self.course
        if play.phase != AIMING:
            raise ValueError(f"{event.name}: nothing is to be decided now")
        if event.name == "stroke" and len(values) == 9:
            ball, pocket = (None if value < 0.0 else int(value) for value in values[5:7])
            call = Call(ball, pocket, bool(values[7]), bool(values[8]))
            stroke = Stroke(*values[:5])
            struck_ball(*stroke)  # refuses what no stroke can be
            play.begin_stroke(stroke, call, PRACTISED)
        elif event.name == "white" and len(values) == 2:  # so recordings name the cue ball
            play.model.move_cue_ball(*values)
        elif event.name == "option" and len(values) == 1:
            play.take_option(check_option(values[0], play.model.frame.game.options))
        else:
            raise ValueError(f"{event.name}: expected stroke, white or option, each with its numbers")

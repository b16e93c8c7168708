"""What players without a hand do: computer players decide, and the table plays by itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.billiards.game.arrangement import Stroke
from game.billiards.game.rules import Call
from game.billiards.shot.cue import strike as struck_ball
from game.scenes.billiards.opponents.thinking import WARM_UPS, decision_of, simple_stroke, think
from game.scenes.billiards.play import AIMING, PERSON, Play
from game.scenes.shared.thinker import Question, Thinker
from game.stage import Decision

if TYPE_CHECKING:
    from game.billiards.search.finding import FoundShot

NEXT_STROKE_S = 0.7  # s of rest before the next stroke of a computer player, or of the table itself
NEW_RACK_S = 2.5


class Opponents:
    """Who thinks for computer players, and what was considered last; no part of the state."""

    def __init__(self, play: Play, seed: int) -> None:
        self.play = play
        self.thinker = Thinker(think, *WARM_UPS)
        self.considered: tuple[FoundShot, ...] = ()
        self._seed = seed

    @property
    def question(self) -> Question:
        """What a computer player at turn is asked."""
        frame = self.play.model.frame
        key = (frame.strokes, self.play.model.word)
        seed = int.from_bytes(key[1].encode()[:7], "little")
        return Question(key, frame, self.play.grade_of(frame.game.turn), seed)

    def decisions(self, at_once: bool = False) -> list[Decision]:
        """What the computer player at turn has decided, if it is one and has. at_once: it does so now."""
        play = self.play
        game = play.model.frame.game
        if not at_once and any(play.grade_of(player) != PERSON for player in range(len(game.players))):
            self.thinker.prepare()
        computer = not play.person_plays and not play.plays_itself and not game.over
        if not computer or play.phase != AIMING or play.grip:
            self.thinker.forget()
            return []
        rested = play.rest_s > NEXT_STROKE_S
        if at_once:
            thought = self.thinker.answer(self.question) if rested else None
        else:
            thought = self.thinker.ask(self.question)
        if thought is None:
            return []
        self.considered = thought.considered
        if not rested:
            return []
        if not thought.decisions:  # it failed; the game goes on
            return [decision_of(simple_stroke(play.model.frame, play.model.frame.strokes))]
        return list(thought.decisions)

    def decide(self, event: Decision) -> None:
        """Let a decision act. ValueError for one that cannot be."""
        values, play = event.values, self.play
        if play.phase != AIMING:
            raise ValueError(f"{event.name}: nothing is to be decided now")
        if event.name == "stroke" and len(values) == 9:
            ball, pocket = (None if value < 0.0 else int(value) for value in values[5:7])
            call = Call(ball, pocket, bool(values[7]), bool(values[8]))
            stroke = Stroke(*values[:5])
            struck_ball(*stroke)  # refuses what no stroke can be
            play.begin_stroke(stroke, call, practised=True)
        elif event.name == "white" and len(values) == 2:  # so recordings name the cue ball
            play.model.move_cue_ball(*values)
        elif event.name == "option" and len(values) == 1:
            options = play.model.frame.game.options
            if not 0 <= int(values[0]) < len(options):
                raise ValueError(f"option {int(values[0])}: there are {len(options)}")
            play.take_option(int(values[0]))
        else:
            raise ValueError(f"{event.name}: expected stroke, white or option, each with its numbers")

    def play_on(self) -> None:
        """A new rack when one is over; and while the table plays itself its own strokes, the same for the
        same frame.
        """
        play = self.play
        frame = play.model.frame
        if play.phase != AIMING or not (play.plays_itself or play.plays_alone):
            return
        if frame.game.over:
            if play.rest_s > NEW_RACK_S:
                play.rack()
        elif play.plays_itself and play.rest_s > NEXT_STROKE_S:
            if frame.game.options:
                play.take_option(0)
            elif frame.playable:
                stroke = simple_stroke(frame, self._seed + frame.strokes)
                play.begin_stroke(stroke, Call(), practised=True)

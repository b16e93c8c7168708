"""What computer players decide at carom, and what the table plays by itself."""

from __future__ import annotations

from game.billiards.map.carom import GLANCE, whole_map
from game.billiards.players.carom import CAROM_GRADES, decide_carom, hand_of, position_of
from game.billiards.search.strokes import Noise
from game.scenes.carom.course import Course
from game.scenes.shared.tables.course import AIMING
from game.scenes.shared.thinker import Question, Thinker, Thought
from game.stage import Decision

NEXT_STROKE_S = 0.7  # s of rest before the next stroke of a computer player, or of the table itself
NEW_GAME_S = 3.0
HAND_SEED = 50_021


def think(question: Question) -> Thought:
    """The decision of a player of some grade, with what its hand makes of the stroke."""
    grade = CAROM_GRADES[question.grade]
    made = decide_carom(question.frame, grade)
    if made.stroke is None:
        names = [option.name for option in question.frame.game.options]
        return Thought((Decision("option", (float(names.index(made.option)),)),))
    stroke = hand_of(made.stroke, grade, question.seed + HAND_SEED)
    return Thought((Decision("play", tuple(stroke)),), made.choices)


class CaromOpponents:
    """Who thinks for computer players; no part of the state."""

    def __init__(self, course: Course) -> None:
        self.course = course
        self.thinker = Thinker(think)

    @property
    def question(self) -> Question:
        """What a computer player at turn is asked."""
        model = self.course.model
        key = (model.frame.strokes, model.word)
        seed = int.from_bytes(key[1].encode()[:6], "little")
        return Question(key, model.frame, self.course.grade_of(model.frame.game.turn), seed)

    def decisions(self, at_once: bool = False) -> list[Decision]:
        """What the computer player at turn has decided, if it is one and has. at_once: it does so now."""
        course = self.course
        computer = not course.person_plays and not course.plays_itself and not course.model.frame.game.ended
        if not computer or course.phase != AIMING or course.grip:
            self.thinker.forget()
            return []
        rested = course.rest_s > NEXT_STROKE_S
        if at_once:
            thought = self.thinker.answer(self.question) if rested else None
        else:
            thought = self.thinker.ask(self.question)
        return list(thought.decisions) if thought is not None and rested else []

    def play_on(self) -> None:
        """A new game when one is over and nobody is there; the table's own strokes while it plays itself."""
        course = self.course
        frame = course.model.frame
        if course.phase != AIMING or not (course.plays_itself or course.plays_alone):
            return
        if frame.game.ended:
            if course.rest_s > NEW_GAME_S:
                course.next_game()
        elif course.plays_itself and course.rest_s > NEXT_STROKE_S:
            if frame.game.options:
                course.take_option(1 if len(frame.game.options) > 1 else 0)
                return
            groups = whole_map(position_of(frame), Noise(), GLANCE).groups
            course.begin_stroke(groups[0].stroke if groups else course.stroke)

"""What computer players decide at carom, and what the table plays by itself."""

from __future__ import annotations

from game.billiards.map.carom import GLANCE, whole_map
from game.billiards.players.carom import CAROM_GRADES, decide_carom, hand_of, position_of
from game.billiards.search.strokes import Noise
from game.scenes.carom.course import Course
from game.scenes.shared.tables.opponents import TableOpponents
from game.scenes.shared.thinker import Question, Thought
from game.stage import Decision

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


class CaromOpponents(TableOpponents):
    """Computer players of carom, and the table by itself."""

    def __init__(self, course: Course) -> None:
        super().__init__(course, think)

    def begin_again(self) -> None:
        """The next game."""
        self.course.next_game()

    def play_itself(self) -> None:
        """The last option, or the best stroke at a glance."""
        course, frame = self.course, self.course.model.frame
        if frame.game.options:
            course.take_option(1 if len(frame.game.options) > 1 else 0)
            return
        groups = whole_map(position_of(frame), Noise(), GLANCE).groups
        course.begin_stroke(groups[0].stroke if groups else course.stroke)

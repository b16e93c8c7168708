"""What computer players decide at carom, and what the table plays by itself."""

from __future__ import annotations

from game.billiards.map.carom import GLANCE, whole_map
from game.billiards.players.carom import Choice, cushions_of, decide_carom, hand_of, position_of
from game.billiards.players.graded import carom_players
from game.billiards.search.strokes import Noise
from game.physics.kernels import elementary
from game.scenes.carom.course import Course
from game.scenes.shared.tables.minds.thoughts import Told, called, share
from game.scenes.shared.tables.opponents import TableOpponents
from game.scenes.shared.thinker import Question, Thought
from game.stage import Decision

HAND_SEED = 50_021


def think(question: Question) -> Thought:
    """The decision of a player of some grade, with what its hand makes of the stroke."""
    grade = carom_players()[question.grade]
    made = decide_carom(question.frame, grade)
    if made.stroke is None:
        names = [option.name for option in question.frame.game.options]
        return Thought((Decision("option", (float(names.index(made.option)),)),))
    stroke = hand_of(made.stroke, grade, question.seed + HAND_SEED)
    told = told_of_ways(called(question.grade, question.frame.game.shooter), made.choices)
    return Thought((Decision("play", tuple(stroke)),), made.choices, told)


def told_of_ways(player: str, choices: tuple[Choice, ...]) -> Told:
    """What a player thought: its way and chance, and the surest other one."""
    if not choices:
        return Told(f"{player} saw no way to score.", "The red ball had to be hit.", False)
    first, *others = choices
    left = f", then {share(first.left)}" if first.left > 0.0 else ""
    way = f"a way by {cushions_of(first.group.code)} cushions"
    chosen = f"{player} meant {way}: {share(first.group.chance)}{left}."
    if not others:
        return Told(chosen, "There was no other.")
    surest = max(others, key=lambda choice: choice.group.chance).group
    return Told(chosen, f"The best other by {cushions_of(surest.code)} cushions: {share(surest.chance)}.")


class CaromOpponents(TableOpponents):
    """Computer players of carom, and the table by itself."""

    def __init__(self, course: Course) -> None:
        super().__init__(course, think)

    def likely(self) -> tuple[tuple[float, float], float] | None:
        """The ball that is played, and the direction to the nearer of the others."""
        frame = self.course.model.frame
        x, y = place = frame.places[frame.game.cue]
        others = [at for ball, at in enumerate(frame.places) if ball != frame.game.cue]
        nearest = min(others, key=lambda at: elementary.hypot(at[0] - x, at[1] - y))
        return place, elementary.atan2(nearest[1] - y, nearest[0] - x)

    def begin_again(self) -> None:
        """The next game."""
        self.course.next_one()

    def play_itself(self) -> None:
        """The last option, or the best stroke at a glance."""
        course, frame = self.course, self.course.model.frame
        if frame.game.options:
            course.take_option(1 if len(frame.game.options) > 1 else 0)
            return
        groups = whole_map(position_of(frame), Noise(), GLANCE).groups
        course.begin_stroke(groups[0].stroke if groups else course.stroke)

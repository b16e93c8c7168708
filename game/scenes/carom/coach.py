"""The coach of the carom table."""

from __future__ import annotations

from collections.abc import Callable

from game.billiards.game.arrangement import Stroke
from game.billiards.game.carom_frame import CaromStruck
from game.billiards.map.carom import Group
from game.billiards.map.point_review import best_way, review_point
from game.billiards.map.words import route_words, tip_words
from game.billiards.players.carom import position_of
from game.billiards.table.carom import BALL_RADIUS
from game.scenes.carom.advisor import Advisor
from game.scenes.carom.course import Course
from game.scenes.shared.tables.beside.coach import Coach, Speech, Told, Way


class CaromCoach(Coach):
    """Knows the ways to score."""

    speech = Speech(
        "it scored", "put right alone, it scores", "nothing put right alone scores",
        ("no point was tried", "it was announced as a safety"), "it goes nowhere",
        ("no way to score in sight", "leave little"), "the chance of the surest way",
    )  # fmt: skip
    course: Course

    def __init__(self, course: Course, advisor: Advisor) -> None:
        super().__init__(course, BALL_RADIUS)
        self.advisor = advisor

    @property
    def hand_words(self) -> str:
        return str(self.course.parameters.odds)

    @property
    def key(self) -> object:
        return self.advisor.key

    def reviewing(self, meant: Stroke, struck: CaromStruck) -> Callable[[], Told]:
        frame, noise, ratio = self.course.model.frame, self.advisor.noise, self.course.ball_per_cue

        def work() -> Told:
            before = struck.frame
            left = best_way(position_of(frame), noise) if frame.playable else None
            told = Told(
                before.game.shooter, frame.game.shooter, bool(frame.game.ended),
                left=way_of(left, frame.game.cue, ratio),
            )  # fmt: skip
            if struck.safety:
                return told
            found = review_point(position_of(before), meant, struck.stroke, noise)
            cue = before.game.cue
            words = route_words(found.code, cue) if found.code else "aimed at no way that scores"
            return told._replace(
                tried=Way(found.chance, words), made=found.made, strayed=found.strayed, causes=found.causes,
                best=way_of(found.best, cue, ratio),
            )  # fmt: skip

        return work

    def best(self) -> Callable[[], Way | None]:
        frame, noise, ratio = self.course.model.frame, self.advisor.noise, self.course.ball_per_cue
        return lambda: way_of(best_way(position_of(frame), noise), frame.game.cue, ratio)


def way_of(group: Group | None, cue: int, ball_per_cue: float) -> Way | None:
    """A way of the map with its stroke; None for none."""
    if group is None:
        return None
    stroke = f"{ball_per_cue * group.stroke.cue_speed:.1f} m/s, {tip_words(group.stroke, brief=True)}"
    return Way(group.chance, route_words(group.code, cue), stroke)

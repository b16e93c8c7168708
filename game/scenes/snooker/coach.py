"""The coach of the snooker table."""

from __future__ import annotations

from collections.abc import Callable

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Struck
from game.billiards.game.rules import Call
from game.billiards.game.snooker.rules import Snooker
from game.billiards.map.pool import Pot
from game.billiards.map.review import best_pot, review
from game.billiards.map.words import tip_words
from game.billiards.search.legality import Legality
from game.billiards.table.snooker import BALL_RADIUS, name_of
from game.scenes.shared.tables.beside.coach import POCKETS, Coach, Speech, Told, Way
from game.scenes.shared.tables.odds import HAND
from game.scenes.snooker.course import BALL_PER_CUE, Course


class SnookerCoach(Coach):
    """Knows the map of pots, and what a nominated colour allows."""

    speech = Speech(key="G")
    course: Course

    def __init__(self, course: Course) -> None:
        super().__init__(course, BALL_RADIUS)

    @property
    def hand_words(self) -> str:
        return "a practised person's"

    @property
    def key(self) -> object:
        frame = self.course.model.frame
        return frame.layout.places, frame.conditions, frame.game

    def reviewing(self, meant: Stroke, struck: Struck) -> Callable[[], Told]:
        frame = self.course.model.frame

        def work() -> Told:
            before = struck.frame
            assert isinstance(before.game, Snooker)
            legality = legality_for(before.game, struck.call)
            found = review(before, meant, struck.stroke, struck.call, HAND, legality)
            tried = None
            if found.ball is not None and found.pocket is not None:
                tried = Way(found.chance, pot_words(found.ball, found.pocket))
            return Told(
                before.game.shooter, frame.game.shooter, frame.game.over, tried,
                f"the {name_of(found.ball)}" if found.ball is not None else "", found.made, found.foul,
                found.strayed, found.causes, way_of(found.best), way_of(best_pot(frame, HAND)),
            )  # fmt: skip

        return work

    def best(self) -> Callable[[], Way | None]:
        frame = self.course.model.frame
        return lambda: way_of(best_pot(frame, HAND))


def legality_for(game: Snooker, call: Call) -> Legality:
    """What is asked of a stroke: which balls may be met first, and which must not go down."""
    target = game.target(call)
    return Legality(target.first, tuple(ball for ball in game.on_table if ball not in target.score))


def pot_words(ball: int, pocket: int) -> str:
    """A pot: "the pink, upper left"."""
    return f"the {name_of(ball)}, {POCKETS[pocket]}"


def way_of(pot: Pot | None) -> Way | None:
    """A pot of the map with its stroke; None for none."""
    if pot is None:
        return None
    stroke = f"{BALL_PER_CUE * pot.stroke.cue_speed:.1f} m/s, {tip_words(pot.stroke, brief=True)}"
    return Way(pot.chance, pot_words(pot.ball, pot.pocket), stroke)

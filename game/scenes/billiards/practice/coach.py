"""The coach of the pool table."""

from __future__ import annotations

from collections.abc import Callable

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Struck
from game.billiards.map.pool import Pot
from game.billiards.map.review import best_pot, review
from game.billiards.map.words import tip_words
from game.billiards.table.rack import BALL_RADIUS
from game.scenes.billiards import layout
from game.scenes.billiards.beside import COACH
from game.scenes.billiards.play import Play
from game.scenes.billiards.practice.hands import hand_of
from game.scenes.billiards.stroke.motion import power_of
from game.scenes.shared.tables.beside.coach import Coach, Told, Way


class PoolCoach(Coach):
    """Knows the map of pots."""

    course: Play

    def __init__(self, play: Play) -> None:
        super().__init__(play, BALL_RADIUS)

    @property
    def shown(self) -> bool:
        return self.course.parameters.beside == COACH

    @property
    def hand_words(self) -> str:
        return hand_of(self.course).words

    @property
    def key(self) -> object:
        frame = self.course.model.frame
        return frame.layout.places, frame.conditions, hand_of(self.course).noise

    def reviewing(self, meant: Stroke, struck: Struck) -> Callable[[], Told]:
        frame, noise = self.course.model.frame, hand_of(self.course).noise

        def work() -> Told:
            before = struck.frame
            found = review(before, meant, struck.stroke, struck.call, noise)
            left, tried = best_pot(frame, noise), None
            if found.ball is not None and found.pocket is not None:
                tried = Way(found.chance, pot_words(found.ball, found.pocket))
            return Told(
                before.game.shooter, frame.game.shooter, frame.game.over, tried,
                f"the {found.ball}" if found.ball is not None else "", found.made, found.foul, found.strayed,
                found.causes, way_of(found.best), way_of(left),
            )  # fmt: skip

        return work

    def best(self) -> Callable[[], Way | None]:
        frame, noise = self.course.model.frame, hand_of(self.course).noise
        return lambda: way_of(best_pot(frame, noise))


def pot_words(ball: int, pocket: int) -> str:
    """A pot: "the 3, upper left"."""
    return f"the {ball}, {layout.POCKETS[pocket]}"


def way_of(pot: Pot | None) -> Way | None:
    """A pot of the map with its stroke; None for none."""
    if pot is None:
        return None
    stroke = f"{power_of(pot.stroke.cue_speed):.1f} m/s, {tip_words(pot.stroke, brief=True)}"
    return Way(pot.chance, pot_words(pot.ball, pot.pocket), stroke)

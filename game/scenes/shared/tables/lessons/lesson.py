"""A lesson of a level: one set-up, one stroke, a goal for each star; after every stroke the same again."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Annotated, NamedTuple

import msgspec

from game.billiards.game.arrangement import Stroke
from game.billiards.game.goals import Goal, Naming, balls_of, missed, stars_of
from game.billiards.game.rules import ShotSummary
from game.worlds.entries.entry import LevelEntry

Degrees = Annotated[float, msgspec.Meta(ge=-360.0, le=360.0)]
Offset = Annotated[float, msgspec.Meta(ge=-0.7, le=0.7)]
NEXT_LESSON = "O goes on to the next lesson."


class Solution(LevelEntry, frozen=True, kw_only=True):
    """A stroke that meets the goal of a puzzle: as `game.billiards.Stroke`, angles in degrees."""

    cue_speed: Annotated[float, msgspec.Meta(gt=0.0, le=20.0)]  # m/s
    azimuth_deg: Degrees
    elevation_deg: Annotated[float, msgspec.Meta(ge=0.0, le=85.0)] = 0.0
    tip_left: Offset = 0.0
    tip_up: Offset = 0.0

    def stroke(self) -> Stroke:
        """The same in rad."""
        return Stroke(
            self.cue_speed, math.radians(self.azimuth_deg), math.radians(self.elevation_deg),
            self.tip_left, self.tip_up,
        )  # fmt: skip


class Lesson(LevelEntry, frozen=True, kw_only=True):
    """What a level teaches. says: in a sentence; goal, more: of the first star and of the others; solution: a
    stroke that wins all of them.
    """

    says: Annotated[str, msgspec.Meta(min_length=1, max_length=120)]
    goal: Goal
    more: Annotated[list[Goal], msgspec.Meta(max_length=2)] = []
    solution: Solution | None = None

    @property
    def goals(self) -> tuple[Goal, ...]:
        """Of all stars, in their order."""
        return self.goal, *self.more


def check_goals(goals: Sequence[Goal], largest: int) -> None:
    """ValueError for a goal that speaks of a ball that the table has not. largest: number of a ball."""
    for goal in goals:
        if (number := max(balls_of(goal), default=0)) > largest:
            raise ValueError(f"goal: there is no ball {number}")


class Marks(NamedTuple):
    """What a stroke of a lesson was worth: its stars, and what is said of it."""

    stars: int
    words: tuple[str, ...]


def marks_of(lesson: Lesson, shot: ShotSummary, name: Naming) -> Marks:
    """What a stroke is worth. name: how balls are called at the table."""
    stars = stars_of(lesson.goals, shot)
    if not stars:
        return Marks(0, missed(lesson.goal, shot, name))
    words = [star_words(stars, len(lesson.goals))]
    if stars < len(lesson.goals):
        words += [f"For another star: {text}" for text in missed(lesson.goals[stars], shot, name)]
    return Marks(stars, tuple(words))


def star_words(stars: int, most: int) -> str:
    """Full and empty stars."""
    return "★" * stars + "☆" * (most - stars)


class Learning:
    """How a lesson goes at a table with a `CueCourse`. lesson: None at a table without; shot: what the
    referee saw of the last stroke; name: how balls are called. best: most stars so far; to_next: the next
    lesson is wanted.
    """

    def __init__(self, lesson: Lesson | None, shot: Callable[[], ShotSummary | None], name: Naming) -> None:
        self.lesson = lesson
        self.best = 0
        self.to_next = False
        self._shot = shot
        self._name = name

    @property
    def stars(self) -> tuple[int, int] | None:
        """Most stars so far, and how many there are; None without a lesson."""
        return None if self.lesson is None else (self.best, len(self.lesson.goals))

    def judged(self) -> tuple[str, ...]:
        """What is said of the stroke that has ended; its stars count. ValueError without a lesson."""
        if self.lesson is None:
            raise ValueError("lesson: there is none")
        shot = self._shot()
        if shot is None:
            return ()
        marks = marks_of(self.lesson, shot, self._name)
        self.best = max(self.best, marks.stars)
        return (*marks.words, NEXT_LESSON) if self.best else marks.words

    def go_on(self) -> None:
        """The next lesson is wanted."""
        self.to_next = self.lesson is not None

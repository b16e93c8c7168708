"""The eye on a story's moments and expectations: what has come true at which step, and since when."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

from game.stage.declarations import Readout
from game.stage.script.course import SLACK_S, Course
from game.stage.script.entries import Found, Reached, Turned
from game.stage.script.lines import Expect, Moment, Say, Story
from game.stage.script.readouts import filled, parse_condition, thresholds_in

if TYPE_CHECKING:
    from game.stage.stage import Stage


class MomentWatch:
    """Looks at the readouts for a story, and notes in its course what they say."""

    def __init__(self, story: Story, stage: Stage, course: Course) -> None:
        self.story, self.stage, self.course = story, stage, course
        self._conditions = {
            i: tuple(parse_condition(words) for words in line.conditions)
            for i, line in enumerate(story.lines)
            if isinstance(line, Moment)
        }
        self._names = {i: line.moment for i, line in enumerate(story.lines) if isinstance(line, Moment)}
        self._readouts: dict[str, Readout] | None = None  # of the present step

    def forget_readouts(self) -> None:
        """Another step has come."""
        self._readouts = None

    @property
    def _film_s(self) -> float:
        return self.course.film_s(self.stage.time_s)

    def measured(self) -> dict[str, Readout]:
        """The readouts of the present step, by their names."""
        if self._readouts is None:
            self._readouts = {readout.name: readout for readout in self.stage.scene.readouts()}
        return self._readouts

    def look(self) -> None:
        """Note which conditions have come true, or are so no more, since the last look.

        All moments to come are watched, also those whose line is still waiting for its turn: so it is known
        how long one has been true.
        """
        course, stage = self.course, self.stage
        for number, conditions in self._conditions.items():
            if self._names[number] in course.reached:
                continue
            true = all(condition.holds(self.measured()) for condition in conditions)
            if true != (number in course.true):
                course.add(Turned(stage.step_number, stage.time_s, self._film_s, number, true))

    def reach(self) -> bool:
        """Note the moments that have come, or that will not come any more; True if there is one."""
        course, noted = self.course, False
        for number in course.awaited:
            line, begun = self.story.lines[number], course.begun[number]
            assert isinstance(line, Moment)
            come = number in course.true
            if come or self.stage.time_s > begun.time_s + line.deadline + SLACK_S:
                self._reach(number, come)
                noted = True
        return noted

    def overtaking(self) -> tuple[int | None, list[int]]:
        """The next moment, if its condition is true and it may come before its turn; the lines before it."""
        course = self.course
        number = next((i for i in self._conditions if i not in course.begun), None)
        between = course.overtaken(number) if number is not None and number in course.true else None
        return (None, []) if between is None else (number, between)

    def _reach(self, number: int, come: bool) -> None:
        stage, course, story = self.stage, self.course, self.story
        film_s, since_s = self._film_s, course.since.get(number, stage.time_s) if come else math.nan
        told = [i for i in story.first_words(number) if i not in course.begun]
        values = self.measured()
        words = {i: line.say for i in told if isinstance(line := story.lines[i], Say)}
        typed = (
            [thresholds_in(text, self._conditions[number], values) for text in words.values()] if come else []
        )
        entry = Reached(stage.step_number, stage.time_s, film_s, number, not come, since_s)
        texts = {i: filled(text, values.values()) for i, text in words.items()}
        course.add(entry._replace(texts=texts, typed=tuple(itertools.chain(*typed))))
        held = course.hold_for(told[0], stage.time_s, film_s, since_s) if come and told else None
        if held is not None:
            course.add(held._replace(step=stage.step_number))

    def measure(self) -> None:
        """Look at the expectations whose time it is."""
        ends = self._film_s >= self.course.end_s - SLACK_S
        for i, one in enumerate(self.story.expectations):
            if i in self.course.found:
                continue
            due = ends or self._is_due(one)
            if not due and one.by is None:
                continue
            readout = self.measured().get(one.expect)
            value = readout.value if readout is not None else math.nan
            if due or one.holds(value):
                stage = self.stage
                self.course.add(Found(stage.step_number, stage.time_s, i, value, one.holds(value)))

    def _is_due(self, one: Expect) -> bool:
        when = one.by if one.at is None else one.at
        if when is None:
            return False
        if isinstance(when, str):
            return when in self.course.reached
        return self.stage.time_s >= when - SLACK_S

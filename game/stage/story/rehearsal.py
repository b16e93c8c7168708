"""The first run of a story, headless: its moments, its length, and whether what it expects is so."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import msgspec

from game.stage.script.course import LATE_S
from game.stage.script.lines import Expect, Moment, Say, Story
from game.stage.story.runner import Runner

if TYPE_CHECKING:
    from game.stage.scene import Scene
    from game.stage.stage import Stage

MOST_S = 1800.0  # s of simulated time that a story may take
MOST_IDLE_S = 8.0  # s of film without a moment, words or another place of the camera
PART_S = 0.25  # s between looks whether it has ended
BEGINNING = "Beginning"


class MomentTime(msgspec.Struct, frozen=True):
    """When a moment came. missed: its deadline came before it.

    late_s: since its condition was true, s simulated. said_late_s: from then to its
    first words, s simulated; None if there are none. typed: readouts that these words only repeat.
    """

    name: str
    chapter: str
    step: int
    time_s: float
    film_s: float
    missed: bool = False
    late_s: float = 0.0
    said_late_s: float | None = None
    typed: tuple[str, ...] = ()

    @property
    def failures(self) -> list[str]:
        """What is wrong with it, in words."""
        if self.missed:
            return [f"the moment {self.name!r} was not reached by {self.time_s:.2f} s"]
        found = []
        if self.late_s > LATE_S:
            found.append(f"the moment {self.name!r} is {self.late_s:.2f} s late: it was so before its turn")
        elif self.said_late_s is not None and self.said_late_s > LATE_S:
            found.append(f"the words of {self.name!r} come {self.said_late_s:.2f} s after it")
        if self.typed:
            found.append(f"the words of {self.name!r} repeat what it waited for: {', '.join(self.typed)}")
        return found


class Outcome(msgspec.Struct, frozen=True):
    """What an expectation came to; value None: it was not measured."""

    expect: str
    range: str
    when: str
    value: float | None
    time_s: float | None
    holds: bool


class Rehearsal(msgspec.Struct, frozen=True):
    """What a whole run has found. film_s, time_s: length of the film, and of simulated time, s."""

    story: str
    title: str
    steps: int
    time_s: float
    film_s: float
    digest: str
    moments: tuple[MomentTime, ...]
    expectations: tuple[Outcome, ...]
    ended: bool
    paces: tuple[tuple[float, float, float], ...] = ((0.0, 0.0, 1.0),)  # see `Course.paces`
    dropped: tuple[str, ...] = ()  # words that were over before they could be said
    idle: tuple[
        tuple[float, float], ...
    ] = ()  # from, to, s of film: longer than `MOST_IDLE_S` without anything new to read

    @property
    def failures(self) -> list[str]:
        """What is not as the story says, a line each."""
        found = [] if self.ended else [f"{self.story}: it has not ended after {self.time_s:.0f} s"]
        found += [f"{self.story}: {words}" for one in self.moments for words in one.failures]
        for one in self.expectations:
            if not one.holds:
                value = "is not measured" if one.value is None else f"is {one.value:.6g}"
                found.append(f"{self.story}: {one.expect} {value} {one.when}; expected {one.range}")
        return found

    @property
    def chapters(self) -> tuple[MomentTime, ...]:
        """All chapters in the order of the film; the first is its beginning."""
        first = MomentTime("", BEGINNING, 0, 0.0, 0.0)
        begun = [one for one in self.moments if one.chapter]
        return (first, *sorted(begun, key=lambda one: one.step))


def stage_of(story: Story, scene_type: type[Scene], **more: Any) -> Stage:
    """A stage at the beginning of a story. Raises as `Stage` does."""
    from game.stage.stage import Stage

    return Stage(scene_type, level=story.level, **more)


def rehearse(
    story: Story,
    scene_type: type[Scene],
    *,
    stage: Stage | None = None,
    progress: Callable[[float], object] | None = None,
) -> Rehearsal:
    """Run a story to its end as fast as it goes; ``progress`` is told s of film and may return False.

    ``stage``: one that stands at its beginning, to be looked at afterwards.
    """
    stage = (
        stage_of(story, scene_type, record=False, snapshot_bytes=0, charts=False) if stage is None else stage
    )
    runner = Runner(story, stage, looks=False)
    while not runner.finished and stage.fault is None and stage.time_s < MOST_S:
        if not stage.run(max(1, round(PART_S / stage.dt))):
            break
        if progress is not None and progress(runner.film_s) is False:
            break
    return result_of(runner)


def result_of(runner: Runner) -> Rehearsal:
    """What a run has found so far."""
    course, stage, story = runner.course, runner.stage, runner.story
    runner.conclude()
    ended = stage.fault is None and runner.stopped_at is None and runner.finished
    return Rehearsal(
        story=story.name,
        title=story.title,
        steps=stage.step_number,
        time_s=stage.time_s,
        film_s=min(runner.film_s, course.end_s),
        digest=stage.digest(),
        moments=tuple(moments_of(runner)),
        expectations=tuple(_outcome(runner, i) for i in range(len(story.expectations))),
        ended=ended,
        paces=course.paces(),
        idle=tuple((a, b) for a, b in itertools.pairwise(course.news()) if MOST_IDLE_S < b - a < math.inf),
        dropped=tuple(line.say for i in course.dropped if isinstance(line := story.lines[i], Say)),
    )


def moments_of(runner: Runner) -> list[MomentTime]:
    """The moments so far, as they came."""
    found = []
    for name, reached in runner.course.reached.items():
        line = runner.story.lines[reached.line]
        assert isinstance(line, Moment)
        since_s = reached.time_s if reached.missed else reached.since_s
        said_s = [begun.time_s for i in reached.texts if (begun := runner.course.begun.get(i)) is not None]
        found.append(
            MomentTime(
                name,
                line.heading,
                reached.step,
                reached.time_s,
                reached.film_s,
                reached.missed,
                reached.time_s - since_s,
                max(said_s) - since_s if said_s else None,
                reached.typed,
            )
        )
    return found


def _outcome(runner: Runner, number: int) -> Outcome:
    one, found = runner.story.expectations[number], runner.course.found.get(number)
    value = found.value if found is not None and math.isfinite(found.value) else None
    return Outcome(
        expect=one.expect,
        range=one.range,
        when=_when(one),
        value=value,
        time_s=found.time_s if found is not None else None,
        holds=found is not None and found.holds,
    )


def _when(one: Expect) -> str:
    when, word = (one.by, "by") if one.at is None else (one.at, "at")
    if when is None:
        return "at the end"
    return f"{word} {when!r}" if isinstance(when, str) else f"{word} {when:g} s"

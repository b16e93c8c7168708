"""Every story of every scene: it ends, what it says is so, its words can be read, its camera keeps up."""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np
import pygame
import pytest

from game.app.stagehand.headless import prepare
from game.app.stagehand.story_picture import covered, hidden, point_camera
from game.app.stagehand.view import StageView
from game.scenes import CATALOGUE
from game.stage import Action, ParameterError, Pointer, Recording, Stage, replay_scene
from game.stage.script.course import READING, Caption
from game.stage.script.deeds import events_of
from game.stage.script.lines import Moment, Slow, Story
from game.stage.story.reading import stories_of
from game.stage.story.rehearsal import MOST_IDLE_S, Rehearsal, result_of, stage_of
from game.stage.story.runner import Runner
from game.ui.look.look import Look
from game.ui.look.theme import theme_named

LEAST_S = 60.0
SLOW_MOTION, SIMULATED = 0.1, 0.2  # pace of a story of slow motion; share of its minute that it simulates
MARKED_EVERY_S, MARKED_PX = 9.0, 60
LOOK_EVERY_S = 0.1
SMALL, OTHER = (64, 36), 20  # px of pictures that are compared; of 255, by which a colour is another one
LARGE_CHANGE = 0.1  # of the picture, within a second
REPLAYED_S = 12.0  # of a story: the rest is made twice in pieces, after each take-over
TAKE_OVERS, BETWEEN_S, AFTER_S = 20, (0.5, 5.0), 0.25  # at least; s from one to the next, s that each lasts
CHANGED_S = 1.0  # after which one thing changed has changed the state

pytestmark = pytest.mark.compiled


class Performance(NamedTuple):
    """A story played to its end, and what was seen of it on the way.

    Now and then somebody takes over and gives it back, by which the steps from the last kept state to there
    are made once more and have to come to the same digest. The recording knows nothing of that, so a replay
    of how it began shows whether it went on as if nobody had.
    """

    story: Story
    stage: Stage
    runner: Runner
    found: Rehearsal
    off_middle: list[tuple[float, float]]  # s of film; the target's distance from the middle over its limit
    outside: list[float]  # s of film at which the view had no finite place
    taken_over: int
    harmed: list[str]  # what a take-over has broken, or changed for good
    beginning: Recording  # the first sixth or so
    changed: list[bool]  # by what the story offers at its end
    marked: list[tuple[float, int]]  # s of film; pixels that marks change there
    hidden: list[str]  # what keeps the subject of a moment from being seen well as it comes
    covered: dict[str, float]  # what lay over it as long as words stood, and when first, s of film
    moved: list[tuple[float, float]]  # s of film; share of the picture that has changed since a second before


def _stories() -> list[tuple[str, str]]:
    return [(entry.name, one.name) for entry in CATALOGUE for one in stories_of(entry.load())]


def simulated_of(story: Story) -> float:
    """The share of its minute that a story has to simulate: less where it is told in slow motion."""
    slowest = min((line.slow for line in story.lines if isinstance(line, Slow)), default=1.0)
    return SIMULATED if slowest <= SLOW_MOTION else 1.0


@pytest.fixture(scope="module", params=_stories(), ids="/".join)
def played(request: pytest.FixtureRequest) -> Performance:
    scene_type = CATALOGUE[request.param[0]].load()
    story = next(one for one in stories_of(scene_type) if one.name == request.param[1])
    prepare()
    stage = stage_of(story, scene_type, charts=False)
    runner = Runner(story, stage)
    off, outside, harmed, eye = [], [], [], Eye(runner)
    every = max(1, round(LOOK_EVERY_S / stage.dt))
    random, taken_over, next_s = np.random.default_rng(18), 0, 1.0
    beginning = stage.recording
    marked, next_look_s, changed = [], MARKED_EVERY_S, []
    while not runner.finished and stage.fault is None and stage.time_s < 600.0:
        stage.run(every)
        eye.look()
        if stage.time_s >= next_s and not runner.finished:
            harmed += _take_over(runner, random)
            between_s = simulated_of(story) * float(random.uniform(*BETWEEN_S))
            taken_over, next_s = taken_over + 1, stage.time_s + between_s
        if stage.time_s >= REPLAYED_S and beginning.steps == 0:
            beginning = stage.recording
        what_if = story.what_if
        if what_if is not None and not changed and what_if.at in runner.course.reached:
            changed.append(_try_what_if(runner))
        if stage.time_s >= next_look_s:
            marked.append((runner.film_s, _changed_by_marks(runner)))
            next_look_s += MARKED_EVERY_S
        view, target = runner.view(runner.shown_s), runner.target()
        if not all(map(math.isfinite, view)):
            outside.append(runner.shown_s)
        if target is not None and runner.arrived(runner.shown_s):
            reach = (0.3 * view.width, 0.16875 * view.width)
            across, up = reach[::-1] if runner.turned else reach
            share = max(abs(target[0] - view.x) / across, abs(target[1] - view.y) / up)
            off.append((runner.shown_s, share))
    found = result_of(runner)
    return Performance(
        story, stage, runner, found, off, outside, taken_over, harmed, beginning, changed, marked,
        eye.hidden, eye.covered, eye.moved,
    )  # fmt: skip


class Eye:
    """Looks at a story's picture: at each moment for its subject, once a second for what has changed."""

    def __init__(self, runner: Runner) -> None:
        self.runner, self.look_of = runner, Look(theme_named("dark"), 0.5)
        self.view = StageView(runner.stage, self.look_of)
        self.view.place(pygame.Rect(0, 0, 640, 360), self.look_of)
        self.view.show_marks(False)
        self.hidden: list[str] = []
        self.covered: dict[str, float] = {}
        self.moved: list[tuple[float, float]] = []
        self._seen: set[str] = set()
        self._picture: np.ndarray | None = None
        self._next_s = 0.0

    def look(self) -> None:
        """After some steps."""
        runner, shown_s = self.runner, self.runner.shown_s
        new = [name for name in runner.course.reached if name not in self._seen]
        point_camera(self.view, runner, shown_s)
        for words in covered(self.look_of, self.view, runner, shown_s):
            self.covered.setdefault(words, shown_s)
        if new:
            self._seen.update(new)
            self.hidden += [f"{new[-1]}: {why}" for why in hidden(self.look_of, self.view, runner, shown_s)]
        if shown_s >= self._next_s:
            self._next_s = shown_s + 1.0
            self._compare(shown_s)

    def _compare(self, shown_s: float) -> None:
        surface = pygame.Surface((640, 360), 0, 32)
        point_camera(self.view, self.runner, shown_s)
        self.view.draw(surface)
        small = pygame.surfarray.array3d(pygame.transform.smoothscale(surface, SMALL)).astype(int)
        if self._picture is not None:
            other = np.abs(small - self._picture).max(axis=2) > OTHER
            self.moved.append((shown_s, float(other.mean())))
        self._picture = small


def _changed_by_marks(runner: Runner) -> int:
    """How many pixels of the picture are others once marks are asked for."""
    look = Look(theme_named("dark"), 0.5)
    view = StageView(runner.stage, look)
    view.place(pygame.Rect(0, 0, 640, 360), look)
    point_camera(view, runner, runner.shown_s)
    pictures = []
    for asked in (False, True):
        surface = pygame.Surface((640, 360), 0, 32)
        view.show_marks(asked)
        view.draw(surface)
        pictures.append(pygame.surfarray.array3d(surface))
    return int(np.count_nonzero(np.any(pictures[0] != pictures[1], axis=2)))


def test_it_ends_and_lasts_a_minute(played: Performance) -> None:
    assert played.stage.fault is None and played.found.ended
    assert played.found.film_s >= LEAST_S and played.found.time_s >= simulated_of(played.story) * LEAST_S


def test_every_moment_comes_before_its_deadline(played: Performance) -> None:
    named = [line.moment for line in played.story.lines if isinstance(line, Moment)]
    assert sorted(one.name for one in played.found.moments) == sorted(named)
    assert [one.name for one in played.found.moments if one.missed] == []


def test_everything_that_is_expected_is_so(played: Performance) -> None:
    assert played.story.expectations
    assert played.found.failures == []


def test_captions_can_be_read_and_do_not_overlap(played: Performance) -> None:
    captions: list[Caption] = played.runner.course.captions()
    assert captions
    for one in captions:
        assert "–" not in one.text.split(), one  # a number that was not measured
        assert (one.ends - one.begins) * READING >= len(one.text) - 1e-6
    spans = [(one.begins, one.ends) for one in captions]
    spans += [(begins, ends) for _, begins, ends in played.runner.course.cards()]
    for (_, ends), (begins, _) in itertools.pairwise(sorted(spans)):
        assert begins >= ends - 1e-9


def test_no_words_are_dropped_for_want_of_time(played: Performance) -> None:
    assert played.found.dropped == ()


def test_the_camera_keeps_its_subject(played: Performance) -> None:
    assert played.outside == []
    assert [pair for pair in played.off_middle if pair[1] > 1.0 + 1e-9] == []


def test_marks_show_something(played: Performance) -> None:
    """With names at single things; not every moment has something to name, but most have."""
    shown = [pixels for _, pixels in played.marked if pixels >= MARKED_PX]
    assert len(shown) >= 0.6 * len(played.marked), played.marked


def test_what_a_moment_is_about_is_seen(played: Performance) -> None:
    """In the middle 60 %, larger than a twentieth of the picture's height, and under no words."""
    assert played.hidden == []


def test_no_words_ever_lie_over_what_is_to_be_seen(played: Performance) -> None:
    """Not only as its moment comes, but for as long as they stand."""
    assert played.covered == {}


def test_there_is_something_new_every_eight_seconds(played: Performance) -> None:
    """A moment, words, another place of the camera; or the picture itself changes."""
    for begins, ends in played.found.idle:
        changes = [at for at, share in played.moved if begins < at < ends and share >= LARGE_CHANGE]
        stretches = itertools.pairwise([begins, *changes, ends])
        assert max(b - a for a, b in stretches) <= MOST_IDLE_S, (begins, ends)


def test_chapters_lie_apart(played: Performance) -> None:
    begins = [one.film_s for one in played.found.chapters]
    assert len(begins) >= 4
    assert all(b - a >= 2.0 for a, b in itertools.pairwise(begins))


@pytest.mark.slow
def test_its_replay_is_equal(played: Performance) -> None:
    """Also to what it would have been had nobody taken over."""
    recording = played.beginning
    assert recording.steps * played.stage.dt >= REPLAYED_S
    assert replay_scene(recording, played.stage.scene_type).digest() == recording.digest


def test_whoever_takes_over_does_no_harm(played: Performance) -> None:
    assert played.harmed == []
    assert played.taken_over >= TAKE_OVERS


def test_it_says_what_if(played: Performance) -> None:
    """At a moment that comes, with one thing changed: a second after that the state is another one."""
    what_if = played.story.what_if
    assert what_if is not None and what_if.say.endswith("?")
    assert played.changed == [True]


def _try_what_if(runner: Runner) -> bool:
    """Whether the change that the story offers changes anything; the story is given back as it was."""
    stage, what_if = runner.stage, runner.story.what_if
    assert what_if is not None
    here = stage.step_number
    stage.run(round(CHANGED_S / stage.dt))
    plain = stage.digest()
    runner.return_to(here)
    runner.take_over()
    for event in events_of(what_if.do, (0.0, 0.0), (0.0, 0.0)):
        stage.post(event)
    stage.run(round(CHANGED_S / stage.dt))
    changed = stage.fault is None and stage.digest() != plain
    runner.return_to(here)
    return changed


def _take_over(runner: Runner, random: np.random.Generator) -> list[str]:
    """Poke the story for a moment and give it back; what was broken by it."""
    stage, wrong = runner.stage, []
    here, before = stage.step_number, stage.digest()
    runner.take_over()
    for event in _pokes(stage, random):
        try:
            stage.post(event)
        except ParameterError:  # refused in words, as a window would tell
            continue
    stage.run(round(AFTER_S / stage.dt))
    if stage.fault is not None:
        wrong.append(f"taken over at step {here}: {stage.fault}")
    runner.return_to(here)
    if stage.digest() != before:
        wrong.append(f"taken over at step {here}: given back in another state")
    return wrong


def _pokes(stage: Stage, random: np.random.Generator) -> list[Pointer | Action]:
    """A drag from a place to another, and one of the scene's actions."""
    frame = stage.scene.frame()
    targets = [*stage.scene.story_targets().values()]
    low, high = (frame.left, frame.bottom), (frame.right, frame.top)
    start = targets[int(random.integers(len(targets)))] if targets else random.uniform(low, high)
    end = random.uniform(low, high)
    pokes: list[Pointer | Action] = [
        Pointer("down", float(start[0]), float(start[1]), 1),
        Pointer("move", float(end[0]), float(end[1]), 1),
        Pointer("up", float(end[0]), float(end[1]), 1),
    ]
    actions = stage.scene_type.actions
    if actions:
        pokes.append(Action(actions[int(random.integers(len(actions)))].name))
    return pokes

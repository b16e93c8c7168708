"""Plays a story into a stage: before each step it looks which lines have their turn.

What it does depends on step and state alone, not on the clock on the wall: played in a window, into a film
or headless it is the same, event for event.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from game.physics.kernels import elementary
from game.stage.events import StageEvent
from game.stage.parameters import ParameterError
from game.stage.script.camera import AHEAD_S, Aim, CameraPath, View, kept_inside, view_of
from game.stage.script.course import SLACK_S, Course
from game.stage.script.deeds import RATE_HZ, begin_of, end_of, on_the_way
from game.stage.script.entries import Begun, Dropped, Ended
from game.stage.script.lines import WHOLE, Do, Follow, HandOver, Look, Moment, Say, Story, Title
from game.stage.script.readouts import filled
from game.stage.story.charts import ChartWatch
from game.stage.story.moments import MomentWatch
from game.stage.story.reading import check_names

if TYPE_CHECKING:
    from game.stage.stage import Stage

Point = tuple[float, float]


class StoryError(RuntimeError):
    """A story that cannot go on: the scene refuses what a line does; one line of words."""


class Runner:
    """One story on one stage that stands at its beginning. `Stage` calls it before each step.

    ``looks``: whether a camera is wanted. ``turned``: the picture's width is along the world's y.
    LevelError for names that the scene does not have.
    """

    def __init__(self, story: Story, stage: Stage, looks: bool = True) -> None:
        check_names(story, stage.scene)
        self.story = story
        self.stage = stage
        self.course = Course(story)
        self.stopped_at: int | None = None  # step at which somebody has taken over
        self._looks = looks
        self.turned = stage.scene_type.quarter_turns % 2 == 1
        self.watch = MomentWatch(story, stage, self.course)
        self.charts = ChartWatch(story, stage, self.course)
        self.restart()
        stage.cue = self

    # -- what Stage calls ---------------------------------------------------------------------------

    def restart(self) -> None:
        """The stage stands at step 0 again."""
        self.course.forget_after(-1)
        self.charts.restart()
        self.stopped_at = None
        self._own_events = 0  # that had acted when somebody took over
        self._own_done = -1
        self._done = -1  # the step that was dealt with last
        start = view_of(self.stage.scene.frame(), self.turned)
        self._aim = Aim("", start.x, start.y, start.log_width, 0.0, 0.0, start)
        self._aims: list[tuple[int, Aim]] = [(-1, self._aim)]
        self.path = CameraPath(start, self.turned)

    def before_step(self) -> None:
        """Do what is due at the present step; called again at the same step it does nothing."""
        self.follow()
        step = self.stage.step_number
        if step == self._done:
            return
        self._done = step
        self.watch.forget_readouts()
        regular = step % max(1, round(1.0 / (RATE_HZ * self.stage.dt))) == 0
        if regular and self.stopped_at is None:
            self._go_on()
        film_s = self.film_s
        if self._looks and film_s + SLACK_S >= self.path.next_s:
            self._lay_key(film_s)

    def conclude(self) -> None:
        """Look at what is expected at the end, where the end has come and no further step follows."""
        if self.stopped_at is None and self.finished:
            self.watch.forget_readouts()
            self.watch.measure()

    def follow(self) -> None:
        """Where the stage has gone back, forget what came after the step at which it stands."""
        step = self.stage.step_number
        if step >= self._done:
            return
        self.course.forget_after(step)
        self.charts.forget_after(step)
        self._aims = [(when, aim) for when, aim in self._aims if when <= step]
        self._aim = self._aims[-1][1]
        self.path.forget_after(step)
        self._done = step
        if self.stopped_at is not None and step < self.stopped_at:
            self.stopped_at = step
        if self.stopped_at is None:
            self.stage.forget_future()

    # -- how it stands ------------------------------------------------------------------------------

    @property
    def film_s(self) -> float:
        """The moment of the film at the present step, s."""
        return self.course.film_s(self.stage.time_s)

    @property
    def shown_s(self) -> float:
        """The moment of the film that the picture shows, between two steps, s."""
        behind = (1.0 - self.stage.alpha) * self.stage.dt / self.course.speed
        return max(self.film_s - behind, 0.0)

    @property
    def finished(self) -> bool:
        """Whether the end card has stood for as long as it is to, or somebody has taken over."""
        return self.stopped_at is not None or self.film_s >= self.course.end_s - SLACK_S

    @property
    def playing(self) -> bool:
        """Whether lines are still to come."""
        return self.stopped_at is None and not self.course.handed_over

    def take_over(self) -> None:
        """From here on the scene is somebody else's: no later line begins."""
        if self.stopped_at is None:
            self.stopped_at = self.stage.step_number
            self._own_events = self.stage.events_acted
            self._own_done = self._done

    def go_on(self) -> None:
        """Lines begin again, from where the stage stands."""
        self.stopped_at = None

    def return_to(self, step: int) -> None:
        """Back to a step of the story as it was, or to its beginning if that is out of reach, and go on.

        What somebody has done since is undone. ``step``: not after the one at which somebody took over.
        """
        stage, taken = self.stage, self.stopped_at
        if taken is not None and step > taken:
            raise ValueError(f"step {step}: the story was left at step {taken}")
        stage.return_to(
            step if step >= stage.first_step else 0, self._own_events if taken is not None else None
        )
        self.follow()
        if taken is not None:  # nothing was done at the steps since, nor at that one if it was not begun
            self._done = min(self._done, self._own_done)
            self.path.forget_after(self._done)
        self.go_on()

    def target(self) -> Point | None:
        """Where what the camera follows is now; None if it follows nothing."""
        return self.stage.scene.story_targets().get(self._aim.target) if self._aim.target else None

    def subject(self) -> str:
        """What has to be seen well now: the subject of the moment that came last; "" if it has none."""
        last = next(reversed(self.course.reached.values()), None)
        line = self.story.lines[last.line] if last is not None else None
        return line.subject if isinstance(line, Moment) else ""

    def view(self, shown_s: float) -> View:
        """What the picture of a moment of the film is to show: what is followed is in its middle 60 %."""
        view = self.path.at(shown_s)
        target = self.target()
        if target is None or not self.arrived(shown_s):
            return view
        return kept_inside(view, *target, self.turned)

    def arrived(self, shown_s: float) -> bool:
        """Whether the camera has come, at a moment of the film, to what it was told last."""
        return shown_s >= self._aim.begins + self._aim.ease

    # -- lines --------------------------------------------------------------------------------------

    def _go_on(self) -> None:
        for number, begun in list(self.course.under_way.items()):
            self._carry_on(number, begun)
        self.watch.look()
        while self.watch.reach() or self._overtake() or self._begin_one():
            pass
        if self.charts.waiting:
            self.charts.look(self.watch.measured())
        self.watch.measure()

    def _begin_one(self) -> bool:
        """Begin the first line that may; False if none may."""
        film_s = self.film_s
        due = next((i for i, from_s in self.course.waiting() if film_s >= from_s - SLACK_S), None)
        if due is None:
            return False
        self._begin(due)
        return True

    def _begin(self, number: int) -> None:
        stage, line = self.stage, self.story.lines[number]
        entry = Begun(stage.step_number, stage.time_s, self.film_s, number)
        if isinstance(line, Say):
            entry = entry._replace(text=self._said(number, line))
        elif isinstance(line, Do):
            place, to = self._place(line.do.place), self._place(line.do.to)
            start = (
                float(stage.scene.values[line.do.parameter]) if line.do.over and line.do.parameter else 0.0
            )
            entry = entry._replace(start=start, place=place, to=to)
        self.course.add(entry)
        if isinstance(line, (Look, Follow)):
            self._point(line, entry)
        elif isinstance(line, Do):
            self._post(number, begin_of(line.do, entry.place))
            if not line.do.over and line.do.to is not None:
                self._post(number, end_of(line.do, entry.to))

    def _overtake(self) -> bool:
        """Let a moment come whose condition is true before its turn: words that are late are dropped."""
        number, between = self.watch.overtaking()
        if number is None:
            return False
        for i in between:
            if isinstance(self.story.lines[i], (Say, Title)):
                self.course.add(Dropped(self.stage.step_number, self.film_s, i))
            else:
                self._begin(i)
        self._begin(number)
        return True

    def _said(self, number: int, line: Say) -> str:
        """A caption's words. The first ones of a moment have the numbers of the step at which it came."""
        before = self.course.reached.get(self.story.moment_before(number))
        if before is not None and number in before.texts:
            return before.texts[number]
        return filled(line.say, self.stage.scene.readouts())

    def _carry_on(self, number: int, begun: Begun) -> None:
        """Go on with a deed that takes time."""
        line = self.story.lines[number]
        assert isinstance(line, Do)
        share = (self.stage.time_s - begun.time_s) / line.do.over
        if share >= 1.0 - SLACK_S:
            self.course.add(Ended(self.stage.step_number, self.film_s, number))
            self._post(number, end_of(line.do, begun.to))
        else:
            self._post(number, [on_the_way(line.do, begun.start, begun.place, begun.to, share)])

    def _post(self, number: int, events: list[StageEvent]) -> None:
        for event in events:
            try:
                self.stage.post(event)
            except ParameterError as error:
                raise StoryError(f"line[{number}].do: {error}") from None

    def _place(self, place: Point | str | None) -> Point:
        if isinstance(place, str):
            frame = self.stage.scene.frame()
            middle = 0.5 * (frame.left + frame.right), 0.5 * (frame.bottom + frame.top)
            return middle if place == WHOLE else self.stage.scene.story_targets().get(place, middle)
        return place if place is not None else (0.0, 0.0)

    # -- camera -------------------------------------------------------------------------------------

    def _point(self, line: Look | Follow, begun: Begun) -> None:
        """The camera is told something else."""
        frame = self.stage.scene.frame()
        whole = view_of(frame, self.turned)
        target = line.follow if isinstance(line, Follow) else ""
        place = self._place(target or (line.look if isinstance(line, Look) else WHOLE))
        width: float | str | None = line.width
        if width is None and isinstance(line, Look) and line.look == WHOLE:
            width = WHOLE
        log_width = (
            self._aim.log_width if width is None
            else whole.log_width if isinstance(width, str) else elementary.log(width)
        )  # fmt: skip
        if line.cut:
            self.path.cut()
        ease = 0.0 if line.cut else line.ease
        self._aim = Aim(target, *place, log_width, begun.film_s, ease, self.path.last())
        self._aims.append((begun.step, self._aim))
        if line.cut and self._looks:
            self._lay_key(begun.film_s)

    def _lay_key(self, film_s: float) -> None:
        aim = self._aim
        place = self.stage.scene.story_targets().get(aim.target) if aim.target else (aim.x, aim.y)
        ahead = max(AHEAD_S, 2.0 * self.stage.dt / self.course.speed)
        self.path.lay(film_s, self.stage.step_number, aim, place or (aim.x, aim.y), ahead)


def last_words(story: Story) -> str:
    """What the end card says."""
    last = story.lines[-1]
    assert isinstance(last, HandOver)
    return last.hand_over

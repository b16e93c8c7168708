"""A story on a scene's screen: it plays, can be taken over at any moment, and gone on with."""

from __future__ import annotations

import pygame

from game.app.scene.in_play import InPlay
from game.app.scene.story.background import BackgroundRehearsal
from game.app.scene.story.filming import Filming
from game.app.scene.story.journey import Journey
from game.app.screens.host import Host
from game.app.stagehand.story_picture import draw_words, point_camera
from game.app.stagehand.view import StageView
from game.app.window.commands import Actions
from game.stage import Pointer, StageEvent
from game.stage.playing.paced import FASTEST, SLOWEST
from game.stage.script.deeds import events_of
from game.stage.script.lines import Do, Story
from game.stage.story.rehearsal import moments_of
from game.stage.story.runner import Runner
from game.ui.widgets.timebar import TimeBar, TimeBarState
from game.ui.widgets.wishes import Wish

GUESSED_S = 60.0  # a story lasts at least so long, while that is not known
ROOM = 1.15  # of what has passed is how long it is, if it has lasted longer


class StoryPlay:
    """Runner, camera and time bar of one story in the window."""

    def __init__(self, host: Host, record: InPlay, view: StageView, story: Story) -> None:
        self.host = host
        self.record = record
        self.view = view
        self.runner = record.runner = Runner(story, record.stage)
        self.bar = TimeBar(host.look)
        self.journey = Journey(self.runner, record)
        self.rehearsal = BackgroundRehearsal(story, record.stage.scene_type, host.background)
        self.filming = Filming(host, story)
        self.free = False  # the camera is in the viewer's hand
        self.view.teaching = False
        self._pace = 1.0
        self._led: tuple[float, float, float] | None = None  # where the camera was last put
        effects = [
            event for line in story.lines if isinstance(line, Do)
            for event in events_of(line.do, (0.0, 0.0), (0.0, 0.0))
        ]  # fmt: skip
        record.errands.work(lambda: record.variants.prepare(effects))

    @property
    def actions(self) -> Actions:
        """Commands that mean something else, or anything at all, where a story plays."""
        return {
            "reset": lambda: self.journey.to_step(0),
            "view": self.give_camera_back,
            "story": self.go_on if self.runner.stopped_at is not None else self.take_over,
            "marks": self.toggle_marks,
            "film": lambda: self.filming.ask(self.runner.film_s),
        }

    def picture_place(self, stage: pygame.Rect) -> pygame.Rect:
        """The stage lies here now; the part of it that the time bar leaves to the picture."""
        self.bar.place(stage, self.host.look)
        self._led = None
        return pygame.Rect(stage.x, stage.y, stage.w, max(stage.h - self.bar.rect.h, 1))

    def close(self) -> None:
        """The story is left."""
        self.rehearsal.stop()
        self.filming.close()
        if self.record.stage.cue is self.runner:
            self.record.stage.cue = None
        self.record.runner = None
        self.view.teaching = True

    # -- what comes in ------------------------------------------------------------------------------

    def handle(self, event: pygame.Event) -> bool:
        """An event for the time bar; True if it took it."""
        taken, wish = self.bar.handle(event)
        if wish is not None:
            self._fulfil(wish)
        return taken

    def _fulfil(self, wish: Wish) -> None:
        if wish.name == "seek":
            self.journey.to_film(float(wish.value), self.rehearsal.found)
        elif wish.name == "story-go-on":
            self.go_on()
        elif wish.name == "story-here":
            self.runner.go_on()
        elif wish.name == "story-camera":
            self.give_camera_back()
        elif wish.name == "story-take-over":
            self.take_over()

    def touched(self, event: StageEvent) -> bool:
        """An event of the viewer's is about to come in, by which the scene is the viewer's; False to drop it.

        A hand that only moves over the scene is no touch, and nothing that the scene is told of.
        """
        if not self.runner.playing:
            return True
        if isinstance(event, Pointer) and event.kind == "move" and not event.button:
            return False
        self.take_over()
        return True

    def take_over(self) -> None:
        """The scene is the viewer's from here on."""
        if self.runner.playing:
            self.runner.take_over()
            self._keep_pace()
            self.host.tell("The scene is yours.", f"{self.host.keys.label('story')} goes on with the story.")

    def go_on(self) -> None:
        """Back to the script, from the chapter in which somebody took over."""
        at = self.runner.stopped_at
        if at is None:
            return
        steps = [0, *(one.step for one in moments_of(self.runner) if one.step <= at)]
        self.journey.to_step(max(steps))
        self.give_camera_back()

    def give_camera_back(self) -> None:
        """The camera follows the story again."""
        self.free, self._led = False, None

    def toggle_marks(self) -> None:
        """Teaching marks over the picture, or not."""
        self.view.teaching = not self.view.teaching

    # -- time and picture ---------------------------------------------------------------------------

    def update(self, elapsed_s: float, inside: bool) -> None:
        """Let time pass; ``inside``: a thread is at work in the scene, which is not to be looked at."""
        if not inside:
            self.runner.follow()
            self._keep_pace()
            self._lead_camera()
        self.filming.update()
        self.bar.update(elapsed_s, self._bar_state())

    def _keep_pace(self) -> None:
        """The viewer's speed times that of the script."""
        pace = self.runner.course.speed if self.runner.stopped_at is None else 1.0
        if pace != self._pace:
            stage = self.record.stage
            stage.speed = min(max(stage.speed * pace / self._pace, SLOWEST), FASTEST)
            self._pace = pace

    def _lead_camera(self) -> None:
        """Look where the story says, unless the viewer has moved the picture."""
        camera = self.view.camera
        if self._led is not None and camera.wanted != self._led:
            self.free = True
        if self.free or not (self.runner.playing or not self.runner.finished):
            return
        point_camera(self.view, self.runner, self.runner.shown_s)
        self._led = camera.wanted

    def _bar_state(self) -> TimeBarState:
        runner, found = self.runner, self.rehearsal.found
        now_s = runner.film_s
        if found is not None:
            chapters = tuple((one.chapter, one.film_s) for one in found.chapters)
            length = found.film_s
        else:
            chapters = tuple((one.chapter, one.film_s) for one in moments_of(runner))
            length = max(GUESSED_S, ROOM * now_s)
        taken = runner.stopped_at is not None
        return TimeBarState(
            min(now_s, length), length, chapters, taken, runner.course.handed_over, self.journey.share,
            self.free and not runner.finished,
        )  # fmt: skip

    def draw_words(self, surface: pygame.Surface) -> None:
        """Captions and cards over the picture; none once somebody has taken over."""
        if self.runner.stopped_at is not None:
            return
        runner, name = self.runner, self.host.settings.name
        draw_words(surface, self.host.look, self.view, runner, runner.shown_s, name, leaves=True)

    def draw_bar(self, surface: pygame.Surface) -> None:
        """The time bar; it does not look into the scene."""
        self.bar.draw(surface)

"""A story on a scene's screen: it plays, can be taken over at any moment, and gone on with."""

from __future__ import annotations

import pygame

from game.app.scene.in_play import InPlay
from game.app.scene.story.background import BackgroundRehearsal
from game.app.scene.story.filming import Filming
from game.app.scene.story.journey import Journey
from game.app.scene.story.offers import AGAIN, NEXT, WHAT_IF, Offers
from game.app.scene.story.small_pictures import SmallPictures
from game.app.screens.host import Host
from game.app.stagehand.opening import Opening
from game.app.stagehand.story_picture import draw_words, point_camera
from game.app.stagehand.view import StageView
from game.app.window.commands import Actions
from game.stage import Pointer, StageEvent
from game.stage.catalogue import STORIES, Entry
from game.stage.playing.paced import FASTEST, SLOWEST
from game.stage.script.deeds import events_of
from game.stage.script.lines import Do, Story
from game.stage.story.rehearsal import moments_of
from game.stage.story.runner import Runner
from game.ui.widgets.list_row import ListRow
from game.ui.widgets.timebar import TimeBar, TimeBarState, clock
from game.ui.widgets.topbar import speed_text
from game.ui.widgets.wishes import Wish

SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0)
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
        self.pictures = SmallPictures()
        self.journey = Journey(self.runner, record)
        self.rehearsal = BackgroundRehearsal(story, record.stage.scene_type, host.background)
        self.filming = Filming(host, story)
        self.free = False  # the camera is in the viewer's hand
        self.view.show_marks(False)
        self.offers = Offers(host.look, self._offered())
        self._left = False  # the end card has been answered, or the scene was touched after it
        self._unseen = False  # the camera is to be put once where the story had it
        self._pace = 1.0
        self._led: tuple[float, float, float] | None = None  # where the camera was last put
        effects = [
            event for line in story.lines if isinstance(line, Do)
            for event in events_of(line.do, (0.0, 0.0), (0.0, 0.0))
        ]  # fmt: skip
        effects += self._changes()
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

    def tour_places(self) -> dict[str, pygame.Rect]:
        """Where the parts of the bar are that the tour of a story shows."""
        places = {spot.name: spot.rect for spot in self.bar.controls.spots}
        return {**places, "track": self.bar.track.inflate(0, self.bar.rect.h // 2)}

    def picture_place(self, stage: pygame.Rect) -> pygame.Rect:
        """The stage lies here now; the part of it that the time bar leaves to the picture."""
        self.bar.place(stage, self.host.look)
        self._led = None
        picture = pygame.Rect(stage.x, stage.y, stage.w, max(stage.h - self.bar.rect.h, 1))
        self.offers.place(picture, self.host.look)
        return picture

    def close(self) -> None:
        """The story is left."""
        self.journey.stop()
        self.rehearsal.stop()
        self.filming.close()
        if self.record.stage.cue is self.runner:
            self.record.stage.cue = None
        self.record.runner = None
        self.view.show_marks(False, otherwise=True)

    # -- what comes in ------------------------------------------------------------------------------

    def handle(self, event: pygame.Event) -> bool:
        """An event for the time bar, or for what the end offers; True if it was for one of them."""
        if self._stops_jump(event):
            return True
        over, offer = self.offers.handle(event)
        if offer:
            self._take_offer(offer)
        if over:
            return True
        taken, wish = self.bar.handle(event)
        if wish is not None:
            self._fulfil(wish)
        return taken

    def _stops_jump(self, event: pygame.Event) -> bool:
        """Whether an event is a click on picture or bar by which a jump ends where it has come to."""
        if event.type != pygame.MOUSEBUTTONDOWN or event.button > 3:
            return False
        here = self.view.rect.collidepoint(event.pos) or self.bar.rect.collidepoint(event.pos)
        return here and self.journey.stop()

    def _fulfil(self, wish: Wish) -> None:
        if wish.name == "seek":
            self._seek(float(wish.value))
        elif wish.name == "story-go-on":
            self.go_on()
        elif wish.name == "story-here":
            self.runner.go_on()
        elif wish.name == "story-camera":
            self.give_camera_back()
        elif wish.name == "story-take-over":
            self.take_over()
        elif wish.name == "story-chapters":
            self._offer_chapters()
        elif wish.name == "story-speed":
            self._offer_speeds()
        else:
            self.host.perform(wish.name)

    # -- what the end offers ------------------------------------------------------------------------

    def _offered(self) -> tuple[tuple[str, str], ...]:
        """The next story, what if, once more."""
        story, following = self.runner.story, self._following
        rows = [(NEXT, f"Next: {following.title}")] if following is not None else []
        rows += [(WHAT_IF, story.what_if.say)] if story.what_if is not None else []
        return (*rows, (AGAIN, "Once more"))

    @property
    def _following(self) -> Entry | None:
        """The story after this one in the menu."""
        return self.host.catalogue.after_in_category(self.runner.story.scene, STORIES)

    def _changes(self) -> list[StageEvent]:
        what_if = self.runner.story.what_if
        return [] if what_if is None else events_of(what_if.do, (0.0, 0.0), (0.0, 0.0))

    def _take_offer(self, name: str) -> None:
        following, what_if = self._following, self.runner.story.what_if
        self._left = True
        if name == NEXT and following is not None:
            self.host.open_scene(following.name, opening=Opening(story=""))
        elif name == WHAT_IF and what_if is not None:
            reached = self.runner.course.reached.get(what_if.at)
            self.host.tell(what_if.say, "It goes on from here without the script; the scene is yours.")
            self._unseen = True
            self.journey.to_change(reached.step if reached is not None else 0, self._changes())
        else:
            self.journey.to_step(0)

    # -- chapters and speed -------------------------------------------------------------------------

    def _offer_chapters(self) -> None:
        """Those that are known, by name; one is gone to."""
        rows = [ListRow(title, clock(begins), value=begins) for title, begins in self.bar.state.chapters]
        before = [begins for _, begins in self.bar.state.chapters if begins <= self.bar.state.now_s]
        self.host.cards.open_choices("Chapters", rows, self._seek, before[-1] if before else None)

    def _seek(self, film_s: float) -> None:
        self.journey.to_film(film_s, self.rehearsal.found)

    def _offer_speeds(self) -> None:
        rows = [ListRow(speed_text(speed), value=speed) for speed in SPEEDS]
        self.host.cards.open_choices("Speed", rows, self._set_speed, self._speed)

    @property
    def _speed(self) -> float:
        """What the viewer has set, whatever the script makes of it."""
        return self.record.stage.speed / self._pace

    def _set_speed(self, speed: float) -> None:
        self.record.stage.speed = min(max(speed * self._pace, SLOWEST), FASTEST)

    def touched(self, event: StageEvent) -> bool:
        """An event of the viewer's is about to come in, by which the scene is the viewer's; False to drop it.

        A hand that only moves over the scene is no touch, and the scene does not hear of it.
        """
        resting = isinstance(event, Pointer) and event.kind == "move" and not event.button
        if not self.runner.playing:
            self._left |= not resting
            return True
        if resting:
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
        self.view.show_marks(not self.view.asked)

    # -- time and picture ---------------------------------------------------------------------------

    def update(self, elapsed_s: float, inside: bool) -> None:
        """Let time pass; ``inside``: a thread is at work in the scene, which is not to be looked at."""
        if not inside:
            self.runner.follow()
            self._keep_pace()
            self._lead_camera()
        self._left &= self._over
        self.offers.show(self._at_end)
        self.offers.update(elapsed_s)
        self.filming.update()
        self.bar.update(elapsed_s, self._bar_state())

    @property
    def _at_end(self) -> bool:
        """Whether the end card stands, and has not been answered."""
        return self._over and not self._left and self.journey.share is None

    @property
    def _over(self) -> bool:
        return self.runner.course.handed_over and self.runner.stopped_at is None

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
        if self.free or not (self.runner.playing or not self.runner.finished or self._unseen):
            return
        self._unseen = False
        point_camera(self.view, self.runner, self.runner.shown_s)
        self._led = camera.wanted

    def _bar_state(self) -> TimeBarState:
        runner, found = self.runner, self.rehearsal.found
        now_s = runner.film_s
        if found is not None:
            chapters = tuple((one.chapter, one.film_s) for one in found.chapters)
            length = found.film_s
        else:
            chapters = tuple((one.chapter, one.film_s) for one in moments_of(runner) if one.chapter)
            length = max(GUESSED_S, ROOM * now_s)
        taken = runner.stopped_at is not None
        return TimeBarState(
            min(now_s, length), length, chapters, taken, runner.course.handed_over, self.journey.share,
            self.free and not runner.finished, self.record.stage.paused, speed_text(self._speed),
            self.pictures.at(self.bar.pointed),
        )  # fmt: skip

    def draw_words(self, surface: pygame.Surface) -> None:
        """Captions and cards over the picture; none once somebody has taken over."""
        if self.runner.stopped_at is not None:
            return
        self.pictures.see(self.runner.shown_s, surface, self.view.rect)
        runner, name = self.runner, self.host.settings.name
        draw_words(surface, self.host.look, self.view, runner, runner.shown_s, name, leaves=True)
        self.offers.draw(surface)

    def draw_bar(self, surface: pygame.Surface) -> None:
        """The time bar; it does not look into the scene."""
        self.bar.draw(surface)

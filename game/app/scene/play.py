"""A scene in play: the record of it, the parts that work on it, and what is drawn of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pygame

from game.app.compile.preparing import native_code_of
from game.app.scene.banner import FaultBanner
from game.app.scene.caption import LevelCaption
from game.app.scene.film.films import Films
from game.app.scene.in_play import InPlay
from game.app.scene.keeping import keep_built
from game.app.scene.lesson.lesson import Lesson
from game.app.scene.playing.gate import Gate
from game.app.scene.playing.leads import Leads
from game.app.scene.playing.picture import PlayPicture
from game.app.scene.playing.pointer import ScenePointer
from game.app.scene.playing.steps import Steps
from game.app.scene.playing.stopping import Stopping
from game.app.scene.shelf import Shelf
from game.app.scene.shell import Shell
from game.app.scene.story.play import StoryPlay
from game.app.scene.tools.bench import Bench, ToolsCard
from game.app.scene.tools.charts import Charts
from game.app.scene.tools.passing import Passing
from game.app.screens.host import Host
from game.app.stagehand.opening import Opening
from game.app.stagehand.view import StageView
from game.app.window.commands import Actions
from game.app.window.guard import Failure
from game.app.window.keys import chord_of, parse_chord
from game.compiler.prebuilt import anything_taken
from game.stage import Action, Stage, StageEvent
from game.ui.widgets.wishes import Wish

SPEEDS = (1 / 16, 1 / 8, 1 / 4, 1 / 2, 1.0, 2.0, 4.0)
ROOMY_MARGIN = 6.0  # design px


class ScenePlay:
    """The living part of a scene's screen: lets hand and time in, and shows what comes of it."""

    def __init__(self, host: Host, shell: Shell, stage: Stage, opening: Opening):
        self.host = host
        self.shell = shell
        self.record = InPlay(stage, opening.recording, host.background)
        self.view = StageView(stage, host.look)
        self.hand = ScenePointer(stage.scene_type, self.view.camera)
        self.gate = Gate(self.record, host, self.hand)
        self.steps = Steps(self.record, host, self.gate)
        self.shelf = Shelf(self.record, host, self._opened, self._offer_levels)
        self.banner = FaultBanner(host)
        self.caption = LevelCaption(host, welcome=not shell.entry.roomy)
        self.films = Films(host, self.record, self.view)
        self.bench = Bench(host, self.record, self.view)
        self.charts = Charts(host, self.record, shell)
        self.passing = Passing(host, self.record, self.post)
        self.stopping = Stopping()
        self.picture = PlayPicture(self)
        self._pace = 1.0  # of the level in play
        self._frame = stage.scene.frame()  # that the view was fitted to
        self.story: StoryPlay | None = None
        self.leads = Leads(host, self.record, self.shelf, self.open_file)
        self._unseen_s = 0.0  # that a thread has been at work in the scene
        self._chords = {parse_chord(action.key): action.name for action in stage.scene_type.actions}
        shell.open(stage, self.shelf.levels())
        self.lesson = Lesson(host, self.record, shell, self._offer_levels)
        if stage.scene.is_heard():
            host.sounds.prepare()
        story = opening.read_story(stage.scene_type)
        if story is not None:
            self.story = StoryPlay(host, self.record, self.view, story)
            self.gate.touched = self.story.touched
        self.native = native_code_of(shell.entry)
        if host.background and anything_taken():
            self.native.begin()
        if self.story is None:
            self._set_pace()
            self._introduce()
        self.restyle()

    @property
    def stage(self) -> Stage:
        """The stage in play."""
        return self.record.stage

    @property
    def actions(self) -> Actions:
        """What the commands do to the scene."""
        return {
            "pause": self.gate.pause,
            "step": self.gate.step,
            "step-back": self.gate.step_back,
            "undo": self.undo,
            "reset": self.gate.reset,
            "defaults": self.gate.set_defaults,
            "slower": lambda: self.change_speed(-1),
            "faster": lambda: self.change_speed(1),
            "view": lambda: self.view.camera.home(smooth=not self.host.look.less_motion),
            "save": self.shelf.ask_and_save,
            "copy": self.shelf.copy,
            "give": self.passing.give,
            "film": self.films.ask,
            "tools": self.open_tools,
            "teach": self.lesson.ask_and_save,
            "charts": self.charts.ask,
            **(self.story.actions if self.story is not None else {}),
        }

    def restyle(self) -> None:
        """Window, scale or theme has changed."""
        self._place_view()
        self.banner.place(self.shell.layout.free_stage)
        self.caption.place(self.shell.layout.free_stage)

    def _place_view(self) -> None:
        """Fit the scene's frame into the stage; a game comes nearer to its edges."""
        margin = ROOMY_MARGIN * self.host.look.k if self.shell.entry.roomy else None
        if self.shell.layout.overlaid:
            margin = 0.0
        place = self.shell.layout.free_stage
        if self.story is not None:
            place = self.story.picture_place(place)
        self.view.place(place, self.host.look, margin)

    def close(self) -> None:
        """The scene is left."""
        if self.stage.level is not None:
            self.host.toasts.withdraw(self.stage.level.about)
        self.native.stop()
        self.films.close()
        self.record.errands.close()
        if self.story is None and not self.record.borrowed and (complaint := keep_built(self.stage)):
            self.host.tell("What was built is not kept.", complaint, "warning")
        self._leave_story()
        self.host.sounds.follow(None)
        self.steps.close()
        if self.shell.panel is not None:
            self.shell.panel.close()
        self.shell.card.close()

    # -- events -------------------------------------------------------------------------------------

    def handle(self, event: pygame.Event) -> list[Wish]:
        """An event for panel, bar, banner or the scene; the wishes that are not fulfilled here."""
        if self.banner.handle(event):
            return [Wish("reset")]
        if self.story is not None:
            if not self.hand.held and self.story.handle(event):
                return []
        elif self.caption.handle(event):
            return [Wish("pause")]
        if event.type in (pygame.KEYDOWN, pygame.TEXTINPUT) and self.shell.lesson.typing:
            return self.shell.lesson.handle(event)
        if event.type in (pygame.KEYDOWN, pygame.TEXTINPUT) and self.shell.card.typing:
            return self._post_all(self.shell.card.handle(event))
        if event.type == pygame.KEYDOWN and event.key == pygame.K_TAB and self.shell.panel is not None:
            self.shell.panel.focus_next()
            return []
        dragging = bool(self.hand.held)
        if not dragging and self.bench.handle(event, self.shell.layout.free_stage):
            return []
        taken, asked = (False, []) if dragging else self.shell.handle(event)
        if not taken:
            self.hand.handle(event, self.shell.layout.free_stage)
        return self._post_all(asked)

    def _post_all(self, asked: list[Any]) -> list[Wish]:
        """Let stage events act; the wishes that are left."""
        wishes = []
        for wish in asked:
            if isinstance(wish, Wish):
                wishes.append(wish)
            else:
                self.post(wish)
        return wishes

    def post(self, event: StageEvent) -> bool:
        """Let an event act when it is its turn; False if it is refused at once.

        One that asks for another level opens that, with what was chosen beside it.
        """
        level = self.shelf.level_of(event)
        if level is None:
            return self.gate.post(event)
        chosen = self.shelf.chosen()
        self.open_file(level)
        return all(self.gate.post(one) for one in chosen)

    def action_of(self, event: pygame.Event) -> str | None:
        """The scene's own action of a key, if it has one."""
        return self._chords.get(chord_of(event))

    def act(self, name: str) -> None:
        """One of the scene's named actions."""
        self.gate.post_hand()
        self.post(Action(name))

    def undo(self) -> None:
        """Take back what was done last: by the scene's own action of that name, else the last press."""
        if "undo" in self._chords.values():
            self.act("undo")
        else:
            self.gate.undo()

    def open_tools(self) -> None:
        """All that one measures and shows with."""
        label = self.host.keys.label
        more = [
            ("One more chart", "Any readout over the last ten seconds", label("charts"), self.charts.ask),
            ("Phase plot", "Two readouts against each other", "", self.charts.ask_phase),
            ("Save the numbers", "All readouts of the last ten seconds", "csv", self.charts.save),
            ("Film", "This, or the last ten seconds", label("film"), lambda: self.host.perform("film")),
        ]
        ToolsCard(self.host, self.bench, more, self.record.later.append).open()

    def cancel(self) -> bool:
        """Take back a drag; False if there was none."""
        self.bench.cancel()
        begun = self.hand.cancel()
        self.gate.post_hand()
        return begun

    def step_out(self) -> bool:
        """Stop a jump of a story, else take back a drag, or else leave the part of the scene that one is in.

        False if there is none of these.
        """
        if self.story is not None and self.story.journey.stop():
            return True
        if self.cancel():
            return True
        name = "" if self.stopped else self.stage.scene.way_out
        if name:
            self.act(name)
        return bool(name)

    def change_speed(self, notches: int) -> None:
        """So many notches faster (slower, if negative), or normal for 0."""
        nearest = min(range(len(SPEEDS)), key=lambda i: abs(SPEEDS[i] - self.stage.speed))
        index = min(max(nearest + notches, 0), len(SPEEDS) - 1) if notches else SPEEDS.index(1.0)
        self.stage.speed = SPEEDS[index]

    # -- files --------------------------------------------------------------------------------------

    def open_file(self, path: Path) -> None:
        """A level or a recording."""
        self.cancel()
        self.shelf.open(path)

    def _offer_levels(self) -> None:
        """The panel's list shows the levels that there are now, those just saved among them."""
        if self.shell.panel is not None:
            self.shell.panel.offer(self.shelf.levels())

    def _leave_story(self) -> None:
        """Nothing is scripted any more."""
        if self.story is not None:
            self.story.close()
            self.story, self.gate.touched = None, None

    def _opened(self) -> None:
        """What depends on the scene's frame and level follows."""
        self._leave_story()
        self.lesson.follow()
        self.view.stage = self.stage
        self._place_view()
        self.view.camera.home(smooth=False)
        self._offer_levels()
        self._set_pace()
        level = self.stage.level
        if level is not None and level.about:
            self.host.toasts.clear()  # what was to be said of the level before
            if not self._introduce():
                self.host.tell(level.title or "Level", level.about, "marker" if level.hard_case else "info")

    def _set_pace(self) -> None:
        """As fast as the level says; what a user has set is kept where no level has said anything."""
        level, before = self.stage.level, self._pace
        self._pace = level.pace if level is not None else 1.0
        if self._pace != before:
            self.stage.speed = self._pace

    def _introduce(self) -> bool:
        """Let a hard case wait until one has read what it is; False if the level is none, or has begun."""
        fresh = self.stage.step_number == 0 and not self.record.repeating
        if not (fresh and self.caption.introduces(self.stage.level)):
            return False
        self.stage.pause()
        return True

    @property
    def level_words(self) -> tuple[str, str]:
        """Title and words of the level in play; empty if there is none."""
        level = self.stage.level
        return (level.title, level.about) if level is not None else ("", "")

    # -- time and picture ---------------------------------------------------------------------------

    def update(self, elapsed_s: float) -> None:
        """Events of the hand, then the steps that are due, then what is shown of them."""
        errands, later = self.record.errands, self.record.later
        while later:
            later.pop(0)()
        errands.update(elapsed_s)
        if self.stopped:
            self._stand_still(elapsed_s)
            return
        if not errands.busy:
            if self.leads.follow():
                return
            panel = self.shell.panel
            self.steps.go_on(elapsed_s, measuring=panel is not None and panel.shows_effects)
        if self.story is not None:
            self.story.update(elapsed_s, errands.inside)
        if not errands.inside:
            self.films.update(elapsed_s)
        self.bench.update()
        self.shell.filming = self.films.busy
        self.shell.bare = self.stopped or not self.view.teaching
        if errands.inside:
            self.host.sounds.follow(None)
            self.shell.hints.update(elapsed_s)
            self._unseen_s += elapsed_s
            return
        self._follow(elapsed_s, still=self.stage.paused or errands.busy)

    def _follow(self, elapsed_s: float, still: bool) -> None:
        """Sounds, camera, messages and shell as the scene is now."""
        stage = self.stage
        if stage.scene.frame() != self._frame and type(stage.scene).refits:
            self._frame = stage.scene.frame()
            self._place_view()
            self.view.camera.home(smooth=False)
        self.host.sounds.follow(None if still else stage.scene.hearing(), elapsed_s)
        if self.story is None or self.story.free or self.story.runner.finished:
            self.view.camera.update(0.0 if self.host.look.less_motion else elapsed_s)
        for message in stage.scene.messages():
            cause, _, consequence = message.partition(". ")
            self.host.tell(cause + ("." if consequence else ""), consequence)
        self.caption.follow(stage, watched=self.record.script is not None)
        self.shell.update(elapsed_s + self._unseen_s, stage, self.record.meter)
        self._unseen_s = 0.0
        self.banner.update(elapsed_s, self.trouble)

    def _stand_still(self, elapsed_s: float) -> None:
        """Time passes for what is round a scene that is not asked anything any more."""
        self.hand.take()
        self.host.sounds.follow(None)
        self.shell.rest(elapsed_s)
        self.banner.update(elapsed_s, self.trouble)

    @property
    def trouble(self) -> str:
        """Why the scene stands still, if something went wrong."""
        return self.stopping.trouble(self.stage)

    @property
    def stopped(self) -> bool:
        """Whether something asked of the scene has failed, so that nothing more is asked of it."""
        return self.stopping.holds(self.stage)

    def survive(self, failure: Failure, asked: bool) -> bool:
        """Stop the scene, as what it was asked has failed; False if it is what is round it that fails.

        ``asked``: an event has led to it; else time that passed, or the picture.
        """
        if self.stopped and asked:
            self.host.tell("Not done.", failure.message, "warning")
            return True
        return self.stopping.stop(self.stage, failure)

    def draw(self, surface: pygame.Surface) -> None:
        """The scene and its shell; as they were while a thread is at work in the scene."""
        self.picture.draw(surface)

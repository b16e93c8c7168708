"""A scene in play: its stage, its camera, the hand in it, what is drawn of it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import pygame

from game.app.scene.banner import FaultBanner
from game.app.scene.errands import Errands
from game.app.scene.gate import Gate
from game.app.scene.keeping import Keeper
from game.app.scene.pointer import ScenePointer
from game.app.scene.shelf import Shelf
from game.app.scene.standstill import Standstill
from game.app.scene.stopping import Stopping
from game.app.scene.variants import Variants
from game.app.stagehand import files
from game.app.stagehand.opening import Opening
from game.app.stagehand.script import Script
from game.app.stagehand.stars import StarKeeper
from game.app.stagehand.view import StageView
from game.app.window.keys import chord_of, parse_chord
from game.stage import (
    Action,
    EffectMeter,
    Recording,
    Scene,
    Stage,
    StageEvent,
)
from game.ui.widgets.commands import Command

if TYPE_CHECKING:
    from game.app.application import App
    from game.app.scene.shell import Shell
    from game.app.window.guard import Failure

SPEEDS = (1 / 16, 1 / 8, 1 / 4, 1 / 2, 1.0, 2.0, 4.0)
FOCUS_KEYS = (pygame.K_LEFT, pygame.K_RIGHT, pygame.K_UP, pygame.K_DOWN, pygame.K_RETURN, pygame.K_KP_ENTER)
ROOMY_MARGIN = 6.0  # design px
METER_BUDGET_S = 0.0004  # s a frame for measuring what effects cost
MOST_STEPS = 15  # in a frame
TRIALS = 2
STEPS_BUDGET_S = 0.05  # s a frame for steps; one that takes longer is made behind the window


class ScenePlay:
    """The living part of a scene's screen."""

    def __init__(self, app: App, shell: Shell, stage: Stage, opening: Opening):
        self.app = app
        self.shell = shell
        self.stage = stage
        self.script = Script(stage, opening.recording.events) if opening.recording is not None else None
        self.errands = Errands(behind=app.background)
        self.variants = Variants(stage)
        self.gate = Gate(self)
        self.shelf = Shelf(self)
        self.view = StageView(stage, app.look)
        self.hand = ScenePointer(stage.scene_type, self.view.camera)
        self.banner = FaultBanner(app)
        self.meter = EffectMeter(stage)
        self.stopping = Stopping()
        self.standstill = Standstill()
        self._seen = True  # whether the present state has been drawn
        self._unseen_s = 0.0  # that a thread has been at work in the scene
        self.untried = TRIALS  # steps to be made before it is known how long they take
        self.stars = StarKeeper()
        self._chords = {parse_chord(action.key): action.name for action in stage.scene_type.actions}
        shell.open(stage, files.level_rows(stage.scene_type))
        self.keeper = (
            Keeper(stage.scene.name) if type(stage.scene).worth_keeping is not Scene.worth_keeping else None
        )
        if type(stage.scene).hearing is not Scene.hearing:
            app.sounds.prepare()
        self.restyle()

    @property
    def typing(self) -> bool:
        """Whether the panel has a field that takes letters."""
        return self.shell.panel is not None and self.shell.panel.typing

    def panel_wants(self, event: pygame.Event) -> bool:
        """Whether a key is for the control that has the keyboard focus, or moves that focus (Shift+Tab)."""
        panel = self.shell.panel
        if panel is None or not self.shell.layout.panel.w:
            return False
        if event.key == pygame.K_TAB and event.mod & pygame.KMOD_SHIFT:
            return True
        if event.key == pygame.K_ESCAPE and panel.has_open_list:
            return True
        return panel.typing or (panel.has_keys and event.key in FOCUS_KEYS)

    def restyle(self) -> None:
        """Window, scale or theme has changed."""
        self._place_view()
        self.banner.place(self.shell.layout.free_stage)

    def _place_view(self) -> None:
        """Fit the scene's frame into the stage; a game comes nearer to its edges."""
        margin = ROOMY_MARGIN * self.app.look.k if self.shell.entry.roomy else None
        self.view.place(self.shell.layout.free_stage, self.app.look, margin)

    def close(self) -> None:
        """The scene is left."""
        if self.stage.level is not None:
            self.app.toasts.withdraw(self.stage.level.about)
        self.errands.close()
        self.app.sounds.follow(None)
        if self.keeper is not None:
            self.keeper.close()
        if self.shell.panel is not None:
            self.shell.panel.close()

    # -- events -------------------------------------------------------------------------------------

    def handle(self, event: pygame.Event) -> list[Command]:
        """An event for panel, bar, banner or the scene; the commands that are not done here."""
        if self.banner.handle(event):
            return [Command("reset")]
        if event.type == pygame.KEYDOWN and event.key == pygame.K_TAB and self.shell.panel is not None:
            self.shell.panel.focus_next()
            return []
        dragging = bool(self.hand.held)
        taken, wishes = (False, []) if dragging else self.shell.handle(event)
        if not taken:
            self.hand.handle(event, self.shell.layout.free_stage)
        commands = []
        for wish in wishes:
            if isinstance(wish, Command):
                commands.append(wish)
            else:
                self.post(wish)
        return commands

    def post(self, event: StageEvent) -> bool:
        """Let an event act when it is its turn; False if it is refused at once."""
        return self.gate.post(event)

    def action_of(self, event: pygame.Event) -> str | None:
        """The scene's own action of a key, if it has one."""
        return self._chords.get(chord_of(event))

    def act(self, name: str) -> None:
        """One of the scene's named actions."""
        self.gate.post_hand()
        self.post(Action(name))

    def cancel(self) -> bool:
        """Take back a drag; False if there was none."""
        begun = self.hand.cancel()
        self.gate.post_hand()
        return begun

    def step_out(self) -> bool:
        """Take back a drag, or else leave the part of the scene that one is in; False if there is neither."""
        if self.cancel():
            return True
        name = "" if self.stopped else self.stage.scene.way_out
        if name:
            self.act(name)
        return bool(name)

    # -- commands -----------------------------------------------------------------------------------

    def command(self, name: str) -> bool:
        """A key command; False if it is none of these."""
        if name == "view":
            self.view.camera.home(smooth=not self.app.look.less_motion)
        elif name in ("slower", "faster"):
            self.change_speed(-1 if name == "slower" else 1)
        elif name == "reset":
            self.reset()
        elif name == "save":
            self.shelf.save()
        else:
            return self.gate.command(name)
        return True

    def change_speed(self, way: int) -> None:
        """One notch slower or faster, or normal for 0."""
        nearest = min(range(len(SPEEDS)), key=lambda i: abs(SPEEDS[i] - self.stage.speed))
        index = min(max(nearest + way, 0), len(SPEEDS) - 1) if way else SPEEDS.index(1.0)
        self.stage.speed = SPEEDS[index]

    def reset(self) -> None:
        """Build the scene anew with its present parameters."""
        self.hand.cancel()
        self.hand.take()
        self.errands.act(self._reset)

    def _reset(self) -> None:
        self.script = None
        self.gate.reset()

    # -- files --------------------------------------------------------------------------------------

    def open_file(self, path: Path) -> None:
        """A level or a recording."""
        self.shelf.open(path)

    def watch(self, stage: Stage, recording: Recording) -> None:
        """Play a recording, from its beginning, before the user's eyes."""
        self.stage = stage
        self.script = Script(stage, recording.events)
        self.variants, self.meter = Variants(stage), EffectMeter(stage)
        self.view.stage = stage
        self.app.tell("Replaying", f"{recording.steps} steps as they were recorded")
        self._opened()

    def begin_anew(self) -> None:
        """The stage has begun with another level: nothing of the one before is gone on with."""
        self.script = None
        self._opened()

    def offer_levels(self) -> None:
        """The panel's list shows the levels that there are now, those just saved among them."""
        if self.shell.panel is not None:
            self.shell.panel.offer(self.shelf.levels())

    def _opened(self) -> None:
        """What depends on the scene's frame and level follows."""
        self.try_steps()
        self._place_view()
        self.view.camera.home(smooth=False)
        self.offer_levels()
        level = self.stage.level
        if level is not None and level.about:
            self.app.toasts.clear()  # what was to be told of the level before
            self.app.tell(level.title or "Level", level.about, "marker" if level.hard_case else "info")

    # -- time and picture ---------------------------------------------------------------------------

    def update(self, elapsed_s: float) -> None:
        """Events of the hand, then the steps that are due, then what is shown of them."""
        self.errands.update(elapsed_s)
        if self.stopped:
            self._stand_still(elapsed_s)
            return
        if not self.errands.busy:
            self._go_on(elapsed_s)
        if self.errands.inside:
            self.app.sounds.follow(None)
            self.shell.hints.update(elapsed_s)
            self._unseen_s += elapsed_s
            return
        stage = self.stage
        still = stage.paused or self.errands.busy
        self.app.sounds.follow(None if still else stage.scene.hearing())
        self.view.camera.update(0.0 if self.app.look.less_motion else elapsed_s)
        for message in stage.scene.messages():
            cause, _, consequence = message.partition(". ")
            self.app.tell(cause + ("." if consequence else ""), consequence)
        self.shell.update(elapsed_s + self._unseen_s, stage, self.meter)
        self._unseen_s = 0.0
        self.banner.update(elapsed_s, self.trouble)

    def _stand_still(self, elapsed_s: float) -> None:
        """Time passes for what is round a scene that is not asked anything any more."""
        self.hand.take()
        self.app.sounds.follow(None)
        self.shell.rest(elapsed_s)
        self.banner.update(elapsed_s, self.trouble)

    def _go_on(self, elapsed_s: float) -> None:
        """Let the scene go on, and keep what is won or worth keeping in it."""
        self.gate.post_hand()
        if self.script is not None:
            self.script.advance(elapsed_s)
        else:
            self.gate.listen()
            if not self._make_steps(elapsed_s):
                return
            if self.keeper is not None:
                self.keeper.update(self.stage)
            if complaint := self.stars.update(self.stage):
                self.app.tell("Stars.", complaint, "warning")
        panel = self.shell.panel
        if not self.stage.paused and panel is not None and panel.shows_effects:
            # compiles variants of the step behind the window: only if wanted
            self.meter.slice(METER_BUDGET_S)

    def _make_steps(self, elapsed_s: float) -> bool:
        """Make the steps that are due, no more than a frame has time for; False if a thread makes them.

        A thread makes one step at a time, and each is shown, if they take longer than that.
        """
        stage, cost_s = self.stage, self.stage.last_step_s
        slow = False
        if self.errands.behind and not stage.paused and stage.fault is None:
            stage.clock.max_steps = min(max(int(STEPS_BUDGET_S / max(cost_s, 1e-9)), 1), MOST_STEPS)
            slow = cost_s > STEPS_BUDGET_S or (self.untried > 0 and stage.scene.takes_long(None))
        if not slow:
            self._advance(elapsed_s)
        elif self._seen:
            self._seen = False
            self.errands.work_inside(lambda: self._advance(elapsed_s))
            return False
        return True

    def try_steps(self) -> None:
        """Something has changed by which steps may have become slow."""
        self.untried = TRIALS

    def _advance(self, elapsed_s: float) -> None:
        """Make the steps that are due; any thread may do it."""
        self.untried = max(self.untried - self.stage.advance(elapsed_s), 0)

    @property
    def trouble(self) -> str:
        """Why the scene stands still, if something went wrong."""
        return self.stopping.trouble(self.stage)

    @property
    def repeating(self) -> bool:
        """Whether a recording is being played, which a new event would end."""
        return self.script is not None and not self.script.finished

    @property
    def stopped(self) -> bool:
        """Whether something asked of the scene has failed, so that nothing more is asked of it."""
        return self.stopping.holds(self.stage)

    def survive(self, failure: Failure, asked: bool) -> bool:
        """Stop the scene, as what it was asked has failed; False if it is what is round it that fails.

        ``asked``: an event has led to it; else time that passed, or the picture.
        """
        if self.stopped and asked:
            self.app.tell("Not done.", failure.told, "warning")
            return True
        return self.stopping.stop(self.stage, failure)

    def draw(self, surface: pygame.Surface) -> None:
        """The scene and its shell; as they were while a thread is at work in the scene."""
        layout = self.shell.layout
        if self.errands.inside:
            self.standstill.show(surface)
        else:
            self.standstill.end()
            self._draw(surface)
        self.standstill.tell(surface, self.app.look, layout.free_stage, self.errands.seconds)

    def _draw(self, surface: pygame.Surface) -> None:
        self._seen = True
        layout = self.shell.layout
        pictureless = self.stopping.hides(self.stage)
        if pictureless or layout.free_stage != layout.stage:  # else the scene's picture covers it
            surface.fill(self.app.look.theme.stage, layout.stage)
        if not pictureless:
            self.view.draw(surface, self.shell.beat.fresh)
        self.shell.draw(surface, self.stage, () if self.stopped else self.stage.scene.legend())
        self.banner.draw(surface)

"""One scene under a random hand: events, parameter values and files, and what came of them."""

from __future__ import annotations

import math
import traceback
from collections.abc import Callable
from itertools import chain
from pathlib import Path
from random import Random
from time import thread_time
from typing import Any, NamedTuple

import pygame

from game.app.fuzz.driver import Driver
from game.app.fuzz.hand import SIZES, any_drag, any_event
from game.app.fuzz.hostile import spoil
from game.app.fuzz.memory import resident_bytes
from game.app.fuzz.values import any_value
from game.app.scene.screen import SceneScreen
from game.app.window.keys import parse_chord
from game.compiler.progress import compiling
from game.levels import LevelError, level_files, parse_level
from game.physics.kernels.limits import LimitError
from game.stage.catalogue import Catalogue
from game.stage.events import SetEffect, SetParameter, StageEvent

SLOW_S = 0.1  # s of the drawing thread; an event whose frame takes more is felt as a hang
SHOWN = 8  # one frame in so many is drawn: the others take their events and pass their time alone
FRAME_LENGTHS = (0.0, 0.0, 0.004, 0.016, 0.016, 0.1)  # s of simulated time
CARD = 30  # events after which, on average, a card that covers the scene is taken away
BURSTS = (1, 1, 2, 4, 8, 16)  # events in a frame: a mouse may tell of itself a thousand times a second
AGAIN = 1000  # events after which the scene is opened again, so that what broke it does not hide the rest


class FuzzReport(NamedTuple):
    """What came of a scene: events posted, parameter values refused, files refused, faults reported, growth
    of memory in the second half (bytes), and the trouble. Slow frames show no simulated time, and the drawing
    thread worked longer than SLOW_S. Frames in which a kernel was compiled do not count. Trouble: empty, or
    what was raised, with the number of the event.
    """

    scene: str
    events: int
    refused: int
    bad_files: int
    faults: int
    slow: int
    longest_s: float
    growth: int
    trouble: str


class FuzzSession:
    """Plays one scene of a catalogue with a random hand of that seed; the user's files go to ``folder``."""

    def __init__(self, catalogue: Catalogue, scene: str, seed: int, folder: Path):
        self.scene = scene
        self.hand = Random(f"{scene} {seed}")
        self.driver = Driver(folder, (1280, 720), catalogue)
        self.folder = folder
        self.events = self.refused = self.bad_files = self.faults = self.slow = 0
        self.longest_s = 0.0

    def run(self, events: int) -> FuzzReport:
        """Post so many events; never raises."""
        trouble = ""
        half = grown = again = 0
        try:
            while self.events < events and not trouble:
                if self._away() or self.events >= again:
                    again = self.events + AGAIN
                    self._open()
                if not half and 2 * self.events >= events:
                    half = resident_bytes()
                trouble = self._one_thing()
            grown = resident_bytes() - half if half else 0
        except Exception:
            trouble = traceback.format_exc(limit=-3)
        finally:
            self.driver.close()
        where = f"event {self.events}: {trouble}" if trouble else ""
        return FuzzReport(
            self.scene, self.events, self.refused, self.bad_files, self.faults, self.slow, self.longest_s,
            grown, where,
        )  # fmt: skip

    def _away(self) -> bool:
        """Has the hand left the scene for the menu, another scene, or for good?"""
        app = self.driver.app
        scenes = [screen for screen in app.screens if isinstance(screen, SceneScreen)]
        return not (app.running and scenes and scenes[-1].entry.name == self.scene)

    def _open(self) -> None:
        """The scene again, with any of its levels."""
        driver = self.driver
        driver.resize(1280, 720)
        driver.post(pygame.Event(pygame.WINDOWRESTORED))  # nothing goes on in a window that is hidden
        self._close_cards()
        driver.app.running = True  # the hand may have chosen to leave, or a card that closed now
        files = level_files(self.scene)
        driver.app.open_scene(self.scene, level=self.hand.choice(files) if files else None)
        screen = driver.top
        if screen.loader is not None:
            screen.loader.wait(300.0)
        driver.frames(2)
        play = getattr(driver.top, "play", None)
        if play is None:
            raise RuntimeError(f"{self.scene} could not be opened")
        play.record.errands.in_background = True  # as in a window; the hand waits for it
        self.events += 1

    def _close_cards(self) -> None:
        """Back to the scene, or to whatever else lies lowest."""
        while len(self.driver.app.screens) > 1:
            self.driver.app.pop()

    def _one_thing(self) -> str:
        """One event, drag, value, or file; what is wrong after it."""
        hand, driver = self.hand, self.driver
        if hand.randrange(CARD) == 0:
            self._close_cards()
        play = getattr(driver.top, "play", None)
        kind = hand.random()
        if play is None or kind < 0.7:
            chords, size = self._chords(play), driver.window.size
            self._frame([any_event(hand, size, chords) for _ in range(hand.choice(BURSTS))])
        elif kind < 0.8:
            for events in any_drag(hand, driver.window.size):
                self._frame([events])
        elif kind < 0.93:
            self._set_something(play)
        elif kind < 0.97:
            self._open_spoilt_level(play)
        else:
            size = hand.choice(SIZES)
            self.events += 1
            self._measured(lambda: driver.resize(*size))
        return self._check()

    @staticmethod
    def _chords(play: Any) -> list[Any]:
        actions = play.stage.scene.actions if play is not None else ()
        return [parse_chord(action.key) for action in actions]

    def _frame(self, things: list[list[pygame.Event]]) -> None:
        """Post what was done in a frame; one in which no time passes is measured."""
        self.driver.waiting += chain.from_iterable(things)
        self.events += len(things)
        self._measured(lambda: None)

    def _measured(self, act: Callable[[], Any]) -> None:
        """Do something and pass a frame after it, drawn or not; if no time passes in it both are measured."""
        seconds = self.hand.choice(FRAME_LENGTHS)
        shown = self.hand.randrange(SHOWN) == 0
        compiled, begin = compiling().done, thread_time()
        act()
        self.driver.frames(1, seconds, shown)
        took = thread_time() - begin
        self._wait_for_errands()
        if seconds == 0.0 and compiling().done == compiled:
            self.longest_s = max(self.longest_s, took)
            self.slow += took > SLOW_S

    def _wait_for_errands(self) -> None:
        """Wait until nothing is done in the background any more."""
        for screen in self.driver.app.screens:
            play = getattr(screen, "play", None)
            while play is not None and play.record.errands.busy:
                play.record.errands.wait()
                play.record.errands.update(0.0)

    def _set_something(self, play: Any) -> None:
        """A parameter to any value, or an effect on or off."""
        scene, hand = play.stage.scene, self.hand
        declared = list(scene.declared_parameters().items())
        effects = scene.effects.names
        self.events += 1
        if effects and (not declared or hand.random() < 0.2):
            event: StageEvent = SetEffect(hand.choice(effects), hand.random() < 0.5)
        elif declared:
            name, parameter = hand.choice(declared)
            event = SetParameter(name, any_value(hand, parameter))
        else:
            return
        taken: list[bool] = []
        self._measured(lambda: taken.append(play.post(event)))
        self.refused += not taken[0]

    def _open_spoilt_level(self, play: Any) -> None:
        """A level of the scene, spoilt: it is refused in one line, or opens."""
        files = level_files(self.scene)
        self.events += 1
        if not files:
            return
        scene_type = play.stage.scene_type
        text = spoil(self.hand.choice(files).read_text(encoding="utf-8"), self.hand)
        try:
            play.stage.load_level(parse_level(text, self.scene, scene_type.content_type))
        except LevelError as error:
            self.bad_files += 1
            if "\n" in str(error):
                raise RuntimeError(f"not one line: {error}") from error
        self.driver.frames(1, 0.016)

    def _check(self) -> str:
        """What is wrong with the scene now; a fault that was reported to the user is counted and reset."""
        play = getattr(self.driver.top, "play", None)
        if play is None:
            return ""
        fault = play.stage.fault
        if fault is None:
            return "" if math.isfinite(play.stage.time_s) else "the time is not finite"
        if fault.error is not None and not isinstance(fault.error, LimitError):
            return f"the scene raised {fault.quantity}: {fault.message}"
        self.faults += 1
        play.gate.reset()
        return ""

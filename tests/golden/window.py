"""What the window shows after each key and click of a tour: the menu, cards, screens of scenes, a story.

    python -m tests.golden.window [FOLDER]

writes anew what is kept of it, and the pictures into a folder where they can be looked at. Every command of
the program is given on each screen, and bars and columns are clicked through, so that nothing is listed here.
"""

from __future__ import annotations

import functools
import importlib
import itertools
import json
import os
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from unittest import mock

import pygame

from game.app.fuzz.driver import LONGEST_LOAD_S, SCANCODES, Driver
from game.app.screens import settings_card
from game.app.stagehand.headless import prepare
from game.app.stagehand.opening import Opening
from game.app.window.commands import COMMANDS
from game.app.window.keys import parse_chord
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage.catalogue import Catalogue, Entry
from game.stage.effect_costs import EffectMeter
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from tests.golden.accounts import TICK, written_with
from tests.golden.pictures import other_parts, sums_of
from tests.paths import ROOT
from tests.stage.story.bouncing import StoryBall
from tests.ui import gallery

FILE = Path(__file__).with_name("window.json")
SIZE = (1280, 720)  # px
STORY = Entry(
    "story-ball",
    "A00",
    "A ball",
    "one ball",
    "Stories",
    "tests.stage.story.bouncing",
    "StoryBall",
    roomy=True,
)
# scenes of the menu, so that a new one changes nothing here
NAMES = ("pendulum", "bouncing-ball", "billiards", "carom", "a18", *(f"c{n:02}" for n in range(1, 16)))
REST_S = 0.3  # after which what moves has come to rest
LEFT_OUT = {  # what ends the program, writes files, or says the time, where files lie or what things cost
    "accuracy", "back", "career", "challenge", "copy", "film", "full-screen", "give", "next", "open",
    "papers", "paste", "previous", "quit", "save", "screenshot", "teach",
}  # fmt: skip
BAR_Y = 24  # px: the middle of the bar above
PANEL_X = (996, 1120, 1250)  # px: places across the panel
CLOCKS = ("perf_counter", "thread_time", "process_time", "monotonic")

Account = dict[str, str]


class Tour:
    """A program that is driven, and what it shows after each thing that is done."""

    def __init__(self, driver: Driver, told: Account, folder: Path | None = None) -> None:
        """``told``: to which it is added. ``folder``: where pictures are put, if they are asked for."""
        self.driver = driver
        self.folder = folder
        self.told = told

    def see(self, label: str) -> None:
        """Let things come to rest, and keep what is shown."""
        self.driver.frames(1, REST_S)
        self.driver.frames(1, 0.0)
        self.keep(label)

    def keep(self, label: str) -> None:
        """Keep what is on the window's surface."""
        surface, number = self.driver.window.surface, len(self.told)
        self.told[f"{number} {label}"] = f"{type(self.driver.top).__name__} {sums_of(surface)}"
        if self.folder is not None:
            pygame.image.save(surface, self.folder / f"{number:03d} {label.replace('/', ' ')}.png")

    def press(self, word: str) -> None:
        """Press a key, or several together, by their word."""
        chord = parse_chord(word)
        mod = pygame.KMOD_CTRL * chord.control | pygame.KMOD_SHIFT * chord.shift
        self.driver.key(_keys()[chord.scancode], mod)

    def choose(self, word: str, down: int) -> None:
        """Open a list by a key, go down some rows and take the one there."""
        self.press(word)
        for _ in range(down):
            self.press("down")
        self.press("return")
        self.driver.frames(1, REST_S)

    def back_to(self, base: object) -> None:
        """Leave cards until a screen is on top again."""
        for _ in range(6):
            if self.driver.top is not base:
                self.press("escape")
                self.driver.frames(1, REST_S)

    def give_commands(self, where: str) -> None:
        """Each command by its key; what it opens is seen, gone through by keys, and left."""
        base = self.driver.top
        for command in COMMANDS:
            if command.name not in LEFT_OUT:
                self.press(command.key)
                self.see(f"{where}: {command.name}")
                if self.driver.top is not base:
                    self.go_through(f"{where}: {command.name}")
                self.back_to(base)

    def go_through(self, where: str, keys: tuple[str, ...] = ("down", "end", "right")) -> None:
        """Press keys of a list or page."""
        card = self.driver.top
        for word in keys:
            if self.driver.top is card:
                self.press(word)
                self.see(f"{where}, {word}")

    def click_through(self, where: str, places: list[tuple[int, int]]) -> None:
        """Click many places one after the other; what opens is left again."""
        base = self.driver.top
        for x, y in places:
            self.driver.click(x, y)
            self.see(f"{where}: click {x} {y}")
            self.back_to(base)

    def drag(self, start: tuple[int, int], end: tuple[int, int]) -> None:
        """Move with the button held."""
        self.driver.move(*start)
        self.driver.button(True, *start)
        self.driver.post(pygame.Event(pygame.MOUSEMOTION, pos=end, rel=(1, 1), buttons=(1, 0, 0)))
        self.driver.button(False, *end)


@functools.cache
def _keys() -> dict[int, int]:
    """Key codes by scancodes, as the layout has them once there is a window."""
    codes = [code for name, code in vars(pygame).items() if name.startswith("K_") and code]
    return {SCANCODES[code]: code for code in codes}


def account_of_window(folder: Path | None = None) -> Account:
    """What is shown on all tours, by what was done; each begins with a program of its own."""
    told: Account = {}
    course = Catalogue(tuple(entry for entry in CATALOGUE if entry.name in NAMES))
    for part in (menu, settings, pendulum, tools, lesson, games, story, widgets):
        with a_program(Catalogue((STORY,)) if part is story else course) as driver:
            part(Tour(driver, told, folder))
    return told


@contextmanager
def a_program(catalogue: Catalogue) -> Iterator[Driver]:
    """A program that nobody has used before, on a machine without time."""
    with tempfile.TemporaryDirectory(prefix="carom-tour-") as home, ExitStack() as stack:
        stack.enter_context(clocks_that_stand())
        stack.enter_context(mock.patch.dict(os.environ, {"CAROM_HOME": home}))
        stack.enter_context(mock.patch.object(settings_card, "settings_path", lambda _: "HOME"))
        driver = Driver(Path(home), SIZE, catalogue)
        yield driver
        driver.close()


def menu(tour: Tour) -> None:
    """The menu: keys, wheel, words that are searched, other settings."""
    driver = tour.driver
    tour.see("menu")
    tour.give_commands("menu")
    tour.go_through("menu", ("right", "down", "tab", "end", "home"))
    for turns in (-3, -30, 30):
        driver.wheel(turns)
        driver.frames(60, shown=False)
        tour.see(f"menu: wheel {turns}")
    driver.type("ball")
    tour.see("menu: ball")
    tour.go_through("menu: ball", ("down", "backspace"))
    tour.press("escape")
    for x in range(60, 1280, 180):
        driver.move(x, 300)
        tour.see(f"menu: over {x} 300")


def settings(tour: Tour) -> None:
    """The card of settings: each choice, by the pointer and by keys."""
    tour.press("f10")
    card = tour.driver.top
    for name in [spot.name for spot in card.spots.spots]:
        spot = card.spots.find(name)
        if tour.driver.top is card and spot is not None and not name.startswith("screen"):
            tour.driver.click(*spot.rect.center)
            tour.see(f"settings: {name}")


def pendulum(tour: Tour) -> None:
    """A small scene: all that lies about a picture."""
    driver = tour.driver
    base = driver.open("pendulum")
    tour.see("pendulum")
    tour.press("space")
    tour.give_commands("pendulum")
    tour.click_through("bar", [(x, BAR_Y) for x in (468, 508, 552, 596, 636, 708, 1128, 1224, 1256, 1256)])
    tour.click_through("panel", [(x, y) for y in range(80, 400, 40) for x in PANEL_X])
    tour.click_through("charts", [(461, 576), (933, 576), (300, 640)])
    tour.drag((606, 434), (400, 300))
    tour.see("pendulum: dragged")
    driver.wheel(2)
    tour.see("pendulum: nearer")
    tour.drag((1120, 230), (1200, 230))
    tour.see("pendulum: longer")
    for x, y in ((1000, 384), (1128, 24), (300, 600), (40, 704), (1100, 290)):
        driver.move(x, y)
        driver.frames(1, 1.0)
        tour.see(f"over {x} {y}")
    tour.press("ctrl+z")
    tour.see("pendulum: undone")
    for word, down in (("l", 1), ("f5", 0), ("f5", 1), ("f8", 3), ("f8", 4), ("p", 1)):
        tour.choose(word, down)
        tour.see(f"pendulum: {word}, row {down}")
        tour.back_to(base)
    driver.resize(900, 600)
    tour.driver.frames(2)
    driver.resize(*SIZE)
    tour.see("pendulum: as large as before")


def tools(tour: Tour) -> None:
    """Ruler, protractor and stop-watch, each pulled here and there; then a lesson and its answers."""
    driver = tour.driver
    base = driver.open("pendulum")
    tour.press("space")
    place = base.play.view.rect
    x, wide = place.centerx, round(0.18 * place.w)
    grips = ((x + wide, 0.38), (x, 0.38), (x - wide, 0.38)), ((x + wide, 0.74), (x - wide, 0.74)), ()
    for row, ends in enumerate(grips):
        tour.choose("f8", row)
        tour.see(f"tools: row {row}")
        for across, down in ends:
            start = across, round(place.y + down * place.h)
            driver.move(*start)
            tour.see(f"tools: row {row}, over {across}")
            tour.drag(start, (start[0] + 60, start[1] - 35))
            tour.see(f"tools: row {row}, pulled at {across}")
    watch = base.play.bench.watch.rect
    for share in (0.1, 0.3, 0.5, 0.7, 0.9):
        for _ in range(2):
            if base.play.bench.watch is not None:
                driver.click(round(watch.x + share * watch.w), watch.bottom - 14)
                tour.press("period")
                tour.see(f"tools: stop-watch, at {share}")
    tour.choose("f8", 0)
    tour.see("tools: put away")


def lesson(tour: Tour) -> None:
    """A teaching level: a wrong answer, a right one, a hint."""
    driver = tour.driver
    levels = {file.stem: file for file in level_files("pendulum")}
    driver.app.open_scene("pendulum", opening=Opening(level=levels["task-period"]))
    driver.top.loader.wait(30.0)
    driver.frames(2)
    tour.see("lesson")
    sheet = driver.top.shell.lesson.rect
    for y in range(sheet.y + 20, sheet.bottom, 60):
        driver.click(sheet.centerx, y)
        tour.see(f"lesson: click {y}")
    driver.type("1.5")
    tour.press("return")
    tour.see("lesson: answered")


def widgets(tour: Tour) -> None:
    """The pages and cards that need made-up numbers."""
    look, stage = Look(DARK), gallery.sample_stage()
    for draw in (gallery.draw_scene, gallery.draw_loading, gallery.draw_accuracy):
        draw(tour.driver.window.surface, look, stage)
        tour.keep(draw.__name__)


def games(tour: Tour) -> None:
    """The cards before games."""
    for name in ("billiards", "carom"):
        driver = tour.driver
        driver.app.open_scene(name)
        list(driver.app.screens)[-2].loader.wait(LONGEST_LOAD_S)  # else it may come while one looks
        driver.frames(2)
        tour.see(f"{name}: start")
        tour.go_through(f"{name}: start", ("down", "right", "end"))


def story(tour: Tour) -> None:
    """A story: its bar, its marks, what takes it over, and what it offers at its end."""
    driver = tour.driver
    StoryBall.task, StoryBall.title = STORY.task, STORY.title
    driver.open(STORY.name)
    for _ in range(3):
        driver.frames(30, shown=False)
        tour.see("story")
    tour.press("f7")
    tour.see("story: marks")
    tour.press("f6")
    tour.see("story: taken over")
    tour.press("f6")
    tour.see("story: gone on with")
    base, bar = driver.top, driver.top.play.story.bar.rect
    for share in (0.1, 0.4, 0.3, 0.6, 0.85, 0.98):
        place = round(bar.x + share * bar.w), bar.centery
        driver.move(*place)
        tour.see(f"story: over {share} of its bar")
        driver.click(*place)
        base.play.record.errands.wait(30.0)
        driver.frames(30, shown=False)
        tour.see(f"story: at {share}")
        tour.back_to(base)
    tour.go_through("story: its end", ("left", "right", "return"))


@contextmanager
def clocks_that_stand() -> Iterator[None]:
    """Meanwhile each look at a clock finds it TICK later, in each thread by itself; no effect is priced."""
    for name in _that_look_at_clocks():
        importlib.import_module(name)  # else it would keep this clock for ever
    kept = threading.local()

    def tick() -> float:
        kept.ticks = getattr(kept, "ticks", 0) + 1
        return TICK * float(kept.ticks)

    with ExitStack() as stack:
        for owner in [*(one for name, one in sys.modules.items() if name.startswith("game.")), time]:
            for name in CLOCKS:
                if getattr(owner, name, None) is not None and getattr(owner, name) is getattr(time, name):
                    stack.enter_context(mock.patch.object(owner, name, tick))
        stack.enter_context(mock.patch.object(EffectMeter, "slice", lambda *_: None))  # by copies in a thread
        yield


@functools.cache
def _that_look_at_clocks() -> list[str]:
    """Modules of the window whose texts name a clock."""
    floors = (ROOT / "game" / floor for floor in ("app", "stage", "ui", "worlds"))
    files = [file for floor in floors for file in sorted(floor.rglob("*.py"))]
    looking = [file for file in files if any(name in file.read_text(encoding="utf-8") for name in CLOCKS)]
    return [".".join(file.relative_to(ROOT).with_suffix("").parts) for file in looking]


def read() -> Account:
    """What is kept, and ``with`` what it was written."""
    kept: Account = json.loads(FILE.read_text(encoding="utf-8"))
    return kept


def differences(kept: Account, now: Account) -> Iterator[str]:
    """Where two tours show something else, a line each."""
    for label in itertools.chain(kept, (label for label in now if label not in kept)):
        if label not in kept or label not in now:
            yield f"{label}: only {'kept' if label in kept else 'now'}"
            continue
        (one, before), (other, after) = kept[label].split(" ", 1), now[label].split(" ", 1)
        if one != other:
            yield f"{label}: {one} kept, {other} now"
        elif parts := list(other_parts(before, after)):
            yield f"{label}: {'; '.join(parts[:3])}{'; …' if len(parts) > 3 else ''}"


def main() -> None:
    """Write what is kept."""
    prepare()
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
    account = {"with": written_with(), **account_of_window(folder)}
    FILE.write_text(json.dumps(account, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    print(f"{len(account) - 1} pictures, {time.process_time():.1f} s")


if __name__ == "__main__":
    main()

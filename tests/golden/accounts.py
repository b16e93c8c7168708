"""What a scene tells of itself: measured values, words, numbers, its picture, its state.

An account is taken of every level as it opens and runs, of what a hand does in it, of each parameter at
another value, and of all that the scene declares and draws for its pages. It is kept in text, so that a
difference can be read, and compared by numbers, so that rounding is none.
"""

from __future__ import annotations

import itertools
import math
import os
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

import msgspec
import pygame

from game.app.stagehand.opening import read_level
from game.app.stagehand.script import Script, demo_of
from game.levels import level_files
from game.scenes import CATALOGUE
from game.scenes.billiards.practice.landing import LandingMeter
from game.scenes.carom.advisor import MapMaker
from game.scenes.papers import papers_of
from game.scenes.shared.newest import Newest
from game.scenes.shared.tables.odds import OddsMeter
from game.scenes.shared.thinker import Thinker
from game.stage import Action, Choice, Param, Parameter, ParameterError, Pointer, SetParameter, Stage
from game.ui.canvas.pen import CARD
from tests.golden.drawn import FINE_PARTS, Tally, drawing_of, figure_of, in_one, lines, painted
from tests.golden.pictures import picture_of

Account = dict[str, Any]

TICK = 1e-5  # s
TOWARDS = 0.3  # of the way to the farther end of its range, where a parameter is moved
TARGETS = 3  # at most, of what a story may name, that a hand takes hold of
DRAG = (0.13, 0.09)  # shares of the frame that a hand drags


class Plan(NamedTuple):
    """How far a scene is looked at."""

    opening: int  # steps before a level is described
    hand: int  # steps after each gesture
    stirred: int  # steps before parameters are changed
    parameter: int  # steps after each parameter
    grid: tuple[float, ...]  # shares of the frame where a hand takes hold
    levels: int  # at most, spread over all
    choices: int  # other values that are tried of a choice for which the scene is built anew


USUAL = Plan(24, 2, 90, 12, (0.25, 0.7), 100, 100)
SHORT = Plan(6, 1, 6, 1, (0.3, 0.7), 6, 1)
LEAST = Plan(6, 1, 6, 1, (0.4,), 3, 1)
PLANS = {  # where a step, a picture or the opening takes many times as long as elsewhere
    **dict.fromkeys(("a01", "a09", "a18", "broad-phase-race", "c05", "c09", "p04", "p28", "smoke"), SHORT),
    **dict.fromkeys(("solids", "wind-tunnel"), SHORT),
    **dict.fromkeys(("a08", "a10", "a22", "a26", "real-table", "solver-race"), LEAST),
}
LIVELY = {  # the level, and the action that sets it going, where parameters show more than in the default one
    "billiards": ("default", ""),
    "c03": ("hard-07-running-target", ""),
    "c04": ("stone-garden", "emit"),
    "c12": ("bouncing", ""),
    "c13": ("bouncing", ""),
    "carom": ("default", ""),
    "falling-plates": ("litter", ""),
    "lecture-balls": ("hard-03-corner", ""),
    "lecture-table": ("hard-07-break", ""),
    "p28": ("rose", ""),
    "p32": ("gears", ""),
    "snooker": ("default", ""),
    "three-tables": ("default", ""),
    "tracks": ("bowl", ""),
}


def account_of(name: str) -> Account:
    """All accounts of one scene: ``declared``, ``levels``, ``hand``, ``parameters``; and ``with`` what."""
    CATALOGUE[name].load()  # so that its modules are there, which look at the clock
    with nothing_by_chance():
        return _account_of(name)


@contextmanager
def nothing_by_chance() -> Iterator[None]:
    """Meanwhile a clock goes on by TICK with every look at it, and no thread answers."""
    ticks = itertools.count()
    owners = [*(one for name, one in sys.modules.items() if name.startswith("game.")), time]
    with ExitStack() as stack:
        for owner in owners:
            if getattr(owner, "perf_counter", None) is time.perf_counter:
                patch = mock.patch.object(owner, "perf_counter", lambda: TICK * next(ticks))
                stack.enter_context(patch)
        for meter in (LandingMeter, OddsMeter):  # they measure as long as a picture leaves time for
            clock = mock.patch.object(meter.__init__, "__defaults__", (lambda: TICK * next(ticks),))
            stack.enter_context(clock)
        for thinking in (Newest, Thinker, MapMaker):
            stack.enter_context(mock.patch.object(thinking, "ask", lambda *_: None))
        stack.enter_context(mock.patch.object(Thinker, "prepare", lambda _: None))
        yield


def _account_of(name: str) -> Account:
    return {
        "with": written_with(),
        "declared": declared(name),
        "levels": {file.stem: level_account(name, file) for file in levels_of(name)},
        "hand": hand_account(name),
        "parameters": parameter_account(name),
    }


def written_with() -> str:
    """By what words are measured, and so where they are put: with another one they may lie elsewhere."""
    ttf = ".".join(map(str, pygame.font.get_sdl_ttf_version()))
    return f"pygame-ce {pygame.version.ver}, SDL_ttf {ttf}"


def declared(name: str) -> Account:
    """What the class says, and the drawings of its card and of its help page."""
    entry = CATALOGUE[name]
    scene_type = entry.load()
    told: Account = {
        "words": _tallied(
            [
                scene_type.strips, scene_type.equations, scene_type.try_this, scene_type.hints,
                scene_type.actions, sorted(scene_type.takes), scene_type.unit, scene_type.effects.names,
            ]
        ).text()
    }  # fmt: skip
    for parameter in scene_type.declared_parameters().values():
        told[f"parameter {parameter.name}"] = _range_of(parameter)
    if (painter := entry.card_painter()) is not None:
        told["card"] = lines(figure_of(painter, CARD))
    if scene_type.figure is not None:
        told["figure"] = lines(figure_of(scene_type.figure))
    for row in papers_of(name):
        for number, step in enumerate(row.load().steps):
            told[f"{row.number} {number} words"] = _tallied((step.words, step.formula)).text()
            if step.figure is not None:
                told[f"{row.number} {number}"] = lines(figure_of(step.figure))
    return told


def level_account(name: str, file: Path | None) -> Account:
    """A level after its first steps, with the scene's demo if it has one."""
    stage = opened(name, file)
    Script(stage, demo_of(stage.scene_type)).run(plan_of(name).opening)
    return brief(stage)


def hand_account(name: str) -> Account:
    """What gestures and actions bring about, one after the other, and that going back undoes them all."""
    stage = opened(name, None)
    plan = plan_of(name)
    stage.run(plan.hand)
    here, acted, digest = stage.step_number, stage.events_acted, stage.digest()
    begins = f"key {stage.scene_type.actions[0].name}" if stage.scene_type.actions else ""
    told: Account = {}
    for label, events in _gestures(stage, plan.grid):
        refused = ""
        for event in events:
            try:
                stage.post(event)
            except ParameterError as error:
                refused = f"refused: {error}"
            stage.run(1)
        stage.run(plan.stirred if label == begins else plan.hand)
        told[label] = refused or line(stage)
    told["at the end"] = moment(stage)
    stage.return_to(here, acted)
    told["undone"] = "yes" if stage.digest() == digest else "no: given back in another state"
    return told


def parameter_account(name: str) -> Account:
    """Where things go on: each parameter nearer to the farther end of its range, or at its other values."""
    plan, first = plan_of(name), [one.name for one in CATALOGUE[name].load().actions[:1]]
    level, action = LIVELY.get(name, ("default", *first, "")[:2])
    stage = opened(name, next((file for file in level_files(name) if file.stem == level), None))
    _stir(stage, action, plan.stirred)
    here, acted = stage.step_number, stage.events_acted
    told: Account = {}
    for parameter in stage.scene_type.declared_parameters().values():
        values = _other_values(parameter, stage.scene.values[parameter.name])
        for value in values[: plan.choices] if parameter.rebuild else values:
            said = f"{value:.6g}" if isinstance(value, float) else f"{value}"
            told[f"{parameter.name}={said}"] = _with(stage, parameter.name, value, plan.parameter)
            stage.return_to(here, acted)
    _stir(stage, "", plan.parameter)
    told["as it was"] = line(stage)
    return told


def _with(stage: Stage, name: str, value: Any, steps: int) -> str:
    """What comes of another value, of a drag with it, and of some steps."""
    try:
        stage.post(SetParameter(name, value))
    except ParameterError as error:
        return f"refused: {error}"
    _stir(stage, "", steps)
    return line(stage)


def _stir(stage: Stage, action: str, steps: int) -> None:
    """Let something happen: a drag, then an action, which lets go or strikes."""
    frame = stage.scene.frame()
    x, y = 0.5 * (frame.left + frame.right), 0.5 * (frame.bottom + frame.top)
    x, y = next(iter(stage.scene.story_targets().values()), (x, y))
    to = (x + DRAG[0] * (frame.right - frame.left), y + DRAG[1] * (frame.top - frame.bottom))
    for event in [*_drag((x, y), to, 1), *([Action(action)] if action else [])]:
        try:
            stage.post(event)
        except ParameterError:  # refused in words
            continue
        stage.run(1)
    stage.run(steps)


def levels_of(name: str) -> list[Path]:
    """The levels of a scene that are told of: the default one, and others spread over all."""
    files = level_files(name)
    return files[:: -(-len(files) // plan_of(name).levels)] if files else []


def plan_of(name: str) -> Plan:
    """How far a scene is looked at."""
    return PLANS.get(name, USUAL)


def moment(stage: Stage) -> Account:
    """What a scene tells at one moment, in full."""
    tallies, surface = drawing_of(stage)
    return {
        "state": _state(stage),
        "readouts": _readouts(stage),
        "words": _words(stage),
        "drawn": lines(tallies),
        "painted": painted(surface, FINE_PARTS),
        "picture": picture_of(stage),
    }


def brief(stage: Stage) -> Account:
    """State and readouts, and in a tally each what is said and what is drawn."""
    tallies, surface = drawing_of(stage)
    said = in_one({kind: _tallied(what) for kind, what in _said(stage).items() if what})
    return {
        "state": _state(stage),
        "readouts": _readouts(stage),
        "words": said.text(),
        "drawn": in_one(tallies).text(),
        "painted": painted(surface),
    }


def line(stage: Stage) -> str:
    """The same in one line, without the pixels."""
    readouts = _tallied([(one.name, one.value, one.unit) for one in stage.readouts()])
    said = in_one({kind: _tallied(what) for kind, what in _said(stage).items() if what})
    drawn = in_one(drawing_of(stage)[0])
    return f"{_state(stage)} | {readouts.text()} | {said.text()} | {drawn.text()}"


def opened(name: str, file: Path | None) -> Stage:
    """A stage with a level, or with what the scene opens with."""
    scene_type = CATALOGUE[name].load()
    return Stage(scene_type, level=read_level(scene_type, file), record=True)


def _state(stage: Stage) -> str:
    return f"fault: {stage.fault.message}" if stage.fault is not None else stage.digest()[:12]


def _readouts(stage: Stage) -> list[str]:
    return [f"{one.name}: {one.value + 0.0:.6g} {one.unit}".rstrip() for one in stage.readouts()]


def _words(stage: Stage) -> dict[str, str]:
    return {kind: _tallied(what).text() for kind, what in _said(stage).items() if what}


def _said(stage: Stage) -> dict[str, Any]:
    """What is said beside the picture, by kind."""
    scene = stage.scene
    names = scene.declared_parameters()
    hearing = scene.hearing()
    home = os.environ["CAROM_HOME"]  # another one in each run of the tests
    return {
        "frame": scene.frame(),
        "heard": hearing and (hearing.time, hearing.sounds),
        "hints": scene.hints_now(),
        "idle": [scene.why_idle(name) for name in names],
        "kept": _kept(stage),
        "legend": scene.legend(),
        "messages": [words.replace(home, "HOME") for words in scene.messages()],
        "sliders": [scene.slider_range(name) for name in names],
        "standing": scene.standing(),
        "table": scene.panel_table(),
        "targets": scene.story_targets(),
        "title": (scene.level_title, scene.way_out, scene.resting, scene.stars),
    }


def _kept(stage: Stage) -> bytes:
    """The content as it would be saved."""
    content = stage.scene.save_content()
    return b"" if content is None else msgspec.msgpack.encode(content, order="deterministic")


def _tallied(what: Any) -> Tally:
    tally = Tally()
    tally.add(what)
    return tally


def _range_of(parameter: Parameter[Any]) -> str:
    if isinstance(parameter, Param):
        ends = f"{parameter.minimum:g} to {parameter.maximum:g} by {parameter.step}"
        return f"{ends}, {parameter.default:g} {parameter.unit}"
    if isinstance(parameter, Choice):
        return f"{' '.join(parameter.options)}, {parameter.default}"
    return f"switch, {parameter.default}"


def _other_values(parameter: Parameter[Any], now: Any) -> list[Any]:
    if isinstance(parameter, Param):
        low, high = parameter.minimum, parameter.maximum
        far = high if abs(high - now) >= abs(low - now) else low
        moved = TOWARDS * (far - now)
        return [now + (math.copysign(math.ceil(abs(moved)), moved) if parameter.whole else moved)]
    if isinstance(parameter, Choice):
        return [option for option in parameter.options if option != now]
    return [not now]


def _gestures(stage: Stage, grid: tuple[float, ...]) -> Iterator[tuple[str, list[Any]]]:
    """Label and events of each gesture: at what a story may name, over the frame, by keys."""
    scene_type = stage.scene_type
    frame = stage.scene.frame()
    wide, high = frame.right - frame.left, frame.top - frame.bottom
    places = [
        (f"at {name}", place) for name, place in itertools.islice(stage.scene.story_targets().items(), 3)
    ]
    for across, down in itertools.product(grid, grid):
        at = frame.left + across * wide, frame.bottom + down * high
        places.append((f"at {across:g} {down:g}", at))
    for number, (label, (x, y)) in enumerate(places):
        to = (x + DRAG[0] * wide, y + DRAG[1] * high)
        yield f"over {label}", [Pointer("move", x, y)]
        yield f"drag {label}", _drag((x, y), to, 1)
        if number % 3 == 0:
            yield f"click {label}", [Pointer("down", *to, 1), Pointer("up", *to, 1)]
            if "right" in scene_type.takes:
                yield f"right {label}", _drag((x, y), to, 3)
            if "wheel" in scene_type.takes:
                yield f"wheel {label}", [Pointer("wheel", *to, wheel=1.0)]
            yield f"shift {label}", _drag(to, (x, y), 1, shift=True)
    for action in scene_type.actions:
        yield f"key {action.name}", [Action(action.name)]
        x, y = places[len(places) // 2][1]
        yield f"click after {action.name}", [Pointer("down", x, y, 1), Pointer("up", x, y, 1)]


def _drag(
    start: tuple[float, float], end: tuple[float, float], button: int, shift: bool = False
) -> list[Any]:
    middle = 0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1])
    return [
        Pointer("down", *start, button, shift=shift),
        Pointer("move", *middle, button, shift=shift),
        Pointer("move", *end, button, shift=shift),
        Pointer("up", *end, button, shift=shift),
    ]

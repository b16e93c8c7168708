"""Restitution from slider to kernel, followed while it runs: where it goes, as what, who checks it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType, SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
import pygame
import pytest

import game
from game.app.scene.playing.gate import Gate
from game.billiards.lecture.settings import LectureSettings
from game.scenes.lecture_table.parameters import LectureTableParameters
from game.scenes.lecture_table.scene import LectureTable
from game.settings import declared
from game.stage import ParameterError, SetParameter, Stage
from game.stage.parameters import parameters_of
from game.ui.look.look import Look
from game.ui.look.theme import DARK
from game.ui.panel.panel import Panel
from game.ui.panel.slider import SliderRow

VALUE = 0.8128  # no other number of the table
OTHER = 0.9
ROOMS, CHECKS = 12, 1  # at most


class Met(NamedTuple):
    """A call that was given the value: file, function, and of what kind the argument is that held it."""

    file: str
    function: str
    form: str


def holds(thing: Any) -> bool:
    """Whether a thing is the value, or has it among its own things."""
    if isinstance(thing, float):
        return thing == VALUE
    if isinstance(thing, SetParameter):
        return thing.value == VALUE
    if isinstance(thing, dict):
        return any(isinstance(one, float) and one == VALUE for one in thing.values())
    if isinstance(thing, np.ndarray):
        return thing.ndim == 1 and bool((thing == VALUE).any())
    return isinstance(thing, tuple) and any(isinstance(one, float) and one == VALUE for one in thing)


@contextmanager
def followed(met: list[Met]) -> Iterator[None]:
    """Note each call within the game that is given the value."""
    root = Path(game.__file__).parent

    def called(frame: FrameType, what: str, _: object) -> None:
        file = Path(frame.f_code.co_filename)
        if what != "call" or root not in file.parents:
            return
        for argument in list(frame.f_locals.values()):
            if holds(argument):
                name = type(argument).__name__
                met.append(Met(str(file.relative_to(root)), frame.f_code.co_name, name))

    sys.setprofile(called)
    try:
        yield
    finally:
        sys.setprofile(None)


def gate_of(stage: Stage) -> Gate:
    errands = SimpleNamespace(in_background=False, act=lambda deed, name="": deed())
    record: Any = SimpleNamespace(stage=stage, script=None, errands=errands)
    host: Any = SimpleNamespace(tell=lambda *words: None)
    hand: Any = None
    return Gate(record, host, hand)


@pytest.fixture
def way() -> list[Met]:
    """All calls from the slider that sends the value to the end of the step that is made with it."""
    stage = Stage(LectureTable)
    stage.run(1)
    panel = Panel(Look(DARK), LectureTable)
    panel.place(pygame.Rect(960, 48, 320, 672), panel.look)
    panel.update(0.4, stage)
    (row,) = (one for one in panel._sheet.rows if isinstance(one, SliderRow) and one.follows == "restitution")
    gate, met = gate_of(stage), list[Met]()
    row.context = row.context._replace(send=gate.post)
    with followed(met):
        row._send(VALUE)
        stage.run(1)
    assert stage.scene.model.table.settings.restitution == VALUE
    return met


def test_it_goes_through_few_rooms_in_few_forms_and_is_checked_once(way: list[Met]) -> None:
    """The number itself in an event until the scene takes it, and in the method's settings from then on."""
    rooms = sorted({one.file for one in way})
    assert len(rooms) <= ROOMS, rooms
    assert {one.form for one in way} - {"float"} == {"SetParameter", "LectureSettings"}
    checks = [one.function for one in way if "check" in one.function and one.form == "float"]
    assert checks == ["check"] * CHECKS


def test_what_the_panel_and_the_level_say_of_it_is_what_the_method_declares() -> None:
    """Default, range, unit and help of each number stand beside the method; a scene may narrow the range."""
    shown, known = parameters_of(LectureTableParameters), declared(LectureSettings)
    for name in ("restitution", "bounce", "friction", "minimum_speed", "substeps", "passes"):
        parameter, setting = shown[name], known[name]
        assert parameter.default == LectureSettings._field_defaults[name]
        assert (parameter.help, parameter.unit, parameter.whole) == (
            setting.help, setting.unit, setting.whole,
        )  # fmt: skip
        assert setting.minimum <= parameter.minimum < parameter.maximum <= setting.maximum
    for name in ("rule", "order", "repositioning", "friction_law"):
        assert shown[name].options == known[name].words and shown[name].help == known[name].help


@pytest.mark.parametrize("value", [-0.1, 1.1, float("nan"), True, "much"])
def test_what_is_out_of_range_is_refused_where_it_comes_in(value: Any) -> None:
    stage = Stage(LectureTable)
    before = stage.scene.model.table.settings
    with pytest.raises(ParameterError, match="restitution"):
        stage.post(SetParameter("restitution", value))
    assert stage.scene.model.table.settings == before

"""Ruler, protractor, stop-watch and charts, by mouse and keys as a person would."""

from __future__ import annotations

import csv
import math
from pathlib import Path

import pygame
import pytest

from game.stage import Stage
from game.ui.charts.phase import Phase, points_of
from tests.app.tests_app import Driver


@pytest.fixture
def said(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What messages have said."""
    lines: list[str] = []
    monkeypatch.setattr(driver.app, "tell", lambda *words: lines.append(" ".join(words[:2])))
    return lines


def choose(driver: Driver, *titles: str) -> None:
    """Click the rows with these titles, each on a card of its own."""
    for title in titles:
        driver.frames(20)
        row = next(i for i, one in enumerate(driver.top.rows) if one.title == title)
        driver.click(*driver.top.spots.find(f"row-{row}").rect.center)
        driver.frames(20)


def take(driver: Driver, title: str):
    """An instrument by the key; it."""
    driver.key(pygame.K_F8)
    choose(driver, title)
    bench = driver.top.play.bench
    return bench.instruments[-1] if bench.instruments else bench.watch


def drag(driver: Driver, start, end) -> None:
    driver.move(*start)
    driver.button(True, *start)
    driver.post(pygame.Event(pygame.MOUSEMOTION, pos=end, rel=(1, 1), buttons=(1, 0, 0)))
    driver.button(False, *end)


def pixel(driver: Driver, x: float, y: float) -> tuple[int, int]:
    found = driver.top.play.view.camera.to_screen(x, y)
    return round(found[0] - 0.5), round(found[1] - 0.5)


@pytest.mark.parametrize("paused", [False, True])
@pytest.mark.parametrize("zoom", [0, 4, -3])
def test_the_ruler_measures_in_the_scenes_unit_under_any_zoom(driver: Driver, paused: bool, zoom: int):
    driver.open("example")
    if paused:
        driver.key(pygame.K_SPACE)
    ruler = take(driver, "Ruler")
    driver.wheel(zoom)
    driver.frames(90)
    camera = driver.top.play.view.camera
    for i, place in enumerate(((0.1, 0.2), (0.4, 0.6))):
        drag(driver, [round(c) for c in camera.to_screen(*ruler.points[i])], pixel(driver, *place))
    half = 1.0 / camera.scale  # a pixel's width
    assert ruler.length == pytest.approx(0.5, abs=2 * half)
    length = ruler.length
    driver.wheel(2)
    driver.frames(90)
    assert ruler.length == length and ruler.words("m").startswith(f"{1000 * length:.1f} mm")
    assert not driver.stage.scene.held  # nothing of it was told to the scene


def test_the_ruler_is_carried_by_its_strip_and_put_away_by_its_cross(driver: Driver):
    driver.open("example")
    ruler = take(driver, "Ruler")
    (x0, y0), (x1, y1) = ruler.seen(driver.top.play.view.camera)
    before = ruler.points
    middle = round(0.5 * (x0 + x1)), round(0.5 * (y0 + y1))
    drag(driver, middle, (middle[0] + 50, middle[1] - 30))
    scale = driver.top.play.view.camera.scale
    for (ax, ay), (bx, by) in zip(before, ruler.points, strict=True):
        assert (bx - ax, by - ay) == (pytest.approx(50 / scale), pytest.approx(30 / scale))
    assert ruler.length == pytest.approx(math.dist(*before))
    driver.frames()
    driver.click(*ruler.cross.center)
    assert not driver.top.play.bench.instruments


def test_shift_holds_the_ruler_to_whole_turns(driver: Driver, monkeypatch):
    driver.open("example")
    ruler = take(driver, "Ruler")
    monkeypatch.setattr(pygame.key, "get_mods", lambda: pygame.KMOD_SHIFT)
    ruler.points[:] = [(0.0, 0.0), (1.0, 0.0)]
    drag(driver, pixel(driver, 1.0, 0.0), pixel(driver, 1.0, 1.07))
    (_, _), (x, y) = ruler.points
    assert math.degrees(math.atan2(y, x)) == pytest.approx(45.0) and math.hypot(x, y) == pytest.approx(
        1.46, abs=0.02
    )


@pytest.mark.parametrize("zoom", [0, 5])
def test_the_protractor_shows_the_angle_between_its_arms(driver: Driver, zoom: int):
    driver.open("example")
    protractor = take(driver, "Protractor")
    driver.wheel(zoom)
    driver.frames(90)
    camera = driver.top.play.view.camera
    foot = protractor.points[0]
    reach = 100 / camera.scale
    for i, degrees in ((1, 10.0), (2, 130.0)):
        place = (
            foot[0] + reach * math.cos(math.radians(degrees)),
            foot[1] + reach * math.sin(math.radians(degrees)),
        )
        drag(driver, [round(c) for c in camera.to_screen(*protractor.points[i])], pixel(driver, *place))
    assert protractor.angle == pytest.approx(120.0, abs=0.9)
    angle = protractor.angle
    drag(driver, [round(c) for c in camera.to_screen(*foot)], pixel(driver, foot[0] - 0.2, foot[1] + 0.1))
    assert protractor.angle == pytest.approx(angle) and protractor.points[0] != foot
    assert protractor.words("m") == f"{angle:.1f}°"


def test_the_stop_watch_measures_simulated_time_in_slow_motion_and_by_steps(driver: Driver):
    driver.open("example")
    watch = take(driver, "Stop-watch")
    driver.frames()
    start = watch.rect.move(20, 0).midleft
    driver.stage.speed = 0.25
    driver.click(*start)
    begun = driver.stage.time_s
    driver.frames(60)
    driver.key(pygame.K_SPACE)
    shown = watch.seconds(driver.stage.time_s)
    assert shown == pytest.approx(driver.stage.time_s - begun, abs=0.02) and 0.2 < shown < 0.3
    for _ in range(3):
        driver.key(pygame.K_PERIOD)
    assert watch.seconds(driver.stage.time_s) == pytest.approx(shown + 3 * driver.stage.dt)
    driver.key(pygame.K_COMMA)
    assert watch.seconds(driver.stage.time_s) == pytest.approx(shown + 2 * driver.stage.dt)
    driver.click(*start)
    held = watch.seconds(driver.stage.time_s)
    assert held == pytest.approx(shown + 2 * driver.stage.dt)
    driver.key(pygame.K_SPACE)
    driver.frames(30)
    assert watch.seconds(driver.stage.time_s) == held and not watch.runs
    driver.click(*start)
    assert watch.runs and held < watch.seconds(driver.stage.time_s) < held + 0.05  # it goes on from there
    driver.frames(10)
    driver.app.perform("reset")
    driver.frames(2)
    assert watch.runs and watch.seconds(driver.stage.time_s) == pytest.approx(driver.stage.time_s)
    place = watch.rect.move(0, 0)
    drag(driver, (place.centerx, place.y + 2), (place.centerx + 100, place.y + 80))
    driver.frames()
    assert (watch.rect.centerx - place.centerx, watch.rect.y - place.y) == (
        pytest.approx(100, abs=2), pytest.approx(78, abs=24),
    )  # fmt: skip


def test_any_readout_goes_into_a_chart_by_the_sign_in_its_corner(driver: Driver):
    driver.open("example")
    driver.frames(60)
    strips = driver.top.shell.strips
    driver.click(*strips.spots.find("0").rect.center)
    choose(driver, "Height")
    assert [strip.series for strip in strips.strips] == [("height",)]
    driver.frames(20)
    assert strips.unit_shown(strips.strips[0]) == "m"
    driver.key(pygame.K_F5)
    choose(driver, "Energy")
    assert [strip.series for strip in strips.strips] == [("height",), ("energy",)]
    assert len(driver.top.shell.layout.charts) == 2
    driver.click(*strips.spots.find("1").rect.center)
    choose(driver, "Take this chart away")
    driver.click(*strips.spots.find("0").rect.center)
    choose(driver, "As the scene has them")
    assert strips.strips == strips.declared


def test_two_readouts_against_each_other_have_a_higher_row(driver: Driver):
    driver.open("example")
    driver.frames(60)
    before = driver.top.shell.layout.strips.h
    driver.key(pygame.K_F8)
    choose(driver, "Phase plot", "Height", "Energy")
    strips = driver.top.shell.strips
    assert strips.strips[-1] == Phase("height", "energy")
    assert driver.top.shell.layout.strips.h > before
    driver.frames(30)
    points = points_of(driver.stage.series, Phase("height", "energy"))
    heights, energies = (driver.stage.series.values(name) for name in ("height", "energy"))
    assert points.tolist() == [list(pair) for pair in zip(heights, energies, strict=True)]


def test_the_numbers_are_saved_as_they_are(driver: Driver, said):
    driver.open("example")
    driver.frames(90)
    driver.key(pygame.K_SPACE)
    driver.key(pygame.K_F8)
    choose(driver, "Save the numbers")
    driver.frames(3)
    (line,) = [one for one in said if one.startswith("Numbers saved ")]
    with Path(line.removeprefix("Numbers saved ")).open(newline="") as file:
        head, *rows = list(csv.reader(file))
    assert head == ["step", "time [s]", "energy [J/kg]", "height [m]"]
    series = driver.stage.series
    assert [int(row[0]) for row in rows] == series.steps.tolist()
    assert [float(row[3]) for row in rows] == series.values("height").tolist()
    again = Stage(driver.stage.scene_type)
    again.run(int(rows[40][0]))
    assert float(rows[40][3]) == again.readouts()[1].value


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (700, 420)])
@pytest.mark.parametrize("theme", ["dark", "light"])
def test_instruments_stay_within_the_stage(start, size, theme):
    driver = start(size=size, theme=theme)
    driver.open("example")
    for name in ("ruler", "protractor", "stop-watch"):
        driver.top.play.bench.toggle(name)
    driver.frames(3)
    bench, stage = driver.top.play.bench, driver.top.shell.layout.free_stage
    rects = [bench.instruments[0].label, bench.instruments[1].label, bench.watch.rect]
    assert all(stage.contains(rect) for rect in rects)

"""What accuracy costs, over a scene: runs in the background, is clicked, stopped, saved."""

from __future__ import annotations

import csv
import dataclasses
import math
import threading
from pathlib import Path

import pygame
import pytest

from game.app.scene import accuracy_card
from game.app.scene.accuracy_card import AccuracyCard
from game.app.scene.study_run import StudyRun, accuracy_data
from game.lab import Axes, Knob, Method, Outcome, Setting, Study
from game.ui.widgets.wishes import Wish
from tests.app.tests_app import Driver

STEPS = (0.1, 0.05, 0.02, 0.01, 0.005)


class Fake:
    """A trial whose error is the step to the power of the method's order; the largest step of one fails."""

    simulated_s = 1.0

    def __init__(self, setting: Setting, gate: threading.Event | None = None):
        self.setting = setting
        self.gate = gate

    def reset(self) -> None:
        pass

    def run(self) -> None:
        if self.gate is not None:
            assert self.gate.wait(600.0)
        sum(range(round(200.0 / self.setting.knob)))

    def outcome(self) -> Outcome:
        order = 2 if self.setting.method == "second" else 1
        failure = "diverged" if self.setting.knob == 0.1 and order == 2 else ""
        return Outcome(self.setting.knob**order, round(1.0 / self.setting.knob), failure)


def make_study(trial=Fake) -> Study:
    """Two methods of order 1 and 2, five steps each; the scene's gravity stands for the step."""
    return Study(
        name="fake",
        title="Fake",
        error="error of place",
        error_unit="m",
        counter="steps",
        knob=Knob("step", "step", "s"),
        methods=(Method("first", "First order", 1.0), Method("second", "Second order", 2.0)),
        settings=lambda: [
            Setting(method, step, scene={"gravity": 100.0 * step, "elsewhere": 1.0})
            for method in ("first", "second")
            for step in STEPS
        ],
        trial=trial,
        reference="closed form.",
        present=lambda parameters: Setting("first", parameters["gravity"] / 100.0),
    )


@pytest.fixture(autouse=True)
def no_tables(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(accuracy_card, "_tables", {})
    monkeypatch.setattr(accuracy_card, "_latest", [])


@pytest.fixture
def scene(driver: Driver, monkeypatch: pytest.MonkeyPatch) -> Driver:
    """The example scene with a study, its page open and the study done."""
    import example_scene

    monkeypatch.setattr(example_scene.BouncingBall, "study", make_study())
    driver.open()
    driver.key(pygame.K_a)
    driver.top.run.wait(600.0)
    driver.frames(40)
    return driver


def test_data_tell_orders_costs_and_the_present_setting():
    run = StudyRun(make_study(), {"gravity": 2.0})
    run.wait(600.0)
    assert run.error == ""
    assert not run.progress.running
    data = accuracy_data(run, "Title")
    assert [one.name for one in data.series] == ["First order", "Second order"]
    assert [one.order for one in data.series] == pytest.approx([1.0, 2.0])
    assert [sum(p.diverged for p in one.points) for one in data.series] == [0, 1]
    assert [row.expected for row in data.rows] == [1.0, 2.0]
    assert data.present is not None
    assert (data.present.series, data.present.point.y) == (0, 0.02)
    assert data.target == 1e-2  # the smallest round error that both reach
    assert all(math.isfinite(row.cost_s) for row in data.rows)
    assert all(point.parameters["gravity"] > 0.0 for one in data.series for point in one.points)


def test_study_without_any_rows_can_be_shown():
    gate = threading.Event()
    run = StudyRun(make_study(lambda setting: Fake(setting, gate)), {"gravity": 2.0})
    data = accuracy_data(run, "Title")
    assert math.isnan(data.target)
    assert data.sentence == ""
    run.stop()
    gate.set()
    run.wait(600.0)


def test_study_that_raises_says_so():
    def broken(setting: Setting) -> Fake:
        raise RuntimeError("no such trial")

    run = StudyRun(make_study(broken), {"gravity": 2.0})
    run.wait(600.0)
    assert run.error == "no such trial"
    assert "no such trial" in accuracy_data(run, "Title").notes


def test_page_opens_over_the_scene_and_closes(scene: Driver):
    assert isinstance(scene.top, AccuracyCard)
    assert scene.top.page.progress.done == 2 * len(STEPS)
    scene.key(pygame.K_ESCAPE)
    scene.frames(30)
    assert not isinstance(scene.top, AccuracyCard)
    scene.key(pygame.K_a)
    assert len(scene.top.run.table) == 2 * len(STEPS)  # what was measured is kept
    scene.frames(30)
    scene.key(pygame.K_a)
    scene.frames(30)
    assert not isinstance(scene.top, AccuracyCard)


def test_a_page_that_is_opened_again_waits_for_the_run_of_the_one_before(driver: Driver, monkeypatch):
    """Two at a time would spoil each other's times, and the first would put its own rows in place of all."""
    import example_scene

    begun, gate, inside = threading.Event(), threading.Event(), []

    def trial(setting: Setting) -> Fake:
        inside.append(threading.current_thread())
        begun.set()
        return Fake(setting, gate)

    monkeypatch.setattr(example_scene.BouncingBall, "study", make_study(trial))
    driver.open()
    driver.key(pygame.K_a)
    first = driver.top.run
    assert begun.wait(600.0)
    driver.key(pygame.K_a)
    driver.frames(30)
    driver.key(pygame.K_a)
    second = driver.top.run
    assert second is not first and second.table is first.table
    gate.set()
    second.wait(600.0)
    assert inside[0] is first._thread and {*inside[1:]} == {second._thread}
    assert first.error == second.error == ""
    assert len(second.table) == 2 * len(STEPS)


def test_click_on_a_point_sets_the_scene(scene: Driver):
    page = scene.top.page
    series = page.data.series[0]
    x, y = page.plot.place(0, series.points[0])
    scene.click(round(x) + page.overlay.card.x, round(y) + page.overlay.card.y)
    scene.frames(30)
    assert not isinstance(scene.top, AccuracyCard)
    assert scene.stage.scene.gravity == series.points[0].parameters["gravity"]
    assert scene.stage.recording.events[-1].event.name == "gravity"


def test_a_point_switches_effects_and_the_scene_finds_its_place_by_them(
    driver: Driver, monkeypatch: pytest.MonkeyPatch
):
    import example_scene

    def settings() -> list[Setting]:
        return [Setting("first", step, scene={"test-ground": step > 0.01}) for step in STEPS]

    seen = []

    def present(values) -> Setting:
        seen.append(values["test-ground"])
        return Setting("first", 0.05 if values["test-ground"] else 0.005)

    made = dataclasses.replace(make_study(), settings=settings, present=present)
    monkeypatch.setattr(example_scene.BouncingBall, "study", made)
    driver.open()
    driver.key(pygame.K_a)
    driver.top.run.wait(600.0)
    driver.frames(40)
    page = driver.top.page
    point = next(p for p in page.data.series[0].points if p.parameters == {"test-ground": False})
    x, y = page.plot.place(0, point)
    driver.click(round(x) + page.overlay.card.x, round(y) + page.overlay.card.y)
    driver.frames(30)
    assert "test-ground" not in driver.stage.scene.active
    driver.key(pygame.K_a)
    driver.top.run.wait(600.0)
    assert (seen[0], seen[-1]) == (True, False) and driver.top.run.present.knob == 0.005


def test_table_and_picture_are_saved(scene: Driver):
    scene.click(*scene.top.page.spots.find("save-csv").rect.center)
    with Path(scene.app.toasts.shown.consequence).open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 2 * len(STEPS)
    scene.app.toasts.clear()
    scene.click(*scene.top.page.spots.find("save-picture").rect.center)
    scene.app.pictures.wait()
    scene.frames(1)
    assert pygame.image.load(scene.app.toasts.shown.consequence).get_width() > 900


def test_what_cannot_be_saved_is_told(scene: Driver, monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setenv("CAROM_HOME", str(blocked))
    for name in ("save-csv", "save-picture"):
        scene.app.toasts.clear()
        scene.top.fulfil(Wish(name))
        assert scene.app.toasts.shown.cause == "Not saved."


def test_running_study_can_be_stopped_and_gone_on_with(driver: Driver, monkeypatch: pytest.MonkeyPatch):
    import example_scene

    gate = threading.Event()
    monkeypatch.setattr(example_scene.BouncingBall, "study", make_study(lambda setting: Fake(setting, gate)))
    driver.open()
    driver.key(pygame.K_a)
    driver.frames(30)
    assert driver.top.page.progress.running
    driver.click(*driver.top.page.spots.find("stop").rect.center)
    gate.set()
    driver.top.run.wait(600.0)
    driver.frames(30)
    assert not driver.top.page.progress.running
    assert len(driver.top.run.table) < 2 * len(STEPS)
    driver.key(pygame.K_ESCAPE)
    driver.frames(30)
    driver.key(pygame.K_a)
    driver.top.run.wait(600.0)
    assert driver.top.run.table.complete


def test_page_fits_small_and_large_windows(scene: Driver):
    for size in ((320, 240), (1, 1), (2560, 1440)):
        scene.resize(*size)
        scene.frames(2)
    assert isinstance(scene.top, AccuracyCard)


def test_a_tab_shows_and_measures_another_study(driver: Driver, monkeypatch: pytest.MonkeyPatch):
    import example_scene

    cost = {"name": "second", "title": "Second", "short": "Of cost", "axes": Axes("knob", "cpu")}
    second = dataclasses.replace(make_study(), **cost)
    family = dataclasses.replace(make_study(), short="Of error", related=(second,))
    monkeypatch.setattr(example_scene.BouncingBall, "study", family)
    driver.open()
    driver.key(pygame.K_a)
    driver.top.run.wait(600.0)
    driver.frames(40)
    page = driver.top.page
    assert page.data.studies == ("Of error", "Of cost") and page.data.study == 0
    assert page.data.title == "Fake"  # what it is measured on, whatever level is open
    first = driver.top.run.table
    driver.click(*page.spots.find("study-1").rect.center)
    driver.top.run.wait(600.0)
    driver.frames(40)
    assert (page.data.study, page.data.cost_words, page.data.axes.y) == (1, "least", "CPU time")
    assert page.progress.done == 2 * len(STEPS) and driver.top.run.table is not first
    driver.click(*page.spots.find("study-0").rect.center)
    driver.top.run.wait(600.0)
    driver.frames(40)
    assert page.data.study == 0 and driver.top.run.table is first

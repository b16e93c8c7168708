"""Set-ups that are levels: a key or the list opens the level, with camera, name, help, strips and clock."""

from __future__ import annotations

import pytest

from game.levels import level_files, load_level
from game.scenes import CATALOGUE
from game.stage import Action, SetParameter
from tests.app.tests_app import Driver


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    yield driver
    driver.close()


@pytest.mark.parametrize("event", [Action("arch"), SetParameter("setup", "arch")], ids=["key", "list"])
def test_a_set_up_opens_its_level(driver: Driver, event):
    play = driver.open("solver-race").play
    for name in ("sequential_impulses", "xpbd", "compliant_lagrangian"):
        play.post(SetParameter(f"with_{name}", False))
    driver.frames(20)
    before = play.view.camera.to_screen(0.0, 0.0)
    assert play.stage.step_number > 0 and play.stage.level.path.stem == "default"
    play.post(event)
    driver.frames(1)
    stage = play.stage
    assert stage.level.path.stem == "arch" and stage.scene.parameters.setup == "arch"
    assert play.level_words[0] == "An arch at its limit"
    assert stage.step_number <= 2  # clock and strips begin again
    assert stage.scene.model.solvers == ["soft-step"]  # what was chosen beside the set-up stays
    driver.frames(2)
    assert play.view.camera.to_screen(0.0, 0.0) != before
    frame = stage.scene.frame()
    place = play.shell.layout.free_stage
    for x, y in ((frame.left, frame.bottom), (frame.right, frame.top)):
        assert place.inflate(2, 2).collidepoint(play.view.camera.to_screen(x, y))


def test_every_set_up_has_its_level():
    scene_type = CATALOGUE["solver-race"].load()
    named = {load_level(path, "solver-race", None).parameters["setup"] for path in level_files("solver-race")}
    assert named == set(scene_type.parameter("setup").options) == {one.name for one in scene_type.actions}

"""A scene in its screen: every control and key."""

from pathlib import Path

import pygame
import pytest

from game.app.menu.screen import MenuScreen
from game.app.scene.help_card import HelpCard
from game.app.scene.play import SPEEDS
from game.app.screens.choices import ChoiceCard
from game.folders import pictures_folder
from game.levels import Level, save_level
from game.stage import Pointer, SetEffect, SetParameter
from game.stage.catalogue import Catalogue
from game.ui.panel.flow import LEVEL
from tests.app.tests_app import Driver, example_entry


@pytest.fixture
def scene(driver: Driver) -> Driver:
    driver.open()
    driver.frames(5)
    return driver


def world(driver: Driver, x: float, y: float) -> tuple[int, int]:
    px, py = driver.top.play.view.camera.to_screen(x, y)
    return round(px), round(py)


def test_scene_runs_in_real_time(scene: Driver):
    before = scene.stage.step_number
    scene.frames(60)
    assert scene.stage.step_number - before in (119, 120, 121)


def test_loading_screen_stands_until_the_scene_is_there(driver: Driver):
    driver.app.open_scene("example")
    driver.frames(3)
    driver.resize(700, 500)
    driver.key(pygame.K_SPACE)
    driver.click(24, 24)
    assert isinstance(driver.top, MenuScreen)


def test_pause_and_steps(scene: Driver):
    scene.key(pygame.K_SPACE)
    assert scene.stage.paused
    step = scene.stage.step_number
    scene.frames(10)
    assert scene.stage.step_number == step
    scene.key(pygame.K_PERIOD)
    assert scene.stage.step_number == step + 1
    digest = scene.stage.digest()
    scene.key(pygame.K_PERIOD)
    scene.key(pygame.K_COMMA)
    assert (scene.stage.step_number, scene.stage.digest()) == (step + 1, digest)
    scene.key(pygame.K_SPACE)
    scene.frames(2)
    assert not scene.stage.paused
    assert scene.stage.step_number > step + 1


def test_step_back_ends_at_the_beginning(scene: Driver):
    for _ in range(scene.stage.step_number + 3):
        scene.key(pygame.K_COMMA)
    assert scene.stage.step_number == 0
    assert scene.app.toasts.shown.cause == "No further back."


def test_speed(scene: Driver):
    for _ in range(10):
        scene.key(pygame.K_MINUS)
    assert scene.stage.speed == SPEEDS[0]
    for _ in range(10):
        scene.key(pygame.K_EQUALS)
    assert scene.stage.speed == SPEEDS[-1]
    scene.click(*scene.top.shell.bar.spots.find("speed").rect.center)
    assert scene.stage.speed == 1.0


def test_slow_running_is_told(scene: Driver):
    """Ten frames a second leave time for 15 steps each, 1.25 times real time, and no more."""
    bar = scene.top.shell.bar
    scene.frames(180)
    assert bar.state.reached is None
    usual = bar.spots.find("speed").tip
    scene.stage.speed = 4.0
    scene.frames(180)
    assert bar.state.reached is None, "it holds 4 times"
    scene.frames(30, seconds=0.1)
    assert bar.state.reached == pytest.approx(1.25, rel=0.02)
    assert bar.spots.find("speed").tip != usual
    scene.stage.speed = 1.0
    scene.frames(30, seconds=0.1)
    assert bar.state.reached is None
    assert bar.spots.find("speed").tip == usual
    scene.stage.speed = 4.0
    scene.frames(30, seconds=0.1)
    scene.key(pygame.K_SPACE)
    assert bar.state.reached is None, "what stands still is not slow"


def test_held_key_repeats_steps_but_not_pause(scene: Driver):
    def held(code: int, scancode: int) -> pygame.Event:
        return pygame.Event(pygame.KEYDOWN, key=code, scancode=scancode, mod=0, unicode="")

    scene.post(*(held(pygame.K_SPACE, pygame.KSCAN_SPACE) for _ in range(4)))
    assert scene.stage.paused
    step = scene.stage.step_number
    scene.post(*(held(pygame.K_PERIOD, pygame.KSCAN_PERIOD) for _ in range(4)))
    assert scene.stage.step_number == step + 4


@pytest.mark.parametrize(
    "name", ["pause", "step", "step-back", "reset", "slower", "faster", "help", "panel", "screenshot"]
)
def test_every_button_of_the_bar(scene: Driver, name: str):
    screen, stage = scene.top, scene.stage
    before = (stage.paused, stage.step_number, stage.speed, scene.app.settings.panel)
    scene.click(*screen.shell.bar.spots.find(name).rect.center)
    after = (stage.paused, stage.step_number, stage.speed, scene.app.settings.panel)
    assert after != before
    if name == "help":
        assert isinstance(scene.top, HelpCard)
    if name == "screenshot":
        scene.app.pictures.wait()
        scene.frames(1)
        assert scene.app.toasts.shown.cause == "Picture saved"
    if name == "reset":
        assert stage.step_number < 5


def test_back_to_the_menu(scene: Driver):
    scene.click(*scene.top.shell.bar.spots.find("menu").rect.center)
    assert isinstance(scene.top, MenuScreen)


def test_next_and_previous_scene(start):
    driver = start(catalogue=Catalogue(tuple(example_entry(name) for name in ("example", "second", "third"))))
    driver.app.open_scene("example")
    driver.key(pygame.K_PAGEDOWN)
    assert driver.top.entry.name == "second"
    driver.key(pygame.K_PAGEUP)
    driver.key(pygame.K_PAGEUP)
    assert driver.top.entry.name == "third"


def test_panel_on_and_off(scene: Driver):
    stage = scene.top.shell.layout.stage.w
    scene.key(pygame.K_TAB)
    assert scene.top.shell.layout.stage.w == 1280 > stage
    assert not scene.app.settings.panel
    scene.frames(2)
    scene.key(pygame.K_TAB)
    assert scene.top.shell.layout.stage.w == stage


def test_hand_reaches_the_scene_in_world_coordinates(scene: Driver):
    scene.key(pygame.K_SPACE)
    scene.button(True, *world(scene, 0.5, 1.0))
    assert scene.stage.scene.held
    assert scene.stage.scene.ball.position == pytest.approx([0.5, 1.0], abs=0.01)
    scene.move(*world(scene, -0.5, 1.5))
    assert scene.stage.scene.ball.position == pytest.approx([-0.5, 1.5], abs=0.01)
    scene.button(False, *world(scene, -0.5, 1.5))
    assert not scene.stage.scene.held


def test_escape_takes_a_drag_back_and_only_then_leaves(scene: Driver):
    scene.button(True, *world(scene, 0.5, 1.0))
    scene.key(pygame.K_ESCAPE)
    assert not scene.stage.scene.held
    assert scene.stage.recording.events[-1].event.kind == "cancel"
    scene.button(False, *world(scene, 0.5, 1.0))
    scene.key(pygame.K_ESCAPE)
    assert isinstance(scene.top, MenuScreen)


@pytest.mark.parametrize(
    "loss",
    [
        pygame.Event(pygame.WINDOWFOCUSLOST),
        pygame.Event(pygame.WINDOWMINIMIZED),
        pygame.Event(pygame.WINDOWSIZECHANGED, x=1280, y=720),
        pygame.Event(pygame.KEYDOWN, key=pygame.K_F1, scancode=pygame.KSCAN_F1, mod=0, unicode=""),
    ],
    ids=["focus", "minimized", "resized", "help"],
)
def test_what_interrupts_a_drag_takes_it_back(scene: Driver, loss: pygame.Event):
    stage = scene.stage
    scene.button(True, *world(scene, 0.5, 1.0))
    assert stage.scene.held
    scene.post(loss)
    assert not stage.scene.held


def test_hidden_window_draws_nothing(scene: Driver):
    scene.post(pygame.Event(pygame.WINDOWMINIMIZED))
    scene.window.surface.fill("pink")
    scene.frames(3)
    assert scene.window.surface.get_at((5, 5)) == pygame.Color("pink")
    scene.post(pygame.Event(pygame.WINDOWRESTORED))
    assert scene.window.surface.get_at((5, 5)) != pygame.Color("pink")


def test_wheel_zooms_and_middle_drag_pans(scene: Driver):
    camera = scene.top.play.view.camera
    scale, at = camera.scale, camera.to_world(400, 300)
    scene.move(400, 300)
    scene.wheel(3)
    scene.frames(200)
    assert camera.scale == pytest.approx(scale * 1.15**3)
    assert camera.to_world(400, 300) == pytest.approx(at, abs=0.5 / camera.scale)  # half a pixel
    center = camera.center
    scene.button(True, 400, 300, 2)
    scene.post(pygame.Event(pygame.MOUSEMOTION, pos=(450, 300), rel=(50, 0), buttons=(0, 1, 0)))
    scene.button(False, 450, 300, 2)
    assert camera.center[0] == pytest.approx(center[0] - 50 / camera.scale)
    scene.key(pygame.K_HOME)
    scene.frames(200)
    assert camera.scale == pytest.approx(scale)


def test_own_action_by_its_key(scene: Driver):
    scene.key(pygame.K_SPACE)
    speed = scene.stage.scene.ball.velocity[1]
    scene.key(pygame.K_k)
    assert scene.stage.scene.ball.velocity[1] == pytest.approx(speed + 3.0)


def test_parameter_by_the_panel_and_refused_value(scene: Driver):
    play = scene.top.play
    assert play.post(SetParameter("gravity", 5.0))
    assert not play.post(SetParameter("gravity", 1e9))
    assert scene.stage.scene.gravity == 5.0
    assert scene.app.toasts.shown.cause == "Not taken."
    assert "gravity" in scene.app.toasts.shown.consequence
    assert play.post(SetEffect("test-gravity", False))
    play.gate.set_defaults()
    assert scene.stage.scene.gravity == 9.81


def test_slider_is_dragged_with_the_mouse(scene: Driver):
    panel = scene.top.shell.layout.panel
    scene.key(pygame.K_SPACE)
    before = scene.stage.scene.gravity
    y = next(
        row.rect.y
        for row in scene.top.shell.panel._sheet.rows
        if getattr(getattr(row, "parameter", None), "name", "") == "gravity"
    )
    at = (panel.x + 160, panel.y + y + 28)
    scene.move(*at)
    scene.button(True, *at)
    scene.move(panel.x + 200, at[1])
    scene.move(300, 300)  # over the stage, still held by the panel
    scene.button(False, 300, 300)
    assert scene.stage.scene.gravity != before
    assert not any(
        isinstance(s.event, Pointer) and s.event.kind == "down" for s in scene.stage.recording.events
    )


def test_levels_are_opened_from_the_gallery(scene: Driver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    folder = tmp_path / "home" / "levels" / "example"
    good, bad = folder / "a-good.toml", folder / "b-bad.toml"
    save_level(
        Level(scene="example", title="High up", about="It falls far.", parameters={"height": 50.0}), good
    )
    bad.write_text('scene = "example"\ntitle = "Wrong"\n[parameters]\nheight = -1.0\n')
    scene.key(pygame.K_l)
    assert isinstance(scene.top, ChoiceCard)
    assert [row.title for row in scene.top.rows] == ["High up", "Wrong"]
    scene.frames(20)
    scene.key(pygame.K_RETURN)
    scene.frames(20)
    assert scene.stage.scene.height == 50.0
    scene.key(pygame.K_l)
    scene.frames(20)
    scene.key(pygame.K_DOWN)
    scene.key(pygame.K_RETURN)
    scene.frames(20)
    assert scene.stage.scene.height == 50.0
    scene.frames(400)
    messages = [toast.cause for toast in scene.app.toasts._queue]
    assert messages == [] or "Not opened." in messages


def save(scene: Driver) -> None:
    """Save, by the title that is offered."""
    scene.key(pygame.K_s, pygame.KMOD_LCTRL)
    scene.key(pygame.K_RETURN)
    scene.frames(20)


def level_in_panel(scene: Driver) -> str:
    """The level that the panel's list shows."""
    scene.frames(2)
    return scene.top.shell.panel._sheet.menus[LEVEL].selected_option[0]


def test_the_panel_shows_the_saved_level_that_was_opened(scene: Driver):
    save(scene)
    (saved,) = (row for row in scene.top.play.shelf.saved() if row.chip == "level")
    assert level_in_panel(scene) != saved.title
    scene.key(pygame.K_o, pygame.KMOD_LCTRL)
    scene.top.pressed(f"row-{[row.value for row in scene.top.rows].index(saved.value)}")
    scene.frames(20)
    assert scene.stage.level.path == saved.value
    assert level_in_panel(scene) == saved.title


def test_the_panel_shows_the_level_of_a_file_from_elsewhere(scene: Driver, tmp_path: Path):
    save_level(Level(scene="example", title="High up"), tmp_path / "high.toml")
    save(scene)  # without any level there is no list of them
    scene.top.play.open_file(tmp_path / "high.toml")
    assert level_in_panel(scene) == "High up"


def test_broken_level_is_told_with_file_field_and_reason(scene: Driver, tmp_path: Path):
    bad = tmp_path / "bad.toml"
    bad.write_text('scene = "example"\n[parameters]\nheight = -1.0\n')
    scene.top.play.open_file(bad)
    toast = scene.app.toasts.shown
    assert toast.cause == "Not opened."
    assert all(word in toast.consequence for word in ("bad.toml", "height", "outside"))
    assert scene.stage.scene.height == 1.0


def test_saved_session_is_found_and_replayed(scene: Driver):
    scene.button(True, *world(scene, 0.5, 1.0))
    scene.button(False, *world(scene, 0.6, 1.2))
    scene.frames(30)
    save(scene)
    assert scene.app.toasts.shown.cause == "Saved"
    recording = scene.stage.recording
    scene.key(pygame.K_o, pygame.KMOD_LCTRL)
    row = next(row for row in scene.top.rows if row.chip == "recording")
    scene.top.pressed(f"row-{scene.top.rows.index(row)}")
    scene.frames(20, seconds=0.011)
    while scene.stage.step_number < recording.steps:
        scene.frames(1, seconds=0.0037)
    assert not scene.top.play.record.repeating
    while scene.stage.step_number > recording.steps:
        scene.key(pygame.K_COMMA)
    assert scene.stage.digest() == recording.digest


def save_screenshot(scene: Driver) -> None:
    """Press the key, and wait for the thread that writes."""
    scene.key(pygame.K_F12)
    scene.app.pictures.wait()
    scene.frames(1)


def test_screenshot_is_written_and_named(scene: Driver):
    save_screenshot(scene)
    path = Path(scene.app.toasts.shown.consequence)
    picture = pygame.image.load(str(path))
    assert picture.get_size() == (1280, 720)
    assert path.name.startswith("carom-bouncing-ball-")
    save_screenshot(scene)
    assert len(list(path.parent.iterdir())) == 2


def test_screenshot_that_cannot_be_written_is_told(
    scene: Driver, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
):
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setenv("CAROM_HOME", str(blocked))
    scene.key(pygame.K_F12)
    assert scene.app.toasts.shown.cause == "No picture."


def test_a_picture_that_fails_while_it_is_written_is_told_and_leaves_nothing(
    scene: Driver, monkeypatch: pytest.MonkeyPatch
):
    def full(surface, path):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("game.app.window.pictures.write_png", full)
    save_screenshot(scene)
    assert scene.app.toasts.shown.cause == "No picture."
    assert "No space left" in scene.app.toasts.shown.consequence
    assert list(pictures_folder().iterdir()) == []


def test_state_that_is_not_finite_stops_and_reset_begins_anew(scene: Driver):
    scene.stage.scene.ball.position[1] = float("nan")
    scene.frames(3)
    assert scene.stage.fault is not None
    banner = scene.top.play.banner
    assert "position" in banner.text
    step = scene.stage.step_number
    scene.frames(10)
    assert scene.stage.step_number == step
    scene.click(*banner.spots.find("reset").rect.center)
    scene.frames(3)
    assert scene.stage.fault is None
    assert banner.text == ""
    assert 0 < scene.stage.step_number < 20


def test_what_is_under_a_card_stands_still(scene: Driver):
    stage, step = scene.stage, scene.stage.step_number
    scene.key(pygame.K_F1)
    scene.frames(60)
    assert stage.step_number == step
    scene.key(pygame.K_F1)
    scene.frames(30)
    assert step < stage.step_number < step + 60


def test_window_drag_of_ten_seconds_makes_no_huge_step(scene: Driver):
    step = scene.stage.step_number
    scene.frames(1, seconds=10.0)
    assert 0 < scene.stage.step_number - step <= scene.stage.clock.max_steps
    assert scene.stage.dropped_s > 0.5


def test_full_screen(scene: Driver):
    scene.key(pygame.K_F11)
    assert scene.app.window.full_screen
    scene.frames(2)
    scene.key(pygame.K_F11)
    assert not scene.app.window.full_screen


def test_quit(scene: Driver):
    scene.key(pygame.K_q, pygame.KMOD_LCTRL)
    assert not scene.app.running


def test_window_close_ends_the_loop(driver: Driver):
    driver.waiting.append(pygame.Event(pygame.QUIT))
    driver.loop.run()
    assert len(driver.app.screens) == 0


def test_study_that_is_not_there_is_told(scene: Driver):
    scene.key(pygame.K_a)
    assert scene.app.toasts.shown.cause == "No study."


@pytest.mark.parametrize("size", [(1, 1), (2, 600), (320, 240), (700, 500), (1920, 1080), (2560, 1440)])
def test_scene_fits_any_window(scene: Driver, size: tuple[int, int]):
    for theme in range(2):
        scene.resize(*size)
        scene.frames(3)
        assert scene.window.surface.get_size() == size
        if theme == 0:
            scene.key(pygame.K_F2)
    scene.key(pygame.K_F1)
    scene.frames(3)


def test_panel_by_keyboard_alone(scene: Driver):
    scene.key(pygame.K_SPACE)
    scene.key(pygame.K_TAB, pygame.KMOD_LSHIFT)
    assert scene.top.shell.panel.has_keys
    before = scene.stage.scene.gravity
    scene.key(pygame.K_RIGHT)
    raised = scene.stage.scene.gravity
    scene.key(pygame.K_LEFT)
    assert before < raised > scene.stage.scene.gravity
    scene.key(pygame.K_SPACE)
    assert not scene.stage.paused


def test_number_is_typed_and_letters_are_no_commands_meanwhile(scene: Driver):
    scene.key(pygame.K_SPACE)
    scene.key(pygame.K_TAB, pygame.KMOD_LSHIFT)
    scene.key(pygame.K_RETURN)
    assert scene.top.shell.panel.typing
    scene.type("3.5")
    scene.key(pygame.K_l)
    scene.key(pygame.K_RETURN)
    assert scene.stage.scene.gravity == 3.5
    assert not scene.top.shell.panel.typing
    scene.key(pygame.K_l)
    assert isinstance(scene.top, ChoiceCard)


def test_pause_card_does_what_is_chosen(scene: Driver):
    scene.frames(120)
    step = scene.stage.step_number
    scene.key(pygame.K_p)
    scene.frames(20)
    scene.key(pygame.K_DOWN)
    scene.key(pygame.K_RETURN)
    scene.frames(30)
    assert scene.stage.step_number < step
    scene.key(pygame.K_p)
    scene.frames(20)
    scene.key(pygame.K_UP)
    scene.key(pygame.K_END)
    for _ in range(10):
        scene.key(pygame.K_DOWN)
    scene.key(pygame.K_RETURN)
    scene.frames(30)
    assert not scene.app.running


def test_a_tool_tip_does_not_stay_under_a_card(scene: Driver):
    shell = scene.top.shell
    scene.move(*shell.bar.spots.find("help").rect.center)
    scene.frames(60)
    clean = pygame.Surface(scene.window.size, 0, 32)
    shown = clean.copy()
    shell.tip.draw(shown)
    assert pygame.image.tobytes(shown, "RGB") != pygame.image.tobytes(clean, "RGB")
    scene.key(pygame.K_F1)
    assert isinstance(scene.top, HelpCard)
    shown = clean.copy()
    shell.tip.draw(shown)
    assert pygame.image.tobytes(shown, "RGB") == pygame.image.tobytes(clean, "RGB")

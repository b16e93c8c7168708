"""The billiard game in its window: drawn in every phase and size, kept and gone on with, heard."""

import numpy as np
import pygame
import pytest

from game.app.scene.keeping import kept_path
from game.app.stagehand.opening import Opening
from game.billiards.table.rack import BALL_RADIUS
from game.scenes import CATALOGUE
from game.scenes.billiards import layout
from game.stage import Action, Decision, SetParameter
from tests.app.tests_app import Driver


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    driver = Driver(tmp_path, catalogue=CATALOGUE)
    yield driver
    driver.close()


def pixel(driver: Driver, x: float, y: float) -> tuple[int, int]:
    px, py = driver.top.play.view.camera.to_screen(x, y)
    return round(px), round(py)


def break_off(driver: Driver) -> None:
    """A hard break by mouse, skipped to its end."""
    x, y = driver.stage.scene.model.frame.cue_ball
    driver.move(*pixel(driver, x + 0.01, y + 1.0))
    driver.button(True, *pixel(driver, x + 0.01, y + 1.0))
    driver.move(*pixel(driver, x + 0.01, y + 0.6))
    driver.button(False, *pixel(driver, x + 0.01, y + 0.6))
    driver.frames(8, 0.08)
    assert driver.stage.scene.play.phase == "rolling"
    driver.key(pygame.K_RETURN)
    driver.frames(2)


def drawn(driver: Driver) -> np.ndarray:
    """The picture, which could be drawn."""
    driver.frames(2)
    assert driver.top.play.trouble == ""
    return pygame.surfarray.array3d(driver.window.surface)


def test_the_table_has_all_of_the_window_until_the_panel_is_asked_for(driver):
    driver.open("billiards")
    lay = driver.top.shell.layout
    assert lay.panel.w == 0 and lay.strips.h == 0 and driver.app.settings.panel
    driver.app.perform("panel")
    lay = driver.top.shell.layout
    assert lay.panel.w > 0 and lay.strips.h > 0 and driver.app.settings.panel_in_games


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_a_ball_is_11_5_px_wide_at_720_lines_and_nothing_of_the_window_lies_on_the_table(driver, size):
    driver.open("billiards")
    driver.resize(*size)
    driver.frames(2)
    scale = driver.top.play.view.camera.scale
    assert BALL_RADIUS * scale == pytest.approx(11.5 * size[1] / 720, abs=0.15)
    lay, bar = driver.top.shell.layout, driver.top.shell.bar
    corners = [
        driver.top.play.view.camera.to_screen(*corner)
        for corner in (
            (layout.TABLE.top, layout.TABLE.left),
            (layout.TABLE.bottom, layout.TABLE.right),
            (layout.BOARD.top, layout.card_box(0).left),
            (layout.BOARD.bottom, layout.card_box(1).right),
        )
    ]
    (left, top), (right, bottom), board, board_end = corners
    table = pygame.Rect(left, top, right - left, bottom - top)
    cards = pygame.Rect(*board, board_end[0] - board[0], board_end[1] - board[1])
    assert driver.window.surface.get_rect().contains(table.union(cards))
    assert not table.colliderect(lay.hint_bar) and not table.colliderect(cards)
    assert bar.slim and bar.spots.find("pause") is None
    for spot in bar.spots.spots:
        assert not table.colliderect(spot.rect) and not cards.colliderect(spot.rect)


def test_no_letter_round_the_table_is_below_11_px_with_the_panel_open(driver, monkeypatch):
    driver.open("billiards")
    driver.app.perform("panel")
    driver.frames(2)
    sizes = []
    font = pygame.font.Font
    monkeypatch.setattr(pygame.font, "Font", lambda path, px: sizes.append(px) or font(path, px))
    driver.app.toggle_theme()  # all is drawn anew
    driver.frames(3)
    assert driver.top.play.view.camera.scale < 0.75 * layout.PIXELS and sizes and min(sizes) >= 11


def test_between_the_buttons_over_the_table_a_press_is_the_games_own(driver):
    driver.open("billiards")
    before = driver.stage.scene.parameters.second_player
    driver.click(*pixel(driver, *layout.card_box(1).middle))
    assert driver.stage.scene.parameters.second_player != before
    driver.click(*driver.top.shell.bar.spots.find("panel").rect.center)
    driver.frames(2)
    assert driver.top.shell.layout.panel.w > 0 and not driver.top.shell.bar.slim
    assert driver.top.shell.bar.spots.find("pause") is not None


def test_escape_closes_an_open_list_before_it_leaves(driver):
    driver.open("billiards")
    driver.app.perform("panel")
    driver.frames(3)
    panel = driver.top.shell.panel
    box = panel._sheet.menus["second_player"].rect.move(panel.view.topleft).move(0, -panel.scroll)
    driver.click(*box.center)
    driver.frames(3)
    assert panel.has_open_list
    scene = driver.top
    driver.key(pygame.K_ESCAPE)
    driver.frames(3)
    assert driver.top is scene and not panel.has_open_list
    driver.key(pygame.K_ESCAPE)
    driver.frames(3)
    assert driver.top is not scene


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (700, 500), (400, 900)])
def test_every_phase_is_drawn_at_every_size(driver, size):
    driver.open("billiards")
    driver.resize(*size)
    pictures = [drawn(driver)]
    stage = driver.stage
    for event in (
        Decision("white", (0.4, 0.4)), SetParameter("tip_up", -0.4), SetParameter("elevation", 35.0),
        Decision("stroke", (5.0, 1.5, 0.1, 0.1, -0.2, -1.0, -1.0, 0.0, 0.0)),
    ):  # fmt: skip
        stage.post(event)
        pictures.append(drawn(driver))
    driver.frames(40, 0.1)
    assert stage.scene.play.phase == "rolling"
    pictures.append(drawn(driver))
    stage.post(Action("strike"))
    for event in (Action("replay"), Action("replay"), Action("set-up"), Action("set-up"), Action("view")):
        stage.post(event)
        pictures.append(drawn(driver))
    stage.post(Action("rack"))
    stage.post(Decision("stroke", (0.7, 1.57, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0)))
    driver.frames(40, 0.1)
    stage.post(Action("strike"))
    assert stage.scene.model.frame.game.options
    pictures.append(drawn(driver))
    driver.app.toggle_theme()
    pictures.append(drawn(driver))
    assert len({picture.tobytes() for picture in pictures}) >= 9  # two looks at the same are alike


def test_a_game_goes_on_after_the_program_was_closed_and_n_begins_a_new_one(driver, tmp_path):
    driver.open("billiards")
    break_off(driver)
    places, game = driver.stage.scene.model.frame.layout.places, driver.stage.scene.model.frame.game
    driver.app.open_menu()
    again = Driver(tmp_path, catalogue=CATALOGUE)
    again.open("billiards")
    assert again.app.toasts.shown.cause == "Your game goes on."
    assert (
        again.stage.scene.model.frame.layout.places == places and again.stage.scene.model.frame.game == game
    )
    again.key(pygame.K_n)
    assert again.stage.scene.model.frame.game.opening
    again.close()


def test_a_kept_game_that_cannot_be_read_costs_a_line(driver):
    kept_path("billiards").parent.mkdir(parents=True, exist_ok=True)
    kept_path("billiards").write_text("scene = 'billiards'\n[content]\nballs = 7\n")
    driver.app.open_scene("billiards", opening=Opening())
    for _ in range(4):
        if driver.top.loader is not None:
            driver.top.loader.wait(300.0)
        driver.frames(2)
    assert driver.top.play is not None and driver.stage.scene.model.frame.game.opening
    assert "cannot be read" in driver.app.toasts.shown.cause


def test_strokes_are_heard_and_the_state_knows_nothing_of_it(driver, monkeypatch):
    heard = []
    player = driver.app.sounds
    player._ready = True
    monkeypatch.setattr(player, "_play", lambda samples: heard.append(len(samples)))
    driver.open("billiards")
    driver.stage.post(Decision("stroke", (5.0, 1.5, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0)))
    driver.frames(70, 0.1)
    assert len(heard) > 3
    loud = driver.stage.digest()
    player.volume = 0.0
    other = driver.stage.recording
    from game.stage import replay

    assert replay(other, CATALOGUE).digest() == loud
    player._ready = False


@pytest.mark.parametrize(("key", "phase"), [(pygame.K_r, "replay"), (pygame.K_e, "set-up")])
def test_escape_ends_a_replay_or_the_set_up_and_only_then_leaves_for_the_menu(driver, key, phase):
    driver.open("billiards")
    break_off(driver)
    assert driver.stage.scene.play.phase == "aiming"
    before = driver.stage.scene.model.frame.layout.places
    driver.key(key)
    driver.frames(2)
    assert driver.stage.scene.play.phase == phase
    driver.key(pygame.K_ESCAPE)
    driver.frames(2)
    assert driver.top.play is not None and driver.stage.scene.play.phase == "aiming"
    assert driver.stage.scene.model.frame.layout.places == before
    driver.key(pygame.K_ESCAPE)
    driver.frames(2)
    assert getattr(driver.top, "play", None) is None


def test_the_arrow_of_the_bar_leaves_for_the_menu_at_once(driver):
    driver.open("billiards")
    driver.stage.post(Action("set-up"))
    driver.frames(2)
    assert driver.stage.scene.play.phase == "set-up"
    driver.click(*driver.top.shell.bar.spots.find("menu").rect.center)
    driver.frames(2)
    assert getattr(driver.top, "play", None) is None


def test_the_volume_is_a_setting(driver, tmp_path):
    from game.app.window.settings import load_settings

    driver.app.cards.open_settings()
    driver.frames(20)
    spot = driver.top.spots.find("volume-0.25")
    driver.click(*spot.rect.center)
    assert driver.app.settings.volume == driver.app.sounds.volume == 0.25
    assert load_settings(tmp_path).settings.volume == 0.25


def test_random_hands_in_the_window(driver):
    random = np.random.default_rng(5)
    driver.open("billiards")
    keys = [pygame.K_RETURN, pygame.K_u, pygame.K_r, pygame.K_e, pygame.K_v, pygame.K_n, pygame.K_ESCAPE,
            pygame.K_d, pygame.K_1, pygame.K_UP, pygame.K_SPACE, pygame.K_COMMA]  # fmt: skip
    worth = [layout.button_box(row).middle for row in range(4)]
    for _ in range(150):
        if driver.top.__class__.__name__ != "SceneScreen":
            driver.open("billiards")
        chance = random.random()
        if chance < 0.3:
            driver.key(int(random.choice(keys)))
        elif chance < 0.5:
            driver.click(*pixel(driver, *worth[random.integers(len(worth))]))
        else:
            x, y = int(random.integers(1280)), int(random.integers(60, 680))
            driver.move(x, y)
            driver.button(bool(random.random() < 0.5), x, y)
        driver.frames(int(random.integers(1, 4)))
        if getattr(driver.top, "play", None) is not None:
            assert driver.top.play.trouble == ""


def test_the_right_button_sets_spin_and_a_click_locks_the_aim(driver):
    driver.open("billiards")
    scene = driver.stage.scene
    x, y = scene.model.frame.cue_ball
    driver.move(*pixel(driver, x + 0.05, y + 1.0))
    driver.click(*pixel(driver, x + 0.05, y + 1.0))
    driver.frames(2)
    aim = scene.aiming.cue.aim
    assert scene.aiming.locked
    start = pixel(driver, 0.4, 1.6)
    driver.button(True, *start, 3)
    driver.move(start[0], start[1] + 12)
    driver.frames(2)
    driver.button(False, start[0], start[1] + 12, 3)
    driver.frames(2)
    assert scene.parameters.tip_up < -0.2 and scene.aiming.cue.aim == aim and scene.play.phase == "aiming"


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_the_tour_leaves_free_the_line_that_says_what_to_do(driver, size):
    driver.open("billiards")
    driver.resize(*size)
    camera = driver.top.play.view.camera
    driver.app.perform("tour")
    driver.frames(2)
    left, top = camera.to_screen(layout.FOOT.top, layout.FOOT.left)
    right, bottom = camera.to_screen(layout.FOOT.bottom, layout.FOOT.right)
    line = pygame.Rect(round(left), round(top), round(right - left), round(bottom - top))
    assert driver.top.stop.part == "stage" and line.w > 300 and not driver.top.card.colliderect(line)

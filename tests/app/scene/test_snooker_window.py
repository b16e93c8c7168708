"""Snooker in its window: drawn in every phase, nominated and chosen by the mouse."""

import numpy as np
import pygame
import pytest

from game.billiards.table.snooker import BALL_RADIUS, BLACK
from game.scenes import CATALOGUE
from game.scenes.snooker import layout
from game.stage import Action
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


def click(driver: Driver, x: float, y: float) -> None:
    driver.move(*pixel(driver, x, y))
    driver.button(True, *pixel(driver, x, y))
    driver.button(False, *pixel(driver, x, y))
    driver.frames(2)


def drawn(driver: Driver) -> np.ndarray:
    """The picture, which could be drawn."""
    driver.frames(2)
    assert driver.top.play.trouble == ""
    return pygame.surfarray.array3d(driver.window.surface)


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080)])
def test_table_and_board_have_all_of_the_window_and_nothing_lies_on_them(driver, size):
    driver.open("snooker")
    driver.resize(*size)
    drawn(driver)
    scale = driver.top.play.view.camera.scale
    assert BALL_RADIUS * scale > 7.5 * size[1] / 720
    lay, bar = driver.top.shell.layout, driver.top.shell.bar
    left, top = pixel(driver, layout.TABLE.top, layout.TABLE.left)
    right, bottom = pixel(driver, layout.TABLE.bottom, layout.TABLE.right)
    table = pygame.Rect(left, top, right - left, bottom - top)
    x, y = pixel(driver, layout.BOARD.top, layout.card_box(0).left)
    end_x, end_y = pixel(driver, layout.BOARD.bottom, layout.card_box(1).right)
    cards = pygame.Rect(x, y, end_x - x, end_y - y)
    assert driver.window.surface.get_rect().contains(table.union(cards))
    assert not table.colliderect(lay.hint_bar) and not table.colliderect(cards)
    for spot in bar.spots.spots:
        assert not table.colliderect(spot.rect) and not cards.colliderect(spot.rect)


def test_a_stroke_by_the_mouse_options_and_a_choice(driver):
    driver.open("snooker")
    scene = driver.stage.scene
    before = drawn(driver)
    x, y = scene.model.frame.cue_ball
    for pressed, way in ((None, 1.0), (True, 1.0), (None, 0.9), (None, 0.75), (False, 0.75)):
        at = pixel(driver, x - 0.3 * way, y + way)
        driver.move(*at) if pressed is None else driver.button(pressed, *at)
    driver.frames(8, 0.08)
    assert scene.course.phase == "rolling"
    drawn(driver)
    driver.key(pygame.K_RETURN)
    driver.frames(2)
    assert scene.course.phase == "aiming" and scene.model.frame.strokes == 1
    assert (drawn(driver) != before).any()
    if scene.model.game.options:  # the aim passed the reds
        click(driver, *layout.option_box(0, len(scene.model.game.options)).middle)
    assert not scene.model.game.options


def test_a_colour_is_nominated_by_its_chip_and_the_magnifier_comes_where_balls_are_small(driver):
    driver.open("snooker")
    scene = driver.stage.scene
    scene.model.frame = scene.model.frame.replace(
        game=type(scene.model.game)(stage="colour", opening=False, in_hand="")
    )
    plain = drawn(driver)
    click(driver, *layout.chip_place(BLACK))
    assert scene.course.call.ball == BLACK
    assert (drawn(driver) != plain).any()
    driver.stage.post(Action("concede"))
    driver.frames(2)
    assert drawn(driver).shape == plain.shape

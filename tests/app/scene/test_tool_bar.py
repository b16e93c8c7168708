"""The bar of tools and the card of a body on the stage, by pointer and keys; undo of what is done there."""

from __future__ import annotations

import pygame
import pytest

from game.app.scene.keeping import presses
from game.scenes import CATALOGUE
from tests.app.tests_app import Driver

SIZES = [(1280, 720), (1920, 1080), (900, 600)]


def opened(start, scene: str, size: tuple[int, int], level: str = "Empty sheet") -> Driver:
    driver = start(catalogue=CATALOGUE, size=size, toured=True)
    driver.open(scene)
    path = next(row.value for row in driver.top.play.shelf.levels() if row.title == level)
    driver.top.play.open_file(path)
    driver.frames(5)
    return driver


def pixel(driver: Driver, x: float, y: float) -> tuple[int, int]:
    px, py = driver.top.play.view.camera.to_screen(x, y)
    return round(px), round(py)


def drag(driver: Driver, start: tuple[int, int], end: tuple[int, int]) -> None:
    driver.move(*start)
    driver.button(True, *start)
    driver.move((start[0] + end[0]) // 2, (start[1] + end[1]) // 2)
    driver.move(*end)
    driver.button(False, *end)
    driver.frames(2)


def built(driver: Driver) -> int:
    return len(driver.stage.scene.model.movable())


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("scene", ["solids", "tracks"])
def test_each_tool_is_chosen_by_its_button_within_the_stage(start, scene, size):
    driver = opened(start, scene, size)
    bar, stage = driver.top.shell.tools, driver.top.shell.layout.free_stage
    assert stage.contains(bar.rect) and len(bar.spots.spots) == len(driver.stage.scene.tool_bar())
    for button in bar.buttons:
        spot = bar.spots.find(button.action)
        assert bar.rect.contains(spot.rect)
        driver.click(*spot.rect.center)
        driver.frames(2)
        assert driver.stage.scene.parameters.tool == button.action
        assert [one.action for one in bar.buttons if one.chosen] == [button.action]
    assert not presses(driver.stage)  # nothing of it reached the stage


def test_each_tool_is_chosen_by_its_key(start):
    driver = opened(start, "solids", SIZES[0])
    for button in driver.stage.scene.tool_bar():
        driver.key(getattr(pygame, f"K_{button.key.lower()}"))
        driver.frames(2)
        assert driver.stage.scene.parameters.tool == button.action


def test_a_tool_under_the_pointer_says_what_it_does_and_its_key(start):
    driver = opened(start, "solids", SIZES[0])
    bar = driver.top.shell.tools
    driver.move(*bar.spots.find("weld").rect.center)
    driver.frames(2)
    words, _ = bar.tip()
    assert words == "Weld: click where two overlap (W)"


def test_a_density_is_dragged_on_the_card_and_undone_as_one_deed(start):
    driver = opened(start, "solids", SIZES[0])
    drag(driver, pixel(driver, -2.0, 0.2), pixel(driver, -1.0, 1.2))
    assert built(driver) == 1
    driver.frames(40)
    driver.click(*pixel(driver, -1.5, 0.5), button=3)
    driver.frames(3)
    scene, card = driver.stage.scene, driver.top.shell.card
    body, world = scene.hand.inspected, scene.model.world
    assert card.rect.w and scene.inspected() is not None
    mass = 1.0 / float(world.bodies.inverse_masses[body])
    row = next(row for row in card._sheet.rows if row.follows == "own_density")
    px = driver.app.look.px
    y = card.rect.bottom - card._sheet.height + row.rect.y + px(26)
    drag(driver, (card.rect.x + px(40), y), (card.rect.x + px(170), y))
    heavier = 1.0 / float(driver.stage.scene.model.world.bodies.inverse_masses[body])
    assert heavier > 20.0 * mass
    assert heavier == pytest.approx(mass * scene.values["own_density"], rel=1e-9)
    driver.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    driver.frames(2)
    scene = driver.stage.scene
    assert 1.0 / float(scene.model.world.bodies.inverse_masses[body]) == mass
    assert scene.values["own_density"] == 1.0 and built(driver) == 1


def test_the_cross_of_the_card_closes_it(start):
    driver = opened(start, "solids", SIZES[0])
    drag(driver, pixel(driver, -2.0, 0.2), pixel(driver, -1.0, 1.2))
    driver.frames(40)
    driver.click(*pixel(driver, -1.5, 0.5), button=3)
    driver.frames(3)
    card, px = driver.top.shell.card, driver.app.look.px
    driver.click(card.rect.right - px(17), card.rect.y + px(17))
    driver.frames(3)
    assert driver.stage.scene.inspected() is None and not card.rect.w


def test_keys_are_letters_while_a_number_is_typed_on_the_card(start):
    driver = opened(start, "solids", SIZES[0])
    drag(driver, pixel(driver, -2.0, 0.2), pixel(driver, -1.0, 1.2))
    driver.frames(40)
    driver.click(*pixel(driver, -1.5, 0.5), button=3)
    driver.frames(3)
    card = driver.top.shell.card
    row = next(row for row in card._sheet.rows if row.follows == "own_density")
    top, number = card.rect.bottom - card._sheet.height + row.rect.y, row.value_rect().center
    driver.click(card.rect.x + number[0], top + number[1])
    driver.frames(2)
    assert card.typing
    driver.type("12.5")
    driver.key(pygame.K_RETURN)
    driver.frames(2)
    assert driver.stage.scene.values["own_density"] == 12.5
    assert driver.stage.scene.parameters.tool == "box"


def test_deleting_by_key_is_undone(start):
    driver = opened(start, "solids", SIZES[0])
    drag(driver, pixel(driver, -2.0, 0.2), pixel(driver, -1.0, 1.2))
    driver.key(pygame.K_DELETE)
    driver.frames(2)
    assert built(driver) == 0
    driver.key(pygame.K_z, mod=pygame.KMOD_CTRL)
    driver.frames(2)
    assert built(driver) == 1


def test_a_scene_without_tools_has_no_bar(start):
    driver = start(catalogue=CATALOGUE, toured=True)
    driver.open("pendulum")
    driver.frames(3)
    assert driver.top.shell.tools.tip() is None and not driver.top.shell.tools.covers((480, 530))

"""The lessons in the window: a star is kept, and a key or a button goes on to the next one."""

import pygame

from game.app.stagehand.level_index import lessons_of, next_lesson
from game.app.stagehand.stars import kept_stars
from game.scenes import CATALOGUE
from game.scenes.billiards import layout
from game.stage import Action
from tests.app.tests_app import Driver


def present(driver: Driver) -> str:
    return driver.stage.level.path.stem


def test_key_and_button_go_on_and_stars_are_kept_under_each_lesson(start):
    driver = start(catalogue=CATALOGUE)
    heads = lessons_of("billiards")
    assert len(heads) == 5 and next_lesson(heads) == heads[0]
    driver.app.open_scene("billiards", level=heads[0].path)
    driver.top.loader.wait(300.0)
    driver.frames(2)
    for name in ("lesson-1-stop", "lesson-2-follow"):
        assert present(driver) == name
        scene = driver.stage.scene
        scene.aiming.aim_as(scene.model.content.solution.stroke())
        driver.stage.post(Action("strike"))
        driver.frames(60 * 8, shown=False)
        assert kept_stars("billiards")[name].won == 3
        if name == "lesson-1-stop":
            driver.key(pygame.K_o)
        else:
            rows = [row[0] for row in scene.buttons.rows()]
            x, y = layout.button_box(rows.index("lesson")).middle
            driver.click(*(round(v) for v in driver.top.play.view.camera.to_screen(x, y)))
        driver.frames(60)
    assert present(driver) == "lesson-3-draw"
    assert next_lesson(lessons_of("billiards")).path.stem == "lesson-3-draw"

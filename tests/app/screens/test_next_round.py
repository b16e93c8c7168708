"""After a match of a cup the table itself leads to the next round, and never to a match beside the cup."""

import msgspec
import pytest

from game.app.screens.career_card import CareerCard
from game.app.stagehand.career_file import keep_career, read_career
from game.app.stagehand.career_opening import begin_match
from game.billiards.career.career import Career, Player
from game.billiards.career.matches import cup_match, new_cup
from game.scenes import CATALOGUE
from game.scenes.shared.tables.seats.cup import NEXT_ROUND, THE_CUP, after_match
from game.stage import Action
from tests.app.tests_app import Driver

LONGEST_S = 300.0
TABLES = [("nine-ball", "rack"), ("six-red", "rack"), ("straight-rail", "next")]


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    made = Driver(tmp_path, catalogue=CATALOGUE)
    made.frames(5)
    yield made
    made.close()


def loaded(driver):
    driver.frames(5)
    while driver.top.loader is not None:
        driver.top.loader.wait(LONGEST_S)
        driver.frames(2)
    return driver.stage.scene


def begun(driver, game):
    """The first match of a cup at its table."""
    player = new_cup(Player("Mia"), game, seed=3)
    match = begin_match(Career((player,)), cup_match(player))
    driver.app.open_scene(match.scene, opening=match.opening)
    return loaded(driver)


def end(driver, won):
    """End the match as if its last stroke had."""
    scene = driver.stage.scene
    frame, winner = scene.model.frame, int(not won)
    score = (10, 4) if won else (4, 10)
    changes = {"winner": winner}
    if hasattr(frame.game, "ended"):
        changes |= {"points": score, "ended": True}
    else:
        changes |= {"won": (3, 0) if won else (0, 3), "turn": winner}
    scene.model.frame = frame.replace(game=msgspec.structs.replace(frame.game, **changes))
    assert scene.contest.over
    driver.frames(3)
    return scene


@pytest.mark.parametrize(("game", "action"), TABLES)
def test_the_table_leads_to_the_next_round(driver, game, action):
    first = begun(driver, game)
    assert not after_match(first.course)
    opponent = first.parameters.second_player
    end(driver, won=True)
    assert after_match(first.course) == NEXT_ROUND
    driver.stage.post(Action(action))
    driver.frames(3)
    second = loaded(driver)
    player = read_career().player
    assert second is not first and player.cup.knockout.round_name == "Semi-final"
    assert second.parameters.second_player == cup_match(player).opponent != opponent
    assert player.pending == cup_match(player) and second.contest.over is False
    assert second.save_content().cup == "Semi-final"


@pytest.mark.parametrize(("game", "action"), TABLES)
def test_a_cup_that_is_lost_leads_to_the_card_and_racks_nothing(driver, game, action):
    scene = begun(driver, game)
    end(driver, won=False)
    assert after_match(scene.course) == THE_CUP
    driver.stage.post(Action(action))
    driver.frames(5)
    assert isinstance(driver.top, CareerCard)
    assert [cup.reached for cup in read_career().player.cups] == [0]
    assert scene.contest.over, "no match beside the cup has begun"


def test_a_cup_with_fair_starts_goes_on_with_them(driver):
    player = new_cup(Player("Mia"), "straight-rail", seed=3)
    fair = player.replace(cup=msgspec.structs.replace(player.cup, fair=True))
    start = cup_match(fair).head_start
    assert start > 0 == cup_match(player).head_start
    match = begin_match(Career((fair,)), cup_match(fair))
    assert match.opening.parameters["head_start"] == start
    driver.app.open_scene(match.scene, opening=match.opening)
    loaded(driver)
    end(driver, won=True)
    driver.stage.post(Action("next"))
    driver.frames(3)
    scene, after = loaded(driver), read_career().player
    assert scene.contest.head_start == cup_match(after).head_start != 0


def test_a_match_outside_of_a_cup_is_followed_by_another_one(driver):
    keep_career(Career((Player("Mia"),)))
    driver.app.cards.open_career()
    driver.frames(30)
    driver.top._take_game("straight-rail")
    driver.top.begin()
    scene = loaded(driver)
    end(driver, won=True)
    assert not after_match(scene.course)
    driver.stage.post(Action("next"))
    driver.frames(5)
    assert driver.stage.scene is scene and not scene.contest.over

"""After a match of a cup the table itself leads to the next round, and never to a match beside the cup."""

from types import SimpleNamespace

import msgspec
import pytest

from game.app.screens.career_card import CareerCard
from game.app.stagehand.career_file import keep_career, read_career
from game.app.stagehand.career_opening import begin_match
from game.billiards.career.career import Career, Player
from game.billiards.career.matches import cup_match, new_cup
from game.scenes import CATALOGUE
from game.scenes.billiards.view.standing import standing_of as pool_standing
from game.scenes.carom.view.score_board import counted_of as carom_card
from game.scenes.shared.tables.seats.cup import FINAL, NEXT_ROUND, THE_CUP, after_match, with_round, won_with
from game.scenes.snooker.view.words import counted_of as snooker_card
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
    assert won_with(first.course, "rack") == "quarter-final"
    driver.stage.post(Action(action))
    driver.frames(3)
    second = loaded(driver)
    player = read_career().player
    assert second is not first and player.cup.knockout.round_name == "Semi-final"
    assert second.parameters.second_player == cup_match(player).opponent != opponent
    assert player.pending == cup_match(player) and second.contest.over is False
    assert second.save_content().cup == "Semi-final"
    if game == "nine-ball":
        assert pool_standing(second.play, second.opponents.thinker).caption == "Semi-final, to 3"
    assert won_with(second.course, "rack") == "rack"


def test_the_round_is_said_in_a_cup_alone():
    played = [
        SimpleNamespace(model=SimpleNamespace(content=SimpleNamespace(cup=cup))) for cup in ("", "Final")
    ]
    assert [with_round("points, race to 50", one) for one in played] == ["points, race to 50", "Final, to 50"]
    assert with_round("best of 3", played[1]) == "Final, best of 3"


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


@pytest.mark.parametrize("game", ["nine-ball", "six-red", "straight-rail"])
def test_the_last_match_wins_the_cup_and_says_so(driver, game):
    scene = begun(driver, game)
    scene.model.content = msgspec.structs.replace(scene.model.content, cup=FINAL)
    end(driver, won=True)
    assert won_with(scene.course, "rack") == "cup" and after_match(scene.course) == THE_CUP
    titles = {"six-red": snooker_card, "straight-rail": carom_card}
    if game in titles:
        assert titles[game](scene.course).title == "Mia wins the cup"


def test_a_cup_is_played_as_the_person_has_chosen(driver):
    chosen = {"stroke_by": "push", "their_strokes": "fast", "table": "tight", "second_player": "master"}
    driver.app.settings.start = {"billiards": chosen}
    keep_career(Career((new_cup(Player("Mia"), "nine-ball", seed=3),)))
    driver.app.open_next_round()
    scene = loaded(driver)
    settings = scene.parameters
    assert (settings.stroke_by, settings.their_strokes) == ("push", "fast")
    assert settings.table == "match", "tight pockets are not unlocked yet"
    assert settings.second_player == cup_match(read_career().player).opponent and settings.race == "3"


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

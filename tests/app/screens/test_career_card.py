"""The card of a career: a name is asked for once, a match begins at its table, its result comes back."""

import itertools

import msgspec
import pygame
import pytest

from game.app.screens.career_card import CareerCard
from game.app.screens.career_parts import paint_cups, unrated
from game.app.screens.career_prizes import prize_words
from game.app.screens.choices import ChoiceCard
from game.app.screens.name_card import NameCard
from game.app.stagehand.career_file import career_path, keep_career, read_career
from game.billiards.career.career import Career, CupResult, Match, Player, Result, counted
from game.billiards.career.matches import cup_match, new_cup, opponents_at
from game.billiards.career.prizes import PRIZES
from game.billiards.game.register import REGISTER
from game.scenes import CATALOGUE
from game.stage import Action
from tests.app.tests_app import Driver

LONGEST_S = 300.0


@pytest.fixture
def driver(tmp_path, monkeypatch):
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    made = Driver(tmp_path, catalogue=CATALOGUE)
    made.frames(5)
    yield made
    made.close()


def press(driver, name):
    driver.click(*driver.top.spots.find(name).rect.center)
    driver.frames(15)


def opened(driver):
    driver.frames(5)
    while driver.top.loader is not None:
        driver.top.loader.wait(LONGEST_S)
        driver.frames(2)
    return driver.stage.scene


def test_a_name_is_asked_for_once_and_kept(driver):
    driver.key(pygame.K_k, pygame.KMOD_CTRL)
    driver.frames(30)
    assert isinstance(driver.top, NameCard)
    driver.type("Mia")
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    assert isinstance(driver.top, CareerCard)
    assert driver.top.heading == "Career of Mia"
    assert read_career().player.name == "Mia"
    driver.key(pygame.K_ESCAPE)
    driver.frames(30)
    driver.app.cards.open_career()
    driver.frames(30)
    assert isinstance(driver.top, CareerCard)


def test_the_header_of_the_menu_opens_it_and_all_games_are_there(driver):
    keep_career(Career((Player("Mia"),)))
    driver.click(*driver.top.header.spots.find("career").rect.center)
    driver.frames(30)
    card = driver.top
    assert isinstance(card, CareerCard)
    press(driver, "game")
    assert isinstance(driver.top, ChoiceCard)
    assert [row.value for row in driver.top.rows] == list(REGISTER)
    driver.key(pygame.K_ESCAPE)
    driver.frames(30)
    card._take_game("six-red")
    assert card.opponent == opponents_at("six-red")[0].name
    strongest = opponents_at("six-red")[-1].name
    press(driver, f"opponent={strongest}")
    assert card.match == Match("six-red", strongest)
    press(driver, "start")
    assert card.match.head_start > 0
    driver.key(pygame.K_TAB)
    assert card.spots.focused is not None


def test_a_match_begins_at_its_table_and_its_result_comes_back(driver):
    keep_career(Career((Player("Mia"),)))
    driver.app.cards.open_career()
    driver.frames(30)
    driver.top._take_game("nine-ball")
    press(driver, "opponent=greta")
    driver.key(pygame.K_RETURN)
    scene = opened(driver)
    assert read_career().player.pending == Match("nine-ball", "greta")
    assert scene.model.frame.game.players == ("Mia", "Greta Lind")
    assert (scene.parameters.second_player, scene.parameters.race) == ("greta", "3")
    seen = scene.contest
    assert (seen.game, seen.person, seen.opponent, seen.over) == ("nine-ball", "Mia", "greta", False)
    frame = scene.model.frame
    scene.model.frame = frame.replace(game=msgspec.structs.replace(frame.game, won=(1, 3), winner=1, turn=1))
    assert scene.contest.over
    driver.frames(3)
    player = read_career().player
    assert [(one.won, one.lost, one.victory) for one in player.results] == [(1, 3, False)]
    assert player.pending is None
    before = career_path().read_text()
    driver.frames(5)
    assert career_path().read_text() == before


def test_a_tournament_is_begun_and_won_in_the_window(driver):
    keep_career(Career((Player("Mia"),)))
    driver.app.cards.open_career()
    driver.frames(30)
    driver.top._take_game("three-cushion")
    press(driver, "cup")
    assert isinstance(driver.top, ChoiceCard)
    driver.key(pygame.K_DOWN)
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    for _ in range(3):
        if not isinstance(driver.top, CareerCard):
            driver.app.open_menu()
            driver.frames(5)
            driver.app.cards.open_career()
            driver.frames(30)
        match = cup_match(read_career().player)
        assert driver.top.match == match
        driver.top.begin()
        scene = opened(driver)
        assert scene.parameters.second_player == match.opponent
        frame = scene.model.frame
        over = msgspec.structs.replace(frame.game, points=(10, 4), ended=True, winner=0, high_runs=(5, 1))
        scene.model.frame = frame.replace(game=over)
        driver.frames(3)
    player = read_career().player
    assert [cup.reached for cup in player.cups] == [3]
    assert [one.highest for one in player.results] == [5, 5, 5]
    assert player.cup is None


def test_a_match_that_was_not_agreed_upon_does_not_count(driver):
    keep_career(Career((Player("Mia", pending=Match("nine-ball", "greta")),)))
    driver.app.open_scene("carom", opening=None)
    driver.frames(3)
    assert read_career().player.results == ()


def test_the_card_says_what_is_unlocked_and_what_unlocks_the_next():
    player = Player("Mia")
    assert prize_words(player) == ["0 of 7", "Next: blue cloth", "win a match"]
    player = player.replace(unlocked=("blue cloth",))
    assert prize_words(player)[1:] == [
        "Next: fast pool cloth",
        "beat two of the pool ladder without a start (0 of 2)",
    ]
    player = player.replace(unlocked=tuple(one.name for one in PRIZES))
    assert prize_words(player) == ["7 of 7, such as slate cloth", "Nothing is locked any more."]


@pytest.mark.parametrize("start", [2, -2])
def test_matches_that_do_not_count_are_not_called_none(start: int):
    match = Match("straight-rail", "ines", start)
    played = Player("Ana", results=(Result(match, "2026-01-01T10:00:00", 0, 1, False),))
    assert unrated(Player("Ana"))[0] == "no match yet"
    assert unrated(played)[0] == "not rated yet" and "do not count" in unrated(played)[1]
    assert not counted(played.results)


def test_a_tournament_may_be_played_with_fair_head_starts(driver):
    """The choice stays with the tournament: its match is begun with the start, and counts for it."""
    keep_career(Career((Player("Mia"),)))
    driver.app.cards.open_career()
    driver.frames(15)
    card = driver.top
    card._take_game("straight-rail")
    press(driver, "cup")
    driver.key(pygame.K_DOWN)
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    level = card.match
    assert level is not None and level.cup and level.head_start == 0
    press(driver, "start")
    fair = card.match
    assert fair == msgspec.structs.replace(level, head_start=fair.head_start)
    assert fair.head_start != 0 and card.in_cup
    press(driver, "play")
    assert read_career().player.pending == fair


def test_the_first_tournament_of_a_career_is_that_of_newcomers(driver):
    """It is what Enter takes; two short matches win it, and then the tournament of eight comes first."""
    keep_career(Career((Player("Mia"),)))
    driver.app.cards.open_career()
    driver.frames(30)
    assert driver.top.game == "eight-ball"
    press(driver, "cup")
    driver.key(pygame.K_RETURN)
    driver.frames(30)
    for round_name in ("Semi-final", "Final"):
        player = read_career().player
        assert player.cup.newcomers and player.cup.knockout.round_name == round_name
        if round_name == "Semi-final":
            driver.top.begin()
        else:
            driver.stage.post(Action("rack"))
            driver.frames(3)
        scene = opened(driver)
        assert scene.parameters.race == "1" and not scene.contest.over
        assert scene.parameters.second_player in [one.name for one in opponents_at("eight-ball")[:3]]
        frame = scene.model.frame
        won = msgspec.structs.replace(frame.game, won=(1, 0), winner=0, turn=0)
        scene.model.frame = frame.replace(game=won)
        driver.frames(3)
    player = read_career().player
    assert [(cup.reached, cup.newcomers) for cup in player.cups] == [(3, True)]
    assert "slate cloth" not in player.unlocked and "olive cloth" not in player.unlocked
    driver.app.cards.open_career()
    driver.frames(30)
    press(driver, "cup")
    assert driver.top.rows[driver.top.focus].value == "eight"


@pytest.mark.parametrize("newcomers", [True, False])
def test_lines_of_the_shelf_stand_below_each_other_and_say_what_was_won(driver, monkeypatch, newcomers):
    player = new_cup(Player("Mia"), "nine-ball", seed=3, newcomers=newcomers)
    when = "2026-01-02T03:04:05"
    cups = (CupResult("six-red", when, 1, newcomers=True), CupResult("six-red", when, 3, newcomers=True))
    player = player.replace(cups=cups)
    look, lines = driver.app.look, []
    monkeypatch.setattr(
        type(look), "text", lambda self, picture, words, at, *_: lines.append((round(at[1]), words))
    )
    area = pygame.Rect(0, 0, look.px(319), look.px(420))
    paint_cups(pygame.Surface((400, 500)), look, area, player)
    heights = sorted({height for height, _ in lines})
    assert [height for height, _ in lines] == sorted(height for height, _ in lines)
    assert min(after - one for one, after in itertools.pairwise(heights)) >= look.px(18)
    assert [words for _, words in lines[-2:]] == [
        "Newcomers' cup, Six-red snooker, 2026-01-02", "Newcomers' cup, Six-red snooker: semi-final"
    ]  # fmt: skip

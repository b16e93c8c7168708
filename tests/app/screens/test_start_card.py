"""The card before a game: what is chosen there holds, is remembered, and Enter plays."""

from collections.abc import Callable

import numpy as np
import pygame
import pytest

from game.app.menu.screen import MenuScreen
from game.app.scene.keeping import kept_path
from game.app.scene.screen import SceneScreen
from game.app.scene.tour import TourScreen
from game.app.screens.level_card import LevelCard, level_picture
from game.app.screens.name_card import NameCard
from game.app.screens.start_card import StartCard
from game.app.stagehand.career_file import keep_career, read_career
from game.app.stagehand.stars import Stars, keep_stars
from game.app.window.settings import load_settings
from game.billiards.career.career import Career, Player
from game.billiards.table.table import Table
from game.scenes import CATALOGUE
from game.scenes.billiards.card import TO_PEN
from game.ui.look.look import Look
from game.ui.look.theme import THEMES
from tests.app.tests_app import Driver

LONGEST_S = 300.0


@pytest.fixture
def begin(tmp_path, monkeypatch):
    """Starts programs that stand before the card of billiards."""
    monkeypatch.setenv("CAROM_HOME", str(tmp_path))
    drivers: list[Driver] = []

    def make(**settings) -> Driver:
        drivers.append(Driver(tmp_path, catalogue=CATALOGUE, **settings))
        drivers[-1].app.open_scene("billiards")
        drivers[-1].frames(20)
        return drivers[-1]

    yield make
    for driver in drivers:
        driver.close()


def press(driver: Driver, name: str) -> None:
    """Click a place of the card."""
    driver.click(*driver.top.spots.find(name).rect.center)
    driver.frames(2)


def opened(driver: Driver):
    """The scene, once it is there."""
    while driver.top.loader is not None:
        driver.top.loader.wait(LONGEST_S)
        driver.frames(2)
    return driver.stage.scene


def test_every_choice_is_one_that_the_scene_takes():
    for entry in CATALOGUE:
        parameters = entry.load().declared_parameters() if entry.start else {}
        for line in entry.start_lines():
            assert line.default in dict(line.options)
            for value, _ in line.options:
                assert parameters[line.parameter].check(value) == value


def test_enter_plays_against_a_computer_with_the_guide_to_the_first_ball(begin: Callable[..., Driver]):
    driver = begin()
    assert isinstance(driver.top, StartCard)
    driver.key(pygame.K_RETURN)
    scene = opened(driver)
    assert isinstance(driver.top, SceneScreen)
    chosen = scene.parameters
    assert (chosen.first_player, chosen.second_player, chosen.game) == ("person", "novice", "eight-ball")
    assert scene.play.guide == "first" and scene.play.racks_to_win == 1


def test_what_was_chosen_is_the_next_default(begin: Callable[..., Driver]):
    driver = begin()
    for name in ("second_player=master", "game=nine-ball", "race=5", "guide=none", "hand=average", "play"):
        press(driver, name)
    scene = opened(driver)
    chosen = scene.parameters
    assert (chosen.second_player, chosen.race, chosen.guide, chosen.hand) == (
        "master",
        "5",
        "none",
        "average",
    )
    assert type(scene.model.frame.game).__name__ == "NineBall"
    kept = load_settings(driver.app.folder).settings
    again = begin(start=kept.start)
    assert again.top.chosen == driver.app.settings.start["billiards"]
    assert again.top.chosen["second_player"] == "master" and again.top.chosen["race"] == "5"


def test_each_person_of_a_career_keeps_what_is_its_own(begin: Callable[..., Driver]):
    keep_career(Career((Player("Mia"), Player("Jo")), 0))
    driver = begin()
    for name in ("second_player=master", "stroke_by=push", "hand=average", "play"):
        press(driver, name)
    kept = load_settings(driver.app.folder).settings.start
    mia, jo = read_career().players
    assert mia.choices["billiards"]["hand"] == "average" and jo.choices == {}
    assert "second_player" not in mia.choices["billiards"], "who plays against it is no trait of a person"
    keep_career(Career((mia, jo), 1))
    again = begin(start=kept)
    press(again, "hand=steady")
    press(again, "play")
    assert read_career().players[0] == mia
    assert read_career().players[1].choices["billiards"]["hand"] == "steady"
    keep_career(Career(read_career().players, 0))
    third = begin(start=load_settings(again.app.folder).settings.start)
    assert third.top.chosen["hand"] == "average" and third.top.chosen["stroke_by"] == "push"
    assert third.top.chosen["second_player"] == "master"


def test_a_remembered_choice_that_there_is_no_more_gives_way_to_the_default(begin: Callable[..., Driver]):
    driver = begin(start={"billiards": {"second_player": "wizard", "race": "3", "gone": "x"}})
    assert driver.top.chosen["second_player"] == "novice" and driver.top.chosen["race"] == "3"
    assert "gone" not in driver.top.chosen


def test_practice_has_no_opponent_to_be_chosen(begin: Callable[..., Driver]):
    driver = begin()
    press(driver, "game=practice")
    press(driver, "second_player=master")
    assert driver.top.chosen["second_player"] == "novice"
    press(driver, "play")
    scene = opened(driver)
    assert len(scene.model.frame.game.players) == 1
    assert driver.top.play.trouble == ""


@pytest.mark.parametrize("way", ["escape", "cross"])
def test_the_way_back_is_the_menu(begin: Callable[..., Driver], way: str):
    driver = begin()
    if way == "escape":
        driver.key(pygame.K_ESCAPE)
    else:
        press(driver, "close")
    driver.frames(2)
    assert isinstance(driver.top, MenuScreen)


def test_a_game_under_way_can_be_gone_on_with(begin: Callable[..., Driver]):
    driver = begin()
    assert driver.top.spots.find("go-on") is None
    driver.key(pygame.K_RETURN)
    scene = opened(driver)
    stroke = scene.aiming.stroke
    scene.play.begin_stroke(stroke, scene.aiming.call)
    driver.frames(20, 0.08)
    driver.key(pygame.K_RETURN)
    driver.frames(2)
    places = scene.model.frame.layout.places
    driver.app.open_menu()
    assert kept_path("billiards").exists()
    again = begin()
    press(again, "go-on")
    again.frames(30)
    scene = opened(again)
    assert scene.model.frame.layout.places == places
    assert again.app.toasts.shown.cause == "Your game goes on."


def test_a_kept_game_that_cannot_be_read_is_not_offered(begin: Callable[..., Driver]):
    driver = begin()
    driver.app.open_menu()
    kept_path("billiards").parent.mkdir(parents=True, exist_ok=True)
    kept_path("billiards").write_text("scene = 'billiards'\n[content]\nballs = 7\n")
    again = begin()
    scene_below = again.app.screens.visible()[0]
    for _ in range(3):
        if scene_below.loader is not None:
            scene_below.loader.wait(LONGEST_S)
        again.frames(2)
    assert again.top.spots.find("go-on") is None
    again.key(pygame.K_RETURN)
    assert opened(again).model.frame.game.opening


def test_the_levels_stand_in_groups_with_pictures_and_stars(begin: Callable[..., Driver]):
    driver = begin()
    keep_stars("billiards", "trick-02-plant", Stars(2, 3))
    press(driver, "levels")
    card = driver.top
    assert isinstance(card, LevelCard)
    titles = [title for title, _ in card.groups]
    assert titles == [
        "Games", "The first ten minutes", "Against the ghost", "Drills in sets", "Drills", "Trick shots",
        "Hard cases",
    ]  # fmt: skip
    plant = next(tile.head for tile in card.tiles if tile.head.path.stem == "trick-02-plant")
    assert plant.stars == "★★☆"
    driver.frames(len(card.tiles) + 20)
    shown = {bytes(pygame.image.tobytes(card.shown(tile.head.path), "RGB")) for tile in card.tiles}
    assert len(shown) > 25  # racked games look alike
    driver.key(pygame.K_END)
    assert card.focus == len(card.tiles) - 1
    driver.key(pygame.K_HOME)
    assert card.focus == 0
    for _ in range(6):
        driver.key(pygame.K_DOWN)
    chosen = card.tiles[card.focus].head.path
    assert chosen.stem.startswith("drill-")
    driver.key(pygame.K_RETURN)
    driver.frames(2)
    opened(driver)
    assert driver.stage.level.path == chosen


def test_the_picture_of_a_level_has_the_balls_where_they_lie(tmp_path):
    level = tmp_path / "own.toml"
    level.write_text(
        'scene = "billiards"\n[content]\ngame = "practice"\n'
        "balls = [{ number = 0, position = [1.0, 0.3] }, { number = 1, position = [0.2, 2.3] }]"
    )
    pygame.font.init()
    size = (320, 173)
    picture = level_picture(CATALOGUE["billiards"], level, size, Look(THEMES["dark"], 1.0))
    rgb = pygame.surfarray.array3d(picture).astype(int)
    yellow = (rgb[..., 0] > 200) & (rgb[..., 1] > 150) & (rgb[..., 2] < 110)
    x, y = (float(rows.mean()) for rows in np.nonzero(yellow))
    # the table's middle is the picture's; its length of 2.54 m lies across
    scale = 2.0 * TO_PEN
    assert x == pytest.approx(160.0 + scale * (2.3 - 1.27), abs=3.0)
    assert y == pytest.approx(86.4 + scale * (0.2 - 0.635), abs=3.0)


def test_a_level_that_cannot_be_read_has_the_picture_of_its_scene(tmp_path):
    broken = tmp_path / "broken.toml"
    broken.write_text("scene = 'billiards'\n[content]\nballs = 7\n")
    pygame.font.init()
    picture = level_picture(CATALOGUE["billiards"], broken, (160, 86), Look(THEMES["dark"], 1.0))
    assert picture.get_size() == (160, 86)
    gone = level_picture(CATALOGUE["billiards"], tmp_path / "gone.toml", (160, 86), Look(THEMES["dark"], 1.0))
    assert pygame.image.tobytes(gone, "RGB") == pygame.image.tobytes(picture, "RGB")


def test_a_level_in_play_leads_to_the_same_list(begin: Callable[..., Driver]):
    driver = begin()
    driver.key(pygame.K_RETURN)
    opened(driver)
    driver.app.perform("levels")
    driver.frames(20)
    assert isinstance(driver.top, LevelCard)
    tile = next(tile for tile in driver.top.tiles if tile.head.path.stem == "practice")
    place = next(
        spot for spot in driver.top.spots.spots if spot.name == f"level-{driver.top.tiles.index(tile)}"
    )
    driver.click(*place.rect.center)
    driver.frames(30)
    assert driver.stage.level.path == tile.head.path


def test_the_tour_does_not_come_between_a_person_and_the_first_game(begin: Callable[..., Driver]):
    driver = begin()
    driver.app.tour_due = True
    driver.key(pygame.K_RETURN)
    opened(driver)
    driver.frames(150)
    assert not isinstance(driver.top, TourScreen) and driver.app.tour_due


@pytest.mark.parametrize("size", [(1280, 720), (1920, 1080), (700, 500), (400, 900)])
def test_nothing_is_cut_off_at_any_size(begin: Callable[..., Driver], size: tuple[int, int]):
    driver = begin()
    driver.resize(*size)
    driver.frames(4)
    card = driver.top.veil.card
    rects = [spot.rect for spot in driver.top.spots.spots]
    assert all(card.contains(rect) for rect in rects)
    assert all(not a.colliderect(b) for i, a in enumerate(rects) for b in rects[:i])


def test_what_the_career_has_not_unlocked_is_told_and_not_chosen(begin: Callable[..., Driver]):
    driver = begin(start={"billiards": {"felt": "slate", "table": "tight"}})
    card = driver.top
    assert (card.chosen["felt"], card.chosen["table"]) == ("house", "match")
    said = []
    card.host.tell = lambda *words: said.append(words)
    press(driver, "felt=olive")
    assert card.chosen["felt"] == "house"
    assert said == [("Olive cloth is locked.", "In the career reach a final.")]


def test_what_the_career_has_unlocked_is_played_on(begin: Callable[..., Driver], tmp_path):
    keep_career(Career((Player("Mia", unlocked=("olive cloth", "tight pool")),)))
    driver = begin()
    press(driver, "felt=olive")
    press(driver, "table=tight")
    press(driver, "play")
    scene = opened(driver)
    assert (scene.parameters.felt, scene.parameters.table) == ("olive", "tight")
    assert (scene.model.frame.table.jaws == Table.pool(tight=True).jaws).all()


@pytest.mark.parametrize("name", ["billiards", "carom", "snooker"])
def test_no_choice_is_cut_off_and_the_card_leads_to_the_career(begin: Callable[..., Driver], name: str):
    driver = begin()
    driver.app.open_menu()
    driver.app.open_scene(name)
    driver.frames(20)
    card, fonts = driver.top, driver.app.look.fonts
    for line in card.rows:
        places = [card.spots.find(f"{line.parameter}={value}").rect for value, _ in line.options]
        for (_, words), place, after in zip(line.options, places, [*places[1:], None], strict=True):
            inner = place.w - 2 * driver.app.look.px(2)
            assert fonts.fit(words, 13, "semibold", inner) == words
            assert after is None or after.x == place.right
        assert card.veil.card.contains(places[0].unionall(places[1:]))
    press(driver, "hand=average")
    press(driver, "career")
    driver.frames(20)
    assert load_settings(driver.app.folder).settings.start[name]["hand"] == "average", "a match keeps to it"
    assert isinstance(driver.top, NameCard)


def test_what_matters_beside_a_computer_and_between_two_persons_shares_a_line(begin: Callable[..., Driver]):
    driver = begin()
    for other, there, gone in (
        ("person", "hand_over=card", "their_strokes=fast"),
        ("novice", "their_strokes=fast", "hand_over=card"),
    ):
        press(driver, f"second_player={other}")
        find = driver.top.spots.find
        assert find(there).enabled and find(gone) is None
        press(driver, there)
    assert driver.top.chosen["their_strokes"] == "fast" and driver.top.chosen["hand_over"] == "card"

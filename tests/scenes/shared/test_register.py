"""The register of games: each begins from its level, and answers how a frame of it stands."""

import pytest

from game.billiards.game.register import REGISTER, Registered, games_of
from game.levels import level_files, load_level
from game.scenes.billiards.level import BilliardsContent
from game.scenes.billiards.scene import Billiards
from game.scenes.carom.level import CaromContent
from game.scenes.carom.scene import CaromScene
from game.scenes.snooker.level import SnookerContent
from game.scenes.snooker.scene import SnookerScene
from game.stage import Stage

SCENES = {"billiards": Billiards, "carom": CaromScene, "snooker": SnookerScene}
CONTENTS = {"billiards": BilliardsContent, "carom": CaromContent, "snooker": SnookerContent}


def stage_of(entry: Registered) -> Stage:
    """The game as its level begins it."""
    scene = SCENES[entry.family]
    path = next(path for path in level_files(entry.family) if path.stem == entry.level)
    level = load_level(path, entry.family, scene.content_type)
    return Stage(scene, level=level)


@pytest.mark.parametrize("name", REGISTER)
def test_a_registered_game_begins_from_its_level(name):
    entry = REGISTER[name]
    stage = stage_of(entry)
    content = stage.scene.level.content or CONTENTS[entry.family]()
    assert content.game == entry.name == name
    game = stage.scene.model.frame.game
    assert len(game.players) == len(game.won) == 2
    assert not game.over and game.winner is None and game.turn in (0, 1)


@pytest.mark.parametrize("name", REGISTER)
def test_a_registered_game_can_be_chosen_in_its_scene(name):
    stage = Stage(SCENES[REGISTER[name].family], parameters={"game": name})
    assert stage.scene.save_content().game == name


def test_every_scene_has_games_and_no_title_stands_twice():
    assert all(games_of(family) for family in SCENES)
    assert len({entry.title for entry in REGISTER.values()}) == len(REGISTER)

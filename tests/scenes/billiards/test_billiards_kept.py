"""A game under way is kept, whole, at any moment, and goes on where it was."""

import math
import os
import signal
import subprocess
import sys
import time

import msgspec

from game.app.scene.keeping import Keeper, kept_path
from game.app.stagehand.files import present_level
from game.billiards.game.frame import Frame
from game.levels import format_level, load_level, parse_level
from game.scenes.billiards.scene import Billiards
from game.stage import Action, Pointer, SetParameter, Stage
from tests.scenes.billiards.billiards_stages import aim, check_balls, open_level, until_aiming


def broken_off(level: str = "default", **parameters) -> Stage:
    """A game after its break."""
    stage = open_level(level, **parameters)
    aim(stage, 0.5 * math.pi + 0.02)
    stage.post(SetParameter("power", 8.5))
    stage.post(Action("strike"))
    return until_aiming(stage)


def opened_again(stage: Stage) -> Stage:
    """What opens from the level that the game is kept as."""
    text = format_level(present_level(stage, "kept"))
    return Stage(Billiards, level=parse_level(text, "billiards", Billiards.content_type))


def test_a_kept_game_goes_on_with_all_that_the_rules_know():
    for level in ("default", "nine-ball", "combination", "practice"):
        stage = broken_off(level)
        again = opened_again(stage)
        assert again.scene.model.frame.game == stage.scene.model.frame.game
        assert again.scene.model.frame.layout.places == stage.scene.model.frame.layout.places
        assert again.scene.model.frame.conditions == stage.scene.model.frame.conditions
        check_balls(again)
        assert again.scene.parameters.power == 8.5


def test_a_kept_game_plays_on_to_the_same_end():
    stage = broken_off("combination")
    again = opened_again(stage)
    for one in (stage, again):
        if one.scene.model.frame.game.options:
            one.post(Action("first"))
        x, y = one.scene.model.frame.cue_ball
        one.post(Pointer("move", x + 0.3, y + 0.4))
        one.post(Action("strike"))
        until_aiming(one)
    assert again.scene.model.frame.layout.places == stage.scene.model.frame.layout.places


def test_touching_balls_and_one_in_the_jaws_are_kept_as_they_lie():
    stage = open_level("hard-05-jammed-in-the-jaws")
    stage.post(Action("set-up"))
    scene = stage.scene
    touching = 2.0 * scene.model.frame.conditions.radii[0] - 5e-10
    layout = scene.model.frame.layout.with_ball(9, (0.5 + touching, 0.5)).with_ball(10, (0.9, -0.002 + 0.03))
    scene.model.set_up(layout)
    stage.post(Action("set-up"))
    assert opened_again(stage).scene.model.frame.layout.places == scene.model.frame.layout.places


def test_nothing_is_kept_before_the_first_stroke_nor_while_it_plays_itself():
    stage = open_level()
    assert stage.scene.worth_keeping() is None
    stage = broken_off()
    assert stage.scene.worth_keeping() is not None
    stage.post(Action("demo"))
    assert stage.scene.worth_keeping() is None


def test_the_keeper_writes_what_is_new_and_waits_for_its_thread_at_the_end():
    stage = broken_off()
    keeper = Keeper("billiards")
    for _ in range(5):
        keeper.update(stage)
    keeper.close()
    kept = load_level(kept_path("billiards"), "billiards", Billiards.content_type)
    saved = msgspec.json.encode(stage.scene.model.frame.game)  # whose tuples are lists
    assert kept.content.saved == {k: v for k, v in msgspec.json.decode(saved).items() if v is not None}
    again = Stage(Billiards, level=kept)
    assert again.scene.model.frame.layout.places == stage.scene.model.frame.layout.places
    kept_path("billiards").unlink()


PROGRAM = """
import sys
from pathlib import Path
from game.levels import Level, save_level
from game.scenes.billiards.level import BilliardsContent, PlacedBall
path, k = Path(sys.argv[1]), 0
while True:
    k += 1
    balls = [PlacedBall(number=n, position=(0.1 + 0.07 * n, 0.2 + 0.001 * (k % 100))) for n in range(16)]
    content = BilliardsContent(game="practice", balls=balls)
    save_level(Level(scene="billiards", title=str(k), content=content), path)
    if k == 3:
        print("going", flush=True)
"""


def test_a_kept_game_survives_a_kill_at_any_moment(tmp_path):
    path = tmp_path / "autosave.toml"
    for delay in (0.013, 0.031):
        process = subprocess.Popen(
            [sys.executable, "-c", PROGRAM, str(path)], stdout=subprocess.PIPE, env=dict(os.environ)
        )
        assert process.stdout is not None and process.stdout.readline() == b"going\n"
        time.sleep(delay)
        process.send_signal(signal.SIGKILL)
        process.wait()
        process.stdout.close()
        level = load_level(path, "billiards", Billiards.content_type)
        assert len(level.content.balls) == 16 and int(level.title) >= 3


def test_undo_turns_the_balls_back_as_they_were():
    stage = open_level("practice")
    before = stage.scene.model.turns.copy()
    aim(stage, 0.5 * math.pi)
    stage.post(Action("strike"))
    until_aiming(stage)
    assert (stage.scene.model.turns != before).any()
    stage.post(Action("undo"))
    stage.run(1)
    assert (stage.scene.model.turns == before).all()


def test_a_stroke_that_cannot_be_played_leaves_the_round_as_it_was(monkeypatch):
    stage = open_level("practice")
    scene = stage.scene
    before = scene.model.frame

    def refuse(_frame):
        raise ValueError("it is too far.")

    monkeypatch.setattr(Frame, "outcome", refuse)
    aim(stage, 0.5 * math.pi)
    stage.post(Action("strike"))
    stage.run(round(4.0 / stage.dt))
    assert stage.fault is None
    assert scene.play.phase == "aiming" and scene.model.frame is before and scene.play.pending is None
    assert any("cannot be played" in text for text in scene.messages())

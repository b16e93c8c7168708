"""Whatever a hand has begun: what is saved at that moment can be opened again."""

from __future__ import annotations

import contextlib

import numpy as np
import pytest

from game.app.stagehand.files import present_level
from game.app.stagehand.opening import read_level
from game.levels import format_level, parse_level
from game.scenes import CATALOGUE
from game.stage import Action, ParameterError, Pointer, Stage

KINDS = ("down", "move", "move", "up", "down", "move", "up", "wheel", "cancel")
ROUNDS = 24  # of events, each followed by a save


def opened_again(stage: Stage) -> Stage:
    """The scene, saved as it is and opened from the text; a LevelError or ValueError if it cannot be."""
    text = format_level(present_level(stage, "kept"))
    level = parse_level(text, stage.scene.name, stage.scene_type.content_type)
    again = Stage(stage.scene_type, level=level)
    again.run(1)
    assert again.fault is None, again.fault
    return again


def somewhere(random: np.random.Generator, stage: Stage) -> tuple[float, float]:
    """A place of the picture: often one where a story takes hold."""
    targets = list(stage.scene.story_targets().values())
    if targets and random.random() < 0.5:
        return targets[random.integers(len(targets))]
    frame = stage.scene.frame()
    return (
        float(random.uniform(frame.left, frame.right)),
        float(random.uniform(frame.bottom, frame.top)),
    )


def stir(random: np.random.Generator, stage: Stage) -> None:
    """One thing that a hand or a key does; a gesture is often left in its midst."""
    actions = [action.name for action in stage.scene.actions]
    with contextlib.suppress(ParameterError):  # refused in words
        if actions and random.random() < 0.4:
            stage.post(Action(str(random.choice(actions))))
            return
        for kind in KINDS[: random.integers(1, len(KINDS) + 1)]:
            stage.post(Pointer(kind, *somewhere(random, stage), int(kind in ("down", "up"))))


@pytest.mark.parametrize("name", sorted(entry.name for entry in CATALOGUE))
def test_what_is_saved_at_any_moment_opens(name):
    random = np.random.default_rng(sum(name.encode()))
    scene_type = CATALOGUE[name].load()
    stage = Stage(scene_type, level=read_level(scene_type, None))
    saved = 0
    for number in range(ROUNDS):
        stir(random, stage)
        stage.run(int(random.choice((0, 1, 4))))
        if stage.fault is not None:
            stage.reset()
            continue
        try:
            opened_again(stage)
        except ValueError as error:
            raise AssertionError(f"{name}: after {number + 1} things: {error}") from error
        saved += 1
    assert saved > ROUNDS // 2

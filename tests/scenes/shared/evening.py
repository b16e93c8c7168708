"""An evening of racks: programs play every registered game by events alone, as the window would send them.

`python -m tests.scenes.shared.evening [RACKS [SEED]]` plays 200 and says how each game went. In every third
rack one of the two is a program with a pointer, which aims at a ball and strikes as a person does.
"""

from __future__ import annotations

import argparse
import math
import time
from typing import Any

import msgspec
import numpy as np

from game.billiards.game.register import REGISTER, Registered
from game.levels import level_files, load_level
from game.scenes.billiards.scene import Billiards
from game.scenes.carom.scene import CaromScene
from game.scenes.shared.tables.actions import OPTIONS
from game.scenes.snooker.scene import SnookerScene
from game.stage import Action, Pointer, SetParameter, Stage

SCENES: dict[str, Any] = {"billiards": Billiards, "carom": CaromScene, "snooker": SnookerScene}
SHORT = {"carom": {"target": 2, "innings": 6}}  # points and innings of a short game
STRAIGHT_POOL_POINTS = 16  # so many want one new rack
HALF_A_SECOND = 0.5  # s
LONGEST = 900  # strokes and choices of a rack


def opened(entry: Registered, seed: int) -> Stage:
    """A game at its beginning, shortened where it is played for points."""
    scene = SCENES[entry.family]
    path = next(path for path in level_files(entry.family) if path.stem == entry.level)
    level = load_level(path, entry.family, scene.content_type)
    if entry.name == "straight-pool":
        short = msgspec.structs.replace(level.content, target=STRAIGHT_POOL_POINTS)
        level = msgspec.structs.replace(level, content=short)
    return Stage(scene, level=level, parameters=SHORT.get(entry.family, {}), seed=seed)


def check(stage: Stage) -> None:
    """No fault; rules and cloth agree on what lies on the table, and no ball in another or outside."""
    assert stage.fault is None, stage.fault
    frame = stage.scene.model.frame
    places = getattr(frame, "places", None)
    if places is None:
        numbers = [number for number, _, _ in frame.layout.places]
        assert {number for number in numbers if number} == set(frame.game.on_table)
        places, radii = frame.layout.positions, frame.layout.radii
    else:
        radii = np.full(3, 0.03075)
    places = np.asarray(places)
    assert np.isfinite(places).all()
    assert (places > -0.06).all() and (places < (frame.table.width + 0.06, frame.table.length + 0.06)).all()
    for k in range(len(places)):
        for other in range(k):
            gap = math.dist(places[k], places[other]) - 2.0 * math.sqrt(radii[k] * radii[other])
            assert gap > -2e-6, (k, other, gap)


def by_pointer(stage: Stage, random: np.random.Generator) -> None:
    """A person's stroke, or choice: by pointer and keys."""
    course, frame = stage.scene.course, stage.scene.model.frame
    game = frame.game
    if game.options:
        stage.post(Action(OPTIONS[int(random.integers(len(game.options)))]))
        return
    if getattr(getattr(course, "aiming", None), "locked", False):
        stage.post(Action("lock"))
    if hasattr(frame, "places"):
        (x, y), others = frame.places[game.cue], [p for k, p in enumerate(frame.places) if k != game.cue]
    else:
        x, y = frame.cue_ball
        others = [(px, py) for ball, px, py in frame.layout.places if ball in game.legal_first()]
    chosen = int(random.integers(len(others)))
    tx, ty = others[chosen]
    aim = math.atan2(ty - y, tx - x) + float(random.normal(0.0, 0.01))
    stage.post(SetParameter("power", round(float(random.uniform(1.5, 6.0)), 2)))
    stage.post(Pointer("move", x + 0.2 * math.cos(aim), y + 0.2 * math.sin(aim)))
    if hasattr(course, "nominate") and game.needs_call():  # a snookered colour is nominated by its key
        numbers = [ball for ball, _, _ in frame.layout.places if ball in game.legal_first()]
        stage.post(Action(f"nominate-{numbers[chosen] - 14}"))
    stage.post(Action("strike"))


def play_rack(stage: Stage, random: np.random.Generator) -> int:
    """Play until a rack, game or frame is over; how many turns that took."""
    scene = stage.scene
    half = round(HALF_A_SECOND / stage.dt)
    for turn in range(LONGEST):
        for _ in range(40):
            stage.run(half)
            check(stage)
            if scene.course.phase == "aiming":
                break
            stage.post(Action("strike"))  # to the end of the shot
        else:
            raise AssertionError("a shot does not end")
        if scene.model.frame.game.over:
            return turn
        if scene.course.person_plays:
            by_pointer(stage, random)
        else:
            scene.course.rest_s = 10.0  # nobody need wait
            stage.listen(at_once=True)
    raise AssertionError(f"no end after {LONGEST} turns")


def play_one(entry: Registered, seed: int) -> int:
    """A rack of a game between two programs; how many turns it took."""
    random = np.random.default_rng((seed, len(entry.name)))
    stage = opened(entry, seed)
    grades = random.choice(["novice", "club"], 2).tolist()
    if seed % 3 == 2:
        grades[seed % 2] = "person"
    stage.post(SetParameter("first_player", grades[0]))
    stage.post(SetParameter("second_player", grades[1]))
    turns = play_rack(stage, random)
    assert scene_points(stage) is not None
    return turns


def scene_points(stage: Stage) -> object:
    """How the rack ended: who has won, or the score of a draw."""
    game = stage.scene.model.frame.game
    return game.winner if game.winner is not None else getattr(game, "points", None)


def parser() -> argparse.ArgumentParser:
    """What an evening is asked for with."""
    made = argparse.ArgumentParser(prog="python -m tests.scenes.shared.evening", description=__doc__)
    made.add_argument("racks", nargs="?", type=int, default=200, help="how many are played (%(default)s)")
    made.add_argument("seed", nargs="?", type=int, default=0, help="of the first of them (%(default)s)")
    return made


def main(racks: int, seed: int) -> None:
    """Play, game after game in turn, and say how it went."""
    entries, faults = list(REGISTER.values()), 0
    said: dict[str, list[int]] = {entry.name: [] for entry in entries}
    began = time.process_time()
    for rack in range(racks):
        entry = entries[rack % len(entries)]
        try:
            said[entry.name].append(play_one(entry, seed + rack))
        except Exception as error:
            faults += 1
            print(
                f"rack {rack}, {entry.name}, seed {seed + rack}: {type(error).__name__}: {error}", flush=True
            )
    for name, turns in said.items():
        print(f"{name}: {len(turns)} racks, {sum(turns)} turns")
    print(f"{racks} racks, {faults} faults, {time.process_time() - began:.0f} s of processor time")


if __name__ == "__main__":
    asked = parser().parse_args()
    main(asked.racks, asked.seed)

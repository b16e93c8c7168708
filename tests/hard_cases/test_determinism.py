"""The same level, seed and events give the same bits, for every scene."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from numba import config

from game.app.commands.selftest import GOLDEN_FILE, HALF_STEPS
from game.app.stagehand.opening import Opening
from game.app.stagehand.script import Script, demo_of
from game.compiler.decorator import kernel
from game.compiler.target import making
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage import Recording, Scene, Stage, Stamped, replay_scene
from game.stage.states.state import digest_of
from tests.paths import ROOT, TESTS
from tests.stage.example_scene import BouncingBall, step_ball
from tests.stage.odd_scenes import Cloud

STEPS, HALF, BACK = 480, 240, 48
AFTER = 2 * BACK  # steps past the half, to which a stage that went back goes on
SOON, FIRST = BACK, 8  # steps from the beginning and on both sides of the half: many of them, and each one
ELSEWHERE = 2 * HALF_STEPS  # steps made in another process
GOLDEN = TESTS / "golden" / "example.json"
KEPT = TESTS / "golden" / GOLDEN_FILE  # of each level after as many steps, made by some process before
UPDATE = "CAROM_UPDATE_GOLDEN"  # set to 1 to write the digests of now
STILL = {"p32"}  # nothing moves there until somebody turns a knob
SCENES = {"example": BouncingBall, "cloud": Cloud}
NAMES = [*SCENES, *(entry.name for entry in CATALOGUE)]


def scene_named(name: str) -> type[Scene]:
    return SCENES.get(name) or CATALOGUE[name].load()


def play(stage: Stage, until: int, events: tuple[Stamped, ...]) -> dict[int, str]:
    """Digests of some of the steps to come, the scene's own demo being played.

    Of each just after the beginning and the half, of many around, where a state that was not kept whole would
    tell, and of every twelfth: a digest of the fireworks takes ten times as long as a step of them. What has
    gone another way goes on so.
    """
    digests = {}
    waiting = [stamped for stamped in events if stamped.step >= stage.step_number]
    while stage.step_number < until:
        while waiting and waiting[0].step == stage.step_number:
            stage.post(waiting.pop(0).event)
        stage.run(1)
        step = stage.step_number
        near = step <= SOON or abs(step - HALF) <= SOON
        if step % (4 if near else 12) == 0 or step <= FIRST or 0 < step - HALF <= FIRST:
            digests[step] = stage.digest()
        assert stage.fault is None
    return digests


class Played(NamedTuple):
    """A scene's demo, played straight on by a stage that remembers nothing, and once more to the half."""

    scene: type[Scene]
    whole: dict[int, str]  # digests: what every other way must come to
    stage: Stage  # one that remembers, at half time
    half: dict[int, str]


def small_kernels() -> list[Any]:
    """Some kernels in use on the floors without a screen, by name, that compile quickly."""
    found = {}
    for name, module in sorted(sys.modules.items()):
        if name.startswith(("game.physics.", "game.billiards.")):
            for key, value in vars(module).items():
                if (
                    hasattr(value, "py_func")
                    and value.signatures
                    and len(value.py_func.__code__.co_code) < 300
                ):
                    found[f"{value.py_func.__module__}.{key}"] = value
    return [found[key] for key in sorted(found)][:12]


@pytest.fixture(scope="class", params=NAMES)
def played(request: pytest.FixtureRequest) -> Played:
    scene = scene_named(request.param)
    whole = play(Stage(scene, record=False, snapshot_bytes=0, charts=False), STEPS, scene.demo)
    stage = Stage(scene)
    return Played(scene, whole, stage, play(stage, HALF, scene.demo))


def later(digests: dict[int, str], until: int = STEPS) -> dict[int, str]:
    return {step: digest for step, digest in digests.items() if HALF < step <= until}


class TestEveryScene:
    def test_run_twice(self, played: Played) -> None:
        """From the same beginning; what the stage remembers takes no part in what happens."""
        assert played.half == {step: played.whole[step] for step in played.half}
        assert len(played.half) > HALF / 6
        begun, done = Stage(played.scene).scene.state(), played.stage.scene.state()
        assert (digest_of(begun, 0) == digest_of(done, 0)) == (played.scene.name in STILL)

    def test_kept_at_half_time_and_gone_on_with(self, played: Played, tmp_path: Path) -> None:
        """What was kept is all that the future depends on."""
        played.stage.recording.save(tmp_path / "half.json")
        again = replay_scene(Recording.load(tmp_path / "half.json"), played.scene)
        assert again.step_number == HALF
        assert play(again, STEPS, played.scene.demo) == later(played.whole)

    def test_back_and_forth_at_half_time(self, played: Played) -> None:
        """A snapshot and the steps from it are no other way to a state than the straight one."""
        stage, before = played.stage, HALF - BACK
        for _ in range(BACK):
            assert stage.step_back()
        assert stage.step_number == before and stage.digest() == played.whole[before]
        stage.run(BACK)
        assert play(stage, HALF + AFTER, played.scene.demo) == later(played.whole, HALF + AFTER)


def end_of_demo(name: str) -> str:
    """Digest of a scene's default level after some steps, its demo being played."""
    if name in SCENES:
        stage = Stage(SCENES[name])
    else:
        default = next(file for file in level_files(name) if file.stem == "default")
        stage = Opening(level=default).make_stage(CATALOGUE[name].load())
    Script(stage, demo_of(stage.scene_type)).run(ELSEWHERE)
    return stage.digest()


def test_in_another_process_with_another_number_of_threads() -> None:
    """However many threads numba may use, and in whatever order names are hashed.

    What it comes to are the digests kept of another process. Where they are not, as on a processor that none
    was kept on, this process comes to the same.
    """
    code = f"""
import json, sys
sys.path.insert(0, {str(ROOT)!r})
from tests.hard_cases.test_determinism import NAMES, end_of_demo
print(json.dumps(dict((name, end_of_demo(name)) for name in NAMES)))
"""
    threads = "1" if config.NUMBA_NUM_THREADS > 1 else "2"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "NUMBA_NUM_THREADS": threads, "PYTHONHASHSEED": "18"},
        capture_output=True,
        text=True,
        check=True,
    )
    found = json.loads(done.stdout.splitlines()[-1])
    kept = json.loads(KEPT.read_text(encoding="utf-8"))
    assert list(found) == NAMES
    new = {name: digest for name, digest in found.items() if kept.get(f"{name}/default") != digest}
    assert new == {name: end_of_demo(name) for name in new}


class TestMachineCode:
    """Products and sums are rounded one by one"""

    def test_products_are_rounded_before_they_are_added(self) -> None:
        @kernel
        def product_and_sum(a, b, c):
            return a * b + c

        assert product_and_sum(1.0 + 2.0**-30, 1.0 - 2.0**-30, -1.0) == 0.0

    def test_no_fused_instruction(self, monkeypatch: pytest.MonkeyPatch) -> None:
        """Compiled again, as code from the disk cannot be looked at: the smaller kernels of the table."""
        if config.DISABLE_JIT:
            pytest.skip("there is no machine code without the compiler")
        Stage(scene_named("lecture-table")).run(2)
        monkeypatch.setattr(making, "code_folder", lambda file: None)
        looked_at = 0
        for dispatcher in [step_ball, *small_kernels()]:
            again = kernel(dispatcher.py_func)
            for signature in dispatcher.signatures:
                again.compile(signature)
            for text in again.inspect_asm().values():
                assert "vfmadd" not in text, dispatcher
                assert "vfnmadd" not in text, dispatcher
                looked_at += 1
        assert looked_at > 3

    def test_a_test_for_nan_is_a_test(self) -> None:
        @kernel
        def is_nan(x):
            return x != x

        assert is_nan(float("nan"))
        assert not is_nan(1.0)


def test_golden_digests() -> None:
    """Digests kept in the repository; CAROM_UPDATE_GOLDEN=1 writes them again."""
    stage = Stage(BouncingBall)
    found = {}
    for step in (1, 60, 600):
        stage.run(step - stage.step_number)
        found[str(step)] = stage.digest()
    if os.environ.get(UPDATE) == "1":
        GOLDEN.parent.mkdir(exist_ok=True)
        GOLDEN.write_text(json.dumps(found, indent=2) + "\n")
    assert json.loads(GOLDEN.read_text()) == found

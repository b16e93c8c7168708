"""The same level, seed and events give the same bits, for every scene."""

from __future__ import annotations

import ast
import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from numba import config

import game
from game.physics.kernels import jit
from game.physics.kernels.jit import kernel
from game.scenes import CATALOGUE
from game.stage import Recording, Scene, Stage, Stamped, replay_scene
from tests.paths import ROOT, TESTS
from tests.stage.example_scene import BouncingBall, step_ball
from tests.stage.odd_scenes import Cloud

STEPS = 600
GOLDEN = TESTS / "golden" / "example.json"
UPDATE = "CAROM_UPDATE_GOLDEN"  # set to 1 to write the digests of now
SCENES = {"example": BouncingBall, "cloud": Cloud}
# The catalogue from its end: another process begins with the studies of all scenes from the front, and so
# neither compiles what the other is at.
NAMES = [*SCENES, *(entry.name for entry in reversed(list(CATALOGUE)))]


def scene_named(name: str) -> type[Scene]:
    return SCENES.get(name) or CATALOGUE[name].load()


def play(stage: Stage, steps: int, events: tuple[Stamped, ...]) -> list[str]:
    """Digests of the steps to come, the scene's own demo being played."""
    digests = []
    waiting = [stamped for stamped in events if stamped.step >= stage.step_number]
    for _ in range(steps):
        while waiting and waiting[0].step == stage.step_number:
            stage.post(waiting.pop(0).event)
        stage.run(1)
        digests.append(stage.digest())
    assert stage.fault is None
    return digests


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


@cache
def whole_run(name: str) -> list[str]:
    """Digests of a scene's demo from its beginning: what every other way must come to."""
    scene = scene_named(name)
    return play(Stage(scene), STEPS, scene.demo)


@pytest.mark.parametrize("name", NAMES)
class TestEveryScene:
    def test_run_twice(self, name: str) -> None:
        """Twice from the same beginning."""
        scene = scene_named(name)
        assert play(Stage(scene), STEPS, scene.demo) == whole_run(name)
        assert len(set(whole_run(name))) == STEPS

    def test_kept_at_half_time_and_gone_on_with(self, name: str, tmp_path: Path) -> None:
        """A snapshot is all that the future depends on."""
        scene = scene_named(name)
        whole = whole_run(name)
        stage = Stage(scene)
        play(stage, STEPS // 2, scene.demo)
        stage.recording.save(tmp_path / "half.json")
        again = replay_scene(Recording.load(tmp_path / "half.json"), scene)
        assert again.step_number == STEPS // 2
        assert play(again, STEPS // 2, scene.demo) == whole[STEPS // 2 :]

    def test_back_and_forth_at_half_time(self, name: str) -> None:
        """A snapshot and the steps from it are no other way to a state than the straight one."""
        scene = scene_named(name)
        whole = whole_run(name)
        stage = Stage(scene)
        play(stage, STEPS // 2, scene.demo)
        for _ in range(50):
            assert stage.step_back()
        assert stage.digest() == whole[STEPS // 2 - 51]
        stage.run(50)
        assert play(stage, STEPS // 2, scene.demo) == whole[STEPS // 2 :]

    def test_without_recording_and_snapshots(self, name: str) -> None:
        """What the stage remembers takes no part in what happens."""
        scene = scene_named(name)
        bare = Stage(scene, record=False, snapshot_bytes=0)
        assert play(bare, STEPS, scene.demo)[-1] == whole_run(name)[-1]


def test_number_of_threads() -> None:
    """However many threads numba may use."""
    code = f"""
import json, sys
sys.path.insert(0, {str(ROOT)!r})
from tests.hard_cases.test_determinism import NAMES, play, scene_named, Stage
found = dict()
for name in NAMES:
    scene = scene_named(name)
    found[name] = play(Stage(scene), 200, scene.demo)[-1]
print(json.dumps(found))
"""
    answers = []
    for threads in ("1", "2"):
        done = subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "NUMBA_NUM_THREADS": threads},
            capture_output=True,
            text=True,
            check=True,
            timeout=200,
        )
        answers.append(json.loads(done.stdout.splitlines()[-1]))
    assert set(answers[0]) == set(NAMES)
    assert answers[0] == answers[1]


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
        monkeypatch.setattr(jit, "code_folder", lambda file: None)
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


def test_sorting_is_stable() -> None:
    """No argsort with ties in an order of its own"""
    unstable = []
    for path in sorted(Path(game.__file__).parent.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "argsort":
                kinds = [ast.unparse(word.value).strip("'") for word in node.keywords if word.arg == "kind"]
                if kinds not in (["stable"], ["mergesort"]):
                    unstable.append(f"{path.name}:{node.lineno}")
    assert unstable == []


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

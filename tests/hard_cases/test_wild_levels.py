"""Whatever a level may declare is refused in one line, or builds and steps within bounds of time and memory.

The levels are written from the declarations of each scene (see wild_levels) and tried in a process of its
own (see wild_run). CAROM_WILD_LEVELS=300 tries so many of each scene, with all choices and effects; that
takes an hour.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from game.levels import LevelError, parse_level
from game.scenes import CATALOGUE
from tests.hard_cases.wild_levels import wild_level
from tests.paths import ROOT

MANY = int(os.environ.get("CAROM_WILD_LEVELS", "0"))  # levels of each scene
FEW = 3
NAMES = [entry.name for entry in CATALOGUE]

pytestmark = pytest.mark.skipif(
    not hasattr(signal, "SIGPROF") or not sys.platform.startswith("linux"),
    reason="bounds of time and memory as Linux has them",
)


def outcomes(levels: list[str], steps: int, tame: bool) -> dict[str, dict[str, Any]]:
    """What came of each of the levels; who ended the process is told as trouble, and the rest goes on."""
    told: dict[str, dict[str, Any]] = {}
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "tests")))}
    while len(told) < len(levels):
        waiting = levels[len(told) :]
        run = subprocess.run(
            [sys.executable, "-m", "hard_cases.wild_run", str(steps), "tame" if tame else "wild", *waiting],
            env=environment, cwd=ROOT, capture_output=True, text=True, check=False,
        )  # fmt: skip
        lines = [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]
        for level, outcome in zip(lines[0::2], lines[1::2], strict=False):
            told[level["level"]] = outcome
        if run.returncode:
            assert len(told) < len(levels), run.stderr
            told[levels[len(told)]] = {"trouble": f"status {run.returncode}: {run.stderr[-1000:]}"}
    return told


def trouble_in(told: dict[str, dict[str, Any]]) -> dict[str, str]:
    """What is neither refused in one line nor keeps within the bounds, by level."""
    trouble = {level: outcome["trouble"] for level, outcome in told.items() if "trouble" in outcome}
    refused = {level: outcome.get("refused", "") for level, outcome in told.items()}
    return trouble | {level: words for level, words in refused.items() if "\n" in words}


@pytest.mark.skipif(MANY > 0, reason="the many are tried")
@pytest.mark.compiled
def test_a_few_wild_levels_of_each_scene() -> None:
    told = outcomes([f"{name}:{number}" for name in NAMES for number in range(FEW)], steps=4, tame=True)
    assert trouble_in(told) == {}
    assert sum("steps" in outcome for outcome in told.values()) > len(told) // 3


@pytest.mark.skipif(MANY == 0, reason="CAROM_WILD_LEVELS says how many")
@pytest.mark.timeout(0)
@pytest.mark.parametrize("name", NAMES)
def test_many_wild_levels(name: str) -> None:
    assert trouble_in(outcomes([f"{name}:{number}" for number in range(MANY)], steps=40, tame=False)) == {}


def test_the_bounds_are_kept(tmp_path: Path) -> None:
    """A level that never ends, and one that takes all memory: both are told, and the next one is tried."""
    code = (
        "import sys\n"
        "from hard_cases import wild_run\n"
        "from game.scenes import CATALOGUE\n"
        "scene = CATALOGUE['c10'].load()\n"
        "def advance(self, dt):\n"
        "    while self.level is not None and sys.argv[1] == 'time':\n"
        "        pass\n"
        "    self.room = bytearray(3 << 30 if self.level is not None else 1)\n"
        "scene.advance = advance\n"
        "wild_run.ALL_S = 1.0\n"
        "wild_run.main(1, True, [f'c10:{number}' for number in range(6)])\n"
    )
    for bound in ("time", "memory"):
        run = subprocess.run(
            [sys.executable, "-c", code, bound], cwd=ROOT, capture_output=True, text=True, check=False,
            env={**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "tests")))},
        )  # fmt: skip
        if bound == "time":
            assert run.returncode == -signal.SIGPROF
            assert "in advance" in run.stderr
        else:
            assert run.returncode == 0, run.stderr
            assert "MemoryError" in run.stdout


@pytest.mark.parametrize("name", NAMES)
def test_wild_levels_are_wild_but_levels(name: str) -> None:
    """The same for the same number; they differ; and most are refused by the scene at most, not the types."""
    scene_type = CATALOGUE[name].load()
    texts = [wild_level(scene_type, number) for number in range(12)]
    assert texts == [wild_level(scene_type, number) for number in range(12)]
    assert len(set(texts)) > 6
    taken = 0
    for text in texts:
        try:
            parse_level(text, name, scene_type.content_type)
        except LevelError as error:
            assert "\n" not in str(error)
        else:
            taken += 1
    assert taken > 8

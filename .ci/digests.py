"""Digests of some levels after some steps, one line each: what .ci/same_number compares between machines.

    python .ci/digests.py STEPS [SCENE[/LEVEL] ...]

Without names every level of every scene. The demonstration that a scene plays in the selftest is played.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

from game.app.stagehand.opening import Opening
from game.app.stagehand.script import Script, demo_of
from game.levels import level_files
from game.scenes import CATALOGUE


def wanted(names: list[str]) -> Iterator[tuple[object, Path | None, str]]:
    """(scene type, level file, name) of each level that is asked for."""
    for entry in CATALOGUE:
        scene = entry.load()
        for file in level_files(scene.name) or [None]:
            name = f"{scene.name}/{file.stem if file else '(none)'}"
            if not names or name in names or scene.name in names:
                yield scene, file, name


def main() -> None:
    steps = int(sys.argv[1])
    for scene, file, name in wanted(sys.argv[2:]):
        began = time.perf_counter()
        try:
            stage = Opening(level=file).make_stage(scene)  # type: ignore[arg-type]
            Script(stage, demo_of(stage.scene_type)).run(steps)
            found = stage.digest() if stage.fault is None else f"stopped: {stage.fault.message}"
        except Exception as error:  # what one machine raises, another must too
            found = f"{type(error).__name__}: {' '.join(str(error).split())}"
        print(f"{name} {found}", flush=True)
        print(f"{name}: {time.perf_counter() - began:.1f} s", file=sys.stderr, flush=True)


main()

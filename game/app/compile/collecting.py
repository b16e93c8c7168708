"""Opening and playing scenes in every way that needs a kernel of its own, and naming the files these are in.

``python -m game.app.compile.collecting SCENE...`` is a process of its own, so that it can be told by its
environment for which processor to compile. It prints a JSON object on a line: of each scene, then of itself.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Sequence

import pygame

from game.app.compile.preparing import compile_scene
from game.app.compile.rehearsal import SIZE
from game.app.stagehand.opening import Opening
from game.app.stagehand.script import Script, demo_of
from game.app.stagehand.view import StageView
from game.compiler.cache import files_used
from game.compiler.progress import compiling
from game.levels import level_files
from game.scenes import CATALOGUE
from game.stage import Stage
from game.stage.catalogue import Entry
from game.stage.story.reading import stories_of
from game.ui.look.look import Look
from game.ui.look.theme import DARK

STEPS = 24  # of each level: its demo begins by then
FEW_STEPS = 2  # of a scene without one of its effects
LONG_STEPS = 240  # of the scene as it opens, with its own players and pictures on the way


def collect_scene(entry: Entry) -> list[str]:
    """Compile what a scene needs: as it opens, at each level, in its stories, and without each effect.

    What could not be played, with the reason; the rest is compiled all the same.
    """
    scene_type, look, trouble = entry.load(), Look(DARK, 1.0), list[str]()

    def attempt(name: str, steps: int, opening: Opening) -> None:
        try:
            stage = opening.make_stage(scene_type)
            script = Script(stage, demo_of(scene_type), players=steps == LONG_STEPS)
            for done in range(0, steps, STEPS):
                script.run(min(STEPS, steps - done))
                _draw(stage, look)
        except Exception as error:  # a scene's own code may raise anything
            trouble.append(f"{name}: {type(error).__name__}: " + " ".join(str(error).split()))

    compile_scene(entry)
    attempt("as it opens", LONG_STEPS, Opening())
    for file in level_files(entry.name):
        attempt(file.stem, STEPS, Opening(level=file))
    for story in stories_of(scene_type):
        attempt(story.name, STEPS, Opening(story=story.name))
    names = tuple(scene_type.effects.names)
    for off in [*((name,) for name in names), *([names] if len(names) > 1 else [])]:
        attempt(f"without {', '.join(off)}", FEW_STEPS, Opening(effects_off=off))
    return trouble


def _draw(stage: Stage, look: Look) -> None:
    surface = pygame.Surface(SIZE, 0, 32)
    view = StageView(stage, look)
    view.place(surface.get_rect(), look)
    view.draw(surface)


def collect(names: Sequence[str]) -> None:
    """Compile what these scenes need, and print what came of it."""
    from game.ui.raster import WARM_UPS

    for _, call in WARM_UPS:
        call()
    for name in names:
        try:
            trouble, opened = collect_scene(CATALOGUE[name]), True
        except Exception as error:  # a scene that cannot be opened at all
            trouble, opened = [f"{type(error).__name__}: " + " ".join(str(error).split())], False
        row = {"scene": name, "opened": opened, "trouble": trouble, "compiled": compiling().done}
        print(json.dumps(row), flush=True)
    print(json.dumps({"used": [str(path) for path in files_used()], "compiled": compiling().done}))


if __name__ == "__main__":
    from game.app.stagehand.headless import prepare

    prepare()
    collect(sys.argv[1:])

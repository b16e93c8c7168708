"""How long a newcomer waits: from starting Python to the menu, and on to a stroke at the billiard table.

    python .ci/cold_start.py [--runs 3] [--kept] [--at-most MENU_S BILLIARDS_S] [--compiled-at-most N]

Beside the times of the clock stands the CPU time of the whole, which a busy machine hardly lengthens.
Each run is a process of its own with an empty cache folder and an empty home (``--kept``: those of the run
before, so the first is cold and the others are warm). It opens the menu, opens billiards from it, and breaks
off by mouse. It measures the Carom that the Python it is called with has, in the folder it is called from.
Without a display SDL's dummy driver stands for one.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

LIMIT_S = 600.0


def child(began: float) -> None:
    """One start; prints when menu and stroke were there, s after ``began`` (of time.time)."""
    import pygame

    from game.app.loop import Loop
    from game.app.window.settings import load_settings
    from game.app.window.window import Window
    from game.folders import user_folder

    found: dict[str, Any] = {}

    def after(name: str) -> None:
        found.setdefault(name, round(time.time() - began, 3))

    loaded = load_settings(user_folder())
    window = Window((loaded.settings.width, loaded.settings.height))
    window.show_start(loaded.settings.theme)
    from game.app.start import start

    plain_frame = Loop.frame

    def frame(self: Any, shown: bool = True) -> None:
        plain_frame(self, shown)
        after("menu")
        app = self.app
        if "asked" not in found:
            from game.app.stagehand.opening import Opening

            after("asked")
            app.welcome_due = app.tour_due = False
            app.open_scene("billiards", opening=Opening())
        play = getattr(app.screens.top, "play", None)
        if play is not None and "opened" not in found:
            after("opened")
            x, y = play.stage.scene.model.frame.cue_ball
            a, b = (tuple(map(round, play.view.camera.to_screen(x + 0.01, y + d))) for d in (1.0, 0.6))
            for kind, place in (
                (pygame.MOUSEMOTION, a), (pygame.MOUSEBUTTONDOWN, a),
                (pygame.MOUSEMOTION, b), (pygame.MOUSEBUTTONUP, b),
            ):  # fmt: skip
                more = {"rel": (0, 0), "buttons": (1, 0, 0)} if kind == pygame.MOUSEMOTION else {"button": 1}
                pygame.event.post(pygame.Event(kind, pos=place, **more))
        if play is not None and play.stage.scene.play.phase == "rolling":
            after("billiards")
            found["cpu"] = round(time.process_time(), 3)
            app.running = False
        if time.time() - began > LIMIT_S:
            app.running = False

    Loop.frame = frame  # type: ignore[method-assign]
    start(window, loaded)
    import numba

    from game import __file__ as package
    from game.compiler.progress import compiling

    print(json.dumps({**found, "compiled": compiling().done, "package": package, "numba": numba.__version__}))
    sys.stdout.flush()
    os._exit(0)  # a compiler in the background is not waited for


def one_run(home: str) -> dict[str, Any]:
    environment = {**os.environ, "CAROM_CACHE_DIR": f"{home}/cache", "CAROM_HOME": f"{home}/home"}
    environment.setdefault("SDL_AUDIODRIVER", "dummy")
    if not environment.get("DISPLAY") and not environment.get("WAYLAND_DISPLAY"):
        environment.setdefault("SDL_VIDEODRIVER", "dummy")
    code = Path(__file__).read_text(encoding="utf-8")
    command = [sys.executable, "-c", code, "--child", repr(time.time())]
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, timeout=LIMIT_S + 60)
    if done.returncode:
        raise SystemExit(done.returncode)
    return json.loads(done.stdout.splitlines()[-1])


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--kept", action="store_true")
    parser.add_argument("--at-most", nargs=2, type=float, metavar=("MENU_S", "BILLIARDS_S"))
    parser.add_argument("--compiled-at-most", type=int, metavar="N")
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--child", type=float, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child is not None:
        child(options.child)
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for i in range(options.runs):
            found.append(one_run(folder if options.kept else f"{folder}/{i}"))
            print(" ".join(f"{key} {value}" for key, value in found[-1].items()), flush=True)
    if options.json:
        Path(options.json).write_text(json.dumps(found))
    best = {
        key: min(run.get(key, LIMIT_S) for run in found) for key in ("menu", "billiards", "cpu", "compiled")
    }
    print(" ".join(f"least {key} {value}" for key, value in best.items()))
    late = options.at_most and any(
        best[key] > most for key, most in zip(("menu", "billiards"), options.at_most, strict=True)
    )
    compiled = options.compiled_at_most is not None and best["compiled"] > options.compiled_at_most
    return 1 if late or compiled else 0


if __name__ == "__main__":
    sys.exit(main())

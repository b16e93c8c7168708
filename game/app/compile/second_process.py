"""A second Python process that works for the window out of sight."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
from collections.abc import Sequence
from typing import Any

from game.app.window.children import start
from game.folders import PACKAGE

PATIENCE_S = 1.0


def with_this_game() -> dict[str, str]:
    """The environment in which ``python -m game...`` is this very package.

    Whatever is called so in the folder that the program was started from: Python would look there first.
    """
    places = [str(PACKAGE.parent), *filter(None, [os.environ.get("PYTHONPATH", "")])]
    return {**os.environ, "PYTHONSAFEPATH": "1", "PYTHONPATH": os.pathsep.join(places)}


def start_quietly(command: Sequence[str], **options: Any) -> subprocess.Popen[Any] | None:
    """Start it without a screen or sound card; None on one core, or where it cannot be started.

    ``options`` go to `subprocess.Popen`; what is not said otherwise is neither read nor written. In a frozen
    application ``sys.executable`` is the application: only if it says that it runs modules is it started.
    """
    frozen = getattr(sys, "frozen", False) and not getattr(sys, "runs_modules", False)
    if (os.cpu_count() or 1) < 2 or frozen:
        return None
    streams: dict[str, Any] = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.DEVNULL)
    environment = {**with_this_game(), "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy"}
    with contextlib.suppress(OSError):
        return start(command, env=environment, **{**streams, **options})
    return None


def end(process: subprocess.Popen[Any] | None) -> None:
    """End it, wherever it is: what it keeps on disk it writes whole or not at all.

    One that a busy machine is slow to end is waited for in a thread, so that nothing is left of it.
    """
    if process is None:
        return
    with contextlib.suppress(OSError):
        process.kill()
    try:
        process.wait(PATIENCE_S)
    except subprocess.TimeoutExpired:
        threading.Thread(target=process.wait, name="ending", daemon=True).start()

"""Before a scene is opened nothing is compiled: no module of menu or career calls a kernel as it comes in."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tests.paths import ROOT

CODE = """
import game.app.application, game.app.start, game.app.menu.screen
import game.app.screens.career_card, game.app.screens.statistics_card
import game.app.stagehand.career_file, game.app.stagehand.stroke_file
from game.compiler.progress import compiling
print("compiled", compiling().done)
"""


def test_menu_and_career_come_in_without_the_compiler(tmp_path: Path):
    world = {**os.environ, "CAROM_CACHE_DIR": str(tmp_path), "PYTHONPATH": str(ROOT)}
    ended = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, env=world, cwd=ROOT)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.split()[-2:] == ["compiled", "0"]

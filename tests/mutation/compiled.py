"""The second round: what no test noticed without the compiler is judged with it, in new processes."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

from tests.mutation.drawing import Sown
from tests.mutation.operators import sow
from tests.mutation.watchers import Watchers

FILES = 8  # of tests in one process
TESTS_S = 420.0  # for all tests of a fault; those that are left then have not noticed
UNCOMPILED_S = 90.0  # for the tests nearby without the compiler, of what runs at import
DIGESTS_S = 240.0
MOST_SCENES = 2  # whose digests are taken
MOST_TOLD = 6  # folders of scenes whose accounts are taken
ACCOUNTS = "tests/golden/test_accounts.py::test_a_scene_tells_what_it_told"


def judge(sown: Sown, copy: Path, watchers: Watchers, at_import: bool) -> tuple[bool, str]:
    """Whether a fault is noticed, and by what. What runs at import no test has met without the compiler."""
    path = copy / sown.path
    kept = path.read_text()
    near = watchers.near(sown.module)
    wide = [name for name in watchers.folder(sown.module) if name not in near]
    path.write_text(sow(kept, sown.fault))
    try:
        if at_import and (failed := run_tests(copy, near, UNCOMPILED_S, jit=False)):
            return True, failed
        ends = time.monotonic() + TESTS_S
        told = [f"{ACCOUNTS}[{name}]" for name in names_of(copy, watchers.scenes(sown.module)[:MOST_TOLD])]
        for files in (near, told, wide):
            for start in range(0, len(files), FILES):
                left = ends - time.monotonic()
                if left > 0.0 and (failed := run_tests(copy, files[start : start + FILES], left)):
                    return True, failed
        scenes = watchers.scenes(sown.module)[:MOST_SCENES]
        if scenes and (failed := run_digests(copy, scenes)):
            return True, failed
    finally:
        path.write_text(kept)
    return False, f"{len(near) + len(wide)} files of tests"


def run_tests(copy: Path, files: list[str], limit_s: float, jit: bool = True) -> str | None:
    """Which test of some files fails first within so many seconds, if one does."""
    if not files:
        return None
    environment = dict(os.environ, NUMBA_DISABLE_JIT="0" if jit else "1", PYTHONDONTWRITEBYTECODE="1")
    command = [sys.executable, "-m", "pytest", "-n", "0", "-q", "-x", "--no-header", "-p", "no:cacheprovider"]
    status, told = _run([*command, *files], copy, environment, limit_s)
    if status in (None, 0, 5):
        return None
    failed = [line for line in told.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return failed[0] if failed else told[-200:]


def run_digests(copy: Path, scenes: list[str]) -> str | None:
    """What selftest says if the recorded digests of some scenes hold no longer."""
    command = [
        sys.executable,
        "-m",
        "game",
        "selftest",
        *names_of(copy, scenes),
        "--golden",
        "tests/golden/scenes.json",
    ]
    status, told = _run(command, copy, dict(os.environ), DIGESTS_S)
    return None if status in (None, 0) else told[-200:]


def names_of(copy: Path, folders: list[str]) -> list[str]:
    """Names of the scenes that some folders hold, as their catalogue entries state them."""
    modules = [f"game.scenes.{folder}" for folder in folders]
    listing = "print(*[e.name for m in sys.argv[1:] for e in getattr(import_module(m), 'ENTRIES', ())])"
    program = f"import sys; from importlib import import_module; {listing}"
    status, told = _run([sys.executable, "-c", program, *modules], copy, dict(os.environ), DIGESTS_S)
    if status != 0:  # else what it says of the trouble would be taken for names, and those for noticed
        raise RuntimeError(f"{modules}: {told}")
    return told.split()


def _run(
    command: list[str], folder: Path, environment: dict[str, str], limit_s: float
) -> tuple[int | None, str]:
    """Exit status (None: no end in time) and what a program said."""
    try:
        done = subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, text=True, timeout=limit_s, check=False
        )
    except subprocess.TimeoutExpired:
        return None, f"no end within {limit_s:g} s"
    return done.returncode, done.stdout + done.stderr

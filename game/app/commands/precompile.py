"""``precompile``: machine code of all kernels for a generic processor, as a file or in a wheel.

Each scene is opened and played in processes of their own, until one turn compiles nothing: what that turn has
taken from the cache folder is what a start needs, and is packed (see game/compiler/prebuilt.py).
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from game.app.commands import given, output
from game.app.compile.second_process import with_this_game
from game.app.window.children import start
from game.app.window.mistake import MistakeError
from game.app.window.words import say

MOST_TURNS = 4
WHEEL_VARIABLE = "CAROM_WHEEL_KERNELS"  # hatch_build.py reads it


class Turn(NamedTuple):
    """What one turn came to: files that were used, scenes that could be opened, kernels compiled."""

    used: list[Path]
    scenes: list[str]
    compiled: int


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "precompile", help="machine code for a generic processor, as a file or in a wheel", allow_abbrev=False
    )
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="only these")
    parser.add_argument("--out", metavar="FILE", help="write the machine code")
    parser.add_argument("--wheel", metavar="FOLDER", help="make a wheel that carries it; in a checkout")
    parser.add_argument("--processes", metavar="N", help="how many at once; as many as there are cores")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Compile, pack, write; or, asked for neither file nor wheel, say what came with this Carom."""
    from game.compiler.prebuilt import PACKAGE, file_name, pack

    if options.out is None and options.wheel is None:
        return _say_what_is_there()
    output.check_writable(options.out, "--out")
    root = PACKAGE.parent
    if options.wheel is not None and not (root / "hatch_build.py").is_file():
        raise MistakeError("--wheel: wheels are made in a checkout, and this Carom is an installed one")
    names = [given.scene_type_named(name).name for name in options.scenes] or _all_names()
    turn = compile_all(names, _count(options.processes))
    content = pack(_codes(turn.used), turn.scenes)
    say(f"{len(turn.used)} kernels of {len(turn.scenes)} scenes, {len(content) / 1e6:.1f} MB")
    if options.out is not None:
        _write(Path(options.out), content)
    if options.wheel is not None:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / file_name()
            _write(file, content)
            make_wheel(root, file, Path(options.wheel))
    return 0


def _say_what_is_there() -> int:
    """Whether machine code came with this Carom and is taken; status 1 if not."""
    from game.compiler.prebuilt import found, shipped_file

    code, reason = found()
    if code is None:
        say(f"no machine code is taken: {reason}")
        return 1
    say(f"machine code of {len(code)} kernels of {len(code.scenes)} scenes is taken from {shipped_file()}")
    return 0


def compile_all(names: Sequence[str], processes: int) -> Turn:
    """Turns, until one compiles nothing; MistakeError if that does not come about."""
    for _ in range(MOST_TURNS):
        turn = _turn(names, processes)
        if turn.compiled == 0:
            return turn
        say(f"{turn.compiled} kernels compiled; once more, to see what a start takes")
    raise MistakeError("kernels are compiled anew in each turn: is there a cache folder to write to?", 1)


def _turn(names: Sequence[str], processes: int) -> Turn:
    """Open all scenes once, dealt to so many processes."""
    hands = [names[i::processes] for i in range(processes) if names[i::processes]]
    running = [_start(hand) for hand in hands]
    used: dict[Path, None] = {}
    scenes, compiled = [], 0
    for process, hand in zip(running, hands, strict=True):
        for row in _rows(process):
            if "scene" in row:
                scenes += [row["scene"]] if row["opened"] else []
                say(f"{row['scene']:<16} {'; '.join(row['trouble'])}".rstrip(), flush=True)
            else:
                used.update(dict.fromkeys(map(Path, row["used"])))
                compiled += row["compiled"]
        if process.wait() != 0:
            raise MistakeError(
                f"the process that compiles {', '.join(hand)} ended with {process.returncode}", 1
            )
    return Turn(list(used), [name for name in names if name in scenes], compiled)


def _start(names: Sequence[str]) -> subprocess.Popen[str]:
    """A process that compiles for a processor that has only what all of its kind have."""
    from game.compiler.prebuilt import GENERIC, VARIABLE

    environment = {
        **with_this_game(),
        "NUMBA_CPU_NAME": GENERIC[0], "NUMBA_CPU_FEATURES": GENERIC[1],
        "NUMBA_DISABLE_INTEL_SVML": "1",  # a library that another machine need not have
        "NUMBA_DISABLE_JIT": "0", VARIABLE: "0",
        "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "PYGAME_HIDE_SUPPORT_PROMPT": "1",
    }  # fmt: skip
    command = [sys.executable, "-m", "game.app.compile.collecting", *names]
    return start(
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
        encoding="utf-8",
    )


def _rows(process: subprocess.Popen[str]) -> Iterator[dict[str, Any]]:
    assert process.stdout is not None
    with process.stdout as lines:
        for line in lines:
            if line.startswith("{"):
                yield json.loads(line)


def _codes(files: Sequence[Path]) -> dict[str, bytes]:
    """Machine code by the name that it is looked for by."""
    from game.compiler.cache import code_in

    return {f"{path.parent.name}/{path.name}": code_in(path) for path in files}


def make_wheel(root: Path, file: Path, folder: Path) -> None:
    """Build the wheel of a checkout with a file of machine code in it. MistakeError if pip cannot."""
    command = [sys.executable, "-m", "pip", "wheel", "-q", "--no-deps", "-w", str(folder), str(root)]
    environment = {**os.environ, WHEEL_VARIABLE: str(file)}
    if start(command, group=True, env=environment, stdin=subprocess.DEVNULL).wait():
        raise MistakeError(f"--wheel {folder}: pip could not build it", 1)


def _write(path: Path, content: bytes) -> None:
    """A file that only its owner may write, whatever the mask."""
    path.write_bytes(content)
    path.chmod(0o644)


def _all_names() -> list[str]:
    from game.scenes import CATALOGUE

    return [entry.name for entry in CATALOGUE]


def _count(word: str | None) -> int:
    """How many processes."""
    if word is None:
        return os.cpu_count() or 1
    if not word.isascii() or not word.isdigit() or not 1 <= int(word) <= 64:
        raise MistakeError(f"--processes {word}: expected a whole number from 1 to 64")
    return int(word)

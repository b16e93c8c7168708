"""Sow faults one at a time and see which of them no test notices.

    python -m tests.mutation --seed 1 --count 300 --log faults.jsonl
    python -m tests.mutation --log faults.jsonl --report

Each fault is sown into a copy of the checkout. First the tests that import the module run, those of kernels
without the compiler; then all tests of its folder and of what stands on it; last the recorded digests of the
scenes that use it. The first that fails ends the search. The log can be continued. equivalent.toml lists the
faults that change nothing, with reasons.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from pathlib import Path
from typing import NamedTuple

from tests.mutation.operators import Fault, find_faults, sow
from tests.mutation.watchers import Watchers
from tests.paths import ROOT

SHARES = {
    "physics": 90,
    "billiards": 60,
    "levels": 15,
    "lab": 30,
    "stage": 40,
    "ui": 15,
    "scenes": 35,
    "app": 15,
}
PICTURES = (
    "figure.py",
    "card.py",
    "view.py",
    "view/",
    "painters/",
    "look/",
)  # lengths and shades that only the eye judges
UNCOMPILED_S = 60.0  # what takes longer without the compiler runs again with it
TIMEOUT_S = 600.0  # of a round of tests, which takes far less: no end within it counts as noticed
MOST_SCENES = 2  # whose digests are taken
EQUIVALENT = Path(__file__).with_name("equivalent.toml")


class Sown(NamedTuple):
    """A fault and the file it is sown into, relative to the checkout."""

    path: str
    fault: Fault
    text: str
    """The line it stands in."""

    @property
    def key(self) -> str:
        """What names the fault in logs: it survives changes elsewhere in the file."""
        old, new = " ".join(self.fault.old.split()), " ".join(self.fault.new.split())
        return f"{self.path}: {self.text} | {old} -> {new}"


def choose(seed: int, count: int, root: Path) -> list[Sown]:
    """Faults drawn at random over all floors by their shares, each kind as often as another."""
    generator = random.Random(seed)
    chosen: dict[str, Sown] = {}
    for floor, share in SHARES.items():
        kinds: dict[str, list[Sown]] = {}
        for path in sorted((root / "game").rglob("*.py")):
            name = path.relative_to(root / "game").as_posix()
            if name.split("/")[0].removesuffix(".py") == floor and not any(part in name for part in PICTURES):
                source = path.read_text()
                lines = source.splitlines()
                for fault in find_faults(source):
                    kinds.setdefault(fault.kind, []).append(
                        Sown(f"game/{name}", fault, lines[fault.line - 1].strip())
                    )
        wanted = len(chosen) + round(count * share / sum(SHARES.values()))
        while len(chosen) < wanted and any(kinds.values()):
            several = generator.choice([each for each in kinds.values() if each])
            sown = several.pop(generator.randrange(len(several)))
            chosen[sown.key] = sown
    drawn = list(chosen.values())
    generator.shuffle(drawn)
    return drawn


def run_tests(copy: Path, files: list[str], jit: bool) -> tuple[bool | None, str]:
    """Whether some test files pass (None: uncompiled code came to no end), and which test failed first."""
    environment = dict(os.environ, NUMBA_DISABLE_JIT="0" if jit else "1", PYTHONDONTWRITEBYTECODE="1")
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-n",
        "0",
        "-q",
        "-x",
        "--no-header",
        "-p",
        "no:cacheprovider",
        *files,
    ]
    limit = TIMEOUT_S if jit else UNCOMPILED_S
    try:
        done = subprocess.run(
            command, cwd=copy, env=environment, capture_output=True, text=True, timeout=limit
        )
    except subprocess.TimeoutExpired:
        return False if jit else None, f"no end within {limit:g} s"
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return done.returncode in (0, 5), failed[0] if failed else done.stdout[-200:]


def run_digests(copy: Path, scenes: list[str]) -> tuple[bool, str]:
    """Whether the recorded digests of some scenes still hold."""
    names = [name for folder in scenes for name in _names_of(copy, folder)]
    command = [sys.executable, "-m", "game", "selftest", *names, "--golden", "tests/golden/scenes.json"]
    done = subprocess.run(command, cwd=copy, capture_output=True, text=True, check=False)
    return done.returncode == 0, (done.stdout + done.stderr)[-200:]


def _names_of(copy: Path, folder: str) -> list[str]:
    """Names of the scenes that a folder holds, as its catalogue entries state them."""
    program = (
        f"import game.scenes.{folder} as f; print(*[entry.names.name for entry in getattr(f, 'ENTRIES', ())])"
    )
    return subprocess.run(
        [sys.executable, "-c", program], cwd=copy, capture_output=True, text=True, check=False
    ).stdout.split()


def judge(sown: Sown, copy: Path, watchers: Watchers) -> tuple[bool, str]:
    """Whether a fault is noticed, and by what."""
    path = copy / sown.path
    kept = path.read_text()
    module = ".".join(Path(sown.path).with_suffix("").parts).removesuffix(".__init__")
    near = watchers.near(module)
    wide = [name for name in watchers.folder(module) if name not in near]
    rounds = [(near, True), (wide, True)]
    if "@kernel" in kept or "lean_kernel" in kept:
        rounds.insert(0, (near, False))
    path.write_text(sow(kept, sown.fault))
    try:
        for files, jit in rounds:
            for start in range(0, len(files), 12):
                passed, what = run_tests(copy, files[start : start + 12], jit)
                if passed is False:
                    return True, what
        if scenes := watchers.scenes(module)[:MOST_SCENES]:
            passed, what = run_digests(copy, scenes)
            if not passed:
                return True, what
    finally:
        path.write_text(kept)
    return False, f"{len(near) + len(wide)} files of tests"


def sow_all(options: argparse.Namespace) -> None:
    """Judge every chosen fault that the log does not hold yet."""
    log = Path(options.log)
    known = {json.loads(line)["key"] for line in log.read_text().splitlines()} if log.exists() else set()
    with tempfile.TemporaryDirectory(prefix="carom-mutation-") as folder:
        copy = Path(folder) / "carom"
        skipped = shutil.ignore_patterns(
            ".git", ".venv", "__pycache__", ".pytest_cache", ".hypothesis", ".mypy_cache"
        )
        shutil.copytree(ROOT, copy, ignore=skipped)
        watchers = Watchers(copy)
        for number, sown in enumerate(choose(options.seed, options.count, copy)):
            if sown.key in known or number % options.of != options.part:
                continue
            started = time.perf_counter()
            noticed, by = judge(sown, copy, watchers)
            row = {
                "key": sown.key,
                "line": sown.fault.line,
                "noticed": noticed,
                "by": by,
                "s": round(time.perf_counter() - started, 1),
            }
            with log.open("a") as file:
                file.write(json.dumps(row) + "\n")
            print(
                "noticed " if noticed else "MISSED  ",
                f"{sown.path}:{sown.fault.line}",
                sown.fault.kind,
                flush=True,
            )


def report(options: argparse.Namespace) -> None:
    """Print how many faults of a log were noticed, and each that was not."""
    rows = [json.loads(line) for line in Path(options.log).read_text().splitlines()]
    equivalent = {
        entry["key"]: entry["why"] for entry in tomllib.loads(EQUIVALENT.read_text()).get("fault", [])
    }
    missed = [row for row in rows if not row["noticed"]]
    open_ones = [row for row in missed if row["key"] not in equivalent]
    same = len(missed) - len(open_ones)
    counted = len(rows) - same
    print(f"{len(rows)} sown, {same} equivalent, {counted - len(open_ones)} of {counted} noticed")
    for row in open_ones:
        print(f"MISSED line {row['line']} {row['key']}")


def main() -> None:
    """Read the command line and sow, or report."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.mutation", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--seed", type=int, default=1, help="which faults are drawn")
    parser.add_argument("--count", type=int, default=300, help="how many are drawn over all floors")
    parser.add_argument(
        "--log", default="faults.jsonl", help="where the outcome of each is kept, a line each"
    )
    parser.add_argument("--part", type=int, default=0, help="which part of them this process judges")
    parser.add_argument("--of", type=int, default=1, help="of how many parts")
    parser.add_argument("--report", action="store_true", help="print what the log says")
    options = parser.parse_args()
    (report if options.report else sow_all)(options)


if __name__ == "__main__":
    main()

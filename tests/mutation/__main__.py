"""Sow faults one at a time and see which of them no test notices.

    python -m tests.mutation --seed 1 --count 300 --log faults.jsonl
    python -m tests.mutation --log faults.jsonl --report

Each fault is sown into a copy of the checkout. In the first round the tests that call the changed function
run without the compiler, the quickest first (tests.mutation.uncompiled). What none of them notices is judged
with the compiler: the tests that import the module, the accounts of the scenes that use it (tests.golden),
the tests of its folder and of what stands on it, last the recorded digests of those scenes. The first that
fails ends the search. The log can be continued;
beside it lies what each test costs. equivalent.toml lists the faults that change nothing, with reasons.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.mutation.compiled import judge
from tests.mutation.drawing import SHARES, find
from tests.mutation.log import AT_IMPORT, Log
from tests.mutation.watchers import Watchers
from tests.paths import ROOT

SKIPPED = (".git", ".venv", "__pycache__", ".pytest_cache", ".hypothesis", ".mypy_cache")


def sow_all(options: argparse.Namespace) -> None:
    """Judge every chosen fault that the log does not hold yet, or all that were missed, again."""
    os.environ.setdefault("CAROM_CACHE_DIR", str(ROOT / ".pytest_cache" / "carom"))
    with tempfile.TemporaryDirectory(prefix="carom-mutation-") as folder:
        copy = Path(folder) / "carom"
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(*SKIPPED))
        path = Path(options.log).resolve()
        drawn = ["--seed", str(options.seed), "--count", str(options.count), "--log", str(path)]
        drawn += ["--floors", *options.floors]
        again = ["--again"] if options.again else []
        program = [sys.executable, "-m", "tests.mutation.uncompiled", *drawn, *again]
        subprocess.run(program, cwd=copy, check=True)
        if options.quick:
            return
        log = Log(path)
        watchers = Watchers(copy)
        for key, row in list(log.rows.items()):
            sown = find(key, row["line"], copy)
            if sown and row["round"] == "uncompiled" and log.is_open(key, again=True):
                started = time.perf_counter()
                noticed, by = judge(sown, copy, watchers, row["by"] == AT_IMPORT)
                log.add(sown, noticed, by, "compiled", time.perf_counter() - started)


def main() -> None:
    """Read the command line and sow, or report."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.mutation", description=(__doc__ or "").splitlines()[0]
    )
    parser.add_argument("--seed", type=int, default=1, help="which faults are drawn")
    parser.add_argument("--count", type=int, default=300, help="how many are drawn over all floors")
    parser.add_argument(
        "--floors", nargs="+", choices=tuple(SHARES), default=tuple(SHARES), help="where they are sown"
    )
    parser.add_argument(
        "--log", default="faults.jsonl", help="where the outcome of each is kept, a line each"
    )
    parser.add_argument("--again", action="store_true", help="judge those again that were missed")
    parser.add_argument("--quick", action="store_true", help="the first round only, without the compiler")
    parser.add_argument("--report", action="store_true", help="print what the log says")
    options = parser.parse_args()
    if options.report:
        print(Log(Path(options.log)).report(ROOT))
    else:
        sow_all(options)


if __name__ == "__main__":
    main()

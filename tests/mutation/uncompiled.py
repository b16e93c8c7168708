"""The first round: faults judged without the compiler, each in forks of one process that has read every test.

    python -m tests.mutation.uncompiled --seed 1 --count 300 --log faults.jsonl

is started by `python -m tests.mutation` in a copy of the checkout. A fork costs milliseconds where a new
process costs seconds. Every run tells what a test costs and which functions it calls: with time the tests
that call the changed function run first, the quickest foremost; those nearby that never ran are run once
without the fault before. What fails must pass without the fault.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.mutation.costs import Costs, Ran
from tests.mutation.drawing import Sown, choose, find
from tests.mutation.forks import in_fork
from tests.mutation.log import AT_IMPORT, Log
from tests.mutation.operators import sow
from tests.mutation.runs import TEST_S, run_until_failure
from tests.mutation.swapping import Change, compare, functions_of, swap
from tests.mutation.watchers import SLOW, Watchers
from tests.paths import ROOT

# Seconds of processor time, but for those of a clock on the wall
NEAR_S = 15.0  # for the tests nearby
WIDE_S = 8.0  # for all others that call the function
FILE_S, LEARN_S = 10.0, 60.0  # for the tests of a file that is new, and of all that are
MORE_FILES = 2  # of the mirrored folder and of what stands on the module
WAIT_S = 25  # on the wall for a test, which may wait for something
WALL_S = 200.0  # on the wall for a fork, on a busy machine


class Sowing(NamedTuple):
    """A file without and with a fault, and what that changes."""

    path: Path
    kept: str
    changed: str
    change: Change


class Judge:
    """A pytest plugin that runs the tests once for every fault in place of once."""

    def __init__(self, options: argparse.Namespace) -> None:
        """Judge what the options draw, as far as the log does not hold it."""
        self.options = options
        self.log = Log(Path(options.log))

    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """Judge every fault that is drawn and not known yet."""
        self.items = {item.nodeid: item for item in session.items}
        self.costs = Costs(self.log.path.with_suffix(".costs.json"), ROOT, self.items)
        self.watchers = Watchers(ROOT)
        self.functions = functions_of(str(ROOT / "game"))
        for item in session.items:  # of what takes minutes without the compiler, some tests are quick
            if item.get_closest_marker("compiled"):
                item.own_markers = [mark for mark in item.own_markers if mark.name != "skip"]
        missed = (
            [find(key, row["line"], ROOT) for key, row in self.log.rows.items()] if self.options.again else []
        )
        drawn = choose(self.options.seed, self.options.count, ROOT, self.options.floors)
        for sown in dict.fromkeys([*missed, *drawn]):
            if sown and self.log.is_open(sown.key, self.options.again):
                started = time.perf_counter()
                noticed, by = self.judge(sown)
                self.log.add(sown, noticed, by, "uncompiled", time.perf_counter() - started)
                self.costs.save()
        return True

    def learn(self, files: list[str]) -> None:
        """Run what is new among some files once without a fault: what a test costs and calls decides when it
        is asked.
        """
        rest_s = LEARN_S
        for file in self.costs.new_of(files):
            left, limit_s = self.costs.files[file], min(FILE_S, rest_s)
            while left and limit_s > 0.0 and (told := self._run(left, limit_s, None)):
                self.costs.learn(told)
                spent = sum(one.seconds for one in told)
                limit_s, rest_s, left = limit_s - spent, rest_s - spent, left[len(told) :]

    def judge(self, sown: Sown) -> tuple[bool, str]:
        """Whether a fault is noticed, and by what."""
        path = ROOT / sown.path
        kept = path.read_text()
        changed = sow(kept, sown.fault)
        change = compare(kept, changed, str(path))
        if change is None or change.at_import:
            return False, AT_IMPORT
        if change.function is None:
            return False, "compiles to the same code"
        near = self.watchers.near(sown.module)
        folder = [file for file in self.watchers.folder(sown.module) if file not in near]
        self.learn([*near, *folder[:MORE_FILES]])
        function = f"{sown.path}:{change.function}"
        ran: set[str] = set()
        for tests, limit_s in (
            (self.costs.select(function, near), NEAR_S),
            (self.costs.calling(function), WIDE_S),
            (self.costs.select(function, folder[:MORE_FILES]), WIDE_S),
        ):
            left = [test for test in tests if test not in ran]
            if failed := self._first_failure(left, limit_s, Sowing(path, kept, changed, change), ran):
                return True, failed
        return False, f"{len(ran)} tests without the compiler"

    def _first_failure(self, left: list[str], limit_s: float, sowing: Sowing, ran: set[str]) -> str | None:
        """Which of some tests notices a fault first, if one does; those that ran are added to `ran`."""
        while left and limit_s > 0.0:
            sowing.path.write_text(sowing.changed)  # for late imports and for what is started as a program
            try:
                told = self._run(left, limit_s, sowing)
            finally:
                sowing.path.write_text(sowing.kept)
            if told is None:
                return f"no end within {WALL_S:g} s"
            self.costs.learn(one for one in told if one.passed)
            ran |= {one.test for one in told}
            limit_s -= sum(one.seconds for one in told)
            if not told or told[-1].passed:
                return None
            if self._passes_without(told[-1]):
                return told[-1].test
            limit_s -= told[-1].seconds
            left = left[len(told) :]
        return None

    def _passes_without(self, failed: Ran) -> bool:
        """Whether a test that failed passes without the fault, well within its time."""
        known = self.costs.known(failed.test) is not None
        told = self._run([failed.test], TEST_S, None) or [failed._replace(passed=False)]
        self.costs.learn(told)
        return told[0].passed and (known or failed.seconds < TEST_S or told[0].seconds < TEST_S / 2)

    def _run(self, tests: list[str], limit_s: float, sowing: Sowing | None) -> list[Ran] | None:
        """Run tests in a fork, with a fault, until one fails or the time is over."""

        def work() -> list[Ran]:
            if sowing and not swap(self.functions.get(str(sowing.path), []), sowing.change):
                return []
            return run_until_failure([self.items[test] for test in tests], self.costs.known, limit_s, ROOT)

        told = in_fork(work, WALL_S)
        return None if told is None else [Ran(*row) for row in told]


def main() -> None:
    """Read the command line, let pytest read the tests and judge."""
    parser = argparse.ArgumentParser(prog="python -m tests.mutation.uncompiled")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--log", required=True)
    parser.add_argument("--floors", nargs="+", required=True)
    parser.add_argument("--again", action="store_true")
    options = parser.parse_args()
    os.environ["NUMBA_DISABLE_JIT"] = "1"
    sys.dont_write_bytecode = True
    scratch = ROOT.parent / "temporary"
    quiet = ["-n", "0", "-s", "-p", "no:cacheprovider", f"--basetemp={scratch}"]
    slow = [f"--ignore={folder}" for folder in SLOW]
    sys.exit(pytest.main([*quiet, *slow, f"--timeout={WAIT_S}", "tests"], [Judge(options)]))


if __name__ == "__main__":
    main()

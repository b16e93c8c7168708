"""What is known of the tests without the compiler: what each costs and which functions it calls."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

UNKNOWN_S = 0.3  # what a test is taken to cost that never ran


class Ran(NamedTuple):
    """One run of one test."""

    test: str
    passed: bool
    seconds: float
    """Of processor time."""
    calls: list[str]
    """Functions of the game it called, as "file:name"."""


class Costs:
    """What earlier runs told of the tests, kept in a file by the texts of theirs."""

    def __init__(self, kept: Path, root: Path, tests: Iterable[str]) -> None:
        """Read what is kept of some tests, whose files lie below the folder `root`."""
        self.kept = kept
        self.files: dict[str, list[str]] = {}
        for test in tests:
            self.files.setdefault(test.split("::")[0], []).append(test)
        self._texts = {
            file: hashlib.sha256((root / file).read_bytes()).hexdigest()[:16] for file in self.files
        }
        self._functions: dict[str, int] = {}
        self._names: list[str] = []  # of functions, by their numbers
        self._tests: dict[str, tuple[bool, float, frozenset[int]]] = {}
        if kept.exists():
            self._read(json.loads(kept.read_text()))

    def learn(self, ran: Iterable[Ran]) -> None:
        """Keep what runs told."""
        for test, passed, seconds, calls in ran:
            for call in calls:
                if call not in self._functions:
                    self._functions[call] = len(self._names)
                    self._names.append(call)
            numbers = frozenset(self._functions[call] for call in calls)
            self._tests[test] = bool(passed), seconds, numbers

    def save(self) -> None:
        """Write everything down."""
        rows: dict[str, dict[str, Any]] = {}
        for test, (passed, seconds, calls) in self._tests.items():
            file = test.split("::")[0]
            row = rows.setdefault(file, {"text": self._texts[file], "tests": {}})
            row["tests"][test] = passed, seconds, sorted(calls)
        self.kept.write_text(json.dumps({"functions": self._names, "files": rows}))

    def new_of(self, files: Iterable[str]) -> list[str]:
        """Those files of which no test has run since they were changed."""
        run = {test.split("::")[0] for test in self._tests}
        return [file for file in files if file in self.files and file not in run]

    def known(self, test: str) -> Ran | None:
        """What is known of a test that passes without the compiler; None: it is not known to."""
        passed, seconds, calls = self._tests.get(test, (False, 0.0, frozenset()))
        return Ran(test, True, seconds, [self._names[call] for call in sorted(calls)]) if passed else None

    def select(self, function: str, files: Iterable[str]) -> list[str]:
        """Tests of some files that may notice a change of a function, file by file, the quickest first.

        Left out are tests that fail or take long without the compiler, and those known not to call the
        function, unless there is no other: what a fixture calls is noted with one test only.
        """
        calling, others = [], []
        number = self._functions.get(function)
        for file in files:
            tests = [test for test in self.files.get(file, []) if self._tests.get(test, (True,))[0]]
            tests.sort(key=lambda test: self._tests[test][1] if test in self._tests else UNKNOWN_S)
            for test in tests:
                known = test in self._tests and number not in self._tests[test][2]
                (others if known else calling).append(test)
        return calling or others

    def calling(self, function: str) -> list[str]:
        """All tests that are known to call a function, the quickest first."""
        number = self._functions.get(function)
        found = [test for test, (passed, _, calls) in self._tests.items() if passed and number in calls]
        return sorted(found, key=lambda test: self._tests[test][1])

    def _read(self, rows: dict[str, Any]) -> None:
        self._names = rows["functions"]
        self._functions = {name: number for number, name in enumerate(self._names)}
        for file, row in rows["files"].items():
            if self._texts.get(file) == row["text"]:
                for test, (passed, seconds, calls) in row["tests"].items():
                    self._tests[test] = passed, seconds, frozenset(calls)

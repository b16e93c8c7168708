"""Tests run one by one in this process, until one fails: how long each takes and what it calls."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import CodeType, FrameType

import pytest

from tests.mutation.costs import Ran
from tests.mutation.forks import at_most
from tests.mutation.swapping import outermost

# Seconds of processor time
TEST_S = 2.0  # a test that takes longer is left to the second round
SLACK = 5.0  # a test that takes so many times as long as it should
LEAST_S = 2.0  # and so much more has failed


class Failures:
    """A pytest plugin that keeps which tests failed, in order."""

    def __init__(self) -> None:
        """Nothing has failed."""
        self.names: list[str] = []

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Keep what failed, be it in set-up, call or tear-down."""
        if report.failed:
            self.names.append(report.nodeid)


def run_until_failure(
    items: list[pytest.Item], known: Callable[[str], Ran | None], limit_s: float, root: Path
) -> list[Ran]:
    """Run tests until one fails or this process has used up its time.

    `known` says what is known of a test that passes: it may take somewhat longer, and what it calls is not
    noted again, of what lies below `root`/game.
    """
    ran = []
    for number, item in enumerate(items):
        started = _used_s()
        if started > limit_s:
            break
        before, following = known(item.nodeid), items[number + 1] if number + 1 < len(items) else None
        if before is not None:
            passed, calls = run(item, following, LEAST_S + SLACK * before.seconds), before.calls
        else:
            with _calls_noted() as codes:
                passed = run(item, following, TEST_S)
            calls = _named(codes, root)
        ran.append(Ran(item.nodeid, passed, round(_used_s() - started, 4), calls))
        if not passed:
            break
    return ran


def run(item: pytest.Item, following: pytest.Item | None, limit_s: float) -> bool:
    """Run one test within so many seconds of processor time; whether it passed or was skipped."""
    failures = Failures()
    item.config.pluginmanager.register(failures)
    try:
        with at_most(limit_s):
            item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
    except BaseException:  # out of time between two phases of the test, or a fault that breaks pytest itself
        return False
    finally:
        item.config.pluginmanager.unregister(failures)
    return not failures.names


def _used_s() -> float:
    """Processor time of this process and of those that it has started and that have ended."""
    return sum(os.times()[:4])


@contextmanager
def _calls_noted() -> Iterator[dict[int, CodeType]]:
    """The codes that are entered within, by their identity."""
    seen: dict[int, CodeType] = {}

    def note(frame: FrameType, event: str, argument: object) -> None:
        seen.setdefault(id(frame.f_code), frame.f_code)

    threading.settrace(note)
    sys.settrace(note)
    try:
        yield seen
    finally:
        sys.settrace(None)
        threading.settrace(None)  # type: ignore[arg-type]


def _named(codes: dict[int, CodeType], root: Path) -> list[str]:
    below = str(root / "game")
    return sorted(
        {
            f"{Path(code.co_filename).relative_to(root)}:{outermost(code)}"
            for code in list(codes.values())
            if code.co_filename.startswith(below)
        }
    )

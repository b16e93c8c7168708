"""``accuracy``: what accuracy costs, measured and written as CSV, PNG and Markdown; of all scenes as a page.

What was measured is kept in the folder as it comes in, so that an interrupted run goes on where it stopped.
"""

from __future__ import annotations

import argparse
import json
import signal
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from game.app.commands import given
from game.app.window.deadline import say_stopped
from game.app.window.mistake import MistakeError
from game.app.window.words import say

if TYPE_CHECKING:
    from game.app.report.page import SceneReport
    from game.app.report.prices import Prices
    from game.lab import Study, StudyTable
    from game.lab.runner import Progress

PAGE, PRICES = "index.html", "effects.json"
ENOUGH_S = 0.02  # CPU time of repeats of a cheap point
KEPT_EVERY_S = 0.5  # what was measured since is lost where a point cannot be interrupted


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("accuracy", help="measure what accuracy costs", allow_abbrev=False)
    parser.add_argument("scene", nargs="?", metavar="SCENE", help="name of a scene")
    parser.add_argument("--all", action="store_true", help="the studies of all scenes, on one page")
    parser.add_argument("--out", metavar="FOLDER", default="report", help="folder of the report (report)")
    parser.add_argument("--anew", action="store_true", help="measure again what is there from before")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Measure and write; progress goes to standard error."""
    if bool(options.scene) == options.all:
        raise MistakeError("accuracy: name a scene, or say --all")
    folder = _made_folder(options.out)
    from game.app.report.page import write_page
    from game.scenes import CATALOGUE

    types = [entry.load() for entry in CATALOGUE] if options.all else [given.scene_type_named(options.scene)]
    if options.scene and types[0].study is None:
        raise MistakeError(f"accuracy: {options.scene} has no study")
    reports = []
    known: dict[str, StudyTable] = {}  # some studies belong to two scenes
    with _interruption() as stopped:
        for number, scene_type in enumerate(types, 1):
            place = f"{number} of {len(types)}  " if options.all else ""
            name = scene_type.name if options.all else ""
            reports.append(_measure(scene_type, folder, name, place, stopped, options.anew, known))
            if options.all:
                page = write_page(reports, folder / PAGE)
            if stopped.is_set():
                break
    if options.all:
        say(str(page))
    if stopped.is_set():
        say_stopped("Stopped; the same command goes on from here.")
        return stopped.status
    return 0


def _made_folder(word: str) -> Path:
    """The folder, made if need be."""
    folder = Path(word)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise MistakeError(f"--out {word}: {error.strerror or error}") from None
    return folder


class _Stop(threading.Event):
    """Set by a signal; ``status``: what the program then ends with."""

    status = 0


@contextmanager
def _interruption() -> Iterator[_Stop]:
    """An event that Ctrl+C or SIGTERM sets, the first time; the second one ends the program as usual."""
    stopped = _Stop()
    if threading.current_thread() is not threading.main_thread():
        yield stopped
        return
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}

    def stop(number: int, frame: Any) -> None:
        stopped.status = 128 + number
        stopped.set()
        signal.signal(number, before[signal.Signals(number)])

    for number in before:
        signal.signal(number, stop)
    try:
        yield stopped
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _measure(
    scene_type: Any,
    folder: Path,
    name: str,
    place: str,
    stopped: threading.Event,
    anew: bool,
    known: dict[str, StudyTable],
) -> SceneReport:
    """The studies of one scene into one folder; with a name into one of that name, and the effects too."""
    from game.app.report.page import SceneReport
    from game.lab import PlotsMissingError, StudyTable, run_study, write_report

    into = _made_folder(str(folder / name)) if name else folder
    tables = []
    for study in scene_type.study.family if scene_type.study is not None else ():
        if stopped.is_set():
            break
        print(f"{place}{study.title}", file=sys.stderr)
        kept = known.get(study.name) or (None if anew else _kept(study, into, bool(name)))
        table = StudyTable(study) if kept is None else kept
        try:
            run_study(study, _keeper(table, into), stopped.is_set, table, seconds=ENOUGH_S)
            known[study.name] = table
            if sys.stderr.isatty():
                print(file=sys.stderr)
            tables.append(table)
            _keep(table, into)
            paths = [] if stopped.is_set() else write_report(table, into)
        except (OSError, PlotsMissingError) as error:
            raise MistakeError(f"--out {into}: {error}") from None
        for path in paths:
            say(str(path))
    prices = _prices(scene_type, into, place, anew) if name and not stopped.is_set() else None
    return SceneReport(scene_type, tuple(tables), name, prices)


def _prices(scene_type: Any, folder: Path, place: str, anew: bool) -> Prices:
    """What the effects cost: kept from before, or measured and kept."""
    from game.app.report.prices import Prices, measure_prices
    from game.files import FileProblem, read_text

    path = folder / PRICES
    labels = [effect.label for effect in scene_type.effects]
    try:
        prices = Prices.from_dict(json.loads(read_text(path, 1 << 20)))
        if not anew and [price.label for price in prices.effects] == labels:
            return prices
    except (FileProblem, ValueError, TypeError, KeyError, RecursionError):
        pass
    print(f"{place}{scene_type.title}: effects", file=sys.stderr)
    prices = measure_prices(scene_type)
    try:
        _write(path, prices.to_dict())
    except OSError as error:
        raise MistakeError(f"--out {folder}: {error}") from None
    return prices


def _kept(study: Study, folder: Path, complete: bool) -> StudyTable | None:
    """What an earlier run has measured of a study, whole ones only if ``complete``; None if there is nothing.

    A scene that is named is measured; of all scenes only what is missing.
    """
    from game.files import FileProblem, read_text
    from game.lab import StudyTable

    try:
        values = json.loads(read_text(folder / f"{study.name}.json", 1 << 26))
        table = StudyTable.from_dict(study, values)
    except (FileProblem, ValueError, TypeError, AttributeError, RecursionError):
        return None
    return table if complete or not table.complete else None


def _keeper(table: StudyTable, folder: Path) -> Progress:
    """Shows how far a study is and writes what was measured now and then, for a program may end anywhere."""
    kept, last = len(table), time.monotonic()

    def show(done: int, total: int, label: str, seconds_left: float) -> None:
        nonlocal kept, last
        if len(table) > kept and time.monotonic() > last + KEPT_EVERY_S:
            _keep(table, folder)
            kept, last = len(table), time.monotonic()
        _show_progress(done, total, label, seconds_left)

    return show


def _keep(table: StudyTable, folder: Path) -> None:
    """Write what was measured, to go on with."""
    _write(folder / f"{table.study.name}.json", table.to_dict())


def _write(path: Path, values: dict[str, Any]) -> None:
    """Write JSON; numbers that are not finite are kept. OSError if it cannot be written."""
    from game.files import FileProblem, write_text

    try:
        write_text(path, json.dumps(values) + "\n")
    except FileProblem as problem:
        raise OSError(str(problem)) from None


def _show_progress(done: int, total: int, label: str, seconds_left: float) -> None:
    """One line that is written over, where somebody looks at it."""
    if sys.stderr.isatty():
        left = f"{seconds_left:.0f} s left" if seconds_left > 0.0 else ""
        bar = "█" * round(20 * done / max(total, 1))
        print(
            f"\r{bar:<20} {done} of {total}  {label:<32.32} {left:<14}", end="", file=sys.stderr, flush=True
        )

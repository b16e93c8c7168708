"""``accuracy``: what accuracy costs, measured and written as CSV, PNG and Markdown."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from game.app.commands import given
from game.app.mistake import MistakeError


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("accuracy", help="measure what accuracy costs", allow_abbrev=False)
    parser.add_argument("scene", nargs="?", metavar="SCENE", help="name of a scene")
    parser.add_argument("--all", action="store_true", help="the studies of all scenes")
    parser.add_argument("--out", metavar="FOLDER", default="report", help="folder of the report (report)")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Measure and write; progress goes to standard error."""
    if bool(options.scene) == options.all:
        raise MistakeError("accuracy: name a scene, or say --all")
    folder = _made_folder(options.out)
    from game.scenes import CATALOGUE

    types = [entry.load() for entry in CATALOGUE] if options.all else [given.scene_type_named(options.scene)]
    studied = [scene_type for scene_type in types if scene_type.study is not None]
    if not studied:
        raise MistakeError(
            f"accuracy: {options.scene or 'no scene'} has {'no' if options.scene else 'a'} study"
        )
    for scene_type in studied:
        _measure(scene_type, folder / scene_type.name if options.all else folder)
    return 0


def _made_folder(word: str) -> Path:
    """The folder, made if need be."""
    folder = Path(word)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise MistakeError(f"--out {word}: {error.strerror or error}") from None
    return folder


def _measure(scene_type: Any, folder: Path) -> None:
    """The studies of one scene into one folder."""
    from game.lab import PlotsMissingError, run_study, write_report

    for study in (scene_type.study, *scene_type.study.related):
        print(f"{study.title}", file=sys.stderr)
        table = run_study(study, progress=_show_progress)
        if sys.stderr.isatty():
            print(file=sys.stderr)
        try:
            paths = write_report(table, folder)
        except (OSError, PlotsMissingError) as error:
            raise MistakeError(f"--out {folder}: {error}") from None
        for path in paths:
            print(path)


def _show_progress(done: int, total: int, label: str, seconds_left: float) -> None:
    """One line that is written over, where somebody looks at it."""
    if sys.stderr.isatty():
        left = f"{seconds_left:.0f} s left" if seconds_left > 0.0 else ""
        print(f"\r{done} of {total}  {label:<32} {left:<14}", end="", file=sys.stderr, flush=True)

"""``fit``: which table and which strokes explain filmed shots."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from game.app.commands import output
from game.app.window.mistake import MistakeError
from game.app.window.words import printable, say

if TYPE_CHECKING:
    from game.billiards.fitting.fitting import FittedShot
    from game.billiards.fitting.tables import FittedTable


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "fit", help="find the table and the strokes that explain filmed shots", allow_abbrev=False
    )
    parser.add_argument("tracks", metavar="TRACKS", help="track file (JSON, see assets/TRACKS.md)")
    parser.add_argument(
        "--train", metavar="FILE", help="tracks to find the table with (every second shot of TRACKS)"
    )
    parser.add_argument("--json", metavar="FILE", help="write table and strokes; - is standard output")
    parser.add_argument(
        "--cushion", default="han-2005", metavar="NAME", help="model of the cushions (han-2005)"
    )
    parser.add_argument(
        "--balls", default="wallace-1988", metavar="NAME", help="model of ball on ball (wallace-1988)"
    )
    parser.add_argument(
        "--fix", action="append", default=[], metavar="K=V",
        help="a number of the table that is known; may be given several times",
    )  # fmt: skip
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Find the table, fit every shot, print the medians, write the rest."""
    output.check_writable(options.json, "--json")
    from game.billiards.fitting.fitting import fit_data, fit_shots, fit_table, split
    from game.billiards.fitting.tracks import TrackError, load_tracks

    try:
        tracks = load_tracks(Path(options.tracks))
        training = load_tracks(Path(options.train)) if options.train is not None else None
    except TrackError as error:
        raise MistakeError(printable(str(error))) from None
    if training is not None and training.table != tracks.table:
        raise MistakeError(f"{options.train}: table: not the one of {options.tracks}")
    start, fixed = _read_start(options, tracks.table)
    train = list(training.shots) if training is not None else split(tracks.shots)[0]
    table = fit_table(train, start, fixed, _show)
    known = () if training is not None else [shot.id for shot in train]
    shots = fit_shots(tracks.shots, table, known, _show)
    _end_progress()
    if options.json:
        output.write_json(fit_data(tracks, table, shots), options.json)
    if options.json != output.STANDARD_OUTPUT:
        where = options.train if training is not None else f"every second shot of {options.tracks}"
        say(f"table found with {len(train)} shots: {where}")
        print_result(table, shots)
    return 0


def _read_start(options: argparse.Namespace, size: Any) -> tuple[FittedTable, list[str]]:
    """The table to begin with, and what of it is known. MistakeError names what is wrong."""
    from game.billiards.fitting.tables import START_OF_CAROM, FittedTable, free_names
    from game.billiards.laws.contacts import BALL_MODELS, CUSHION_MODELS
    from game.billiards.shot.physics import ShotError, check_physics

    for option, known in (("cushion", CUSHION_MODELS), ("balls", BALL_MODELS)):
        name = getattr(options, option)
        if name not in known:
            raise MistakeError(f"--{option} {printable(name)}: expected one of {', '.join(known)}")
    physics = START_OF_CAROM._replace(cushion=options.cushion, ball_ball=options.balls)
    names = (*free_names(physics), "ball_friction")
    fixed: dict[str, Any] = {}
    for word in options.fix:
        name, _, text = word.partition("=")
        if name not in names:
            raise MistakeError(f"--fix {printable(word)}: expected K=V with K one of {', '.join(names)}")
        try:
            fixed[name] = float(text)
        except ValueError:
            raise MistakeError(f"--fix {printable(word)}: expected a number") from None
    physics = physics._replace(**fixed)
    try:
        check_physics(physics)
    except ShotError as error:
        raise MistakeError(f"--fix: {error}") from None
    return FittedTable(size, physics), list(fixed)


def print_result(table: FittedTable, shots: list[FittedShot]) -> None:
    """The table, and medians, for people."""
    from game.billiards.fitting.fitting import medians

    for name, value in table.physics._asdict().items():
        say(f"  {name:<26} {value if isinstance(value, str) else format(value, '.5g')}")
    held = [shot for shot in shots if shot.held_out]
    for words, some in (("held-out shots", held), ("all shots", shots)):
        if some:
            cue, every = medians(some)
            say(
                f"{words} ({len(some)}): median rmse {100.0 * cue:.2f} cm of the cue ball,"
                f" {100.0 * every:.2f} cm of all balls"
            )


def _show(words: str) -> None:
    """One line that is written over, where somebody looks at it."""
    if sys.stderr.isatty():
        print(f"\r{words:<76}", end="", file=sys.stderr, flush=True)


def _end_progress() -> None:
    if sys.stderr.isatty():
        print(f"\r{'':<76}\r", end="", file=sys.stderr, flush=True)

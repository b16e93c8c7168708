"""``tracks``: shots made by the program, as a track file; what is true of them is known, their noise too."""

from __future__ import annotations

import argparse
import math
from typing import Any

from game.app.commands import given, output
from game.app.window.mistake import MistakeError

MOST_SHOTS = 500
MOST_NOISE = 20.0  # mm


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "tracks", help="make a track file of computed shots, with noise", allow_abbrev=False
    )
    parser.add_argument("file", metavar="FILE", help="track file to write; - is standard output")
    parser.add_argument("--shots", default="8", metavar="N", help="how many (8)")
    parser.add_argument("--noise", default="1", metavar="MM", help="standard deviation, mm (1)")
    parser.add_argument("--seed", default="1", metavar="N", help="seed of places, strokes and noise (1)")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Make the tracks and write them."""
    seed = given.read_seed(options.seed) or 0
    shots = int(_number(options.shots, "--shots", 1, MOST_SHOTS))
    noise = _number(options.noise, "--noise", 0.0, MOST_NOISE)
    output.check_writable(options.file, "FILE")
    from game.billiards.fitting.made import make_tracks
    from game.billiards.fitting.tables import START_OF_CAROM, FittedTable
    from game.billiards.fitting.tracks import TableSize, write_tracks

    table = FittedTable(TableSize(), START_OF_CAROM)
    made = make_tracks(table, shots, seed, 0.001 * noise)
    text = write_tracks(
        table.size,
        tuple(one.tracked for one in made),
        what=f"{shots} shots computed by Carom, seed {seed}",
        note=f"not filmed: noise of {noise:g} mm in x and y, 50 pictures a second",
    )
    output.write_text(text, options.file, "FILE")
    return 0


def _number(word: str, option: str, least: float, most: float) -> float:
    """MistakeError if it is no number within the bounds."""
    try:
        value = float(word)
    except ValueError:
        value = math.nan
    whole = isinstance(least, float) or value == int(value if math.isfinite(value) else 0)
    if not (least <= value <= most and whole):
        kind = "a number" if isinstance(least, float) else "a whole number"
        raise MistakeError(f"{option} {word}: expected {kind} between {least:g} and {most:g}")
    return value

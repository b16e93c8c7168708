"""``statistics``: what has been counted of a person's strokes, in a few lines or as a CSV file."""

from __future__ import annotations

import argparse
from typing import Any

from game.app.commands import output
from game.app.window.mistake import MistakeError


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "statistics", help="strokes of the career: pots, points, position, breaks", allow_abbrev=False
    )
    parser.add_argument("--player", default="", metavar="NAME", help="whose (who played last)")
    parser.add_argument("--csv", metavar="FILE", help="write every stroke; - is standard output")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Print the summary, and write the file."""
    output.check_writable(options.csv, "--csv")
    from game.app.stagehand.career_file import read_career
    from game.app.stagehand.stroke_file import read_strokes
    from game.billiards.career.strokes import by_opponent, csv_of, summary_of, summary_words

    try:
        strokes, player = read_strokes(), read_career().player
    except ValueError as error:
        raise MistakeError(str(error), status=1) from None
    name = options.player or (player.name if player is not None else "")
    if options.player and options.player not in strokes:
        known = ", ".join(sorted(strokes)) or "nobody"
        raise MistakeError(f"--player {options.player}: no strokes are kept; there are those of {known}")
    facts = strokes.get(name, [])
    if options.csv:
        output.write_text(csv_of(facts), options.csv, "--csv")
    if options.csv != output.STANDARD_OUTPUT:
        print(summary_words(name or "no player", summary_of(facts)))
        for opponent, found in by_opponent(facts).items():
            print("  " + summary_words(f"against {opponent}", found))
    return 0

"""``match``: a billiard match that plays itself; from its record every round can be played again.

A match to be watched is the story of the billiard game: ``record billiards --story``.
"""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING, Any

from game.app.commands import given, output
from game.app.window.mistake import MistakeError

if TYPE_CHECKING:
    from game.billiards.players.match import Round

MOST_TITLE = 120


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser(
        "match", help="play a billiard match, each ball by way of another", allow_abbrev=False
    )
    parser.add_argument("--seed", default="1", metavar="N", help="seed of balls, rack and search (1)")
    parser.add_argument("--json", metavar="FILE", help="write all rounds; - is standard output")
    parser.add_argument("--title", default="", metavar="TEXT", help="title of the match, with a name")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Play the match; print its rounds, and write them."""
    seed = given.read_seed(options.seed)
    if len(options.title) > MOST_TITLE:
        raise MistakeError(f"--title: expected at most {MOST_TITLE} letters")
    output.check_writable(options.json, "--json")
    from game.billiards.players.match import MatchError, match_data, play_match

    silent = options.json == output.STANDARD_OUTPUT
    try:
        match = play_match(seed or 0, progress=_show_progress)
    except MatchError as error:
        raise MistakeError(str(error), status=1) from None
    if sys.stderr.isatty():
        print(file=sys.stderr)
    if options.json:
        output.write_json(match_data(match, options.title), options.json)
    if not silent:
        for one in match.rounds:
            print(describe(one))
        print(f"{len(match.rounds)} rounds, {match.playing_time:.0f} s of play")
    return 0


def describe(one: Round) -> str:
    """A round for people, its pocket named as in the film."""
    from game.scenes.billiards.layout import pocket_words

    chain = " - ".join(["cue ball", *(str(number) for number in one.fallen.chain[1:])])
    pocket = pocket_words(one.fallen.pocket)
    return f"round {one.number:>2}  {chain:<27} {pocket}, {one.stroke.cue_speed:.1f} m/s"


def _show_progress(one: Round) -> None:
    """One line that is written over, where somebody looks at it."""
    if sys.stderr.isatty():
        print(f"\r{describe(one):<76}", end="", file=sys.stderr, flush=True)

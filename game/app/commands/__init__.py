"""The command line. Each command is a module: ``add`` declares its options, ``execute`` does it.

Modules import what they need inside ``execute``, so that no command pays for another one.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

from game import __version__
from game.app.commands import accuracy, bench, fuzz, listing, match, play, record, replay, run, selftest, shot
from game.app.mistake import MistakeError

COMMANDS = (play, run, listing, replay, selftest, accuracy, shot, match, record, fuzz, bench)


class _Parser(argparse.ArgumentParser):
    """argparse whose complaint is one line."""

    def error(self, message: str) -> NoReturn:
        raise MistakeError(f"{message} (see {self.prog} --help)")


def build_parser() -> argparse.ArgumentParser:
    """The parser with all commands."""
    parser = _Parser(
        prog="carom",
        description="A physics arcade. Without a command: the menu.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"carom {__version__}")
    parser.set_defaults(execute=play.execute_menu)
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", parser_class=_Parser)
    for module in COMMANDS:
        module.add(commands)
    return parser


def run_command_line(arguments: Sequence[str]) -> int:
    """Do what the arguments say; the exit status. A user's mistake is one line on stderr and status 2."""
    try:
        options = build_parser().parse_args(list(arguments))
        return int(options.execute(options) or 0)
    except MistakeError as mistake:
        print(f"carom: {mistake}", file=sys.stderr)
        return mistake.status
    except KeyboardInterrupt:
        print("carom: stopped", file=sys.stderr)
        return 130
    except BrokenPipeError:
        # whoever read the output has enough; nothing must be flushed into the closed pipe at exit
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0

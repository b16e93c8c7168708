"""The command line. Each command is a module: ``add`` declares its options, ``execute`` does it.

Modules import what they need inside ``execute``, so that no command pays for another one.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

from game import __version__
from game.app.commands import (
    accuracy,
    bench,
    fit,
    fuzz,
    listing,
    match,
    open_text,
    play,
    precompile,
    record,
    replay,
    run,
    selftest,
    shot,
    statistics,
    stories,
    tracks,
)
from game.app.window.deadline import say_stopped
from game.app.window.ending import status_of
from game.app.window.mistake import MistakeError
from game.app.window.words import printable, speak_what_is_understood
from game.definition import DefinitionError

COMMANDS = (
    play, run, listing, statistics, stories, replay, open_text, selftest, accuracy, shot, fit, tracks, match,
    record, fuzz, bench, precompile,
)  # fmt: skip


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
    speak_what_is_understood()
    try:
        options = build_parser().parse_args(list(arguments))
        status = int(options.execute(options) or 0)
        if sys.stdout is not None:
            sys.stdout.flush()  # what cannot be written is reported here, not at the exit
        return status
    except MistakeError as mistake:
        print(f"carom: {mistake}", file=sys.stderr)
        return mistake.status
    except DefinitionError as mistake:
        print(f"carom: {printable(str(mistake))}", file=sys.stderr)
        return 2
    except KeyboardInterrupt as why:
        say_stopped()
        return status_of(why)
    except BrokenPipeError:
        # the reader of the output has enough; nothing must be flushed into the closed pipe at exit
        _drop_output()
        return 0
    except OSError as error:  # a disk that is full or gone, under a file or under the standard output
        if sys.stdout is not None:
            _drop_output()
        print(f"carom: {_words_of(error)}", file=sys.stderr)
        return 1


def _drop_output() -> None:
    """What is still to be printed goes nowhere."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _words_of(error: OSError) -> str:
    """What the system says, and of which file, in one line."""
    words = (error.strerror or str(error) or type(error).__name__).lower()
    return printable(" ".join(f"{error.filename}: {words}".split() if error.filename else words.split()))

"""``shot``: one billiard shot from a file, computed by a chosen model."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from game.app.commands import output
from game.app.window.mistake import MistakeError
from game.app.window.words import say


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("shot", help="compute a billiard shot from a file", allow_abbrev=False)
    parser.add_argument("file", metavar="FILE", help="shot file (JSON)")
    parser.add_argument("--model", default="exact", metavar="NAME", help="exact, stepped or lecture (exact)")
    parser.add_argument("--json", metavar="FILE", help="write events and end; - is standard output")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Compute the shot; print its events or write them."""
    output.check_writable(options.json, "--json")
    from game.billiards import run_shot_file

    try:
        result = run_shot_file(Path(options.file), options.model)
    except (ValueError, OSError) as error:
        raise MistakeError(_line(error, options.file)) from None
    if options.json:
        output.write_json(result, options.json)
    if options.json != output.STANDARD_OUTPUT:
        print_result(result)
    return 0


def _line(error: Exception, file: str) -> str:
    """The complaint, with the file named."""
    if isinstance(error, OSError) and error.strerror:
        return f"{file}: {error.strerror}"
    text = str(error)
    return text if file in text else f"{file}: {text}"


def print_result(result: dict[str, Any]) -> None:
    """Events and final places for people."""
    for event in result["events"]:
        ids = ", ".join(str(name) for name in event["ids"])
        say(f"{event['time']:10.6f} s  {event['type']:<16} {ids}")
    for name, place in result["final"].items():
        where = place if isinstance(place, str) else f"{place[0]:.6f} {place[1]:.6f} m"
        say(f"{name:>10}  {where}")
    print(f"all at rest after {result['end_time']:.6f} s")

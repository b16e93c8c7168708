"""``fuzz``: every scene under random clicks, drags, keys, resizes, values and spoilt levels."""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path
from typing import Any

from game.app.commands import given, output
from game.app.window.mistake import MistakeError

EVENTS = 2000
MOST_EVENTS = 10_000_000


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("fuzz", help="random input for every scene", allow_abbrev=False)
    parser.add_argument("scenes", nargs="*", metavar="SCENE", help="only these")
    parser.add_argument("--events", type=int, default=EVENTS, help=f"for each scene; {EVENTS} if not said")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", metavar="FILE", help="write the results; - is standard output")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Fuzz and print a table; status 1 if anything was raised."""
    from game.app.fuzz.session import FuzzSession
    from game.app.stagehand.headless import prepare
    from game.folders import home_at
    from game.scenes import CATALOGUE

    if not 1 <= options.events <= MOST_EVENTS:
        raise MistakeError(f"--events {options.events}: expected 1 to {MOST_EVENTS}")
    output.check_writable(options.json, "--json")
    names = [given.scene_type_named(name).name for name in options.scenes]
    prepare()
    quiet = options.json == output.STANDARD_OUTPUT
    if not quiet:
        print(f"{'scene':<18}{'events':>8}{'refused':>9}{'files':>7}{'faults':>8}{'slow':>6}"
              f"{'longest':>10}{'growth':>10}")  # fmt: skip
    reports = []
    for name in names or [entry.name for entry in CATALOGUE]:
        with tempfile.TemporaryDirectory(prefix="carom-fuzz-") as folder, home_at(Path(folder)):
            report = FuzzSession(CATALOGUE, name, options.seed, Path(folder)).run(options.events)
        reports.append(report)
        if not quiet:
            print(f"{name:<18}{report.events:>8}{report.refused:>9}{report.bad_files:>7}{report.faults:>8}"
                  f"{report.slow:>6}{1e3 * report.longest_s:>7.0f} ms{report.growth / 1e6:>7.1f} MB"
                  f"{'  ' + report.trouble if report.trouble else ''}", flush=True)  # fmt: skip
    failed = [report for report in reports if report.trouble]
    if options.json:
        output.write_json({"results": [r._asdict() for r in reports], "failed": len(failed)}, options.json)
    return 1 if failed else 0

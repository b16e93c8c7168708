"""``bench``: how long the library takes beside installed peers, in one run, as ratios."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from game.app.commands import output
from game.app.report.machine import about, about_words
from game.app.window.mistake import MistakeError

if TYPE_CHECKING:
    from game.lab.benchmarks import Measured

TURNS, MOST_TURNS = 15, 1000


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("bench", help="time the library beside its peers", allow_abbrev=False)
    parser.add_argument("names", nargs="*", metavar="NAME", help="only scenarios whose names begin so")
    parser.add_argument("--turns", type=int, default=TURNS, help=f"timings of each; {TURNS} if not said")
    parser.add_argument("--json", metavar="FILE", help="write the results; - is standard output")
    parser.add_argument("--markdown", metavar="FILE", help="write a table; - is standard output")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Measure and print."""
    from game.lab.benchmarks import all_scenarios, measure_scenario

    if not 1 <= options.turns <= MOST_TURNS:
        raise MistakeError(f"--turns {options.turns}: expected 1 to {MOST_TURNS}")
    for word, option in ((options.json, "--json"), (options.markdown, "--markdown")):
        output.check_writable(word, option)
    scenarios = [s for s in all_scenarios() if not options.names or s.name.startswith(tuple(options.names))]
    if not scenarios:
        names = ", ".join(scenario.name for scenario in all_scenarios())
        raise MistakeError(f"no scenario begins with {' or '.join(options.names)}; there are {names}")
    quiet = output.STANDARD_OUTPUT in (options.json, options.markdown)
    measured = []
    for scenario in scenarios:
        one = measure_scenario(scenario, options.turns)
        measured.append(one)
        if not quiet:
            print(
                f"{scenario.name:<26}{_time(one.least_s):>12} a {scenario.unit:<8}{_peers(one)}", flush=True
            )
    if options.json:
        output.write_json({**about(), "results": [_row(one) for one in measured]}, options.json)
    if options.markdown:
        output.write_text(markdown(measured), options.markdown, "--markdown")
    return 0


def markdown(measured: list[Measured]) -> str:
    """A table with date, machine and versions; ratios are of least times."""
    lines = [
        "| workload | least | median | peers in the same run |",
        "| --- | ---: | ---: | --- |",
    ]
    for one in measured:
        title = one.scenario.title.replace("|", "/")
        lines.append(f"| {title} | {_time(one.least_s)} | {_time(one.median_s)} | {_peers(one)} |")
    return "\n".join([*lines, "", about_words(about()), ""])


def _row(one: Measured) -> dict[str, Any]:
    scenario = one.scenario
    ratios = {name: one.ratio(name) for name in one.peers}
    return {
        "name": scenario.name, "title": scenario.title, "unit": scenario.unit, "least_s": one.least_s,
        "median_s": one.median_s, "worst_s": one.worst_s, "peers_s": one.peers, "ratios": ratios,
    }  # fmt: skip


def _peers(one: Measured) -> str:
    return ", ".join(f"{name} {_ratio(one.ratio(name))} x" for name in one.peers)


def _ratio(ratio: float) -> str:
    return f"{ratio:.0f}" if ratio >= 10.0 else f"{ratio:.1f}"


def _time(seconds: float) -> str:
    for factor, unit in ((1.0, "s"), (1e3, "ms"), (1e6, "µs"), (1e9, "ns")):
        if seconds * factor >= 1.0 or unit == "ns":
            return f"{seconds * factor:.3g} {unit}"
    return ""

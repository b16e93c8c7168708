"""``list``: scenes with their parameters, effects and levels."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from game.app.commands import given, output
from game.app.window.words import say

if TYPE_CHECKING:
    from game.stage import Entry


def add(commands: Any) -> None:
    """Declare the command."""
    parser = commands.add_parser("list", help="list scenes, parameters, levels", allow_abbrev=False)
    parser.add_argument("scene", nargs="?", metavar="SCENE", help="only this one, with all words of help")
    parser.add_argument("--json", metavar="FILE", help="write the list; - is standard output")
    parser.set_defaults(execute=execute)


def execute(options: argparse.Namespace) -> int:
    """Print or write the list."""
    output.check_writable(options.json, "--json")
    from game.scenes import CATALOGUE

    entries = tuple(CATALOGUE)
    if options.scene:
        entries = (CATALOGUE[given.scene_type_named(options.scene).name],)
    rows = [describe(entry) for entry in entries]
    if options.json:
        output.write_json({"scenes": rows}, options.json)
    if options.json != output.STANDARD_OUTPUT:
        for row in rows:
            print_scene(row, in_full=bool(options.scene))
    return 0


def describe(entry: Entry) -> dict[str, Any]:
    """Everything that the command line can set about a scene, for JSON."""
    scene_type = entry.load()
    return {
        "name": entry.name,
        "task": entry.task,
        "title": entry.title,
        "category": entry.category,
        "fact": entry.fact,
        "parameters": [_describe_knob(knob) for knob in scene_type.knobs().values()],
        "effects": [{"name": e.name, "label": e.label, "help": e.help} for e in scene_type.effects],
        "levels": _describe_levels(entry.name),
    }


def _describe_knob(knob: Any) -> dict[str, Any]:
    from game.stage import Choice, Param

    row = {"name": knob.name, "label": knob.label, "help": knob.help, "default": knob.default}
    if isinstance(knob, Param):
        row |= {"kind": "number", "minimum": knob.minimum, "maximum": knob.maximum, "unit": knob.unit,
                "whole": knob.whole}  # fmt: skip
    elif isinstance(knob, Choice):
        row |= {"kind": "choice", "options": list(knob.options)}
    else:
        row |= {"kind": "switch"}
    return row


def _describe_levels(scene_name: str) -> list[dict[str, str]]:
    from game.app.stagehand.level_index import level_heads

    return [
        {"name": head.path.stem, "title": head.title, "file": str(head.path)}
        for head in level_heads(scene_name)
    ]


def print_scene(row: dict[str, Any], in_full: bool) -> None:
    """A scene for people."""
    say(f"{row['name']:<16} {row['task']:<5} {row['title']}")
    for knob in row["parameters"]:
        say(f"    {knob['name']:<22} {_range(knob)}" + (f"  {knob['help']}" if in_full else ""))
    if row["effects"]:
        say("    effects: " + ", ".join(effect["name"] for effect in row["effects"]))
    if row["levels"]:
        say("    levels: " + ", ".join(level["name"] for level in row["levels"]))


def _range(knob: dict[str, Any]) -> str:
    """Default and range of a knob in few words."""
    if knob["kind"] == "number":
        unit = f" {knob['unit']}" if knob["unit"] else ""
        return f"{knob['default']:g}{unit}  ({knob['minimum']:g} to {knob['maximum']:g})"
    if knob["kind"] == "choice":
        return f"{knob['default']}  (" + " | ".join(knob["options"]) + ")"
    return "on" if knob["default"] else "off"

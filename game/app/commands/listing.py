"""``list``: scenes by category, with their parameters, effects and levels."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from game.app.commands import given, output
from game.app.window.words import say

if TYPE_CHECKING:
    from game.stage import Entry
    from game.stage.catalogue import Catalogue


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

    entries = _by_category(CATALOGUE)
    if options.scene:
        entries = (CATALOGUE[given.scene_type_named(options.scene).name],)
    rows = [describe(entry) for entry in entries]
    if options.json:
        output.write_json({"scenes": rows}, options.json)
    if options.json != output.STANDARD_OUTPUT:
        heading = ""
        for row in rows:
            if not options.scene and heading != _heading(row):
                heading = _heading(row)
                say(heading)
            print_scene(row, in_full=bool(options.scene))
    return 0


def _by_category(catalogue: Catalogue) -> tuple[Entry, ...]:
    """All scenes in the order of the menu's categories and their topics."""
    return tuple(
        entry
        for category in catalogue.categories()
        for entries in catalogue.topics(category).values()
        for entry in entries
    )


def _heading(row: dict[str, Any]) -> str:
    """Category and topic, as over the cards of the menu."""
    return f"{row['category']}: {row['topic']}" if row["topic"] else str(row["category"])


def describe(entry: Entry) -> dict[str, Any]:
    """Everything that the command line can set about a scene, for JSON."""
    scene_type = entry.load()
    return {
        "name": entry.name,
        "task": entry.task,
        "title": entry.title,
        "category": entry.category,
        "topic": entry.topic,
        "fact": entry.fact,
        "parameters": [
            _describe_parameter(parameter) for parameter in scene_type.declared_parameters().values()
        ],
        "effects": [{"name": e.name, "label": e.label, "help": e.help} for e in scene_type.effects],
        "levels": _describe_levels(entry.name),
    }


def _describe_parameter(parameter: Any) -> dict[str, Any]:
    from game.stage import Choice, Param

    row = {
        "name": parameter.name,
        "label": parameter.label,
        "help": parameter.help,
        "default": parameter.default,
    }
    if isinstance(parameter, Param):
        row |= {"kind": "number", "minimum": parameter.minimum, "maximum": parameter.maximum}
        row |= {"unit": parameter.unit, "whole": parameter.whole}
    elif isinstance(parameter, Choice):
        row |= {"kind": "choice", "options": list(parameter.options)}
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
    for parameter in row["parameters"]:
        say(
            f"    {parameter['name']:<22} {_range(parameter)}" + (f"  {parameter['help']}" if in_full else "")
        )
    if row["effects"]:
        say("    effects: " + ", ".join(effect["name"] for effect in row["effects"]))
    if row["levels"]:
        say("    levels: " + ", ".join(level["name"] for level in row["levels"]))


def _range(parameter: dict[str, Any]) -> str:
    """Default and range of a parameter in few words."""
    if parameter["kind"] == "number":
        unit = f" {parameter['unit']}" if parameter["unit"] else ""
        return f"{parameter['default']:g}{unit}  ({parameter['minimum']:g} to {parameter['maximum']:g})"
    if parameter["kind"] == "choice":
        return f"{parameter['default']}  (" + " | ".join(parameter["options"]) + ")"
    return "on" if parameter["default"] else "off"

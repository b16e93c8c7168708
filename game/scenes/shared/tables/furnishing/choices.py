"""What can be chosen of a table's furnishing; a career wins some of it, then the start card offers it."""

from __future__ import annotations

from collections.abc import Mapping

from game.stage import Choice
from game.stage.declarations import StartLine

HOUSE = "house"
FELT_NAMES = {HOUSE: "House colour", "blue": "Blue", "olive": "Olive", "slate": "Slate"}
CAROM_FELT_NAMES = {"blue": "Blue", "green": "Green", "olive": "Olive", "slate": "Slate"}
MATCH, FAST, TIGHT = "match", "fast", "tight"
TABLE_NAMES = {MATCH: "Match table", FAST: "Fast cloth", TIGHT: "Tight pockets"}


def felt(names: Mapping[str, str] = FELT_NAMES) -> Choice:
    """The colour of a table's cloth. names: what there is, by the option; the first is the default."""
    return Choice(
        next(iter(names)), tuple(names), labels=tuple(names.values()), group="Table", in_panel=False,
        label="Colour of the cloth", help="chosen on the card before the game; a career unlocks colours",
    )  # fmt: skip


def table() -> Choice:
    """The kind of a table with pockets."""
    return Choice(
        MATCH, tuple(TABLE_NAMES), labels=tuple(TABLE_NAMES.values()), group="Table", in_panel=False,
        help="chosen on the card before the game; a career unlocks tables",
    )  # fmt: skip


CAROM_FELT_LINE = StartLine("felt", "Colour", "of the cloth", tuple(CAROM_FELT_NAMES.items()), "blue")
FELT_LINE = StartLine("felt", "Cloth", "its colour", tuple(FELT_NAMES.items()), HOUSE)
TABLE_LINE = StartLine("table", "Table", "its cloth and pockets", tuple(TABLE_NAMES.items()), MATCH)

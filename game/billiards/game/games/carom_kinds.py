"""The kinds of carom: how many cushions a point needs, which zones are barred (UMB, articles 52 to 83)."""

from __future__ import annotations

from typing import Literal, NamedTuple

from game.billiards.table.balk import BALKLINE_47_1, BALKLINE_47_2, BALKLINE_71_2, FREE, STRAIGHT_RAIL, Barred

Kind = Literal[
    "straight-rail",
    "one-cushion",
    "three-cushion",
    "balkline-47-2",
    "balkline-47-1",
    "balkline-71-2",
    "artistic",
]


class Rule(NamedTuple):
    """title: for people. cushions: needed before the second ball. barred: zones where points are limited."""

    title: str
    cushions: int = 0
    barred: Barred = FREE


RULES: dict[Kind, Rule] = {
    "straight-rail": Rule("Straight rail", 0, STRAIGHT_RAIL),
    "one-cushion": Rule("One-cushion", 1),
    "three-cushion": Rule("Three-cushion", 3),
    "balkline-47-2": Rule("Balkline 47/2", 0, BALKLINE_47_2),
    "balkline-47-1": Rule("Balkline 47/1", 0, BALKLINE_47_1),
    "balkline-71-2": Rule("Balkline 71/2", 0, BALKLINE_71_2),
    "artistic": Rule("Artistic"),
}
CUSHIONS = {kind: rule.cushions for kind, rule in RULES.items()}
TITLES = {kind: rule.title for kind, rule in RULES.items()}

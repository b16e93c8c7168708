"""Strokes and tables of snooker for tests of its rules."""

from __future__ import annotations

import msgspec

from game.billiards.game.rules import Pocketing, ShotSummary
from game.billiards.game.snooker.rules import Snooker, new_snooker
from game.billiards.game.snooker.stroke import Seen
from game.billiards.table.snooker import COLOURS, SPOTS

YELLOW, GREEN, BROWN, BLUE, PINK, BLACK = COLOURS
OPEN = {0: (0.9, 1.2), 1: (0.4, 2.0), 2: (1.3, 2.2), **SPOTS}  # the cue ball sees all that lies here


def game(**changes) -> Snooker:
    """A frame in its midst: two reds, all colours, Ada at the table."""
    start = {"on_table": (1, 2, *COLOURS), "opening": False, "in_hand": ""}
    return msgspec.structs.replace(new_snooker(), **{**start, **changes})


def order(*colours: int, **changes) -> Snooker:
    """A frame without reds, these colours left."""
    return game(on_table=tuple(colours), stage="order", **changes)


def shot(*first: int, down=(), cue=False, rest=None, off=()) -> ShotSummary:
    """A stroke: what was hit first, what went down, where all lies then."""
    gone = {*down, *off, *((0,) if cue else ())}
    places = OPEN if rest is None else rest
    lying = tuple((ball, x, y) for ball, (x, y) in sorted(places.items()) if ball not in gone)
    fallen = tuple(Pocketing(ball, 0) for ball in down)
    return ShotSummary(first=first, pocketed=fallen, cue_pocketed=cue, off_table=off, rest=lying)


def seen(places=None, **more) -> Seen:
    """What the referee saw of an open table, unless other places are given."""
    return Seen(OPEN if places is None else places, **more)

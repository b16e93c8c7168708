"""Points in the barred zones of straight rail and balkline: what is counted, when a ball must leave.

Numbers of articles are those of the Union Mondiale de Billard, World rules of carom billiard.
"""

from __future__ import annotations

from typing import NamedTuple

from game.arrays import Floats
from game.billiards.game.carom_summary import CaromSummary
from game.billiards.game.rules import Foul
from game.billiards.table.balk import Barred, Zone, zone_at
from game.billiards.table.carom import RED

ENTERED, INSIDE = 1, 2  # both balls have come into one barred zone; a point was made there (53)


class Counts(NamedTuple):
    """ENTERED or INSIDE while both object balls lie in one corner or box (inside), in one anchor (anchored);
    else 0.
    """

    inside: int = 0
    anchored: int = 0


def entered(barred: Barred, places: Floats, cue: int) -> Counts:
    """Of a position that a player comes to, or that a point has led to anew. places (3, 2) m."""
    return Counts(*(ENTERED * (_shared(zones, places, cue) >= 0) for zones in (barred.boxes, barred.anchors)))


def counts_after(barred: Barred, before: Counts, shot: CaromSummary, cue: int) -> Counts:
    """53: a point that leaves both balls in their zone; one that came back has entered anew."""
    now = entered(barred, shot.rest, cue)
    return Counts(
        INSIDE if now.inside and before.inside and not shot.left_corner else now.inside,
        INSIDE if now.anchored and before.anchored and not shot.left_anchor else now.anchored,
    )


def stayed(barred: Barred, before: Counts, shot: CaromSummary) -> tuple[Foul, ...]:
    """54: after the points that a zone gives, the next one must drive an object ball out of it."""
    most = barred.strokes
    if most is None:
        return ()
    name = "box" if barred.anchors else "corner"
    zones = ((name, before.inside, shot.left_corner), ("anchor", before.anchored, shot.left_anchor))
    return tuple(
        Foul("corner", f"Both balls stayed in the {zone}; one of them must leave it.")
        for zone, count, left in zones
        if count > most and not left
    )


def shared_zones(barred: Barred, counts: Counts, places: Floats, cue: int) -> tuple[tuple[Zone, int], ...]:
    """The zones in which both object balls lie, each with its count. places (3, 2) m."""
    found = []
    for zones, count in zip((barred.boxes, barred.anchors), counts, strict=True):
        zone = _shared(zones, places, cue)
        if zone >= 0:
            found.append((zones[zone], count))
    return tuple(found)


def must_leave(barred: Barred, counts: Counts, places: Floats, cue: int) -> tuple[Zone, ...]:
    """54: the zones of which a point must drive an object ball out. places (3, 2) m."""
    most = barred.strokes
    if most is None:
        return ()
    return tuple(zone for zone, count in shared_zones(barred, counts, places, cue) if count > most)


def _shared(zones: tuple[Zone, ...], places: Floats, cue: int) -> int:
    """Number of the zone in which both object balls lie, -1 for none. places (3, 2) m."""
    first, second = (zone_at(zones, tuple(places[ball].tolist())) for ball in (1 - cue, RED))
    return first if first == second else -1

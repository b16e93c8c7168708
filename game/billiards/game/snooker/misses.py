"""Foul and a miss (WPBSA 2.21, 3.14): when a stroke that hit no ball on is called one.

The referee's eye for a good enough attempt is a setting. Professional: every failure to hit a ball on is a
miss. Club: so is one where a straight path to any part of a ball on was open. An escape from a snooker is
good enough if the cue ball came within a ball's breadth of a ball on. Off: none is called. No program sees an
intention: where a player needs penalty points, or the points on the table are just the difference, a miss
counts as not intended. But 3.14(c) holds whatever the scores.
"""

from __future__ import annotations

from typing import Literal

from game.billiards.game.rules import ShotSummary
from game.billiards.game.snooker.sight import any_path
from game.billiards.game.snooker.stroke import Seen, Target, fails_to_hit
from game.billiards.table.snooker import BALL_RADIUS

MissRule = Literal["professional", "club", "off"]

CLUB_NEAR = 2.0 * BALL_RADIUS  # m; an escape that comes so near is good enough in a club
MOST_FULL = 3  # failures in a row with a full ball to be hit lose the frame (3.14(c)(ii))
MOST_SIX_RED = 5  # misses in a row at six-red snooker (six-red rule 1)


def is_miss(
    rule: MissRule, target: Target, shot: ShotSummary, seen: Seen, excused: bool, full_again: bool
) -> bool:
    """True if a stroke is a miss. excused: a player needs penalty points, see above. full_again: a full ball
    could be hit, and a miss was called from this position before (3.14(c)(i)).
    """
    if rule == "off" or not seen.places or not fails_to_hit(target, shot, seen):
        return False
    if excused:
        return full_again
    if rule == "professional" or any_path(seen.places, target.first):
        return True
    return seen.near > CLUB_NEAR

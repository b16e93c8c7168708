"""How near to the place of a drill the last stroke has brought the ball that is to stop there."""

from __future__ import annotations

import math

from game.billiards.game.games import Drill
from game.billiards.game.goals import missed
from game.scenes.billiards.play import AIMING, Play
from game.stage.records.scored import Scored


def scored_by(play: Play) -> Scored | None:
    """None where the last goal has no ring, and while balls roll."""
    frame = play.model.frame
    game = frame.game
    zone = next(iter(game.more[-1].zones), None) if isinstance(game, Drill) and game.more else None
    if zone is None or not isinstance(game, Drill) or play.phase != AIMING or play.plays_itself:
        return None
    played, distance = play.model.played, None
    if played is not None and not missed(game.goal, played.summary):
        places = {ball: (x, y) for ball, x, y in played.summary.rest}
        if zone.ball in places:
            x, y = places[zone.ball]
            distance = math.sqrt((x - zone.x) * (x - zone.x) + (y - zone.y) * (y - zone.y))
    return Scored(frame.strokes, distance, zone.radius)

"""What is kept of a billiard game: as a level, and against a crash."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from game.billiards.game.arrangement import Arrangement
from game.billiards.game.deciding import deciding_strokes
from game.billiards.game.frame import BestStroke, Struck, trajectory_of
from game.billiards.game.games import Drill, RunDrill
from game.scenes.billiards.level import BestPlayed, BilliardsContent, PlacedBall
from game.scenes.billiards.model import BilliardsModel
from game.scenes.billiards.opponents.thinking import decision_of
from game.scenes.billiards.play import SET_UP, SLOW, SLOW_AFTER_S, SLOW_BEFORE_S, Play
from game.scenes.billiards.practice.drill_maker import DrillMaker
from game.scenes.billiards.practice.log_text import text_of_log
from game.scenes.billiards.stroke.motion import PRACTISED, stroke_motion
from game.scenes.shared.tables.kept.excerpts import REST_S, excerpt_of
from game.stage.records.excerpt import Excerpt

if TYPE_CHECKING:
    from game.stage import Scene


def content_of(play: Play, maker: DrillMaker) -> BilliardsContent:
    """Game, table and log as they are; in the midst of a stroke, as they were before it.

    A drill is kept as it begins, for it is to be tried again. While the balls are set up it is what will be
    played: the drill that is made, as soon as nothing is lacking, else what is practised then.
    """
    if maker.active and not maker.lacking:
        return maker.content
    model = play.model
    frame = model.after_set_up if play.phase == SET_UP else model.frame
    game, best = frame.game, frame.best
    if isinstance(game, Drill | RunDrill):
        return model.content
    return BilliardsContent(
        game=model.content.game, players=model.content.players, cup=model.content.cup,
        calling=model.content.calling, alternating=model.content.alternating,
        balls=_placed(frame.layout), solution=model.content.solution,
        saved=msgspec.to_builtins(game), tallies=frame.tallies,
        rack_tallies=frame.rack_tallies, log=text_of_log(play.log),
        best=_told(best) if best is not None else None,
    )  # fmt: skip


def _placed(layout: Arrangement) -> list[PlacedBall]:
    return [PlacedBall(number=number, position=(x, y)) for number, x, y in layout.places]


def _told(best: BestStroke) -> BestPlayed:
    """A stroke as a level tells of it."""
    frame, stroke, call = best.struck
    return BestPlayed(
        balls=_placed(frame.layout), game=msgspec.to_builtins(frame.game), stroke=(*stroke,),
        **call._asdict(),
    )  # fmt: skip


def stroke_excerpt(play: Play, scene: Scene) -> Excerpt | None:
    """The last stroke from the position before it, to its end as it is shown. None if there is none, or if
    balls, table or cloth have been changed since.
    """
    last = play.model.frame.last
    if last is None or last.frame.conditions != play.model.frame.conditions:
        return None
    played = play.model.played
    return _excerpt_of(last, play, scene, played.trajectory.end_time if played is not None else 0.0)


def highlights(play: Play, scene: Scene) -> tuple[Excerpt, ...]:
    """The strokes that decided the match, each from the position before it."""
    now = play.model.frame.conditions
    return tuple(
        _excerpt_of(one.struck, play, scene, trajectory_of(one.struck).end_time)
        for one in deciding_strokes(play.log) if one.struck.frame.conditions == now
    )  # fmt: skip


def _excerpt_of(last: Struck, play: Play, scene: Scene, end_s: float) -> Excerpt:
    """A stroke from the position before it, to its end, s, as it is shown."""
    model = play.model
    content = BilliardsContent(
        game=model.content.game, players=model.content.players, calling=model.content.calling,
        balls=_placed(last.frame.layout), saved=msgspec.to_builtins(last.frame.game),
    )  # fmt: skip
    slowed_s = (SLOW_BEFORE_S + SLOW_AFTER_S) * (1.0 / SLOW - 1.0)
    motion = stroke_motion(last.stroke.cue_speed, PRACTISED)
    shown_s = max(end_s, motion.end_s - motion.hit_s) + 0.05
    longest_s = motion.hit_s + shown_s + slowed_s + REST_S
    return excerpt_of(scene, content, decision_of(last.stroke, last.call), longest_s)


def worth_keeping(model: BilliardsModel, plays_itself: bool) -> object:
    """Game and places once a stroke has been played; None for a drill, which begins again with each."""
    frame = model.frame
    if isinstance(frame.game, Drill | RunDrill) or plays_itself or not frame.strokes:
        return None
    return frame.game, frame.layout.places

"""A stroke of a game as a recording of its own, for films: the position before it, the stroke, its end."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from game.billiards.game.deciding import deciding_of
from game.levels import Level
from game.scenes.shared.tables.cue import longest_swing_s
from game.stage import Decision, Scene
from game.stage.records.excerpt import Excerpt

REST_S = 0.25  # s that the balls are shown at rest after the stroke
# parameters that a single stroke does not depend on
WHO_PLAYS = ("game", "first_player", "second_player", "hand_over", "head_start")


def excerpt_of(scene: Scene, content: Any, decision: Decision, shown_s: float) -> Excerpt:
    """A stroke as an excerpt. content: of a level that begins before it; shown_s: how long it is, s."""
    declared = scene.declared_parameters()
    changed = {
        name: value for name, value in scene.values.items()
        if value != declared[name].default and name not in WHO_PLAYS
    }  # fmt: skip
    level = Level(scene=scene.name, title="A stroke", parameters=changed, content=content)
    return Excerpt("stroke", level, scene.seed, scene.active, (decision,), round(shown_s / scene.dt))


def excerpts_of(
    scene: Scene, course: Any, content_of: Callable[[Any], Any], decision_of: Callable[[Any], Decision]
) -> tuple[Excerpt, ...]:
    """The strokes that decided the match at a table with a `CueCourse`, each from the position before it.

    content_of: a frame as a level's content; decision_of: a stroke with its frame as the event that plays it.
    """
    slow_s = course.slowed_s
    return tuple(
        excerpt_of(
            scene, content_of(one.struck.frame), decision_of(one.struck),
            longest_swing_s(one.struck.stroke.cue_speed * course.ball_per_cue) + one.end_s + slow_s + REST_S,
        )
        for one in deciding_of(course.marked) if one.struck.frame.physics == course.model.frame.physics
    )  # fmt: skip

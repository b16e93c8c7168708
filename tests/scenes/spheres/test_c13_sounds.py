"""Colliding spheres are heard: each collision once, whatever the frames' lengths."""

from game.app.stagehand.opening import Opening
from game.levels import level_files
from game.scenes.spheres.scene import SphereCollisions
from tests.scenes.listening import heard_in


def test_every_collision_is_heard_once_at_any_frame_rate():
    slow, fast = (heard_in(Opening().make_stage(SphereCollisions), [n] * (240 // n)) for n in (6, 1))
    assert slow == fast
    assert {kind for kind, _ in fast} == {"ball", "cushion"}


def test_a_cradle_at_rest_between_its_clicks_is_silent():
    path = next(p for p in level_files("c13") if "cradle" in p.stem)
    stage = Opening(level=path).make_stage(SphereCollisions)
    clicks = heard_in(stage, [2] * 120)
    assert 1 <= len(clicks) < 200
    assert all(kind == "ball" for kind, _ in clicks)

"""A story of the example scene, short and with every verb in it."""

from __future__ import annotations

from game.stage import Choice, Hearing, Readout, Sound
from game.stage.script.lines import Story
from game.stage.story.reading import parse_story
from tests.stage.example_scene import BouncingBall


class StoryBall(BouncingBall):
    """The example scene with what a story may name."""

    name = "story-ball"
    quality = Choice("play", ("play", "film"), help="how fine")

    def story_targets(self):
        return {"ball": tuple(self.ball.position.tolist())}

    def readouts(self):
        return [*super().readouts(), Readout("bounces", int(self.ball.bounces[0]))]

    def build(self, level):
        super().build(level)
        self.time = 0.0

    def advance(self, dt):
        super().advance(dt)
        self.time += dt

    def hearing(self):
        return Hearing("ball", self.time, [Sound(0.5 * i, "ball", 2.0) for i in range(1, 200)])


TEXT = """
scene = "story-ball"
title = "A ball"
about = "It bounces."
[parameters]
height = 12.0
[[line]]
look = "whole"
cut = true
[[line]]
title = "A ball"
line = "that bounces"
seconds = 2.0
[[line]]
follow = "ball"
width = 4.0
ease = 1.0
[[line]]
say = "It has bounced {bounces:.0f} times and is {height} up."
[[line]]
moment = "three"
when = ["bounces > 2.5"]
deadline = 8.0
chapter = "Three bounces"
[[line]]
slow = 0.25
[[line]]
say = "Slowly."
until = "five"
[[line]]
moment = "five"
when = "bounces >= 5"
deadline = 9.0
[[line]]
slow = 1.0
[[line]]
do = { parameter = "restitution", value = 0.4, over = 1.0 }
[[line]]
do = { action = "kick" }
at = "five"
after = 0.5
[[line]]
look = [0.0, 1.0]
width = 8.0
cut = true
[[line]]
do = { pointer = "click", place = [0.5, 2.0] }
[[line]]
hand_over = "Kick it."
seconds = 3.0
[[expect]]
expect = "bounces"
least = 5.0
at = "five"
[[expect]]
expect = "height"
most = 4.0
by = 2.0
[[expect]]
expect = "energy"
least = 0.0
"""


def story(text: str = TEXT) -> Story:
    """The story that a text says."""
    return parse_story(text, StoryBall)


StoryBall.stories = (story(),)

"""The hand at the three tables: one cue for all of them, and strokes of their own while it is not held."""

from __future__ import annotations

import math

import msgspec

from game.scenes.shared.tables.cue import AIMING, CueControl
from game.scenes.shared.tables.demo_shots import choose_stroke
from game.scenes.three_tables.model import ThreeTablesModel
from game.scenes.three_tables.places import EXACT, ORIGINS, table_at
from game.stage import Part, Pointer
from game.stage.messages import Messages

NEXT_STROKE_S = 1.5  # s between the end of a shot and the next stroke that the table plays itself


class ThreeTablesHand(Part):
    """The cue, and whose it is. grasped: the table that the pointer is on. seed: of strokes of their own."""

    def __init__(self, model: ThreeTablesModel, plays_itself: bool, seed: int) -> None:
        self.model = model
        self.cue = CueControl(0.5 * math.pi)
        self.grasped = EXACT
        self.plays_itself = plays_itself
        self.seed = seed
        self.messages = Messages()

    def advance(self, dt: float) -> None:
        """Move the cue; it strikes when it reaches the ball."""
        if self.cue.advance(dt) and not self.model.playing:
            self.model.strike(self.cue.aim, self.cue.speed)

    def play_by_itself(self) -> None:
        """Begin a stroke if the cue is not held and the last shot is long over."""
        model = self.model
        if self.plays_itself and model.idle_s > NEXT_STROKE_S and self.cue.phase == AIMING:
            chosen = choose_stroke(
                model.start, model.radii, model.in_play, model.bed, self.seed, model.strokes
            )
            self.cue.strike(chosen.aim, chosen.speed)

    def take(self, event: Pointer) -> None:
        """What a pointer event does to the cue; a table that plays itself is taken over by a press."""
        if event.kind == "down" and event.button == 1 and self.plays_itself:
            self.plays_itself = False
            self.messages.say("The cue is yours: pull back and let go.")
        if self.plays_itself:
            return
        if self.cue.phase == AIMING:
            self.grasped = table_at(event.x, event.y)
        x, y = ORIGINS[self.grasped]
        local = msgspec.structs.replace(event, x=event.x - x, y=event.y - y)
        ball_x, ball_y = self.model.start[0].tolist()
        self.cue.pointer(local, ball_x, ball_y, not self.model.playing)

    def take_action(self, name: str) -> None:
        """Let the table play itself ("demo"), or not; turn the cue a little ("left", "right")."""
        if name == "demo":
            self.plays_itself = not self.plays_itself
            self.cue.let_go()
        else:
            self.cue.nudge(name)

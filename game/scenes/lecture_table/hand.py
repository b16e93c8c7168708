"""The hand at the lecture's table: it takes the cue, aims, pulls back and lets go."""

from __future__ import annotations

from game.scenes.lecture_table.turns import Turns
from game.stage import Pointer


def take_pointer(turns: Turns, event: Pointer) -> None:
    """What a pointer event does to the cue; a table that plays itself is taken over by a press."""
    model = turns.model
    if not model.has_cue_ball:
        return
    if event.kind == "down" and event.button == 1 and turns.plays_itself:
        turns.take_over()
    if turns.plays_itself:
        return
    x, y = model.table.positions[0].tolist()
    turns.cue.pointer(event, x, y, model.cue_ball_ready)


def take_action(turns: Turns, name: str) -> None:
    """Let the table play itself ("demo"), or not; turn the cue a little ("left", "right")."""
    if name == "demo":
        turns.plays_itself = not turns.plays_itself
        turns.cue.let_go()
    else:
        turns.cue.nudge(name)

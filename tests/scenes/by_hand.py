"""What a person does to a stage, and reads of it, for the tests of scenes."""

from __future__ import annotations

from game.stage import Pointer, Stage


def measured(stage: Stage, name: str) -> float:
    """The value of a readout by its name."""
    return next(readout.value for readout in stage.readouts() if readout.name == name)


def drag(stage: Stage, *places: tuple[float, float], button: int = 1, steps: int = 1) -> None:
    """Press at the first place, move through the others, let go at the last. steps: before each of it."""
    stage.post(Pointer("down", *places[0], button))
    for place in places[1:]:
        stage.run(steps)
        stage.post(Pointer("move", *place, button))
    stage.run(steps)
    stage.post(Pointer("up", *places[-1], button))
    stage.run(1)

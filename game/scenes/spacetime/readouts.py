"""What is measured of detection on a budget."""

from __future__ import annotations

from game.physics.spacetime.refine import NO_BOUND
from game.scenes.spacetime.model import SpaceTimeModel
from game.stage import Readout


def readouts_of(model: SpaceTimeModel) -> tuple[Readout, ...]:
    """The last step's tests, and the two bodies' distance by the budget beside the exact one."""
    pair, queue = model.pair(), model.world.queue()
    upper = pair.answer.upper
    return (
        Readout("tests", model.tests),
        Readout("pairs due", model.due),
        Readout("untested", model.untested),
        Readout("bounces", model.bounces),
        Readout("missed", model.world.missed()),
        Readout("next contact", max(queue[0][0], 0.0) if queue else 0.0, "s"),
        Readout("in doubt", model.doubt, "m"),
        Readout("distance", pair.answer.estimate, "m"),
        Readout("exact distance", pair.exact, "m"),
        Readout("error", pair.error, "m"),
        Readout("error bound", upper - pair.answer.lower if upper < NO_BOUND else 0.0, "m"),
        Readout("level reached", pair.answer.level),
    )

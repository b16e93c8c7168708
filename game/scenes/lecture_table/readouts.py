"""What the lecture's table measures."""

from __future__ import annotations

import math

from game.physics.kernels import linear
from game.scenes.lecture_table.model import LectureTableModel
from game.stage import Readout

LEAST_OVERLAP = 1e-12  # m; below that balls in contact overlap by rounding only


def readouts_of(model: LectureTableModel) -> tuple[Readout, ...]:
    """What is shown and charted."""
    table = model.table
    across, along = table.momentum
    cue_ball = table.velocities[0]
    overlap = table.deepest_overlap
    return (
        Readout("balls down", model.balls_down),
        Readout("cue ball", math.sqrt(float(linear.product(cue_ball, cue_ball))), "m/s"),
        Readout("its velocity along", float(cue_ball[1]), "m/s"),
        Readout("its velocity across", float(cue_ball[0]), "m/s"),
        Readout("energy", table.energy, "J"),
        Readout("along", along, "kg m/s"),
        Readout("across", across, "kg m/s"),
        Readout("overlap", overlap if overlap > LEAST_OVERLAP else 0.0, "m"),
        Readout("passed unseen", model.marks.unseen),
        Readout("substeps", table.counters["substeps"]),
        Readout("strokes", model.strokes),
    )

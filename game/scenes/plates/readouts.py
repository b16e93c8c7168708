"""What is measured of falling plates: of the chosen one in the paper's units, and of all."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementary, elementwise
from game.physics.plates import watch
from game.physics.plates.law import SPIN
from game.scenes.plates.model import PlatesModel
from game.stage import Readout


def readouts_of(model: PlatesModel) -> tuple[Readout, ...]:
    """Spin, descent and period by a and U beside the references; how many flutter, tumble or neither."""
    plates, chosen = model.plates, model.chosen
    courses = [model.course(i).regime for i in range(len(plates))]
    inertia = spin = descent = period = amplitude = speed = now = math.nan
    if 0 <= chosen < len(plates):
        inertia, _, half, unit = model.numbers_of(chosen)
        course = model.course(chosen)
        spin, descent = course.spin * half / unit, course.descent / unit
        period, amplitude = course.period * unit / half, math.degrees(course.amplitude)
        speed = elementary.length(*plates.velocities[chosen].tolist()) / unit
        now = float(plates.rows[SPIN, chosen]) * half / unit
    spin_exact, descent_exact, period_exact = model.reference(chosen)
    fast = elementwise.hypot(*plates.velocities.T) if len(plates) else np.zeros(0)
    return (
        Readout("inertia", inertia),
        Readout("descent", descent, "U"),
        Readout("descent, reference", descent_exact, "U"),
        Readout("spin", abs(spin), "U/a"),
        Readout("spin, reference", spin_exact, "U/a"),
        Readout("period", period, "a/U"),
        Readout("period, reference", period_exact, "a/U"),
        Readout("amplitude", amplitude, "°"),
        Readout("speed", speed, "U"),
        Readout("spin now", now, "U/a"),
        Readout("flutter", courses.count(watch.FLUTTER)),
        Readout("tumble", courses.count(watch.TUMBLE)),
        Readout("glide", courses.count(watch.GLIDE)),
        Readout("irregular", courses.count(watch.CHAOS)),
        Readout("at rest", int(np.count_nonzero(fast < 5e-3))),
        Readout("fastest", float(np.max(fast, initial=0.0)), "m/s"),
        Readout("energy gained", model.gains[0] / max(float(model.gains[1]), 1e-12)),
    )

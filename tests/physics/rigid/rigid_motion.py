"""What the tests of rigid motion share: a free body with the moments 1, 2, 3, many steps in one call."""

from __future__ import annotations

import math

import numpy as np

from game.physics.rigid import ROTATION, RigidBody

MOMENTS = np.array((1.0, 2.0, 3.0))
STARTS = {"axis 3 side": (0.2, 3.0, 0.4), "axis 1 side": (0.4, 3.0, 0.1), "generic": (1.0, 0.5, 2.0)}
# spin after 10 s; half period, s; sign changes of the middle spin in 100 s and the first of them, s
SPINS_AT_10 = {
    "axis 3 side": (-0.125995287565203, -3.004018173632, 0.389818253586907),
    "axis 1 side": (2.54952783347567, 1.63092238513452, -1.45717674215897),
    "generic": (0.314985781916866, 1.072745989128, 1.92347047831169),
}
PERIODS = {"axis 3 side": 6.62501236245006, "axis 1 side": 8.06422455531918, "generic": 3.19359396150564}
FLIPS = {
    "axis 3 side": (30, 1.82754067270596),
    "axis 1 side": (25, 2.28341404275571),
    "generic": (62, 1.36653984756033),
}
ENERGY_BOUNDS = {"axis 3 side": 2.02375809935205, "generic": 2.81481481481481}


def free_body(method, spin, moments=MOMENTS, **settings):
    return RigidBody(
        1.0,
        moments,
        angular_velocity=spin,
        method=method,
        effects=settings.pop("effects", ROTATION),
        **settings,
    )


def energy(body):
    return body.kinetic_energy[1]


def length(vector):
    return math.sqrt(math.fsum(x * x for x in np.asarray(vector).tolist()))

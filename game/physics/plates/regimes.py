"""What a falling plate does in the long run: its regime, period, spin and speed of descent.

Lengths here are in half chords a, times in a/U, speeds in U = sqrt((rho_s/rho - 1) g b), as in the paper. So
a plate is its inertia I, its thickness beta and its coefficients.

BORDERS: of I for the default coefficients at beta = 1/14, found by this program's own runs, the first by
bisection. Published regimes are those of Andersen, Pesavento and Wang 2005 (flutter at 1.1, tumbling at 1.4).

They hold up to a thickness THICKEST: there and at 0 the first two lie within 3 % of these, the last
within 4 %. From the second to about 1.55 plates flutter once more before they are irregular. A thicker plate
tumbles earlier, at 0.5 from 1.02 to 1.29.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.physics.kernels import elementary, elementwise
from game.physics.plates import law
from game.physics.plates.flight import LANES, METHODS, ROWS, WIND, fly
from game.physics.plates.law import Plate, law_of

REGIMES = ("flutter", "tumble", "chaos", "broadside", "glide")
BORDERS = (1.2149, 1.48, 2.83)  # flutter | tumble | irregular | flutter about broadside
THICKEST = 0.125  # beta up to which BORDERS hold
LEAST_SPIN = 0.15  # U/a, of a plate that tumbles
GLIDING = 0.6  # m across for each m down, from which on what swings steadily glides
UNSTEADY = 0.1  # spread of swings beside their mean, from which on they are irregular


class Course(NamedTuple):
    """What a plate did: a word of REGIMES. Then period between two swings (or turns), half amplitude of the
    angle (deg), mean spin and descent. Last half width of the swing between turning points of the angle,
    angle of the descent below the horizontal (deg).
    """

    regime: str
    period: float
    amplitude: float
    spin: float
    descent: float
    swing: float
    slope: float


@lean_kernel
def trace(state, laws, air, buffer, counts, settings, dt, every, out):
    """Fly on and write the states (len(out), STATE, n), ``every`` so many steps of dt (s) the next."""
    for k in range(out.shape[0]):
        for row in range(state.shape[0]):
            for i in range(state.shape[1]):
                out[k, row, i] = state[row, i]
        for _ in range(every):
            fly(state, laws, air, buffer, counts, settings, dt)


def drop(
    plates: list[Plate],
    tilt: float,
    time: float,
    dt: float = 0.02,
    spin: float = 0.0,
    every: int = 5,
    method: str = "rk4",
) -> Floats:
    """States (k, STATE, n) of plates in reduced units, every so many steps dt; begun at rest but for 0.01 U
    along their normal, tilted (rad), with a spin (U/a).
    """
    n = len(plates)
    laws = np.zeros((law.COLUMNS, n))
    for i, plate in enumerate(plates):
        # lengths a = 1, and the half chord at which U = 1
        laws[:, i] = law_of(plate._replace(half_chord=1.0, torque=0.0))
        laws[law.TORQUE, i] = plate.torque
        laws[law.WEIGHT, i] = 1.0  # the weight (I - beta) g in units of U²/a
    state = np.zeros((law.STATE, n))
    state[law.THETA], state[law.SPIN] = tilt, spin
    state[law.VX], state[law.VY] = 0.01 * elementary.sin(tilt), -0.01 * elementary.cos(tilt)
    out = np.zeros((int(time / (dt * every)) + 1, law.STATE, n))
    trace(
        state, laws, np.zeros((WIND, n)), np.zeros(ROWS * LANES), np.zeros(LANES, dtype=np.int64),
        (1.0, 0.0, 0.0, 1.0, float(METHODS.index(method))), dt, every, out,
    )  # fmt: skip
    return out


def course_of(states: Floats, times: Floats) -> Course:
    """The course of one plate over whole cycles: states (k, STATE) at times (k,), without its transient."""
    theta = states[:, law.THETA]
    mean = float(theta[-1] - theta[0]) / float(times[-1] - times[0])
    half = len(theta) // 2
    parts = np.array([theta[half] - theta[0], theta[-1] - theta[half]])
    if abs(mean) > LEAST_SPIN and parts[0] * parts[1] > 0.0 and min(abs(parts)) > 0.7 * max(abs(parts)):
        return _cycle(states, times, crossings(elementwise.sin(0.5 * theta), times), "tumble")
    stops = crossings(states[:, law.SPIN], times)
    if len(stops) < 5:
        level = abs(elementary.sin(float(np.mean(theta)))) < 0.5
        fell, went = states[0, law.Y] - states[-1, law.Y], abs(states[-1, law.X] - states[0, law.X])
        return _cycle(states, times, times[[0, -1]], "broadside" if level and went < fell else "glide")
    last = len(stops) - 1 - (len(stops) - 1) % 2
    begins = stops[: last + 1 : 2]
    angles = values_at(theta, times, stops)
    steady = spread_of(np.diff(begins)) < UNSTEADY and spread_of(np.abs(np.diff(angles))[:last:2]) < UNSTEADY
    if not steady:
        return _cycle(states, times, begins, "chaos")
    x, y = values_at(states[:, law.X], times, begins), values_at(states[:, law.Y], times, begins)
    far = abs(x[-1] - x[0]) > GLIDING * (y[0] - y[-1])
    return _cycle(states, times, begins, "glide" if far else "flutter")


def spread_of(values: Floats) -> float:
    """Standard deviation beside the mean."""
    return float(np.std(values) / max(float(np.mean(values)), 1e-12))


def _cycle(states: Floats, times: Floats, begins: Floats, regime: str) -> Course:
    """Means from the first to the last of the moments at which cycles begin."""
    if len(begins) < 2:
        begins = times[[0, -1]]
    took = float(begins[-1] - begins[0])
    period = took / (len(begins) - 1)
    x, y, theta = (values_at(states[:, row], times, begins) for row in (law.X, law.Y, law.THETA))
    fell, went, turned = float(y[0] - y[-1]), float(x[-1] - x[0]), float(theta[-1] - theta[0])
    angles, swing = 0.0, 0.0
    stops = crossings(states[:, law.SPIN], times)
    if len(stops) > 1:
        angles = math.degrees(_half_way(states[:, law.THETA], times, stops))
        swing = _half_way(states[:, law.X], times, stops)
    if len(stops) < 5 and regime != "tumble":
        period = math.nan
    slope = math.degrees(elementary.atan2(fell, abs(went)))
    return Course(regime, period, angles, turned / took, fell / took, swing, slope)


def _half_way(values: Floats, times: Floats, stops: Floats) -> float:
    """Half the mean way between turning points."""
    return 0.5 * float(np.mean(np.abs(np.diff(values_at(values, times, stops)))))


def _around(at: float, times: Floats) -> slice:
    """Four samples about a time."""
    k = min(max(int(np.searchsorted(times, at)) - 2, 0), max(len(times) - 4, 0))
    return slice(k, k + 4)


def values_at(values: Floats, times: Floats, moments: Floats) -> Floats:
    """Values (m,) at moments between samples, by cubics."""
    found = []
    for at in moments.tolist():
        part = _around(at, times)
        t, v = times[part] - at, values[part]
        found.append(sum(float(v[i]) * _weight(t, i) for i in range(len(t))))
    return np.array(found)


def _weight(t: Floats, i: int) -> float:
    """Lagrange's weight of the sample i at t = 0."""
    others = np.delete(t, i)
    return float(np.prod(-others / (t[i] - others)))


def crossings(values: Floats, times: Floats) -> Floats:
    """Times at which values go through 0, by cubics between samples."""
    found = []
    for k in np.flatnonzero(values[:-1] * values[1:] < 0.0).tolist():
        low, high = float(times[k]), float(times[k + 1])
        rises = values[k] < 0.0
        for _ in range(50):
            middle = 0.5 * (low + high)
            over = float(values_at(values, times, np.array([middle]))[0]) > 0.0
            low, high = (low, middle) if over == rises else (middle, high)
        found.append(low)
    return np.array(found)


def long_run(
    plates: list[Plate], tilt: float = 0.2, time: float = 300.0, skip: float = 150.0
) -> list[Course]:
    """The course of each plate after ``skip``, from a drop at a tilt (rad), reduced units."""
    dt, every = 0.02, 5
    states = drop(plates, tilt, time, dt, every=every)
    times: Floats = np.arange(len(states), dtype=np.float64) * (dt * every)
    kept = times >= skip
    return [course_of(states[kept, :, i], times[kept]) for i in range(len(plates))]

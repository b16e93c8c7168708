"""Samples of key-frames, skins and reaching chains, beside numpy and scipy."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from game.arrays import Floats
from game.lab.benchmarks.scenario import Call, Peer, Scenario
from game.lab.studies.animation.skinning import by_numpy
from game.physics.animation import Binding, Keyframes, Skeleton, Skinner, Solver, bind_weights, chain_skeleton
from game.physics.kernels import elementwise

# -- key-frames -----------------------------------------------------------------------------------------

SAMPLES, KEYS = 1_000_000, 16


def keys(count: int = KEYS, columns: int = 3) -> tuple[Floats, Floats]:
    """Times (count,) s and values (count, columns) of keys of place and angle."""
    rng = np.random.default_rng(1)
    return np.linspace(0.0, 1.0, count), rng.normal(size=(count, columns))


def moments(count: int = SAMPLES, at_random: bool = False) -> Floats:
    """Times (count,) s, in order or not."""
    at = np.linspace(0.0, 1.0, count)
    return np.random.default_rng(2).permutation(at) if at_random else at


def by_interp(at: Floats) -> list[Floats]:
    """Linear, column by column: numpy.interp."""
    times, values = keys()
    return [np.interp(at, times, column) for column in values.T]


def scipy_spline() -> Call:
    """The cubic spline by scipy."""
    from scipy.interpolate import CubicSpline

    spline, at = CubicSpline(*keys()), moments()
    return lambda: spline(at)


def _samples(name: str) -> Call:
    track, at, out = Keyframes(*keys(), name), moments(), np.empty((SAMPLES, 3))
    return lambda: track.sample(at, out)


# -- skins ----------------------------------------------------------------------------------------------

POINTS, BONES = 100_000, 15


def posed_skin() -> tuple[Skeleton, Binding]:
    """A bent chain and points bound to it."""
    rng = np.random.default_rng(1)
    skeleton = chain_skeleton(np.full(BONES, 1.0 / BONES), rng.uniform(-0.3, 0.3, BONES))
    binding = bind_weights(skeleton, rng.uniform(-0.2, 1.0, (POINTS, 2)), 0.3)
    skeleton.pose(rng.uniform(-0.5, 0.5, BONES))
    return skeleton, binding


def _skin(blend: str) -> Call:
    skeleton, binding = posed_skin()
    skinner = Skinner(binding)
    return lambda: skinner(skeleton.world, blend)


def _numpy_skin() -> Call:
    return by_numpy(*posed_skin())


# -- reaching -------------------------------------------------------------------------------------------

TOLERANCE, MOST = 1e-6, 20_000  # m, iterations


def reach(targets: int, farthest: float = 0.9) -> tuple[Solver, Floats, Floats]:
    """A chain of 1 m in all, its start (BONES,) rad, and targets (targets, 2) m within its reach."""
    rng = np.random.default_rng(3)
    skeleton = chain_skeleton(np.full(BONES, 1.0 / BONES))
    solver = Solver(skeleton, 0, BONES - 1)
    start = rng.uniform(-0.3, 0.3, BONES)
    skeleton.pose(start)
    radii, turns = farthest * np.sqrt(rng.random(targets)), rng.uniform(-math.pi, math.pi, targets)
    return solver, start, np.column_stack([radii * elementwise.cos(turns), radii * elementwise.sin(turns)])


def _reaching(method: str) -> Call:
    solver, _, targets = reach(100)
    return lambda: solver.solve_each(targets, method, TOLERANCE, MOST)


SCENARIOS = (
    Scenario(
        "keys-linear", "A million samples of 16 keys, linear", "run", partial(_samples, "linear"),
        peers=(Peer("numpy.interp", lambda: partial(by_interp, moments())),),
    ),
    Scenario(
        "keys-spline", "A million samples of 16 keys, spline", "run", partial(_samples, "spline"),
        peers=(Peer("scipy CubicSpline", scipy_spline),),
    ),
    Scenario(
        "skin-linear", "Skin of 100,000 points and 15 bones, matrices", "run", partial(_skin, "linear"),
        peers=(Peer("numpy einsum", _numpy_skin),),
    ),
    Scenario("skin-rotor", "Skin of 100,000 points and 15 bones, rotors", "run", partial(_skin, "rotor")),
    *(
        Scenario(f"reach-{method}", f"Reaching to 1 µm with 15 bones, {title}", "target",
                 partial(_reaching, method), 100)
        for method, title in (
            ("damped", "damped least squares"), ("fabrik", "FABRIK"), ("ccd", "CCD"), ("buss", "gradient")
        )
    ),
)  # fmt: skip

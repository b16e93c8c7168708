"""A sweep slowed down: time stands still, and link by link is put right from the prediction on."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.constraints import DAMPING
from game.physics.fields import GRAVITY
from game.scenes.springs.model import SpringModel
from game.ui.canvas.canvas import Canvas
from game.ui.look.numerals import format_si

STEPS_A_LINK = 24  # of the scene, that each link takes
SHOWN_SWEEPS = 4  # before it begins again, or as many as there are iterations


class SlowSweep(NamedTuple):
    """places (n, 2) m: after the links that are done. before: as predicted. sweep, link: what is next;
    excess: by how much (m) that one is too long."""

    places: Floats
    before: Floats
    sweep: int
    link: int
    excess: float


def predicted(model: SpringModel) -> Floats:
    """Where (n, 2) m the particles would go in a substep without links."""
    system, parameters = model.system, model.parameters
    h = parameters.step_length / int(parameters.substeps)
    free = (system.inverse_masses > 0.0)[:, None]
    slowed = np.ones(system.count)
    if DAMPING in model.active:
        slowed += h * parameters.damping * system.inverse_masses
    velocities = system.velocities / slowed[:, None]
    if GRAVITY in model.active:
        velocities = velocities - (0.0, h * parameters.gravity)
    return np.where(free, system.positions + h * velocities, system.positions)


def put_right(places: Floats, weights: Floats, pair: tuple[int, int], rest: float) -> None:
    """Move both ends of a link along it, in ``places``, until its length is right; the lighter one more."""
    a, b = pair
    way = places[b] - places[a]
    length, both = math.sqrt(float(way @ way)), float(weights[a] + weights[b])
    if length > 0.0 and both > 0.0:
        move = (length - rest) / (length * both) * way
        places[a] += weights[a] * move
        places[b] -= weights[b] * move


def sweep_now(model: SpringModel) -> SlowSweep | None:
    """What is shown at the model's ``sweep_tick``; None where there is no whole link."""
    system = model.system
    whole = np.flatnonzero(system.torn == 0)
    if not len(whole):
        return None
    pairs, rest = system.links.pairs[whole], system.links.rest[whole]
    sweeps = min(int(model.parameters.iterations), SHOWN_SWEEPS)
    done = model.sweep_tick // STEPS_A_LINK % (sweeps * len(whole))
    before = predicted(model)
    places = before.copy()
    for k in range(done):
        a, b = pairs[k % len(whole)].tolist()
        put_right(places, system.inverse_masses, (a, b), float(rest[k % len(whole)]))
    sweep, link = divmod(done, len(whole))
    a, b = pairs[link].tolist()
    excess = math.dist(places[a].tolist(), places[b].tolist()) - float(rest[link])
    return SlowSweep(places, before, sweep, link, excess)


def draw_slow_sweep(canvas: Canvas, model: SpringModel) -> None:
    """The prediction as a ghost, the network as it is being put right, the next link in amber."""
    shown = sweep_now(model)
    if shown is None:
        return
    pairs = model.system.links.pairs[model.system.torn == 0]
    for places, color in ((shown.before, "ghost"), (shown.places, "text1")):
        canvas.segments(places[pairs[:, 0]], places[pairs[:, 1]], color, 1.6)
        canvas.discs(places, canvas.px(3.0), color)
    a, b = (tuple(shown.places[end].tolist()) for end in pairs[shown.link])
    canvas.line(a, b, "amber", 3.4)
    view = model.content.view
    much = format_si(abs(shown.excess), "m")
    words = (
        f"sweep {shown.sweep + 1}, link {shown.link + 1} of {len(pairs)}: {much} too {_which(shown.excess)}"
    )
    corner = (0.5 * (view.left + view.right), view.bottom)
    canvas.label(corner, words, "amber", 13, "semibold", "bottom", offset=(0.0, -14.0))


def _which(excess: float) -> str:
    return "long" if excess >= 0.0 else "short"

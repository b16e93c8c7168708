"""What a story says of leaves in a wind: readouts, places for stories, sounds."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Point
from game.physics.kernels import elementwise
from game.physics.plates import law
from game.physics.plates.flight import WY
from game.physics.plates.watch import FLUTTER, GLIDE, TUMBLE
from game.scenes.leaves.foliage import nearer, shifts_of
from game.scenes.leaves.model import KIND, LeavesModel
from game.scenes.leaves.model import NAMES as SPECIES_NAMES
from game.scenes.leaves.sounds import HALF, NAMES
from game.scenes.leaves.ways import TOOK, TURNED
from game.stage import Hearing, Readout
from game.worlds.hearing import ROOM, wind

MIDST = (1.0, 0.65)  # m across and up from the middle of the cloud, which a picture's middle follows
VERBS = {FLUTTER: "flutters", TUMBLE: "tumbles", GLIDE: "glides"}


def readouts(model: LeavesModel) -> tuple[Readout, ...]:
    """Where the leaves are, what those in the air do, how fast they come down, and the error of a step."""
    plates = model.plates
    flying, inside = model.flying(), model.inside()
    seen = model.seen()
    laws = plates.laws
    terminal = laws[law.UNIT] / np.sqrt((laws[law.DRAG] + laws[law.DRAG_TURN]) * laws[law.HALF])
    falling = flying & (plates.rows[law.VY] < 0.0)
    descent = plates.air[WY] - plates.rows[law.VY]  # through the air
    speeds = elementwise.hypot(*plates.velocities.T) if len(plates) else np.zeros(0)
    return (
        Readout("leaves", len(plates)),
        Readout("in the basket", int(np.count_nonzero(inside))),
        Readout("in the air", int(np.count_nonzero(flying))),
        Readout("share in the basket", 100.0 * float(np.mean(inside)) if len(plates) else 0.0, "%"),
        Readout("took off", int(model.tally[0])),
        Readout("fluttering", int(np.count_nonzero(seen == FLUTTER))),
        Readout("tumbling", int(np.count_nonzero(seen == TUMBLE))),
        Readout("gliding", int(np.count_nonzero(seen == GLIDE))),
        Readout("wind at leaves", model.gusts_now(), "m/s"),
        Readout("highest", float(model.tally[1]), "m"),
        Readout("descent", float(np.mean(descent[falling])) if falling.any() else math.nan, "m/s"),
        Readout("broadside", float(np.mean(terminal[falling])) if falling.any() else math.nan, "m/s"),
        Readout("fastest", float(np.max(speeds, initial=0.0)), "m/s"),
        Readout("step error", plates.step_error(model.parameters.step_length), "m"),
        Readout("time", plates.time, "s"),
    )


def targets(model: LeavesModel) -> dict[str, Point]:
    """Where the camera has the middle of the leaves that fly, and above the basket; m."""
    return {"cloud": (float(model.tally[2]), float(model.tally[3])), "basket": (model.basket.x, 0.75)}


def sizes(model: LeavesModel) -> dict[str, float]:
    """The height of the basket, m."""
    return {"basket": model.basket.height}


def names_of(model: LeavesModel) -> list[tuple[int, str]]:
    """Of each way the leaf in the midst of the cloud that goes it longest: its number; what it is, what it
    does, and its inertia.
    """
    found, seen, ways = [], model.seen(), model.ways
    away = np.abs(model.plates.rows[[law.X, law.Y]].T - model.tally[2:4])
    midst = np.all(away < MIDST, axis=1)
    for way, verb in VERBS.items():
        how_long = np.abs(ways[:, TURNED if way == TUMBLE else TOOK]) + 1.0
        longest = np.where(midst & (seen == way), how_long, 0.0)
        if longest.any():
            i = int(np.argmax(longest))
            inertia = float(model.plates.laws[law.MASS_Y, i]) - 1.0
            found.append((i, f"{SPECIES_NAMES[int(model.own[i, KIND])]} {verb}: I* = {inertia:.2f}"))
    return found


def names(model: LeavesModel) -> list[tuple[Point, str]]:
    """Where these leaves are seen, m, and their words."""
    rows = model.plates.rows
    places = rows[[law.X, law.Y]].T + shifts_of(nearer(model.basket, rows, model.own))
    return [((float(places[i, 0]), float(places[i, 1])), words) for i, words in names_of(model)]


def hearing(model: LeavesModel) -> Hearing:
    """What was heard in the last moments, and the wind as it blows at the leaves."""
    steady = (ROOM, wind(model.gusts_now()))
    return Hearing("leaves", model.plates.time, model.heard.sounds(NAMES, HALF), steady)

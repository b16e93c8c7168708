"""What the valley tells: readouts beside theory, places for stories, names, charts, sounds; its hand."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Point
from game.physics.kernels import elementary
from game.scenes.valley import world
from game.scenes.valley.dam import FOOT, HIGH, breach_radius, thickness
from game.scenes.valley.world import ValleyWorld
from game.stage import Hearing, Readout, Steady
from game.worlds.hands.grab import GRAB, let_loose
from game.worlds.hands.hand import NOBODY, Hand, Use
from game.worlds.hearing import ROOM, fire
from game.worlds.rubbing import rubbing_heard

NAMES = {world.EARTH: "ground", world.STONES: "stone", world.BURST: "burst", world.SPLASH: "splash"}
HALF, MIDDLE = 50.0, world.MIDDLE  # m to one side of the picture; its middle
GRINDING, ROARING = 4.0e5, 4.0e5  # W of rubbing, W/m of water, that are loudest


def readouts(model: ValleyWorld) -> list[Readout]:
    """Rocket, dam, fronts, what flows, what the method did."""
    liquid, dam, theory = model.liquid, model.dam, model.theory
    moved, rows = dam.moved(), model.solids.world.bodies
    torn = moved > world.MOVED
    pieces = len(dam.bodies) if dam.broken else 0
    far = rows.positions[dam.bodies[torn], 0]
    farthest = float(far[far < world.RIGHT].max(initial=0.0))
    moving, lifted = liquid.energy()
    put_in, gone, _ = liquid.account.tolist()
    full = liquid.count * liquid.area
    behind, front = model.area_behind(), model.front()
    charge = float(dam.struck[0, 2]) if dam.broken else float(model.parameters.charge)
    deep, gravity = model.depth_behind(), max(float(model.parameters.gravity), 1e-9)
    height = float(dam.struck[0, 1]) if dam.broken else float(model.parameters.aim)
    return [
        Readout("fired", model.fired), Readout("struck", len(dam.struck)),
        Readout("rocket's speed", model.rocket.speed, "m/s"),
        Readout("to the dam", _to_the_dam(model), "m"),
        Readout("struck at", float(dam.struck[0, 1]) if dam.broken else math.nan, "m"),
        Readout("charge", float(model.parameters.charge), "kg"),
        Readout("push on the wall", 1e-3 * model.push() / gravity, "t/m"),
        Readout("push by depth", 0.5 * deep * deep, "t/m"),
        Readout("wall's thickness", thickness(height), "m"),
        Readout("breach radius", breach_radius(charge), "m"),
        Readout("pieces", pieces), Readout("torn out", int(np.count_nonzero(torn))),
        Readout("heaviest", _heaviest(model, torn), "t/m"),
        Readout("farthest piece", farthest, "m"),
        Readout("logs", _gone(model), "m"),
        Readout("since it broke", model.since, "s"),
        Readout("front", front, "m"), Readout("front, shallow", model.shallow_front(), "m"),
        Readout("front, Ritter", model.ritter_front(), "m"),
        Readout("front, experiment", model.filmed_front(), "m"),
        Readout("behind shallow water", model.shallow_front() - front, "m"),
        Readout("ahead of the film", front - model.filmed_front(), "m"),
        Readout("fastest wave", theory.bore, "m/s"),
        Readout("depth behind", deep, "m"),
        Readout("left behind", 100.0 * behind / model.behind, "%"),
        Readout("run out", model.behind - behind, "m²"),
        Readout("flow", model.flow(), "m²/s"), Readout("flow, Ritter", model.ritter_flow(), "m²/s"),
        Readout("ran off", gone * liquid.area, "m²"), Readout("poured in", put_in * liquid.area, "m²"),
        Readout("volume error", 100.0 * (liquid.wet_area() / full - 1.0) if liquid.count else 0.0, "%"),
        Readout("energy", moving + lifted, "J/m"), Readout("kinetic energy", moving, "J/m"),
        Readout("particles", liquid.count), Readout("slowed", model.water.slowed),
        Readout("a step", model.water.watch.median("step"), "s"),
    ]  # fmt: skip


def _to_the_dam(model: ValleyWorld) -> float:
    """m from the rocket's nose to the dam's lower face; NaN where there is no rocket."""
    if model.rocket.body == NOBODY:
        return math.nan
    x, y = model.rocket.nose()
    return x - thickness(y)


def _gone(model: ValleyWorld) -> float:
    """m that trunks have gone down the valley, in the middle; NaN where there are none."""
    count = len(model.logs)
    if not count:
        return math.nan
    at = world.YARD + world.APART * np.arange(count)
    return float(np.median(model.solids.world.bodies.positions[model.logs, 0] - at))


def _heaviest(model: ValleyWorld, torn: np.ndarray) -> float:
    """t for each metre of the valley's width, of the pieces that are torn out."""
    bodies = model.dam.bodies[torn]
    masses = model.solids.world.bodies.inverse_masses[bodies]
    return 1e-3 / float(masses[masses > 0.0].min()) if (masses > 0.0).any() else math.nan


def targets(model: ValleyWorld) -> dict[str, Point]:
    """The rocket, the dam, the front of the water, the timber, the piece that went farthest."""
    rows, dam = model.solids.world.bodies, model.dam
    front = model.front()
    front = 0.0 if math.isnan(front) else front
    bed = float(world.bed_at(np.array([front]))[0])
    rocket = model.rocket.nose() if model.rocket.body != NOBODY else (0.5 * FOOT, 0.4 * HIGH)
    logs = rows.positions[model.logs].mean(axis=0).tolist() if len(model.logs) else (world.YARD, 0.0)
    found = {
        "rocket": rocket, "dam": (0.5 * FOOT, 0.5 * HIGH), "front": (front, bed + 2.0),
        "logs": (logs[0], logs[1]), "breach": _breach(model),
    }  # fmt: skip
    if dam.broken and len(dam.bodies):
        x, y = rows.positions[dam.bodies[int(np.argmax(rows.positions[dam.bodies, 0]))]].tolist()
        found["piece"] = (x, y)
    return found


def _breach(model: ValleyWorld) -> Point:
    """Where the first rocket struck, or is aimed."""
    if model.dam.broken:
        x, y, _ = model.dam.struck[0].tolist()
        return x, y
    return thickness(model.parameters.aim), float(model.parameters.aim)


def sizes(model: ValleyWorld) -> dict[str, float]:
    """m, of what a story looks at."""
    return {"dam": HIGH, "rocket": 4.0, "front": 4.0, "breach": 4.0}


def names(model: ValleyWorld) -> list[tuple[Point, str]]:
    """The dam's pieces, the rocket, timber."""
    places = targets(model)
    found = [(places["logs"], f"{len(model.logs)} logs, 600 kg/m³")]
    if model.rocket.body != NOBODY:
        found.append((places["rocket"], f"{model.parameters.charge:.0f} kg of TNT"))
    if model.dam.broken:
        torn = int(np.count_nonzero(model.dam.moved() > world.MOVED))
        found.append((places["breach"], f"{torn} of {len(model.dam.bodies)} pieces torn out"))
    else:
        found.append((places["dam"], "concrete, 2400 kg/m³"))
    return found


def hearing(model: ValleyWorld) -> Hearing:
    """Blast, pieces, splashes; the roar of water, what grinds along, the rocket's motor."""
    steady = [ROOM, *model.roar.heard(ROARING, HALF, MIDDLE)]
    steady += rubbing_heard(model.solids.world, 1.0 / 60.0, GRINDING, HALF, MIDDLE)
    if model.rocket.body != NOBODY:
        x, y = model.rocket.nose()
        pan = max(-1.0, min(1.0, (x - MIDDLE) / HALF))
        near = 1.0 / (1.0 + 0.02 * elementary.hypot(x - MIDDLE, y - 8.0))
        steady += [fire(near, 1.0, pan), Steady("hiss", 0.35 * near, 0.5, pan)]
    if len(model.rocket.fire.rows) and model.rocket.body == NOBODY:
        steady.append(Steady("rubble", 0.45, 0.3))
    return Hearing("valley", model.time, model.heard.sounds(NAMES, HALF, MIDDLE), steady)


def _pour(hand: Hand) -> str:
    hand.model.pours = hand.at
    return ""


def _let_go(hand: Hand) -> None:
    hand.model.pours = None
    let_loose(hand)


def valley_hand(model: ValleyWorld) -> Hand:
    """The right button pulls a piece."""
    uses = {"pour": Use(_pour, _pour), "drag": GRAB}
    return Hand(model, uses, (world.LEFT, world.LOW), (world.RIGHT, world.TOP), right="drag", drop=_let_go)

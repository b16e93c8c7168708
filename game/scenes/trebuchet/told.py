"""What the trebuchet tells: readouts beside theory, places for stories, names, sounds; its hand."""

from __future__ import annotations

import math

from game.arrays import Point
from game.physics.kernels import elementary
from game.scenes.trebuchet import world
from game.scenes.trebuchet.machine import COCKED, LOOSE, PIVOT, WINDING
from game.scenes.trebuchet.world import TrebuchetWorld
from game.stage import Hearing, Readout, Steady
from game.worlds.hands.grab import GRAB, PUSH, let_loose
from game.worlds.hands.hand import NOBODY, Hand
from game.worlds.hearing import ROOM, wind
from game.worlds.rubbing import rubbing_heard

NAMES = {world.EARTH: "thud", world.STONES: "stone", world.LANDING: "ground"}
FARTHEST = (-400.0, -50.0), (1000.0, 400.0)  # m
LOWEST = 4.6  # m, of a camera that goes with the stone: else the ground would fill half of the picture
LOUD, HALF, CREAK = 20000.0, 40.0, 3.0  # W of rubbing; m to either side; rad/s of an arm that is loudest


def readouts(model: TrebuchetWorld) -> list[Readout]:
    """Of the last shot: flight, energy, momentum; then the wall and the solver."""
    machine, nan, law = model.machine, math.nan, model.range_by_law()
    x, y, vx, vy, mass, drop, gain, kept = machine.shot or (nan,) * 8
    stone, rows = machine.stones[-1], model.world.bodies
    far, gravity = model.landing[0] - x if model.landing else nan, model.gravity()
    here = rows.positions[stone].tolist()
    late = (here[0] - x) / vx if vx and model.flying != NOBODY else nan
    return [
        Readout("in the air", int(model.flying != NOBODY)), Readout("landed", int(model.landing is not None)),
        Readout("release speed", elementary.hypot(vx, vy), "m/s"),
        Readout("release angle", math.degrees(elementary.atan2(vy, vx)), "°"),
        Readout("range", far, "m"), Readout("ballistic range", law, "m"),
        Readout("greatest range", 2.0 * drop / (mass * gravity) if gravity else nan, "m"),
        Readout("taken by the air", 100.0 * (1.0 - far / law) if law else nan, "%"),
        Readout("given by the weight", drop, "J"), Readout("in the stone", gain, "J"),
        Readout("efficiency", 100.0 * gain / drop if drop else nan, "%"),
        Readout("energy error", 100.0 * abs(kept / drop) if drop else nan, "%"),
        Readout("momentum before", model.before, "kg m/s"), Readout("momentum after", model.after, "kg m/s"),
        Readout("out of place", model.out_of_place()), Readout("blocks", len(model.blocks)),
        Readout("struck at", model.landing[1] if model.landing and math.isfinite(model.before) else nan, "m"),
        Readout("wall's height", model.parameters.rows * world.TALL, "m"),
        Readout("stone's speed", elementary.length(*rows.velocities[stone].tolist()), "m/s"),
        Readout("stone's height", here[1], "m"), Readout("stone's way", here[0], "m"),
        Readout("parabola", y + late * (vy - 0.5 * gravity * late), "m"),
        Readout("cocked", int(machine.phase == COCKED)),
        Readout("a step", model.solids.watch.median("step"), "s"),
    ]  # fmt: skip


def targets(model: TrebuchetWorld) -> dict[str, Point]:
    """The stone, it or what is above where it lies, the machine, the wall."""
    x, y = model.world.bodies.positions[model.machine.stones[-1]].tolist()
    middle = model.content.wall + 0.5 * model.content.columns * world.WIDE
    wall = (middle, 0.5 * model.parameters.rows * world.TALL)
    return {"stone": (x, y), "flight": (x, max(y, LOWEST)), "machine": (0.0, PIVOT), "wall": wall}


def sizes(model: TrebuchetWorld) -> dict[str, float]:
    """The frame up to its axle, and the wall as it was built, m."""
    return {"machine": PIVOT, "wall": model.parameters.rows * world.TALL}


def names(model: TrebuchetWorld) -> list[tuple[Point, str]]:
    """Weight, stone and wall."""
    places, chosen = targets(model), model.parameters
    x, y = model.world.bodies.positions[model.machine.weight].tolist()
    return [
        ((x, y), f"{chosen.counterweight / 1000.0:.3g} t"), (places["stone"], f"{chosen.stone:.3g} kg"),
        (places["wall"], f"{model.out_of_place()} of {len(model.blocks)} out of place"),
    ]  # fmt: skip


def hearing(model: TrebuchetWorld) -> Hearing:
    """Impacts, what slides, the creak of axle and winch, the stone in the air."""
    machine, rows = model.machine, model.world.bodies
    middle = model.landing[0] if model.landing else 0.0
    steady = rubbing_heard(model.world, model.parameters.values["step_length"], LOUD, HALF, middle)
    turning = 0.3 * math.sqrt(min(abs(float(rows.spins[machine.arm])) / CREAK, 1.0))
    if not any(one.kind == "rolling" for one in steady):
        steady.append(Steady("rolling", turning + 0.1 * (machine.phase == WINDING), 0.1))
    if model.flying != NOBODY or machine.phase not in (COCKED, LOOSE):
        steady.append(wind(0.4 * elementary.length(*rows.velocities[machine.stones[-1]].tolist())))
    return Hearing("trebuchet", model.time, model.heard.sounds(NAMES, HALF, middle), [ROOM, *steady])


def trebuchet_hand(model: TrebuchetWorld) -> Hand:
    """The right button pushes."""
    return Hand(model, {"push": PUSH, "drag": GRAB}, *FARTHEST, right="push", drop=let_loose)

"""Words of the marble run: readouts beside theory, places for stories, sounds, the present level."""

from __future__ import annotations

import math

import msgspec
import numpy as np

from game.arrays import Floats, Point
from game.physics.kernels import elementary, elementwise
from game.physics.solids.tracks import motion as m
from game.scenes.metal import hearing as h
from game.scenes.metal.balls import NONE, NOT_YET, RIDES
from game.scenes.metal.gauges import VALUE, exact_of, names_of
from game.scenes.metal.level import BallEntry, GaugeEntry, MetalContent
from game.scenes.metal.world import MetalWorld
from game.stage import Hearing, Readout

UNITS = {
    "speeds up": "m/s²", "arrives": "s", "drop": "m", "leaves": "°", "rode": "", "rises": "m", "speed": "m/s",
    "inside": "", "fallen": "", "kept": "%",
}  # fmt: skip
COUNTED = ("rode", "inside", "fallen")
COMPARED = ("speeds up", "arrives")  # with a formula, so that there is an error
WITH_EXACT = (*COMPARED, "drop", "leaves")
NAMES = {h.STEEL: "steel", h.WOOD: "wood", h.RAIL: "rail", h.ROLL: "roll"}


def readouts(model: MetalWorld) -> list[Readout]:
    """The level's gauges first, each with what is exact; then the balls."""
    found, worst, gauges = [], math.nan, model.content.gauges
    for gauge, ball, noted in zip(gauges, model.measured, model.machine.gauges, strict=True):
        value = float(noted[VALUE])
        if gauge.measure in COUNTED and value != NOT_YET:
            value = int(value)
        found.append(Readout(gauge.name, math.nan if value == NOT_YET else value, UNITS[gauge.measure]))
        if gauge.measure not in WITH_EXACT:
            continue
        exact = exact_now(model, gauge, ball, noted)
        if gauge.measure == "arrives" and math.isnan(exact):
            continue
        found.append(Readout(f"{gauge.name} exact", exact, UNITS[gauge.measure]))
        if gauge.measure == "drop":
            found.append(Readout(f"{gauge.name} margin", 100.0 * (value / exact - 1.0), "%"))
        if gauge.measure in COMPARED and value != NOT_YET and exact > 0.0:
            error = 100.0 * abs(value / exact - 1.0)
            worst = error if math.isnan(worst) else max(worst, error)
    if any(gauge.measure in COMPARED for gauge in gauges):
        found.append(Readout("worst error", worst, "%"))
    return [*found, *_of_balls(model), Readout("a step", model.solids.watch.median("step"), "s")]


def exact_now(model: MetalWorld, gauge: GaugeEntry, ball: int, noted: Floats) -> float:
    """What theory says of a gauge as the run stands; NaN where it says nothing."""
    tracks = model.content.tracks
    track = tracks[gauge.track] if gauge.track < len(tracks) else None
    return exact_of(gauge, noted, track, (model.balls.table, ball, model.balls.rows[ball]), model.gravity())


def _of_balls(model: MetalWorld) -> list[Readout]:
    rows, table, there = model.balls.rows, model.balls.table, model.balls.there()
    speeds = elementwise.hypot(rows[there, m.VX], rows[there, m.VY])
    moving = there & (table.freed != NOT_YET)
    return [
        Readout("balls", int(there.sum())),
        Readout("riding", int(np.count_nonzero(model.tracks.rolling() & moving))),
        Readout("loose", int(np.count_nonzero(table.body != RIDES))),
        Readout("gates open", int(np.count_nonzero(model.machine.gates != NOT_YET))),
        Readout("fastest", float(speeds.max(initial=0.0)), "m/s"),
        Readout("awake", model.solids.awake()),
        Readout("lowest", float(rows[there, m.Y].min(initial=0.0)), "m"),
        Readout("farthest", float(np.abs(rows[there, m.X]).max(initial=0.0)), "m"),
    ]


def saved(model: MetalWorld) -> MetalContent:
    """The level; where a hand has changed it, tracks point by point and balls where they are.

    Balls that hang stay in their cradles, which begin anew, as towers do. Gauges of balls that are gone, and
    those of formulas that have been bent, are left out.
    """
    if not model.changed:
        return model.content
    content, names, table = model.content, names_of(model.content), model.balls.table
    balls = []
    for ball in np.flatnonzero(model.balls.there() & (table.rod == NONE)).tolist():
        row, held = model.balls.rows[ball].tolist(), table.freed[ball] == NOT_YET
        balls.append(
            BallEntry(
                at=(row[m.X], row[m.Y]), radius=row[m.RADIUS], velocity=(row[m.VX], row[m.VY]),
                gate=content.gates[table.gate[ball]] if held else "",
                delay=float(table.delay[ball]) if held else 0.0,
                name=names[ball] if ball < len(names) else "",
                friction=float(table.grip[ball]) if table.grip[ball] != NONE else None,
                seated=bool(model.tracks.riders.balls.pieces[ball, 0] >= 0),
            )
        )  # fmt: skip
    kept = {one.name for one in balls}
    gauges = tuple(
        one for one in content.gauges
        if (not one.of or one.of in kept) and one.measure not in ("drop", "leaves")
    )  # fmt: skip
    return msgspec.structs.replace(
        content, tracks=model.tracks.entries(), balls=tuple(balls), heaps=(), gauges=gauges, expected=()
    )


def targets(model: MetalWorld) -> dict[str, Point]:
    """Balls by their names, the first and the last of each cradle, the middle of the blocks; m."""
    found = {name: model.place(k) for k, name in enumerate(names_of(model.content))}
    for k, balls in enumerate(model.cradle_balls):
        number = "" if k == 0 else f" {k + 1}"
        found["cradle first" + number], found["cradle last" + number] = map(
            model.place, (balls[0], balls[-1])
        )
    if model.block_ids:
        x, y = np.mean(model.world.bodies.positions[model.block_ids], axis=0).tolist()
        found["blocks"] = (x, y)
    return found


def names(model: MetalWorld) -> list[tuple[Point, str]]:
    """Each ball that the level names, and its speed."""
    found = []
    for entry, row in zip(model.content.balls, model.balls.rows, strict=False):
        if entry.name:
            speed = elementary.hypot(float(row[m.VX]), float(row[m.VY]))
            found.append(((float(row[m.X]), float(row[m.Y])), f"{entry.name}, {speed:.1f} m/s"))
    return found


def hearing(model: MetalWorld) -> Hearing:
    """Contacts that began in the last moments, from the left or the right of the whole run."""
    view = model.content.view
    middle, half = 0.5 * (view.left + view.right), max(0.5 * (view.right - view.left), 1e-9)
    return Hearing("metal", model.time, model.heard.sounds(NAMES, half, middle))

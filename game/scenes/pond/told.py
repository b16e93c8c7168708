"""What is measured on a pond, and the hand's tools."""

from __future__ import annotations

import itertools
import math

import numpy as np

from game.physics.kernels import elementary
from game.physics.waves.floats import DENSITY as SHARE
from game.physics.waves.floats import FVX, FVY, FX, FY, FZ, RADIUS, TALL
from game.physics.waves.hull import HX, HY
from game.physics.waves.wave_particles import FADED, HEIGHT, KIND, MADE, REFUSED, SPLIT, X, Y
from game.scenes.pond.level import BoatEntry, FloatEntry, PondContent
from game.scenes.pond.world import CLOCK, RAINED, PondWorld
from game.stage import Readout
from game.worlds.hands.hand import NOBODY, Hand, Use

DENSITY = 1000.0  # kg/m³
HAND_RATE = 8.0  # 1/s: speed of a float for the way to the hand
ROW = 0.5  # m between stones of a row
STRAIGHT = 0.05  # m that a boat may be off its first course
BINS = 12  # of the way behind the boat, in which the outermost particle is looked for


def readouts(model: PondWorld) -> list[Readout]:
    """Rings and wedges beside theory, floats, then what the particles keep."""
    water, floats = model.water, model.floats
    books, rows = water.books, floats.rows
    front, by_law = ring_now(model)
    off = off_rest(model)
    return [
        Readout("particles", water.count), Readout("divided", int(books[SPLIT])),
        Readout("left out", int(books[FADED])), Readout("no place", int(books[REFUSED])),
        Readout("put", int(books[MADE])),
        Readout("wave speed", float(water.speeds[model.kind]), "m/s"),
        Readout("highest", float(np.max(water.heights)), "m"),
        Readout("lowest", float(np.min(water.heights)), "m"),
        Readout("ring", front[0], "m"), Readout("ring by law", by_law[0], "m"),
        Readout("crest", front[1], "m"), Readout("crest by law", by_law[1], "m"),
        Readout("boat speed", model.boat.speed if model.has_boat else math.nan, "m/s"),
        Readout("wedge", wedge(model), "°"), Readout("wedge by law", wedge_by_law(model), "°"),
        Readout("floats", len(floats)),
        Readout("off its rest", off, "m"),
        Readout("drift", float(np.max(np.abs(rows[:, [FVX, FVY]]), initial=0.0)), "m/s"),
        Readout("wave volume", water.volume(), "m³"),
        Readout("wave energy", DENSITY * water.energy(), "J"),
        Readout("rain drops", int(model.clock[RAINED])),
    ]  # fmt: skip


def off_rest(model: PondWorld) -> float:
    """How far (m) the first float is above its rest in still water; nan without one."""
    rows = model.floats.rows
    if not len(rows):
        return math.nan
    return float(rows[0, FZ] + min(rows[0, SHARE], 1.0) * rows[0, TALL])


def ring_of(model: PondWorld) -> tuple[float, float, float] | None:
    """Middle (m) and first crest (m) of the one ring that the level began with, while it is alone."""
    content = model.content
    alone = len(content.drops) == 1 and not (content.floats or content.strewn or content.boat)
    if not alone or model.touched or model.clock[RAINED]:
        return None
    drop = content.drops[0]
    return (drop.x, drop.y, drop.height) if drop.ring else None


def ring_now(model: PondWorld) -> tuple[tuple[float, float], tuple[float, float]]:
    """Radius and height (m) of its crest, measured to the right, and by theory; nan when there is none.

    By theory it runs at the wave's speed. Its height sinks as 1/d, or as 1/sqrt(d) if its energy is kept.
    """
    nothing = (math.nan, math.nan)
    ring = ring_of(model)
    if ring is None:
        return nothing, nothing
    water, x, y = model.water, ring[0], ring[1]
    i, j = int(x / water.cell), int(y / water.cell)
    row = 0.5 * (water.heights[max(j - 1, 0)] + water.heights[j])
    radius = model.reach + float(water.speeds[model.kind]) * float(model.clock[CLOCK])
    if radius > min(x, water.size[0] - x, y, water.size[1] - y):
        return nothing, nothing
    top = i + int(np.argmax(row[i:]))
    share = model.reach / radius
    sunk = share if model.parameters.keeps == "height" else math.sqrt(share)
    fade = elementary.exp(-water.settings.fading * float(model.clock[CLOCK]))
    return ((top + 0.5) * water.cell - x, float(row[top])), (radius, ring[2] * sunk * fade)


def wedge_by_law(model: PondWorld) -> float:
    """Half the angle (degrees) of the wedge, sin = c / U (Mach 1887); nan when the waves outrun the boat."""
    if not model.has_boat:
        return math.nan
    speed, wave = model.boat.speed, float(model.water.speeds[model.kind])
    return math.degrees(elementary.asin(wave / speed)) if speed > wave else math.nan


def wedge(model: PondWorld) -> float:
    """Half the angle (degrees) between the lines through the outermost particles behind a boat.

    nan when there is no wedge, or too little of it: it takes the last two thirds of a way of 3 m.
    """
    boat = model.content.boat
    others = model.content.drops or len(model.floats) or model.clock[RAINED]
    if boat is None or others or model.touched or math.isnan(wedge_by_law(model)):
        return math.nan
    pose, fields, time = model.boat.pose, model.water.fields, float(model.clock[CLOCK])
    if elementary.hypot(boat.x + boat.along * time - pose[HX], boat.y + boat.up * time - pose[HY]) > STRAIGHT:
        return math.nan
    of_boat = fields[:, fields[KIND] == model.kind]
    off_x, off_y = of_boat[X] - pose[HX], of_boat[Y] - pose[HY]
    back = -(off_x * pose[4] + off_y * pose[5])
    side = np.abs(off_y * pose[4] - off_x * pose[5])
    speed, wave = model.boat.speed, float(model.water.speeds[model.kind])
    came = min(
        (speed - wave * wave / speed) * time, 0.8 * model.water.size[1]
    )  # what began the wedge is there
    edges = np.linspace(came / 3.0, came, BINS + 1)
    if came < 3.0:
        return math.nan
    tall = np.abs(of_boat[HEIGHT]) > model.water.settings.lowest
    places, outermost = [], []
    for low, high in itertools.pairwise(edges):
        here = (back >= low) & (back < high) & tall
        if here.any():
            k = int(np.argmax(np.where(here, side, -1.0)))
            places.append(float(back[k]))
            outermost.append(float(side[k]))
    if len(places) < 4:
        return math.nan
    x, y = np.array(places) - np.mean(places), np.array(outermost)
    return math.degrees(elementary.atan(float(np.sum(x * y) / np.sum(x * x))))


def saved(model: PondWorld) -> PondContent:
    """Floats and boat where they are now."""
    rows = model.floats.rows
    floats = tuple(
        FloatEntry(x=row[FX], y=row[FY], radius=row[RADIUS], tall=row[TALL], density=row[SHARE])
        for row in rows.tolist()
    )
    boat = None
    if model.has_boat:
        x, y = model.boat.pose[[HX, HY]].tolist()
        boat = BoatEntry(x=x, y=y, along=float(model.course[0]), up=float(model.course[1]))
    content = model.content
    return PondContent(width=content.width, height=content.height, floats=floats, boat=boat)


def _drop(hand: Hand) -> str:
    hand.model.drop(hand.at)
    return ""


def _row(hand: Hand) -> str:
    last = hand.path[-1]
    if elementary.dist(last, hand.at) >= ROW:
        hand.path.append(hand.at)
        hand.model.drop(hand.at)
    return ""


def _lead(hand: Hand) -> str:
    if not hand.model.has_boat:
        hand.model.has_boat = True
        hand.model.boat.pose[[HX, HY]] = hand.at
    hand.model.lead(hand.at)
    return ""


def _put(hand: Hand) -> str:
    found = hand.model.float_at(hand.at)
    if found is None:
        words: str = hand.model.put_float(hand.at)
        return words
    hand.held = found
    return ""


def _pull(hand: Hand) -> str:
    rows = hand.model.floats.rows
    if hand.held != NOBODY and hand.held < len(rows):
        rows[hand.held, FVX] = HAND_RATE * (hand.at[0] - rows[hand.held, FX])
        rows[hand.held, FVY] = HAND_RATE * (hand.at[1] - rows[hand.held, FY])
        hand.model.touched = True
    return ""


def _stop(hand: Hand) -> None:
    if hand.model.course[2]:
        hand.model.lead(None)


def pond_hand(model: PondWorld) -> Hand:
    """Drops stones, leads the boat, puts and pulls floats; the right button drops."""
    return Hand(
        model,
        {"drop": Use(_drop, _row), "boat": Use(_lead, _lead), "float": Use(_put, _pull)},
        (0.0, 0.0), model.water.size, right="drop", drop=_stop,
    )  # fmt: skip

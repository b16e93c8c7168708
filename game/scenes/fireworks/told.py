"""What the show says of itself: what is measured, what a story may look at and name, what is heard."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Point
from game.physics.generations.step import DROPPED, MADE, X, Y, Z
from game.scenes.fireworks import thunder as t
from game.scenes.fireworks.eye import projected, seen_from
from game.scenes.fireworks.measures import NAMED_S, burst_middle, burst_now, smoke_drift, wind_at_smoke
from game.scenes.fireworks.model import BURST_COUNT, DUDS, LAUNCHED, FireworksModel
from game.scenes.fireworks.shells import SHELLS
from game.stage import Hearing, Readout
from game.worlds.hearing import ROOM, wind

NOWHERE = (0.0, 100.0)


def readouts(model: FireworksModel) -> list[Readout]:
    """What is measured."""
    system, thunder, counts = model.system, model.thunder, model.counts
    newest = burst_now(model)
    heard = int(thunder.counts[t.LAST])
    late = float(thunder.heard[(heard - 1) % t.KEPT, t.HEARD_AFTER]) if heard else math.nan
    smoke = system.stars("smoke").shape[1]
    drift, blown = smoke_drift(model), wind_at_smoke(model)
    return [
        Readout("alive", len(system)),
        Readout("dropped", system.tally(DROPPED)),
        Readout("wind", model.wind, "m/s"),
        Readout("smoke drift", drift, "m/s"),
        Readout("wind at the smoke", blown, "m/s"),
        Readout("smoke lag", blown - drift, "m/s"),
        Readout("burst radius", newest.radius if newest else math.nan, "m"),
        Readout("ballistics", newest.ballistics if newest else math.nan, "m"),
        Readout("radius error", abs(newest.radius - newest.ballistics) if newest else math.nan, "m"),
        Readout("burst depth", newest.depth if newest else math.nan, "m"),
        Readout("burst stars", newest.stars if newest else math.nan),
        Readout("burst speed", newest.fastest if newest else math.nan, "m/s"),
        Readout("burst momentum", newest.momentum if newest else math.nan),
        Readout("off the mark", model.off_mark, "m"),
        Readout("fired", int(counts[LAUNCHED])),
        Readout("bursts", int(counts[BURST_COUNT])),
        Readout("duds", int(counts[DUDS])),
        Readout("born", system.tally(MADE)),
        Readout("puffs of smoke", smoke),
        Readout("sounds on their way", int(thunder.counts[t.WAITING])),
        Readout("heard", heard),
        Readout("sound came after", late, "s"),
        Readout("sounds lost", int(thunder.counts[t.LOST])),
        Readout("show", model.show_s, "s"),
    ]


def targets(model: FireworksModel) -> dict[str, Point]:
    """What a story may look at."""
    smoke = model.system.stars("smoke")
    return {
        "burst": _seen_at(model, *model.burst[1:4].tolist()) if model.burst[0] >= 0.0 else NOWHERE,
        "shell": _highest_shell(model),
        "smoke": _seen_at(model, *smoke[[X, Y, Z]].mean(axis=1).tolist()) if smoke.shape[1] else NOWHERE,
        "listener": model.listener_place(),
    }


def sizes(model: FireworksModel) -> dict[str, float]:
    """How large (m) what a story looks at is seen: the burst from side to side, the smoke in height."""
    newest, smoke = burst_now(model), model.system.stars("smoke")
    found = {"burst": 2.0 * newest.radius} if newest is not None else {}
    return {**found, "smoke": 2.0 * float(smoke[Y].std())} if smoke.shape[1] else found


def names(model: FireworksModel) -> list[tuple[Point, str]]:
    """The newest burst by its shell and radius, the listener by the distance."""
    newest = burst_now(model)
    found = [(model.listener_place(), f"listener, {model.parameters.distance:.0f} m off")]
    if newest is not None and newest.age < NAMED_S:
        words = f"{SHELLS[int(model.burst[4])]}, {newest.stars} stars, {newest.radius:.0f} m"
        found.append((_seen_at(model, *burst_middle(model)), words))
    return found


def hearing(model: FireworksModel) -> Hearing:
    """The sounds heard last, the time of the show, the wind."""
    return Hearing("fireworks", model.system.time_s, model.thunder.sounds(), (ROOM, wind(model.wind)))


def _highest_shell(model: FireworksModel) -> Point:
    """The shell that is farthest up; the newest burst without one."""
    best = (-1.0, NOWHERE)
    for name in SHELLS:
        stars = model.system.stars(name)
        if stars.shape[1]:
            i = int(np.argmax(stars[Y]))
            best = max(best, (float(stars[Y, i]), _seen_at(model, *stars[[X, Y, Z], i].tolist())))
    if best[0] < 0.0 and model.burst[0] >= 0.0:
        return _seen_at(model, *model.burst[1:4].tolist())
    return best[1]


def _seen_at(model: FireworksModel, x: float, y: float, z: float) -> Point:
    """Where a place (m) is seen when the eye aims at the middle of the fleet."""
    return projected(seen_from(0.0, 0.0, 0.0, model.bearing), x, y, z)[:2]

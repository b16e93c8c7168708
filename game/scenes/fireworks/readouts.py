"""What is measured of the show: stars, wind and smoke, the newest burst, sound on its way."""

from __future__ import annotations

import math

from game.physics.generations.step import DROPPED, MADE
from game.scenes.fireworks import thunder as t
from game.scenes.fireworks.measures import burst_now, smoke_drift, wind_at_smoke
from game.scenes.fireworks.model import BURST_COUNT, DUDS, LAUNCHED, FireworksModel
from game.stage import Readout


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

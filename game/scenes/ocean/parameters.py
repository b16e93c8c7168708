"""Level and controls of the ocean."""

from __future__ import annotations

import math
from typing import Annotated

import msgspec

from game.physics.waves.sea import MODELS
from game.physics.waves.sections import HullSettings
from game.stage import Choice, Param, Parameters, Toggle, control_of
from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations
from game.worlds.members.solids import choose_step

COUNTS = {"play": 64, "teach": 96, "film": 128}  # waves


class OceanContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. heel: ° at which the boat is let go; lifted: m above where it floats; grown: the
    sea is as high as the wind makes it from the beginning.
    """

    heel: Annotated[float, msgspec.Meta(ge=-180.0, le=180.0)] = 0.0
    lifted: Annotated[float, msgspec.Meta(ge=0.0, le=20.0)] = 0.0
    grown: bool = True
    expected: Expectations = ()
    view: View = View(left=-13.6, bottom=-4.0, right=13.6, top=11.3)


class OceanParameters(Parameters):
    """Wind, sea, boat, and how finely it is computed."""

    wind = Param(7.0, 0.0, 30.0, unit="m/s", group="Weather", help="10 m above the water")
    gusts = Param(0.15, 0.0, 0.6, group="Weather", help="how much the wind comes and goes")
    course = Param(110.0, 30.0, 180.0, unit="°", group="Weather", label="Wind from",
                   help="from ahead is 0, from the side 90, from behind 180")  # fmt: skip
    rain = Param(0.0, 0.0, 100.0, unit="mm/h", group="Weather", help="a cloudburst has 50")
    model = Choice(
        "jonswap", MODELS, labels=("JONSWAP", "Pierson-Moskowitz"), group="Sea", label="Spectrum",
        help="a sea that wind has raised over a fetch (1973), or to its full (1964)",
    )  # fmt: skip
    fetch = Param(
        25_000.0, 1000.0, 1e6, unit="m", log=True, group="Sea", help="of JONSWAP: water before the boat"
    )
    grows = Param(
        6.0, 0.5, 60.0, unit="s", log=True, group="Sea", help="seconds here stand for hours of life"
    )
    swell = Param(
        0.0, 0.0, 16.0, unit="m", group="Sea", help="height of a wave that comes from far, from behind"
    )
    length = Param(
        60.0, 5.0, 320.0, unit="m", log=True, group="Sea", label="Swell's length", help="crest to crest"
    )
    sheet = Param(50.0, 5.0, 90.0, unit="°", group="Boat", help="how far the boom may swing out")
    ballast = Param(900.0, 0.0, 2500.0, unit="kg", group="Boat", help="in the keel, 1 m deep")
    leaving = control_of(HullSettings, "leaving", group="Boat", label="Waves that leave")
    gravity = Param(9.81, 0.5, 30.0, unit="m/s²", group="World", rebuild=True, help="downwards")
    tier = Choice(
        "play", (*COUNTS, "own"), labels=("Play", "Teach", "Film", "Own"), group="Method", label="Quality",
        help=f"waves of the sea: {', '.join(map(str, COUNTS.values()))}, or as many as you say", rebuild=True,
    )  # fmt: skip
    waves = Param(64, 4, 200, whole=True, log=True, group="Method", rebuild=True, help="of the sea, with Own")
    substeps = Param(
        4, 1, 16, whole=True, group="Method", help="of the boat in a step; of the sail twice as many"
    )
    step_length = choose_step(1.0 / 60.0, 1.0 / 1000.0, 1.0 / 30.0, "Method")
    astern = Toggle(True, group="Shown", label="From astern", help="the boat in cross section, in a corner")

    def count(self) -> int:
        """Waves, by the quality that is chosen."""
        return COUNTS.get(self.tier, int(self.waves))

    def downwind(self) -> float:
        """rad from the course to where the wind blows."""
        return math.pi - math.radians(self.course)

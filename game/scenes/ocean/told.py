"""What the ocean tells: readouts beside theory, places for stories, names, sounds; its hand."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Point
from game.physics.kernels import elementary
from game.physics.waves.sea import LEVEL, full_height
from game.scenes.ocean import world
from game.scenes.ocean.boat import BEAM, HEAVE_S, PITCHED, RISING, ROLL_S, ROLLING, SPEED, UP
from game.scenes.ocean.weather import RAIN_FALLS
from game.scenes.ocean.world import NOW, RAINS, OceanWorld, height_by_law
from game.stage import Comparison, Hearing, Readout, Steady
from game.worlds.hands.hand import Hand, Use
from game.worlds.hearing import ROOM, wind

NAMES = {world.SLAM: "ground", world.BOOM: "wood", world.CRACK: "rustle"}
HALF = 12.0  # m beside the boat that are all on one side
POURS, BREAKS, DEAFENING = 40.0, 3.0, 6.0  # mm/h of rain, m of waves, m/s of cloth that are as loud as can be
LAPPING = 1.0  # m/s of a hull that rolls and rises: as loud as that can be
ARM_UP_TO = 180


def readouts(model: OceanWorld) -> list[Readout]:
    """Wind and sea, then the boat, each beside what is known of it."""
    boat, sea, chosen, gravity = model.boat, model.sea, model.parameters, model.gravity()
    pose, forces = boat.pose, boat.forces
    known = chosen.model == "jonswap"
    law = height_by_law(chosen.wind, chosen.fetch, gravity) if known else full_height(chosen.wind, gravity)
    along, across = model.wind()
    level = float(sea.at(np.zeros((1, 2)))[0, LEVEL])
    slant = model.rain.slant()
    arm = boat.righting_arm()
    seen = along - float(pose[SPEED])
    return [
        Readout("wind", elementary.length(along, across), "m/s"),
        Readout("wind asked for", chosen.wind, "m/s"),
        Readout("wind on board", elementary.length(seen, across), "m/s"),
        Readout("boat speed", float(pose[SPEED]), "m/s"), Readout("sailed", model.sailed(), "m"),
        Readout("heel", boat.heel(), "°"), Readout("pitch", math.degrees(float(pose[PITCHED])), "°"),
        Readout("upside down", int(abs(boat.heel()) > 90.0)),
        Readout("over the water", float(pose[UP]) - boat.rest.up - level, "m"),
        Readout("heeling moment", float(forces[3]), "N m"),
        Readout("righting moment", float(forces[5]), "N m"), Readout("drive", float(forces[0]), "N"),
        Readout("righting arm", arm, "m"),
        Readout("roll period", float(boat.beats[ROLL_S]) or math.nan, "s"),
        Readout("roll by law", boat.laws[1], "s"),
        Readout("heave period", float(boat.beats[HEAVE_S]) or math.nan, "s"),
        Readout("heave by law", boat.laws[0], "s"), Readout("crest speed", model.swell_speed(), "m/s"),
        Readout("crest by law", model.swell_by_law(), "m/s"), Readout("swell length", chosen.length, "m"),
        Readout("wave height", sea.significant(), "m"), Readout("height by law", law, "m"),
        Readout("level at the boat", level, "m"), Readout("rain", float(model.air[RAINS]), "mm/h"),
        Readout("rain slants", slant, "°"),
        Readout("slant by law", math.degrees(elementary.atan(model.air[NOW] / RAIN_FALLS)), "°"),
        Readout("spray", int(model.spray.flung[0])), Readout("blow", float(np.sum(boat.blows)), "N s"),
        Readout("flapping", boat.sail.flapping(), "m/s"), Readout("boom", abs(model.boom()), "°"),
        Readout("ballast", chosen.ballast, "kg"), Readout("mass", boat.hull.mass, "kg"),
        Readout("a step", model.watch.median("step"), "s"),
    ]  # fmt: skip


def targets(model: OceanWorld) -> dict[str, Point]:
    """The boat, its bow and its sail, the crest that is followed."""
    found = {
        "boat": model.seen(0.0, 0.3, 0.0), "bow": model.seen(3.4, 0.5, 0.0), "rig": model.seen(0.0, 3.6, 0.0),
        "stern": model.seen(-3.4, 0.6, 0.0),
    }  # fmt: skip
    if model.air[world.CREST] != world.LOST:
        x = float(model.air[world.CREST])
        found["crest"] = (x, float(model.sea.at(np.array([[x, 0.0]]))[0, LEVEL]))
    return found


def sizes(model: OceanWorld) -> dict[str, float]:
    """m of the boat with its mast, of its hull."""
    return {"boat": 3.0, "rig": 7.0, "bow": 1.6}


def names(model: OceanWorld) -> list[tuple[Point, str]]:
    """The crest that is followed; boat and sail, if there is none."""
    places, boat = targets(model), model.boat
    if "crest" in places:
        return [(places["crest"], f"a crest, {model.swell_speed():.1f} m/s")]
    mass = f"{boat.hull.mass / 1000.0:.1f} t, {model.parameters.ballast:.0f} kg of it ballast"
    return [(places["stern"], mass), (places["rig"], f"{boat.sail.area:.0f} m² of cloth")]


def charts(model: OceanWorld) -> dict[str, Comparison]:
    """The righting arm over the heel, with the boat on it."""
    angles = np.arange(0.0, ARM_UP_TO + 1.0, 6.0)
    law = np.array([(one, model.boat.hull.arm(math.radians(one))) for one in angles.tolist()])
    here = np.array([(abs(model.boat.heel()), model.boat.righting_arm())])
    return {"arms": Comparison(here, law, ("the boat", "righting arm"), "m", "heel", "°", single=True)}


def hearing(model: OceanWorld) -> Hearing:
    """Wind, rain, waves that break and run along the hull, water that laps as it rolls.

    Also a sail that flaps, blows, the boom, cracks of cloth.
    """
    along, across = model.wind()
    strong = elementary.length(along - float(model.boat.pose[SPEED]), across)
    sea = 0.1 + min(model.sea.significant() / BREAKS, 1.0) * 0.3
    pose = model.boat.pose
    rush = 0.25 * min(abs(float(pose[SPEED])) / 4.0, 1.0)
    laps = elementary.length(0.5 * BEAM * float(pose[ROLLING]), float(pose[RISING]))
    steady = [
        ROOM, wind(0.8 * strong), Steady("rubble", 0.5 * sea, 0.2), Steady("sliding", 0.5 * rush, 0.0),
        Steady("water", 0.3 * min(laps / LAPPING, 1.0), 0.3),
        Steady("hiss", 0.35 * math.sqrt(min(max(float(model.air[RAINS]), 0.0) / POURS, 1.0)), 0.4),
        Steady("rustle", 0.4 * min(model.boat.sail.flapping() / DEAFENING, 1.0), 0.2),
    ]  # fmt: skip
    return Hearing("ocean", model.time, model.heard.sounds(NAMES, HALF), steady)


def _take(hand: Hand) -> str:
    """The boat, where it is taken."""
    x, y = hand.at
    if abs(x) > 4.5 or abs(y) > 9.5:
        hand.point = None
        return "There is only the boat to be taken."
    hand.held, hand.model.boat.held = 0, True
    return ""


def _lift(hand: Hand) -> str:
    """It goes up and down with the hand."""
    pose = hand.model.boat.pose
    pose[UP] = min(max(float(pose[UP]) + hand.moved[1], -3.0), 12.0)
    return ""


def _loose(hand: Hand) -> None:
    hand.model.boat.held = False


def _gust(hand: Hand) -> str:
    hand.model.gust()
    return ""


def ocean_hand(model: OceanWorld) -> Hand:
    """Lifts the boat and lets it fall; the right button sends a gust."""
    uses = {"lift": Use(_take, _lift), "gust": Use(_gust)}
    return Hand(model, uses, (-40.0, -10.0), (40.0, 30.0), left="lift", right="gust", drop=_loose)

"""The world of the ocean: wind, sea, boat, spray and rain, and what is measured of them."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY, WIND
from game.physics.kernels import elementary
from game.physics.waves.effects import RAIN, SEA_WAVES, SPRAY
from game.physics.waves.sea import LEVEL, Sea, jonswap
from game.scenes.ocean.boat import (
    HEEL,
    PITCHED,
    PITCHING,
    RISING,
    SAILED,
    SPEED,
    SWUNG,
    UP,
    Boat,
)
from game.scenes.ocean.parameters import OceanContent, OceanParameters
from game.scenes.ocean.weather import Rain, Spray
from game.worlds.hearing import Heard, is_due
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Kept, Whole, World

SLAM, BOOM, CRACK = range(3)  # sounds
HEARD_BLOW, LEAST_BLOW = 150.0, 25.0  # N s of a blow that sounds as one of 1 m/s does; of the least
SPRAY_BLOW = 0.25  # m/s of a section into the water, from which drops fly
# wind, rain, a gust of the hand: m/s, mm/h, m/s; a crest, its way and since when: m, m, s; a storm's share
# of the sky
NOW, RAINS, GUST, CREST, WAY, SINCE, STORM = range(7)
STORM_WIND, STORM_RAIN, FAIR_WIND = 17.0, 30.0, 8.0  # m/s, mm/h that are a storm; m/s of fair weather
TURNS = 4.0  # s in which a sky turns
CRESTS, LOST = 33, -1e9  # places in which it is looked for; m, where there is none
PULLED, PRESSED = 0.24, 0.12  # rad, m


class OceanState(NamedTuple):
    """air (7,), see NOW; waves, boat, rain, spray and what was heard as their members have them."""

    air: Floats
    sea: Any
    pose: Floats
    breadths: Floats
    beats: Floats
    forces: Floats
    blows: Floats
    sail: Floats
    rain: Floats
    spray: Floats
    flung: Floats
    heard: Floats


@lru_cache(maxsize=64)
def height_by_law(wind: float, fetch: float, gravity: float) -> float:
    """m, significant height of JONSWAP's spectrum, summed in steps of a hundredth of its peak."""
    if wind <= 0.0 or gravity <= 0.0:
        return 0.0
    peak = 22.0 * elementary.cbrt(gravity * gravity / (wind * fetch))
    rates = peak * (0.2 + 0.01 * np.arange(3000.0))
    return 4.0 * math.sqrt(float(np.sum(jonswap(rates, wind, fetch, gravity))) * 0.01 * peak)


class OceanWorld(World):
    """``air`` (7,), see NOW. Places are beside the boat, which stands at x = 0."""

    state_type = OceanState
    content: OceanContent
    parameters: OceanParameters

    def __init__(self, content: OceanContent, parameters: OceanParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        self.sea = Sea(
            parameters.count(), parameters.downwind(), gravity=self.gravity(), seed=1 + seed,
        )  # fmt: skip
        self.boat = Boat(content, parameters, active, self.sea)
        self.rain, self.spray, self.heard = Rain(seed), Spray(), Heard()
        self.watch, self.seed = Stopwatch(), seed
        self.air: Floats = np.array((self._wind(0.0), 0.0, 0.0, LOST, 0.0, 0.0, 0.0))
        self.air[STORM] = self._storm(parameters.wind, parameters.rain)
        self.goals: Floats = self._goals()
        if content.grown:
            self.sea.rows[:, 0] = self.goals
        self.members = (
            Kept(self, "air"), Whole(self.sea), self.boat, self.rain, self.spray, self.heard,
        )  # fmt: skip
        if content.grown:
            self.boat.pose[UP] += float(self.sea.at(np.zeros((1, 2)))[0, LEVEL])

    # -- the weather ----------------------------------------------------------------------------------

    def _wind(self, time: float) -> float:
        """m/s as it comes and goes."""
        chosen = self.parameters
        if WIND not in self.active:
            return 0.0
        swing = 0.55 * elementary.sin(0.61 * time + 0.4) + 0.3 * elementary.sin(1.53 * time)
        swing += 0.15 * elementary.sin(3.7 * time + 2.0)
        return float(chosen.wind * (1.0 + chosen.gusts * swing))

    @staticmethod
    def _storm(wind: float, rain: float) -> float:
        """0 to 1, by wind (m/s) and rain (mm/h)."""
        windy = max((wind - FAIR_WIND) / (STORM_WIND - FAIR_WIND), 0.0)
        return float(min(0.75 * windy + 0.6 * max(rain, 0.0) / STORM_RAIN, 1.0))

    def _goals(self) -> Floats:
        """m, amplitudes to which the waves grow."""
        chosen = self.parameters
        if SEA_WAVES not in self.active:
            return np.zeros(len(self.sea.rows))
        wind = float(chosen.wind) if WIND in self.active else 0.0
        self.sea.set_swell(float(chosen.length))
        return self.sea.goals(chosen.model, wind, float(chosen.fetch), float(chosen.swell))

    def wind(self) -> tuple[float, float]:
        """m/s along the course and across it."""
        strong, way = float(self.air[NOW] + self.air[GUST]), self.parameters.downwind()
        return strong * elementary.cos(way), strong * elementary.sin(way)

    def change_parameter(self, name: str) -> None:
        super().change_parameter(name)
        self.goals = self._goals()
        if name == "course":
            self.sea.turn(self.parameters.downwind())
        if name in ("length", "swell"):
            self.air[CREST] = LOST

    def change_effects(self, active: EffectSet) -> None:
        before = self.active
        super().change_effects(active)
        if (GRAVITY in before) != (GRAVITY in active):
            self.sea.set_gravity(self.gravity())
        self.goals = self._goals()

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        with self.watch.time("step"):
            self._go(dt)
        return ""

    def _go(self, dt: float) -> None:
        air, chosen, boat = self.air, self.parameters, self.boat
        share = dt / (1.2 + dt)
        air[NOW] += share * (self._wind(self.time) - air[NOW])
        air[RAINS] += share * ((float(chosen.rain) if RAIN in self.active else 0.0) - air[RAINS])
        air[GUST] /= 1.0 + dt / 1.5
        air[STORM] += dt / (TURNS + dt) * (self._storm(float(air[NOW]), float(air[RAINS])) - air[STORM])
        wind, speed = self.wind(), float(boat.pose[SPEED])
        self.sea.step(speed, self.goals, dt / (float(chosen.grows) + dt), dt)
        boat.time = self.time
        hit = boat.go(wind, dt)
        self.time += dt
        self._hear(hit, dt)
        random = np.random.default_rng((self.seed, round(1e4 * self.time)))
        if SPRAY in self.active:
            self._spray(random, dt)
        elif len(self.spray.drops):
            self.spray.drops = self.spray.drops[:0]
        self.rain.go(float(air[RAINS]), wind, speed, self.gravity(), dt)
        self._follow_crest(speed, dt)

    def _hear(self, hit: float, dt: float) -> None:
        began = self.time - dt
        self.heard.forget(began)
        blow = float(np.sum(self.boat.blows))
        last = self.heard.rows[self.heard.rows[:, 1] == SLAM, 0] if len(self.heard.rows) else ()
        if blow > LEAST_BLOW and not len(last):
            self.heard.add(self.time, SLAM, blow / HEARD_BLOW, float(self.boat.hull.stations[-1]))
        if hit > 0.5:
            self.heard.add(self.time, BOOM, hit, -1.0)
        if self.boat.sail.flapping() > 2.5 and is_due(0.21, self.time, dt):
            self.heard.add(self.time, CRACK, 0.5 * self.boat.sail.flapping(), -1.0)

    def _spray(self, random: Any, dt: float) -> None:
        """Drops where sections go into the water fast, foam at the stern."""
        boat, spray = self.boat, self.spray
        pose, stations, speed = boat.pose, boat.hull.stations, float(boat.pose[SPEED])
        wind = self.wind()
        points = np.stack([stations, np.zeros_like(stations)], axis=1)
        water = self.sea.at(points)
        meets = water[:, 3] + speed * water[:, 1] - pose[RISING] - pose[PITCHING] * stations
        fast = np.where(boat.blows > 0.0, meets, 0.0)
        energies = np.where(fast > SPRAY_BLOW, boat.blows * fast, 0.0)
        if energies.any():
            places = np.stack([stations, water[:, LEVEL] + 0.05, 0.0 * stations], axis=1)
            spray.fling(places, np.maximum(boat.breadths, 0.0), energies, fast + 0.25 * abs(speed), random)
        spray.go((0.6 * wind[0], 0.6 * wind[1]), speed, self.gravity(), dt)
        if len(spray.drops):
            spray.land(self.sea.at(np.ascontiguousarray(spray.drops[:, [0, 2]]))[:, LEVEL])

    def _follow_crest(self, speed: float, dt: float) -> None:
        """Where the crest of the swell is, by the heights of the water alone."""
        air, length = self.air, float(self.parameters.length)
        if self.parameters.swell <= 0.0 or SEA_WAVES not in self.active:
            air[CREST] = LOST
            return
        lost = air[CREST] == LOST or abs(air[CREST]) > 0.75 * length
        reach = 0.5 * length if lost else 0.06 * length
        middle = -0.2 * length if lost else float(air[CREST]) - speed * dt
        x = middle + reach * (np.arange(CRESTS) / (0.5 * (CRESTS - 1)) - 1.0)
        high = self.sea.at(np.stack([x, np.zeros(CRESTS)], axis=1), 0.05 * length)[:, LEVEL]
        k = min(max(int(np.argmax(high)), 1), CRESTS - 2)
        curve = float(high[k - 1] - 2.0 * high[k] + high[k + 1])
        found = float(x[k])
        if curve < 0.0:
            found += 0.5 * float(x[1] - x[0]) * float(high[k - 1] - high[k + 1]) / curve
        if lost:
            air[WAY], air[SINCE] = 0.0, self.time
        else:
            air[WAY] += found - float(air[CREST]) + speed * dt
        air[CREST] = found

    # -- what a hand does -----------------------------------------------------------------------------

    def pull_over(self) -> None:
        """Heel it and let go."""
        self.boat.pull_over(PULLED)

    def press_down(self) -> None:
        """Press it down and let go."""
        self.boat.press_down(PRESSED)

    def gust(self) -> None:
        """A gust of half the wind more, of 4 m/s at least."""
        self.air[GUST] = max(0.5 * float(self.air[NOW]), 4.0)

    # -- what there is --------------------------------------------------------------------------------

    def swell_speed(self) -> float:
        """m/s of the crest that is followed, the mean since it was found; NaN in the first second."""
        gone = self.time - float(self.air[SINCE])
        return float(self.air[WAY]) / gone if self.air[CREST] != LOST and gone > 0.8 else math.nan

    def swell_by_law(self) -> float:
        """m/s of a wave of that length on deep water (Airy 1845)."""
        known = self.parameters.swell > 0.0
        return math.sqrt(self.gravity() * float(self.parameters.length) / math.tau) if known else math.nan

    def masthead(self) -> tuple[float, float]:
        """m, as it is seen from the side."""
        return self.seen(1.75 - self.boat.middle_x, 8.0, 0.0)

    def seen(self, along: float, up: float, across: float) -> tuple[float, float]:
        """A point of the boat, m before the middle of mass, over the drawn water line and to leeward, as
        it is seen from the side."""
        pose = self.boat.pose
        c, s = elementary.cos(float(pose[HEEL])), elementary.sin(float(pose[HEEL]))
        y = (up - self.boat.middle_y) * c - across * s
        tc, ts = elementary.cos(float(pose[PITCHED])), elementary.sin(float(pose[PITCHED]))
        return along * tc - y * ts, float(pose[UP]) + along * ts + y * tc

    def boom(self) -> float:
        """° that it is swung out."""
        return math.degrees(float(self.boat.pose[SWUNG]))

    def sailed(self) -> float:
        """m."""
        return float(self.boat.pose[SAILED])
